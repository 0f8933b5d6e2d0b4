"""The building program: the schema of Fig. 23, with the geometry that every floor shares."""

from typing import Annotated, Final, Literal, TypeAlias

import msgspec

from mansion_msgs_py.openings import GivenOpenings
from mansion_msgs_py.outside import Outside
from mansion_msgs_py.shapes import Area, BuildingId, CompassSide, Elevation, Identifier, Length, Point, Ring, Segment
from mansion_msgs_py.wishes import Wish

__all__ = [
    "Clutter",
    "AreaSummary",
    "BuildingProgram",
    "CorePlan",
    "Downgrade",
    "FloorProgram",
    "GROUND_FLOOR",
    "RequestedObject",
    "RoomProgram",
    "TraceEntry",
    "VerticalConnectivity",
]

Clutter: TypeAlias = Literal["sparse", "dense"]
"""Fewer or more small objects than usual."""

GROUND_FLOOR: Final = 1
"""Number of the ground floor; basements have 0 and less."""


class CorePlan(msgspec.Struct, frozen=True, kw_only=True):
    """A vertical core, an axis-aligned box at the same place on every floor that it serves.

    Attributes
    ----------
    id : str
        ``stair_1``, ``elevator_1``; the id of its node in every floor's topology.
    type : {"stair", "elevator"}
    x, y : (float, float)
        Lower and upper coordinate in metres, integers for outlines that the planner samples.
    door_side : {"north", "south", "east", "west"}, optional
        The side on which the core opens (north is +y); any side when absent.
    landing : {"north", "south", "east", "west"}, optional
        The end of a stair at which its floor landings lie, one above the other; where it is absent, each floor takes
        the end of the door, or else the one deeper in the building.
    """

    id: Identifier
    type: Literal["stair", "elevator"]
    x: Point
    y: Point
    door_side: CompassSide | None = None
    landing: CompassSide | None = None


class VerticalConnectivity(msgspec.Struct, frozen=True, kw_only=True):
    """How floors connect; `method` is ``none`` for one storey."""

    method: Literal["none", "stair", "elevator", "stair_and_elevator"]
    cores: list[CorePlan] = []
    justification: str = ""


class RequestedObject(msgspec.Struct, frozen=True, kw_only=True):
    """Furniture that the brief wants in a room: `count` pieces of a category of the catalogue, none where it is 0.

    Attributes
    ----------
    words : str
        What the brief calls one of them.
    exact : bool
        No more of them are wanted.
    rows : int
        In how many rows they stand, as long as the room allows; 0 where the brief tells none.
    """

    category: str
    count: int
    words: str = ""
    exact: bool = False
    rows: int = 0


class RoomProgram(msgspec.Struct, frozen=True, kw_only=True):
    """A room that a floor is to have.

    Attributes
    ----------
    id : str
        Snake case, unique on the floor (``meeting_room_1``); the hub comes first in the floor's list.
    area_estimate : float
        Square metres.
    room_type : str
        Snake case type that later stages furnish by (``meeting_room``).
    floor_material, wall_material : str
        Descriptions such as ``warm oak hardwood, matte``.
    open_relation : {"open", "door"}
        Whether it stands open to the room it is reached from.
    adjacent_to : list of str
        Ids on the same floor that the brief or the type wants beside it.
    notes : str
    name : str
        What the user calls it; empty for a room that the brief does not name.
    aliases : list of str
        Other names that mean it.
    objects : list of RequestedObject
        Furniture beyond what such rooms usually have.
    clutter : {"sparse", "dense"}, optional
        Fewer or more small objects than usual lie about.
    """

    id: Identifier
    area_estimate: Area
    room_type: str = ""
    floor_material: str = ""
    wall_material: str = ""
    open_relation: Literal["open", "door"] = "door"
    adjacent_to: list[str] = []
    notes: str = ""
    name: str = ""
    aliases: list[str] = []
    objects: list[RequestedObject] = []
    clutter: Clutter | msgspec.UnsetType = msgspec.UNSET


class AreaSummary(msgspec.Struct, frozen=True, kw_only=True):
    """How a floor's areas add up: `reserve_ratio` is what circulation and cores keep of the gross area."""

    sum_rooms: float
    reserve_ratio: float
    fits_within_gfa: bool
    notes: str = ""


class FloorProgram(msgspec.Struct, frozen=True, kw_only=True):
    """One floor: what it is for, its outline and its rooms.

    Attributes
    ----------
    index : int
        Floor number, 1 at the ground, 0 and below for basements.
    label : str
        What a lift button says (``G``, ``2``).
    elevation, height : float
        Height of the finished floor above the ground, and height from floor to floor, in metres.
    outline : Ring
        Inner face of the outer wall.
    structural_walls : list of Segment
        Centre lines that rooms of every floor must respect.
    copy : int, optional
        The floor whose layout this one repeats exactly; `rooms` is then that floor's list.
    openings : GivenOpenings, optional
        Doors and windows of a plan that the user gave; chosen by rules where absent.
    """

    index: int
    requirement: str
    gross_floor_area: Area
    rooms: list[RoomProgram]
    area_summary: AreaSummary
    label: str = ""
    elevation: Elevation = 0.0
    height: Length = 3.2
    outline: Ring = []
    holes: list[Ring] = []
    structural_walls: list[Segment] = []
    copy: int | None = None
    openings: GivenOpenings | None = None


class TraceEntry(msgspec.Struct, frozen=True, kw_only=True):
    """Which words of the brief (or which rule, when `words` is empty) led to which decision."""

    words: str
    effect: str
    start: int | None = None
    end: int | None = None


class Downgrade(msgspec.Struct, frozen=True, kw_only=True):
    """A wish that is not met, or met in part, and why."""

    wish: str
    got: str
    reason: str
    stage: str = ""
    floor: int | None = None


class BuildingProgram(msgspec.Struct, frozen=True, kw_only=True):
    """The program of a whole building, ``B_plan`` of Algorithm 1, line 3.

    Attributes
    ----------
    building_type : str
        In the words of the brief where it has some, else the kind of the knowledge base.
    planned_like : str
        The kind of the knowledge base where `building_type` is called otherwise there; else empty.
    outside : Outside, optional
        Walls, roof and grounds as far as the brief decides them.
    """

    building_id: BuildingId
    reasoning: str
    vertical_connectivity: VerticalConnectivity
    floors: Annotated[list[FloorProgram], msgspec.Meta(min_length=1)]
    description: str = ""
    building_type: str = ""
    planned_like: str = ""
    style: str = ""
    outside: Outside | msgspec.UnsetType = msgspec.UNSET
    seed: int = 0
    trace: list[TraceEntry] = []
    downgrades: list[Downgrade] = []
    wishes: list[Wish] = []
    schema_version: Literal[1] = 1

    @property
    def kind(self) -> str:
        """The kind of building of the knowledge base."""
        return self.planned_like or self.building_type
