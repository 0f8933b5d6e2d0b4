"""What a brief asks for outside: the material of outer walls, the roof, and what lies around the building."""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.shapes import Ring

__all__ = ["GroundArea", "GroundUse", "GroundWish", "Outside", "RoofForm"]

RoofForm: TypeAlias = Literal["", "flat", "gable", "hip"]

GroundUse: TypeAlias = Literal["garden", "pool", "parking", "playground", "hedge", "fence"]


class GroundWish(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """Something that is wanted on the plot.

    Attributes
    ----------
    count : int
        Number of places to park; 0 where none is stated.
    """

    use: GroundUse
    count: Annotated[int, msgspec.Meta(ge=0, le=400)] = 0


class Outside(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """The outside of a building as far as the brief decides it; empty fields follow from its type and style.

    Attributes
    ----------
    facade : str
        Material of the outer walls, by its name in the library of materials.
    roof : {"", "flat", "gable", "hip"}
        Form of the roof over the highest storey.
    covering : str
        Material of the roof.
    grounds : tuple of GroundWish
    """

    facade: str = ""
    roof: RoofForm = ""
    covering: str = ""
    grounds: tuple[GroundWish, ...] = ()


class GroundArea(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A part of the plot with a use of its own.

    Attributes
    ----------
    polygon : Ring
        Metres, in the coordinates of the ground floor, outside its outline.
    count : int
        Number of places to park.
    """

    use: GroundUse
    polygon: Ring
    count: int = 0
