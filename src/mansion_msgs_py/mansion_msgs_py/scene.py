"""The furnished floor: what the scene stages write and the skills read."""

from typing import Annotated, Literal, TypeAlias, TypeVar

import msgspec

from mansion_msgs_py.limits import MAX_OBJECTS, MAX_ROOMS
from mansion_msgs_py.openings import DoorKind
from mansion_msgs_py.outside import GroundArea, Outside
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.shapes import (
    Area,
    BuildingId,
    Coordinate,
    Degrees,
    Elevation,
    Identifier,
    Length,
    Point3,
    Ring,
    Segment,
    Size3,
)
from mansion_msgs_py.topology import NodeKind
from mansion_msgs_py.usage import LlmUsage

__all__ = [
    "Box3",
    "CoreDetails",
    "Discard",
    "Door",
    "DoorKind",
    "FloorScene",
    "LiftButton",
    "LiftDetails",
    "Light",
    "Mount",
    "SceneCore",
    "SceneObject",
    "SceneRoom",
    "Sky",
    "SpawnPose",
    "StairDetails",
    "Wall",
    "Window",
]

T = TypeVar("T")
_Many: TypeAlias = Annotated[list[T], msgspec.Meta(max_length=MAX_OBJECTS)]

Mount: TypeAlias = Literal["floor", "wall", "ceiling", "surface", "inside"]


class SceneRoom(msgspec.Struct, frozen=True, kw_only=True):
    """A room of a furnished floor.

    Attributes
    ----------
    polygon, holes : Ring, list of Ring
        On wall centre lines inside, on the outer wall's inner face outside.
    net_polygon, net_holes : Ring, list of Ring
        Between the faces of the walls: where objects may stand.
    area : float
        Area of the polygon, square metres.
    ceiling_height : float
        Height of the ceiling above the finished floor.
    name : str
        What people call it: the user's words where the brief names it.
    aliases : list of str
        Other names that mean it.
    """

    id: Identifier
    room_type: str
    kind: NodeKind
    polygon: Ring
    net_polygon: Ring
    area: Area
    holes: list[Ring] = []
    net_holes: list[Ring] = []
    name: str = ""
    aliases: list[str] = []
    floor_material: str = ""
    wall_material: str = ""
    ceiling_material: str = ""
    ceiling_height: Length = 2.8
    open_relation: Literal["open", "door"] = "door"


class Wall(msgspec.Struct, frozen=True, kw_only=True):
    """A straight wall.

    Attributes
    ----------
    segment : Segment
        Centre line; `left` lies to the left of its direction.
    left, right : str, optional
        Room or core ids; ``None`` is outside.
    left_material, right_material : str
        Materials of the two faces.
    """

    id: Identifier
    segment: Segment
    thickness: Length
    height: Length
    exterior: bool = False
    structural: bool = False
    left: str | None = None
    right: str | None = None
    left_material: str = ""
    right_material: str = ""


class Door(msgspec.Struct, frozen=True, kw_only=True):
    """A passage between two rooms, a room and a core, or a room and the outside.

    Attributes
    ----------
    segment : Segment
        The clear opening on the wall's centre line.
    wall : str
        Id of the wall that it interrupts; empty for kind ``open``, where no wall stands.
    rooms : (str, str or None)
        Ids of what it joins; ``None`` is outside.
    hinge : {"start", "end", "both", "none"}
        Which end of the segment the leaf hangs from.
    swing : str, optional
        The room into which it opens.
    is_open : bool
        Standing open in the initial state.
    """

    id: Identifier
    kind: DoorKind
    segment: Segment
    rooms: tuple[str, str | None]
    width: Length
    height: Length
    wall: str = ""
    hinge: Literal["start", "end", "both", "none"] = "none"
    swing: str | None = None
    is_open: bool = True
    material: str = ""


class Window(msgspec.Struct, frozen=True, kw_only=True):
    """A window in an outer wall; `sill` is the height of its lower edge, metres."""

    id: Identifier
    wall: str
    room: str
    segment: Segment
    sill: Elevation
    height: Length
    kind: str = "fixed"


