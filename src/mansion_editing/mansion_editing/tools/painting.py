"""PaintObject, and new objects in a colour: what an object's main material is, and how it looks."""

from typing import Final

import msgspec

from mansion_assets.catalogue.palette import COLOURS, FAMILIES
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import object_named
from mansion_language.colours import COLOUR_WORDS, colour_of
from mansion_msgs_py.editing.objects import PaintObjectArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject

__all__ = ["paint_object", "recoloured", "remade"]

NATURAL: Final = {
    "wood": "oak",
    "metal": "steel",
    "glass": "clear",
    "leather": "brown",
    "stone": "grey",
    "paper": "white",
    "ceramic": "white",
    "leaf": "green",
}
"""Colour of a material that no colour is asked for with."""

FAMILY_WORDS: Final = {
    **{family: family for family in FAMILIES},
    "wooden": "wood",
    "metallic": "metal",
    "steel": "metal",
}


def paint_object(state: SceneState, args: PaintObjectArgs) -> SceneObject:
    """Give an object another colour, another material or both.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without either, or for a word that is none.
    """
    if not args.color and not args.material:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give color or material", path="$.color")
    floor, item = object_named(state, args.object_id, "$.object_id")
    after = recoloured(remade(item, args.material), args.color)
    if after != item:
        state.replace(floor, item, after)
    return after


def remade(item: SceneObject, material: str) -> SceneObject:
    """Return an object of a material in its natural colour, as it is when it is of it already or the word is empty.

    Parameters
    ----------
    material : str
        A family of the palette.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for another word.
    """
    if not material:
        return item
    family = FAMILY_WORDS.get(material.lower())
    if family is None:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"unknown material {material[:40]!r}; materials are {', '.join(sorted(FAMILIES))}",
            path="$.material",
        )
    if item.material.split("_")[0] == family:
        return item
    colour = NATURAL.get(family) or colour_of(item.material) or "grey"
    return msgspec.structs.replace(item, material=f"{family}_{colour}", color=COLOURS[colour])


def recoloured(item: SceneObject, colour: str) -> SceneObject:
    """Return an object in a colour, as it is when the colour is its own or empty.

    Parameters
    ----------
    colour : str
        A word of `COLOUR_WORDS`.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for another word.

    Notes
    -----
    Exports paint the main material of the asset's mesh in the object's colour.
    """
    if not colour:
        return item
    name = COLOUR_WORDS.get(colour.lower())
    if name is None:
        known = ", ".join(sorted(set(COLOUR_WORDS.values())))
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"unknown colour {colour[:40]!r}; colours are {known}", path="$.color"
        )
    if colour_of(item.material) == name:
        return item
    family = item.material.split("_")[0] or "paint"
    return msgspec.structs.replace(item, material=f"{family}_{name}", color=COLOURS[name])
