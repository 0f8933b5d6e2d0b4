"""Arguments of the tools that rename, repaint, clear and furnish rooms, and that change the structure of a floor."""

from typing import Annotated, Literal

import msgspec

from mansion_msgs_py.editing.open_buildings import Text, ToolArgs

__all__ = ["ClearRoomArgs", "FurnishRoomArgs", "RenameRoomArgs", "ReshapeFloorArgs", "SetFinishArgs"]


class RenameRoomArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A room, by id or words, and what people call it from now on; the old name stays one that means it."""

    room_id: Text
    name: Annotated[str, msgspec.Meta(min_length=1, max_length=80)]


class SetFinishArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A room, by id or words, and a new finish of its walls, floor or ceiling: a material, a colour, or both.

    Attributes
    ----------
    material : str
        Name of a material, or words for one (``oak parquet``); that of now, or paint on walls, when empty.
    color : str
        A word for its colour.
    """

    room_id: Text
    part: Literal["walls", "floor", "ceiling"]
    material: Text = ""
    color: Text = ""


class ClearRoomArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A room, by id or words, to be emptied of all that is not fixed to the building."""

    room_id: Text


class FurnishRoomArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A room, by id or words, to be furnished again: as what it is, or as another type of room.

    Attributes
    ----------
    room_type : str
        Its own when empty.
    keep : list of str
        Ids of objects that stay, with what carries them and what they carry.
    """

    room_id: Text
    room_type: Text = ""
    keep: Annotated[list[Text], msgspec.Meta(max_length=200)] = msgspec.field(default_factory=list)


class ReshapeFloorArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A change of structure, with all rooms that it does not concern held where they are.

    Attributes
    ----------
    what : str
        ``area``: the room grows or shrinks; ``door``: a door between the two rooms; ``swap``: they change places;
        ``stair``, ``elevator``: one more of these on all storeys, on floor that the room gives.
    room_id, other_id : str
        Rooms, by id or words.
    area : float
        Square metres that the room gains (or loses, where negative).
    absolute : bool
        The room is to have `area`, whatever it has now.
    """

    what: Literal["area", "door", "swap", "stair", "elevator"]
    room_id: Text
    other_id: Text = ""
    area: Annotated[float, msgspec.Meta(ge=-10_000.0, le=10_000.0)] = 0.0
    absolute: bool = False