class SceneObject(msgspec.Struct, frozen=True, kw_only=True):
    """An object that stands, hangs or lies somewhere.

    Attributes
    ----------
    position : (x, y, z)
        Centre of its bounding box in the floor's frame: z above the finished floor.
    rotation : float
        Degrees counter-clockwise about z; at 0 the front faces +y.
    size : (w, d, h)
        Width along the front, depth, height, before rotation.
    asset : str
        Key in the asset catalogue.
    asset_id : str, optional
        AI2-THOR asset id, where one exists.
    mount, parent
        What carries it: ``surface`` and ``inside`` name the receptacle in `parent`; what stands on the floor below a
        table may name the table.
    states : dict
        ``open``, ``on``, ``temperature``, ... where they apply.
    """

    id: Identifier
    room: str
    category: str
    asset: str
    position: Point3
    rotation: Degrees
    size: Size3
    name: str = ""
    asset_id: str | None = None
    mount: Mount = "floor"
    parent: str | None = None
    pickupable: bool = False
    receptacle: bool = False
    openable: bool = False
    toggleable: bool = False
    material: str = ""
    color: str = ""
    states: dict[str, bool | float | str] = {}

    @property
    def bottom(self) -> float:
        """Height of its lower side above the finished floor, metres."""
        return self.position[2] - self.size[2] / 2

    @property
    def top(self) -> float:
        """Height of its upper side above the finished floor, metres."""
        return self.position[2] + self.size[2] / 2


class Light(msgspec.Struct, frozen=True, kw_only=True):
    """A lamp or the sun; `color` is ``#rrggbb``."""

    id: Identifier
    kind: Literal["point", "spot", "area", "directional"]
    position: Point3
    color: str = "#ffffff"
    intensity: float = 1.0
    range: Length = 10.0
    room: str | None = None


class Sky(msgspec.Struct, frozen=True, kw_only=True):
    """Sky box and the sun's position; angles in degrees, azimuth from +y clockwise."""

    name: str = "clear_noon"
    hour: float = 12.0
    sun_azimuth: float = 180.0
    sun_elevation: float = 45.0
    color: str = "#bfd9ff"


class SpawnPose(msgspec.Struct, frozen=True, kw_only=True):
    """Where the robot starts; yaw in degrees counter-clockwise from +x."""

    x: Coordinate
    y: Coordinate
    yaw: Degrees
    room: str


Box3: TypeAlias = tuple[Point3, Point3]
"""An axis-aligned box: lower and upper corner, z above the finished floor; metres."""


class StairDetails(msgspec.Struct, frozen=True, kw_only=True, tag_field="kind", tag="stair"):
    """The flights that leave this floor upwards, and the openings that stairs need.

    Attributes
    ----------
    form : {"dog_leg"}
        Two flights side by side with a landing half way.
    risers, riser, going, width : int, float, float, float
        Steps to the next floor up, height and depth of one, clear width of a flight; 0 risers on the top floor.
    treads, landings : list of Box3
        One solid step each, in walking order, its upper face at the step's level; and the landings between flights.
    rails : list of (Point3, Point3)
        Handrails, as the lines of their axes.
    floor_landing : Ring
        The part of this floor's slab inside the core; the door opens on to it.
    floor_opening, ceiling_opening : Ring
        Holes in this floor's slab and in the slab above; empty where there is none.
    """

    form: Literal["dog_leg"]
    risers: int
    riser: float
    going: float
    width: float
    floor_landing: Ring
    treads: list[Box3] = []
    landings: list[Box3] = []
    rails: list[tuple[Point3, Point3]] = []
    floor_opening: Ring = []
    ceiling_opening: Ring = []


class LiftButton(msgspec.Struct, frozen=True, kw_only=True):
    """A button of the cabin's panel: the floor it calls, what it says, and where it sits."""

    floor: int
    label: str
    position: Point3


