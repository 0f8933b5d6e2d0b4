"""Everything that is written for one floor, as bytes by file name."""

from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology

__all__ = ["FLOOR_FILES", "floor_files", "scene_files"]

FLOOR_FILES = {
    "topology": "topology.json",
    "layout": "layout.json",
    "scene": "scene.json",
    "house": "house.json",
    "plan_svg": "plan.svg",
    "plan_png": "plan.png",
    "map": "map.yaml",
    "map_image": "map.pgm",
    "model": "model.xml",
}


def scene_files(scene: FloorScene) -> dict[str, bytes]:
    """Return what is made from the scene alone, by path relative to the building's folder."""
    from mansion_export.mjcf import floor_mjcf
    from mansion_export.nav2 import map_pgm, map_yaml
    from mansion_export.plan import plan_png, plan_svg
    from mansion_export.thor import house

    folder = floor_directory(scene.floor)
    model = floor_mjcf(scene)
    files = {
        f"{folder}/scene.json": encode_bytes(scene, indent=1),
        f"{folder}/house.json": encode_bytes(house(scene)),
        f"{folder}/plan.svg": plan_svg(scene).encode(),
        f"{folder}/plan.png": plan_png(scene),
        f"{folder}/map.pgm": map_pgm(scene),
        f"{folder}/map.yaml": map_yaml(scene).encode(),
        f"{folder}/model.xml": model.xml.encode(),
    }
    for name, data in sorted(model.meshes.items()):
        files[f"meshes/{name}"] = data
    return files


def floor_files(topology: FloorTopology, layout: FloorLayout, scene: FloorScene) -> dict[str, bytes]:
    """Return all files of a floor, by path relative to the building's folder."""
    folder = floor_directory(scene.floor)
    return {
        f"{folder}/topology.json": encode_bytes(topology, indent=1),
        f"{folder}/layout.json": encode_bytes(layout, indent=1),
        **scene_files(scene),
    }
