"""What an edit changes: objects, rooms and documents, as the edit log and the replies of tools record it."""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.scene import Discard, Light, SceneObject, SceneRoom, SpawnPose
from mansion_msgs_py.shapes import FileInFolder
from mansion_msgs_py.topology import TopologyNode

__all__ = ["DiffReport", "DocumentChange", "EditResult", "ObjectChange", "RoomChange", "RoomParts", "Transaction"]


class ObjectChange(msgspec.Struct, kw_only=True, frozen=True):
    """One object before and after; ``None`` where it was or is not there. `index` is its place in the floor's list."""

    floor: int
    index: int
    before: SceneObject | None = None
    after: SceneObject | None = None

    @property
    def id(self) -> str:
        """Id of the object."""
        found = self.after or self.before
        return "" if found is None else found.id


class RoomParts(msgspec.Struct, frozen=True, kw_only=True):
    """The description of one room in a building's documents, without its objects.

    Attributes
    ----------
    faces : dict of str to str
        By wall, the material of the side that the room has of it.
    spawn : SpawnPose, optional
        Where the robot starts, when that is in this room.
    source : str
        Who chose the furniture, where a model was asked (see `FloorScene.sources`).
    program, node : optional
        The room in the building's program and in its floor's room graph, where they have it.
    """

    room: SceneRoom
    faces: dict[str, str] = {}
    lights: list[Light] = []
    discarded: list[Discard] = []
    spawn: SpawnPose | None = None
    source: str = ""
    program: RoomProgram | None = None
    node: TopologyNode | None = None


class RoomChange(msgspec.Struct, frozen=True, kw_only=True):
    """One room before and after."""

    floor: int
    before: RoomParts
    after: RoomParts

    @property
    def id(self) -> str:
        """Id of the room."""
        return self.after.room.id


_Copy: TypeAlias = Annotated[str, msgspec.Meta(pattern="^([0-9a-f]{32})?$")]


class DocumentChange(msgspec.Struct, frozen=True, kw_only=True):
    """A document of the building that is replaced whole.

    Attributes
    ----------
    path : str
        Relative to the building's folder.
    before, after : str
        Names of the stored copies below ``edits/documents``; empty where the document was or is not there.
    """

    path: FileInFolder
    before: _Copy = ""
    after: _Copy = ""

    @property
    def id(self) -> str:
        """Path of the document."""
        return self.path


class Transaction(msgspec.Struct, frozen=True, kw_only=True):
    """A line of the edit log: what landed together.

    Attributes
    ----------
    number : int
        Counts from 1.
    what : str
        The instruction, or the tool and its arguments.
    changes, rooms, documents : list
        What happened to objects, to rooms and to whole documents.
    undoes, redoes : int, optional
        Number of the transaction that this one takes back or restores.
    revisions : dict
        Floor (as a decimal string) to the revision that this transaction made.
    time : str
        ISO 8601, as the caller's clock had it.
    """

    number: int
    who: str
    what: str
    changes: list[ObjectChange]
    rooms: list[RoomChange] = []
    documents: list[DocumentChange] = []
    revisions: dict[str, int] = {}
    undoes: int | None = None
    redoes: int | None = None
    time: str = ""
    schema_version: Literal[1] = 1


class EditResult(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of every tool that changes something.

    Attributes
    ----------
    object_ids : list of str
        Objects added, moved, changed or removed, in that order of work.
    room_ids : list of str
        Rooms whose name, kind, finishes or light changed.
    saved : bool
        Landed on disk, else waiting for Save.
    transaction : int, optional
        Its number in the log, once saved.
    """

    message: str
    object_ids: list[str] = []
    room_ids: list[str] = []
    saved: bool = False
    transaction: int | None = None
    revisions: dict[str, int] = {}


class DiffReport(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of Diff: changes that wait for Save, in words and as they are."""

    message: str
    changes: list[ObjectChange]
    rooms: list[RoomChange] = []
    documents: list[DocumentChange] = []
