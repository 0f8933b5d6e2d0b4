"""Arguments and replies of the scene editor's tools, and what an edit changes.

The names and inputs of the eight tools of the check-and-provision workflow are those of its tool cards (supplement,
D.2): CheckPath, SearchAssets, ListObjects, CheckSurface, SearchContents, PlaceInContainer, RemoveObject,
PlaceOnSurface. Every one takes `editor` besides, the name that ``scene/open`` gave a building on the server.
"""

from typing import Annotated, Any, Literal, TypeAlias

import msgspec

from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.scene import Discard, Light, SceneObject, SceneRoom, SpawnPose
from mansion_msgs_py.shapes import Coordinate, Degrees, FileInFolder, Point3
from mansion_msgs_py.task import Task
from mansion_msgs_py.topology import TopologyNode

__all__ = [
    "AgentReport",
    "AgentStep",
    "AssetHits",
    "AssetInfo",
    "CheckPathArgs",
    "CheckSurfaceArgs",
    "ClearRoomArgs",
    "DiffReport",
    "DocumentChange",
    "EditResult",
    "EditorInfo",
    "FurnishRoomArgs",
    "InstructArgs",
    "ListObjectsArgs",
    "MoveObjectArgs",
    "ObjectChange",
    "ObjectInfo",
    "ObjectList",
    "OpenEditorArgs",
    "PaintObjectArgs",
    "PathReport",
    "PathStep",
    "PlaceInContainerArgs",
    "PlaceOnSurfaceArgs",
    "PlacingWishes",
    "ProvisionArgs",
    "ReceptacleContents",
    "ReceptacleReport",
    "RemoveObjectArgs",
    "RenameRoomArgs",
    "RoomChange",
    "RoomParts",
    "ReshapeFloorArgs",
    "SearchAssetsArgs",
    "SearchContentsArgs",
    "SetFinishArgs",
    "SetStateArgs",
    "Side",
    "Spot",
    "SwapObjectsArgs",
    "ToolArgs",
    "Transaction",
]

Text = Annotated[str, msgspec.Meta(max_length=400)]
Gap = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]

Side: TypeAlias = Literal["", "beside", "left", "right", "behind", "front", "under", "above", "between", "around"]
"""Where something is, seen from another object; left and right are the object's own."""

Spot: TypeAlias = Literal["", "wall", "corner", "window", "door", "middle"]
"""A part of a room."""


