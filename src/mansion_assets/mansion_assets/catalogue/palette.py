"""Appearance of the materials of assets, which are named ``family_colour``."""

import re
from functools import lru_cache
from typing import Final

import msgspec

__all__ = ["COLOURS", "FAMILIES", "PbrMaterial", "material"]


class PbrMaterial(msgspec.Struct, frozen=True):
    """A material of the metallic-roughness model (glTF 2.0, section 3.9.2); `color` is sRGB, ``#rrggbb``."""

    name: str
    color: str
    metallic: float = 0.0
    roughness: float = 0.8
    opacity: float = 1.0
    emissive: float = 0.0


FAMILIES: Final[dict[str, tuple[float, float, float, float]]] = {
    "wood": (0.0, 0.6, 1.0, 0.0),
    "metal": (0.85, 0.35, 1.0, 0.0),
    "plastic": (0.0, 0.5, 1.0, 0.0),
    "fabric": (0.0, 0.95, 1.0, 0.0),
    "leather": (0.0, 0.55, 1.0, 0.0),
    "glass": (0.0, 0.08, 0.35, 0.0),
    "ceramic": (0.0, 0.2, 1.0, 0.0),
    "stone": (0.0, 0.6, 1.0, 0.0),
    "paper": (0.0, 0.9, 1.0, 0.0),
    "leaf": (0.0, 0.8, 1.0, 0.0),
    "food": (0.0, 0.6, 1.0, 0.0),
    "rubber": (0.0, 0.9, 1.0, 0.0),
    "paint": (0.1, 0.35, 1.0, 0.0),
    "picture": (0.0, 0.7, 1.0, 0.0),
    "screen": (0.0, 0.15, 1.0, 0.15),
    "light": (0.0, 0.5, 1.0, 1.0),
}
"""Metallic, roughness, opacity and emission of each family."""

COLOURS: Final[dict[str, str]] = {
    "white": "#eeeeea",
    "black": "#26272b",
    "grey": "#8d9196",
    "dark": "#45484d",
    "light": "#cfd2d4",
    "red": "#b2382f",
    "blue": "#3d6a9e",
    "green": "#4f7f52",
    "yellow": "#e0b53c",
    "orange": "#d9782d",
    "purple": "#755093",
    "brown": "#7a5638",
    "beige": "#d6c7ab",
    "pink": "#d99aa5",
    "oak": "#c09a6b",
    "walnut": "#6e4a30",
    "birch": "#dcc39a",
    "cork": "#b98d5c",
    "steel": "#b9bdc1",
    "chrome": "#d5d8da",
    "brass": "#b8933f",
    "copper": "#b4693c",
    "clear": "#d9ecf2",
    "amber": "#b5742a",
    "mirror": "#c9d6dc",
    "warm": "#fff1d0",
    "soil": "#4a3626",
    "skin": "#e3c3a3",
    "meadow": "#8fa591",
    "dusk": "#6f5468",
    "sea": "#7aa0ab",
    "fields": "#c0662f",
    "blocks": "#47648a",
    "circles": "#a8927f",
    "night": "#6d6f67",
    "botanical": "#b9b9a0",
    "city": "#6e5f63",
    "map": "#b5c3b8",
    "chart": "#d3c6b8",
}


_HEXADECIMAL: Final = re.compile(r"_([0-9a-f]{6})$")


@lru_cache(maxsize=512)
def material(name: str) -> PbrMaterial:
    """Return the material called ``family_colour``; one whose name ends with ``_rrggbb`` is of that colour.

    Examples
    --------
    >>> material("wood_oak").color
    '#c09a6b'
    >>> material("glass_mirror").opacity
    1.0
    """
    family, _, colour = name.partition("_")
    metallic, roughness, opacity, emissive = FAMILIES.get(family, FAMILIES["plastic"])
    if name == "glass_mirror":
        metallic, roughness, opacity = 0.9, 0.05, 1.0
    elif name in ("glass_black", "glass_white"):
        opacity = 0.95
    elif family == "metal" and colour in ("white", "yellow", "red", "blue", "green", "black", "orange"):
        metallic, roughness = 0.3, 0.45
    return PbrMaterial(name, COLOURS.get(colour, _own(name)), metallic, roughness, opacity, emissive)


def _own(name: str) -> str:
    found = _HEXADECIMAL.search(name)
    return f"#{found.group(1)}" if found else "#a8a39b"
