"""Arguments of the tools that place, move, remove, switch, paint and swap objects."""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.editing.open_buildings import Text, ToolArgs
from mansion_msgs_py.shapes import Coordinate, Degrees

__all__ = [
    "MoveObjectArgs",
    "PaintObjectArgs",
    "PlaceInContainerArgs",
    "PlaceOnSurfaceArgs",
    "PlacingWishes",
    "RemoveObjectArgs",
    "SetStateArgs",
    "Side",
    "Spot",
    "SwapObjectsArgs",
]

Gap = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]

Side: TypeAlias = Literal["", "beside", "left", "right", "behind", "front", "under", "above", "between", "around"]
"""Where something is, seen from another object; left and right are the object's own."""

Spot: TypeAlias = Literal["", "wall", "corner", "window", "door", "middle"]
"""A part of a room."""


class PlaceInContainerArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A new object of the catalogue, and the container to put it into; `color` is a word for its main material.

    Attributes
    ----------
    name : str
        What people call it; what the asset is called when empty.
    """

    asset_id: Text
    container_id: Text
    color: Text = ""
    name: Text = ""


class PlacingWishes(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Wishes for the place of an object: seen from another object, in its room, and which way it looks.

    Attributes
    ----------
    near : str
        An object. Alone it is a preference: as close to it as there is room. With `side` or `within` it must hold.
    side : str
        Where from `near`, in its own frame: its front is where it looks, its left that of who looks out of it.
        ``above`` is for what hangs, ``under`` for what stands on the floor; ``around`` is any side, turned to `near`.
    other : str
        The second object of ``between``.
    within : float, optional
        Greatest gap between the footprints of the object and `near` (and `other`), metres.
    apart : float, optional
        Least gap between the footprints of the object and `near`, metres.
    spot : str
        A part of the room: at a wall, in a corner, at a window or a door, in the middle.
    door : str
        Which door the spot ``door`` means, by its id; any of the room when empty.
    facing : str
        An object that its front is turned to.
    """

    near: Text = ""
    side: Side = ""
    other: Text = ""
    within: Gap | None = None
    apart: Gap | None = None
    spot: Spot = ""
    door: Text = ""
    facing: Text = ""


class PlaceOnSurfaceArgs(PlacingWishes, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A new object of the catalogue, and what to put it on; a room's id is its floor, or its walls and its ceiling.

    Attributes
    ----------
    color : str
        A word for its main material; that of the asset when empty.
    name : str
        What people call it; what the asset is called when empty.
    """

    asset_id: Text
    receptacle_id: Text
    color: Text = ""
    name: Text = ""


class RemoveObjectArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """One object with what it carries, or all that a receptacle carries."""

    object_id: Text = ""
    receptacle_id: Text = ""


class MoveObjectArgs(PlacingWishes, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Where an object goes: on or in a receptacle, or to a point of its floor; with it goes what it carries.

    Attributes
    ----------
    receptacle_id : str
        A surface, a container, or a room for furniture and what hangs. With a wish it may be left out: the room or
        the surface of `near` then, else its own.
    x, y, rotation : float, optional
        Metres and degrees on its own floor. A rotation alone turns it where it is.
    turn : float, optional
        Degrees to turn it by, counter-clockwise.
    inside : bool
        In a receptacle that also carries things on top.
    """

    object_id: Text
    receptacle_id: Text = ""
    inside: bool = False
    x: Coordinate | None = None
    y: Coordinate | None = None
    rotation: Degrees | None = None
    turn: Degrees | None = None


class SetStateArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """States to set: ``open`` of what opens, ``on`` of what switches."""

    object_id: Text
    open: bool | None = None
    on: bool | None = None


class PaintObjectArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A colour, a material or both for an object that is there.

    Attributes
    ----------
    color : str
        A word for a colour; the one that it has when empty.
    material : str
        A family of the palette (``wood``, ``metal``, ...); the one that it has when empty.
    """

    object_id: Text
    color: Text = ""
    material: Text = ""


class SwapObjectsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Two objects that change places, each with what it carries."""

    object_id: Text
    other_id: Text
