"""Objects as nodes of a model; objects of one asset share its mesh."""

from functools import lru_cache

from mansion_assets.catalogue import Asset, Catalogue, load_catalogue
from mansion_assets.catalogue.palette import PbrMaterial
from mansion_export.appearance import hex_color
from mansion_export.model import Material, Model, Node, Surface
from mansion_export.solids import Box
from mansion_export.solids3d import boxes_surface
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["add_objects", "object_asset"]


def add_objects(model: Model, scene: FloorScene, catalogue: Catalogue | None = None, *, ceilings: bool = True) -> None:
    """Add each object of a floor where it stands; what hangs from ceilings only with them.

    An object in another colour than its asset's shows that colour in the asset's main material; one whose asset the
    catalogue does not know, say a user's on another machine, is a box of its size.

    Parameters
    ----------
    catalogue : Catalogue, optional
        The shipped one when it is left out.
    """
    known = catalogue or load_catalogue()
    for item in scene.objects:
        if item.mount == "ceiling" and not ceilings:
            continue
        asset = object_asset(known, item)
        if asset is None:
            name, size = f"box:{item.color}", (1.0, 1.0, 1.0)
            surfaces = None if name in model.meshes else _box(item)
        else:
            own = item.color in ("", asset.color)
            name = f"asset:{asset.key}" if own else f"asset:{asset.key}:{item.color}"
            size = asset.size
            surfaces = None
            if name not in model.meshes:
                surfaces = list(_surfaces(asset.key, known, "" if own else item.color))
        model.add(_node(item, name, size), surfaces)


def object_asset(catalogue: Catalogue, item: SceneObject) -> Asset | None:
    """Return the asset of an object, or None where the catalogue has none."""
    return catalogue.assets.get(item.asset)


def _node(item: SceneObject, mesh: str, size: tuple[float, float, float]) -> Node:
    w, d, h = (1.0 if abs(mine - its) < 1e-4 else mine / its for mine, its in zip(item.size, size))
    # What hangs from a ceiling goes when ceilings are hidden.
    group = "ceiling" if item.mount == "ceiling" else "objects"
    return Node(item.id, mesh, group, item.position, item.rotation, (w, d, h), item.room)


@lru_cache(maxsize=4096)
def _surfaces(key: str, catalogue: Catalogue, color: str) -> tuple[Surface, ...]:
    """The parts of an asset's mesh, the main material in another colour where that is given."""
    from mansion_assets.meshes import mesh

    asset = catalogue.asset(key)
    return tuple(
        Surface(
            _material(part.material, color if part.material.name == asset.material else ""), part.vertices, part.faces
        )
        for part in mesh(asset)
    )


def _material(entry: PbrMaterial, color: str) -> Material:
    return Material(
        f"{entry.name}_{color.lstrip('#')}" if color else entry.name,
        hex_color(color or entry.color),
        entry.opacity,
        entry.roughness,
        entry.metallic,
        entry.emissive,
    )


def _box(item: SceneObject) -> list[Surface]:
    material = Material(f"color_{item.color.lstrip('#') or 'plain'}", hex_color(item.color))
    return [boxes_surface([Box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))], material)]
