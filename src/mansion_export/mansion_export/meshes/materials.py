"""Materials of the library as the 3D formats need them, and conversions of colours."""

from functools import cache

from mansion_assets.materials import set_of
from mansion_export.meshes.model import Material
from mansion_scene.structure.materials import library, match_material

__all__ = ["hex_color", "linear", "named", "surface_material"]


def hex_color(text: str, default: str = "#b0a89c") -> tuple[float, float, float]:
    """Return ``#rrggbb`` as numbers from 0 to 1; `default` for anything else."""
    digits = text if len(text) == 7 and text.startswith("#") else default
    return (int(digits[1:3], 16) / 255.0, int(digits[3:5], 16) / 255.0, int(digits[5:7], 16) / 255.0)


def linear(color: tuple[float, float, float]) -> list[float]:
    """Return an sRGB colour in linear light, as glTF's factors are (IEC 61966-2-1)."""
    return [round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 6) for c in color]


@cache
def named(name: str) -> Material:
    """Return a material of the library by its name."""
    entry = library()[name]
    return Material(
        entry.name, hex_color(entry.color), entry.alpha, entry.roughness, entry.metallic, texture=set_of(name)
    )


@cache
def surface_material(description: str, use: str) -> Material:
    """Return the material of a floor, wall, ceiling or part that the scene names or describes."""
    if description in library():
        return named(description)
    if use == "floor":
        return named(match_material(description, "floor").name)
    if use == "ceiling":
        return named(match_material(description, "ceiling").name)
    if use == "part":
        return named(match_material(description, "part").name)
    return named(match_material(description, "wall").name)
