"""A plan that the user has: rooms, doors and windows by floor, to be furnished as it is.

Coordinates are those of the file, in `BuildingPlan.units`; the planner turns them into metres and names what is wrong.
"""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.limits import MAX_CORNERS, MAX_FLOORS, MAX_OBJECTS, MAX_ROOMS
from mansion_msgs_py.shapes import Area

__all__ = ["BuildingPlan", "PlanDoor", "PlanDoorKind", "PlanFloor", "PlanRoom", "PlanUnit", "PlanWindow"]

PlanUnit: TypeAlias = Literal["m", "cm", "mm", "ft", "in"]

PlanPoint: TypeAlias = tuple[float, float]
PlanRing: TypeAlias = Annotated[list[PlanPoint], msgspec.Meta(max_length=MAX_CORNERS)]
PlanLength: TypeAlias = Annotated[float, msgspec.Meta(gt=0.0)]
PlanName: TypeAlias = Annotated[str, msgspec.Meta(max_length=200)]

PlanDoorKind: TypeAlias = Literal["single", "double", "glazed", "doorway", "open", "garage"]
"""``doorway`` has no leaf; ``open`` takes the whole wall between two rooms away."""


class PlanRoom(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A room, a stair or a lift.

    Attributes
    ----------
    name : str
        What people call it; shown as it is.
    id : str
        Identifier by which doors may name it, besides its name; needed where several rooms of a floor have one name.
    type : str
        Room type or other word for what it is, where the name does not tell; ``stairs`` and ``elevator`` are rooms that
        lie above one another on all floors.
    polygon, holes : list of (x, y)
        Corners, in either order, on wall centre lines or on wall faces; absent where the solver is to draw the room.
    area : float, optional
        Square metres of a room without polygon.
    source : str
        Where the file has it, ``GlobalId ...`` or ``handle ...``; told with its faults.
    """

    name: PlanName = ""
    id: PlanName = ""
    type: PlanName = ""
    polygon: PlanRing = []
    holes: list[PlanRing] = []
    area: Area | None = None
    source: PlanName = ""


class PlanDoor(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A door, or an opening without a leaf.

    Attributes
    ----------
    rooms : list of str
        Names or ids of the two rooms that it joins, or of one and ``outside``; may be left out where the place tells.
    segment : ((x, y), (x, y)), optional
        The clear opening on, or near, a wall.
    at : (x, y), optional
        Its middle, where there is no segment; without either, a place on the shared wall is chosen.
    width : float, optional
        Clear width beside `at`, or of a door without a place; 0.9 m where absent.
    kind : str, optional
        Chosen by what it joins where absent.
    source : str
        Where the file has it; told with its faults.
    """

    rooms: Annotated[list[PlanName], msgspec.Meta(max_length=2)] = []
    segment: tuple[PlanPoint, PlanPoint] | None = None
    at: PlanPoint | None = None
    width: PlanLength | None = None
    kind: PlanDoorKind | None = None
    source: PlanName = ""


class PlanWindow(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A window in an outer wall.

    Attributes
    ----------
    segment : ((x, y), (x, y)), optional
    at : (x, y), optional
        Its middle, where there is no segment.
    width : float, optional
        Beside `at`; 1.2 m where absent.
    sill, height : float, optional
        As rooms of the type usually have them where absent.
    source : str
        Where the file has it; told with its faults.
    """

    segment: tuple[PlanPoint, PlanPoint] | None = None
    at: PlanPoint | None = None
    width: PlanLength | None = None
    sill: Annotated[float, msgspec.Meta(ge=0.0)] | None = None
    height: PlanLength | None = None
    source: PlanName = ""


class PlanFloor(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A storey.

    Attributes
    ----------
    floor : int
        1 at the ground, 0 and below for basements.
    label : str
        What a lift button says.
    height : float, optional
        From floor to floor; as the kind of building usually has it where absent.
    doors, openings, windows : list
        An opening is a door without a leaf.
    outline, holes : list of (x, y)
        Inner face of the outer wall and of courtyards; needed only where rooms have no polygons.
    """

    rooms: Annotated[list[PlanRoom], msgspec.Meta(min_length=1, max_length=MAX_ROOMS)]
    floor: Annotated[int, msgspec.Meta(ge=-MAX_FLOORS, le=MAX_FLOORS)] = 1
    label: PlanName = ""
    height: PlanLength | None = None
    doors: Annotated[list[PlanDoor], msgspec.Meta(max_length=MAX_OBJECTS)] = []
    openings: Annotated[list[PlanDoor], msgspec.Meta(max_length=MAX_OBJECTS)] = []
    windows: Annotated[list[PlanWindow], msgspec.Meta(max_length=MAX_OBJECTS)] = []
    outline: PlanRing = []
    holes: list[PlanRing] = []


class BuildingPlan(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A building as its plan has it.

    Attributes
    ----------
    name : str
        Name of the building.
    building_type, style : str
        As a brief would say them; by the rooms, and by the building type, where absent.
    units : {"m", "cm", "mm", "ft", "in"}
        Unit of all lengths in the file.
    complete : list of {"doors", "windows"}
        What may be added where the plan lacks it.
    """

    floors: Annotated[list[PlanFloor], msgspec.Meta(min_length=1, max_length=2 * MAX_FLOORS)]
    name: PlanName = ""
    building_type: PlanName = ""
    style: PlanName = ""
    units: PlanUnit = "m"
    complete: list[Literal["doors", "windows"]] = []
    schema_version: Literal[1] = 1
