"""The library of physically based materials: found by a description, or for a facade by building type and seed.

Each material carries the name of a material that AI2-THOR has, taken from the material database of the `procthor`
package (Apache-2.0).
"""

import re
from functools import cache
from importlib import resources
from typing import Annotated, Final, Literal, TypeAlias

import msgspec

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.codec import prepared
from mansion_msgs_py.scene import FloorScene

__all__ = [
    "DEFAULT_FACADE",
    "GLASS_FACADE",
    "SUBSTANCES",
    "Material",
    "Use",
    "facade_material",
    "facade_of",
    "library",
    "match_material",
    "material",
]

Use: TypeAlias = Literal["floor", "wall", "ceiling", "part"]


class Material(msgspec.Struct, frozen=True, kw_only=True):
    """A material of the library.

    Attributes
    ----------
    color : str
        Base colour, sRGB ``#rrggbb``.
    roughness, metallic, alpha : float
        0 to 1, as in glTF's metallic-roughness model.
    uses : tuple of str
        Surfaces on which descriptions may match it.
    thor : str
        The AI2-THOR material that looks most like it.
    """

    name: str
    color: Annotated[str, msgspec.Meta(pattern="^#[0-9a-f]{6}$")]
    roughness: float
    metallic: float
    uses: tuple[Use, ...]
    keywords: tuple[str, ...]
    thor: str
    alpha: float = 1.0


_DEFAULTS: dict[Use, str] = {
    "floor": "oak_hardwood",
    "wall": "white_drywall",
    "ceiling": "white_drywall",
    "part": "painted_steel",
}
SUBSTANCES: Final = frozenset(
    [
        "oak",
        "hardwood",
        "wood",
        "wooden",
        "timber",
        "parquet",
        "vinyl",
        "linoleum",
        "lino",
        "rubber",
        "carpet",
        "ceramic",
        "porcelain",
        "tile",
        "tiles",
        "tiled",
        "terrazzo",
        "marble",
        "granite",
        "concrete",
        "epoxy",
        "deck",
        "decking",
        "paving",
        "drywall",
        "plaster",
        "brick",
        "subway",
        "panel",
        "panels",
        "panelling",
        "paneling",
        "acoustic",
        "stone",
        "cladding",
        "resin",
        "herringbone",
    ]
)
"""Words for what a surface is made of, which say more than its colour."""


@cache
def library() -> dict[str, Material]:
    """Return all materials by name, in the order of the library."""
    text = resources.files("mansion_scene.structure").joinpath("data/materials.json").read_bytes()
    return {entry.name: entry for entry in msgspec.json.decode(text, type=prepared(list[Material]))}


def material(name: str) -> Material:
    """Return a material by name.

    Raises
    ------
    KeyError
        When the library has no such material.
    """
    return library()[name]


@cache
def match_material(description: str, use: Use) -> Material:
    """Return the material of a use that a description names best.

    Words for a substance count three times as much as words for a colour or a finish; the first material of the
    library wins a tie, and a default of the use answers when no word is known.

    Examples
    --------
    >>> match_material("warm oak hardwood, matte", "floor").name
    'oak_hardwood'
    >>> match_material("carpet, neutral gray", "floor").name
    'grey_carpet'
    """
    words = re.findall(r"[a-z]+", description.lower())
    best, best_score = library()[_DEFAULTS[use]], 0.0
    if description in library() and use in library()[description].uses:
        return library()[description]
    for entry in library().values():
        if use not in entry.uses:
            continue
        score = sum(3.0 if word in SUBSTANCES else 1.0 for word in words if word in entry.keywords)
        # Among equals the material with the fewest further keywords is the plainest reading of the description.
        if score > 0.0:
            score += 0.5 / (1 + len(entry.keywords))
        if score > best_score:
            best, best_score = entry, score
    return best


DEFAULT_FACADE = "facade_render"
GLASS_FACADE = "glass_panels"
"""What covers slabs and columns of a facade that is of glass between them."""


def facade_material(building_type: str, seed: int, style: str = "", wanted: str = "") -> str:
    """Return the material of a building's outer walls, the same for all its floors.

    Parameters
    ----------
    wanted : str
        The material that the brief asks for, if it does.
    """
    if wanted in library():
        return wanted
    if not building_type:
        return DEFAULT_FACADE
    choice = default_knowledge().groups.facades_of(building_type, style)
    return choice[int(item_generator(seed, "facade").integers(len(choice)))]


def facade_of(scene: FloorScene) -> str:
    """Return the material of a finished floor's outer walls."""
    faces = (wall.right_material for wall in scene.walls if wall.exterior and wall.right_material)
    return next(faces, DEFAULT_FACADE)
