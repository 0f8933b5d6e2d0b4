"""Small models as users have them: GLB, OBJ in millimetres, URDF with a drawer, and broken ones."""

import json
from pathlib import Path

import trimesh
import trimesh.creation
from trimesh.visual import TextureVisuals
from trimesh.visual.material import PBRMaterial

__all__ = [
    "CABINET",
    "bar_glb",
    "box",
    "chair_obj",
    "write_annotated_shelf",
    "write_cabinet",
    "write_library",
    "write_models",
]

CABINET = """<robot name="filing_cabinet"><link name="base">
<visual><origin xyz="0 0 0.02"/><geometry><box size="0.4 0.5 0.04"/></geometry></visual>
<visual><origin xyz="0 0.24 0.4"/><geometry><box size="0.4 0.02 0.72"/></geometry></visual>
<visual><origin xyz="0 -0.24 0.4"/><geometry><box size="0.4 0.02 0.72"/></geometry></visual>
<visual><origin xyz="-0.19 0 0.4"/><geometry><box size="0.02 0.46 0.72"/></geometry></visual>
<visual><origin xyz="0 0 0.77"/><geometry><box size="0.4 0.5 0.02"/></geometry></visual>
<inertial><mass value="30"/></inertial></link>
<link name="tray"><visual><geometry><box size="0.34 0.44 0.3"/></geometry>
<material name="red"><color rgba="0.8 0.2 0.2 1"/></material></visual></link>
<joint name="slide" type="prismatic"><parent link="base"/><child link="tray"/><origin xyz="0.03 0 0.22"/>
<axis xyz="1 0 0"/><limit lower="0" upper="0.35"/></joint></robot>"""
"""A cabinet that faces +x, as ROS has it, with one drawer."""


def box(
    size: tuple[float, float, float], center: tuple[float, float, float], color: tuple[int, int, int] = (150, 30, 30)
) -> trimesh.Trimesh:
    """Return a box of one colour."""
    mesh = trimesh.creation.box(size)
    mesh.apply_translation(center)
    mesh.visual = TextureVisuals(material=PBRMaterial(baseColorFactor=[*color, 255]))
    return mesh


def bar_glb(width: float = 1.6) -> bytes:
    """Return an espresso bar as a GLB in metres: a case, and a top that stands out in front (+z)."""
    parts = [box((width, 1.0, 0.6), (0.0, 0.5, 0.0)), box((width, 0.05, 0.7), (0.0, 1.025, 0.05), (40, 40, 45))]
    return bytes(trimesh.Scene(parts).export(file_type="glb"))


def chair_obj() -> tuple[str, dict[str, bytes]]:
    """Return a chair in millimetres as an OBJ and its files."""
    legs = [box((40, 430, 40), (x, 215, z), (90, 60, 30)) for x in (-190, 190) for z in (-190, 190)]
    seat, back = box((450, 50, 450), (0, 455, 0), (200, 150, 90)), box((450, 450, 50), (0, 700, -200), (200, 150, 90))
    text, files = trimesh.exchange.obj.export_obj(
        trimesh.Scene([seat, back, *legs]), return_texture=True, mtl_name="wooden_chair.mtl"
    )
    return text, files


def write_cabinet(folder: Path) -> Path:
    """Write the cabinet, and return its file."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "filing_cabinet.urdf"
    path.write_text(CABINET)
    return path


def write_annotated_shelf(folder: Path) -> Path:
    """Write a shelf as objathor has it: a folder of its id with annotations of 1.8 m, a quarter turn, a licence."""
    name = "a1b2c3d4e5f60718"
    (folder / name).mkdir(parents=True)
    path = folder / name / f"{name}.glb"
    path.write_bytes(trimesh.Scene([box((1.0, 2.0, 0.3), (0.0, 1.0, 0.0))]).export(file_type="glb"))
    facts = {
        "category": "bookshelf",
        "description": "a tall oak bookshelf",
        "scale": 1.8,
        "z_axis_scale": True,
        "pose_z_rot_angle": 1.5707963267948966,
        "onFloor": True,
        "license_info": {"license": "by", "creator_display_name": "Ann", "uri": "https://example.org/1"},
    }
    (path.parent / "annotations.json").write_text(json.dumps(facts))
    return path


def write_models(folder: Path) -> None:
    """Write four good models and five broken ones."""
    folder.mkdir(parents=True)
    (folder / "espresso_bar.glb").write_bytes(bar_glb())
    text, files = chair_obj()
    (folder / "wooden_chair.obj").write_text(text)
    for name, data in files.items():
        (folder / name).write_bytes(data)
    write_cabinet(folder / "cabinet")
    write_annotated_shelf(folder)
    (folder / "cut.glb").write_bytes(bar_glb()[:600])
    (folder / "empty.obj").write_text("v 0 0 0\nv 1 0 0\n")
    (folder / "nowhere.obj").write_text("v 0 0 0\nv nan 0 0\nv 0 1 1\nf 1 2 3\n")
    (folder / "outside.obj").write_text("mtllib ../../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
    (folder / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")


def write_library(folder: Path) -> str:
    """Write a library with a sofa and an espresso bar, as plain boxes, and return its path."""
    (folder / "assets").mkdir(parents=True)
    for category, size in (("sofa", (1.7, 0.8, 0.8)), ("espresso_bar", (1.4, 0.6, 1.1))):
        key = f"{folder.name}.{category}"
        mesh = trimesh.creation.box((size[0], size[2], size[1]))
        (folder / "assets" / f"{key}.glb").write_bytes(mesh.export(file_type="glb"))
        record = {"key": key, "category": category, "size": size, "glb": f"{key}.glb"}
        (folder / "assets" / f"{key}.json").write_text(json.dumps(record))
    return str(folder)
