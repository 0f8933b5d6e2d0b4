"""Objects in a colour of one's choice: the main material keeps its family and takes the colour."""

import msgspec

from mansion_assets.catalogue.palette import COLOURS
from mansion_editing.vocabulary import COLOUR_WORDS, colour_of
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject

__all__ = ["recoloured"]


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