class LiftDetails(msgspec.Struct, frozen=True, kw_only=True, tag_field="kind", tag="elevator"):
    """The shaft on this floor, the cabin when it stands here, and the panels.

    Attributes
    ----------
    cabin : Box3
        Outer box of the cabin.
    facing : float
        Direction from the cabin out through its door, degrees from +x.
    call_panel, button_panel : Point3
        Centre of the panel beside the landing door, and of the one inside the cabin.
    buttons : list of LiftButton
        One for each floor of the building, ascending.
    floor_opening, ceiling_opening : Ring
        The shaft's holes in this floor's slab and in the slab above; empty where there is none.
    """

    cabin: Box3
    facing: Degrees
    call_panel: Point3
    button_panel: Point3
    buttons: list[LiftButton]
    floor_opening: Ring = []
    ceiling_opening: Ring = []


CoreDetails: TypeAlias = StairDetails | LiftDetails


class SceneCore(msgspec.Struct, frozen=True, kw_only=True):
    """A stair or a lift as it is on this floor.

    Attributes
    ----------
    polygon : Ring
        The shaft, the same on every floor.
    door : str
        Id of the door into it on this floor.
    entrance : (x, y, yaw)
        Standard pose outside the core, facing away from it; degrees.
    floors : list of int
        Floors that it serves, ascending.
    details : StairDetails or LiftDetails, optional
        What export builds its meshes from.
    """

    id: Identifier
    type: Literal["stair", "elevator"]
    polygon: Ring
    door: str
    entrance: Point3
    floors: list[int]
    details: CoreDetails | None = None


class Discard(msgspec.Struct, frozen=True, kw_only=True):
    """Objects that a room was to have and has not, and why."""

    room: str
    name: str
    count: int
    reason: str


class FloorScene(msgspec.Struct, frozen=True, kw_only=True):
    """One furnished floor, ``S_i`` of Algorithm 1; the truth that every export is made from.

    Attributes
    ----------
    floor, floors : int
        This floor's number, and how many the building has.
    elevation, height : float
        Height of the finished floor above the ground; height from floor to floor. Metres.
    outline, holes : Ring, list of Ring
        Inner face of the outer wall.
    building_type : str
        What the building is, ``office``.
    called : str, optional
        What the brief calls it, where that is no such type; pictures and signs have that, else the type.
    outside : Outside, optional
        Walls, roof and grounds as far as the brief decides them.
    grounds : list of GroundArea, optional
        Parts of the plot that the brief asks for; of the ground floor alone.
    downgrades : list of Downgrade
        Openings that differ from what the room graph asked, and why.
    sources : dict of str to str
        ``objects/ROOM`` to ``llm`` or ``rules: REASON``; empty where the rules choose the furniture.
    llm : LlmUsage, optional
        What a language model's choice took; without what differs from run to run.
    revision : int
        Raised by one with each edit.
    """

    building_id: BuildingId
    floor: int
    floors: Annotated[int, msgspec.Meta(ge=1)]
    label: str
    elevation: Elevation
    height: Length
    outline: Ring
    rooms: Annotated[list[SceneRoom], msgspec.Meta(max_length=MAX_ROOMS)]
    walls: _Many[Wall]
    doors: _Many[Door]
    windows: _Many[Window] = []
    cores: list[SceneCore] = []
    objects: _Many[SceneObject] = []
    lights: _Many[Light] = []
    sky: Sky = msgspec.field(default_factory=Sky)
    spawn: SpawnPose | None = None
    holes: list[Ring] = []
    structural_walls: list[Segment] = []
    discarded: list[Discard] = []
    downgrades: list[Downgrade] = []
    building_type: str = ""
    called: str | msgspec.UnsetType = msgspec.UNSET
    style: str = ""
    outside: Outside | msgspec.UnsetType = msgspec.UNSET
    grounds: list[GroundArea] | msgspec.UnsetType = msgspec.UNSET
    seed: int = 0
    sources: dict[str, str] = {}
    llm: LlmUsage | None = None
    revision: int = 1
    schema_version: Literal[1] = 1
