"""The surfaces of an asset's mesh, each with the material that it shows."""

from collections.abc import Sequence
from functools import lru_cache

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.palette import PbrMaterial
from mansion_assets.catalogue.palette import material as pbr_material
from mansion_assets.materials import art, set_of
from mansion_assets.meshes import MeshPart, mesh
from mansion_export.meshes.materials import hex_color
from mansion_export.meshes.model import Material, Surface

__all__ = ["asset_surfaces", "part_surfaces"]


@lru_cache(maxsize=256)  # quickly made again: the recipes' solids are kept too
def asset_surfaces(key: str, catalogue: Catalogue, color: str = "", picture: str = "") -> tuple[Surface, ...]:
    """Return the surfaces of an asset's mesh.

    Parameters
    ----------
    key : str
    catalogue : Catalogue
    color : str
        Colour of the main material; if empty, the one that the asset has.
    picture : str
        Material of the painting that the asset carries; if empty, that of the mesh.
    """
    asset = catalogue.asset(key)
    return part_surfaces(mesh(asset), asset.material, color, picture)


def part_surfaces(parts: Sequence[MeshPart], main: str, color: str, picture: str = "") -> tuple[Surface, ...]:
    """Return the surfaces of parts of a mesh whose main material is `main`; see `asset_surfaces`."""
    surfaces = []
    for part in parts:
        entry = pbr_material(picture) if picture and part.material.name in art() else part.material
        look = _material(entry, color if entry.name == main else "")
        surfaces.append(Surface(look, part.vertices, part.faces, part.coordinates))
    return tuple(surfaces)


def _material(entry: PbrMaterial, color: str) -> Material:
    return Material(
        f"{entry.name}_{color.lstrip('#')}" if color else entry.name,
        hex_color(color or entry.color),
        entry.opacity,
        entry.roughness,
        entry.metallic,
        entry.emissive,
        set_of(entry.name),
    )