class ToolArgs(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Which open building a call is for: the one opened last under the empty name when absent."""

    editor: Text = ""


class OpenEditorArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Open the building folder `path` under the name `editor`.

    Attributes
    ----------
    who : str
        Written into the log beside each change.
    autosave : bool
        Land each edit at once; else edits wait for ``scene/save``.
    """

    path: Annotated[str, msgspec.Meta(max_length=4096)]
    who: Text = ""
    autosave: bool = True


class EditorInfo(msgspec.Struct, frozen=True, kw_only=True):
    """An open building."""

    building_id: str
    floors: list[int]
    labels: list[str]
    revisions: dict[str, int]
    editor: str = ""
    who: str = ""
    autosave: bool = True


class CheckPathArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Both ends may be left out: from the entrance, to every room. A room, core or object, by id or words."""

    start: Text = ""
    end: Text = ""


class SearchAssetsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Words for a new object, how many hits, and properties that each must have (``Pickable``, ``Receptacle``, ...)."""

    query: Text
    top_k: Annotated[int, msgspec.Meta(ge=1, le=50)] = 5
    properties: Annotated[list[Text], msgspec.Meta(max_length=8)] = []


class ListObjectsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Filters: a room (id or words, with a floor where it matters), a keyword or an id."""

    room: Text = ""
    keyword: Text = ""
    id: Text = ""
    limit: Annotated[int, msgspec.Meta(ge=1, le=500)] = 100


class CheckSurfaceArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """The receptacle, by keyword or by id."""

    keyword: Text = ""
    id: Text = ""


class SearchContentsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """The container, by keyword or by id."""

    keyword: Text = ""
    id: Text = ""


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
    spot : str
        A part of the room: at a wall, in a corner, at a window or a door, in the middle.
    facing : str
        An object that its front shall be turned to.
    """

    near: Text = ""
    side: Side = ""
    other: Text = ""
    within: Gap | None = None
    spot: Spot = ""
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
    """

    object_id: Text
    receptacle_id: Text = ""
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
    """A room, by id or words, to be furnished anew: as what it is, or as another type of room.

    Attributes
    ----------
    room_type : str
        Its own when empty.
    keep : list of str
        Ids of objects that stay, with what carries them and what they carry.
    """

    room_id: Text
    room_type: Text = ""
    keep: Annotated[list[Text], msgspec.Meta(max_length=200)] = []


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


class InstructArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """An instruction for the editing agent; `planner` as in a `BuildRequest`."""

    instruction: Annotated[str, msgspec.Meta(max_length=4000)]
    planner: Literal["rules", "llm"] = "rules"


class ProvisionArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A task that shall become possible: what it needs is checked, and provided where it is missing."""

    task: Task


class PathStep(msgspec.Struct, frozen=True, kw_only=True):
    """A place on the way and the door into it; a stair or a lift comes once for each floor."""

    place: str
    floor: int
    door: str = ""


class PathReport(msgspec.Struct, kw_only=True, frozen=True):
    """Reply of CheckPath.

    Attributes
    ----------
    unreachable : list of str
        Rooms that cannot be reached from the start.
    blocked_doors : list of str
        Doors before which an object leaves no way through.
    cut_rooms : list of str
        Rooms whose furniture leaves a robot no way between two parts of their floor, or to a door.
    """

    message: str
    reachable: bool
    start: str = ""
    end: str = ""
    route: list[PathStep] = []
    unreachable: list[str] = []
    blocked_doors: list[str] = []
    cut_rooms: list[str] = []


class AssetInfo(msgspec.Struct, frozen=True, kw_only=True):
    """An asset of the catalogue; `asset_id` is what the Place tools take."""

    asset_id: str
    category: str
    name: str
    size: Point3
    score: float
    material: str = ""
    properties: list[str] = []


class AssetHits(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of SearchAssets, the best first."""

    message: str
    assets: list[AssetInfo]


class ObjectInfo(msgspec.Struct, frozen=True, kw_only=True):
    """An object of the scene with the properties that the catalogue knows of its asset."""

    id: str
    category: str
    name: str
    asset_id: str
    floor: int
    room: str
    position: Point3
    mount: str
    parent: str | None = None
    color: str = ""
    properties: list[str] = []
    states: dict[str, bool | float | str] = {}


class ObjectList(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ListObjects; `total` counts those beyond the limit too."""

    message: str
    total: int
    objects: list[ObjectInfo]


class ReceptacleContents(msgspec.Struct, frozen=True, kw_only=True):
    """One receptacle and what geometry finds on or in it."""

    receptacle: ObjectInfo
    objects: list[ObjectInfo]


class ReceptacleReport(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of CheckSurface and of SearchContents: one entry for each receptacle that fits."""

    message: str
    receptacles: list[ReceptacleContents]


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
    """What a building's documents say of one room, its objects left out.

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


class AgentStep(msgspec.Struct, frozen=True, kw_only=True):
    """One turn of the agent: what it thought, the tool it called and what it saw."""

    thought: str
    tool: str = ""
    arguments: dict[str, Any] = {}
    observation: Any = None
    refused: bool = False


class AgentReport(msgspec.Struct, kw_only=True, frozen=True):
    """Reply of ``scene/instruct`` and ``scene/provision``.

    Attributes
    ----------
    done : bool
        Every fact that the instruction asks for, or the task needs, holds.
    facts, failed : list of str
        What was asked, in words; and what could not be met, each with its reason.
    edits : int
        Tools that changed something.
    question : bool
        It was only asked about the building; `message` is the answer.
    candidates : list of str
        Ids of what words may mean that fit several things.
    """

    message: str
    done: bool
    steps: list[AgentStep] = []
    facts: list[str] = []
    failed: list[str] = []
    edits: int = 0
    saved: bool = False
    transaction: int | None = None
    object_ids: list[str] = []
    question: bool = False
    candidates: list[str] = []
