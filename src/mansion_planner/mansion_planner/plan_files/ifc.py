"""IFC files as plans: storeys, spaces as rooms, doors, windows and openings that nothing fills."""

import importlib
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from shapely.geometry import LineString, Polygon

from mansion_knowledge import KnowledgeBase, default_knowledge
from mansion_msgs_py.building_plan import BuildingPlan, PlanDoor, PlanDoorKind, PlanFloor, PlanRoom, PlanWindow
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.wording import choices
from mansion_planner.given_plan.room_kinds import core_kind, room_kind
from mansion_planner.plan_files.ifc_shapes import Shapes, Span
from mansion_planner.plan_files.open_sides import unwalled

__all__ = ["plan_from_ifc"]

_KINDS: Final[dict[str, PlanDoorKind]] = {
    "single": "single",
    "double": "double",
    "glazed": "glazed",
    "garage": "garage",
    "doorway": "doorway",
}
"""Kinds of doors by the ``ObjectType`` that our own export gives them."""

_IDENTIFIER: Final = re.compile(r"[a-z][a-z0-9_]*")
_BELOW: Final = -1.5
"""Metres above the building's zero from which a storey is at or above the ground."""

_HEIGHTS: Final = (2.3, 8.0)
_AT_WALL: Final = 0.5
"""Metres that a door may be away from the rooms that it joins."""

_DOORWAY: Final = (0.3, 1.8, 0.6)
"""Greatest height above the floor, least height and least width of an opening that people go through, metres."""


@dataclass
class _Storey:
    """A storey with its spaces.

    Attributes
    ----------
    level : float
        Height of its floor, metres.
    ids : dict of int to str
        What doors call each space, by its number in the file.
    """

    entity: Any
    level: float
    rooms: list[PlanRoom]
    ids: dict[int, str]
    doors: list[PlanDoor] = field(default_factory=list)
    openings: list[PlanDoor] = field(default_factory=list)
    windows: list[PlanWindow] = field(default_factory=list)


def plan_from_ifc(file: Path, storey: str = "") -> BuildingPlan:
    """Return the plan that an IFC file holds.

    Parameters
    ----------
    file : Path
    storey : str
        Name of the one storey that is meant; all that have spaces when empty.

    Raises
    ------
    MansionError
        ``NOT_FOUND``; ``UNAVAILABLE`` where ifcopenshell is not installed; ``INVALID_PAYLOAD`` for what is not an IFC
        file, or one without spaces.
    """
    model = _opened(file)
    scale = float(importlib.import_module("ifcopenshell.util.unit").calculate_unit_scale(model))
    shapes = Shapes(scale)
    storeys = _storeys(model, shapes, file)
    if storey:
        storeys = [_named(storeys, storey, file)]
    by_id = {each.entity.id(): each for each in storeys}
    for element in [*model.by_type("IfcDoor"), *model.by_type("IfcWindow")]:
        _add_filling(element, by_id, shapes, scale)
    for element in model.by_type("IfcOpeningElement"):
        _add_unfilled(element, by_id, shapes)
    for element in model.by_type("IfcVirtualElement"):
        _add_open(element, by_id)
    for each in storeys:
        each.openings += unwalled(each.rooms, _joined_already(each), lambda: _walls(model, shapes))
    building = next(iter(model.by_type("IfcBuilding")), None)
    return BuildingPlan(
        name=(building is not None and _text(building.LongName, building.Name)) or "",
        building_type=_building_type(building),
        floors=_floors(storeys, alone=bool(storey)),
    )


def _opened(file: Path) -> Any:
    try:
        library = importlib.import_module("ifcopenshell")
        importlib.import_module("ifcopenshell.geom")
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE, "IFC files need the package ifcopenshell: pip install 'mansion[ifc]'"
        ) from error
    if not file.is_file():
        raise MansionError(ErrorCode.NOT_FOUND, f"{file}: there is no such file; expected a plan in IFC")
    try:
        model = library.open(str(file))
        model.by_type("IfcBuildingStorey")
    except (OSError, RuntimeError, ValueError, AttributeError, library.Error) as error:
        reason = str(error).strip().splitlines()
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"{file} is not an IFC file: {reason[0] if reason else type(error).__name__}"
        ) from None
    return model


def _text(*words: Any) -> str:
    """Return the first of some words that says something."""
    return next((word.strip()[:200] for word in words if isinstance(word, str) and word.strip()), "")


def _building_type(building: Any) -> str:
    """Return the type of a building where its ``ObjectType`` is one that the knowledge base has."""
    said = _text(building.ObjectType if building is not None else "")
    return said if said in default_knowledge().buildings else ""


def _storeys(model: Any, shapes: Shapes, file: Path) -> list[_Storey]:
    """Return the storeys that have spaces, from the lowest to the highest."""
    spaces: dict[int, list[Any]] = {}
    entities: dict[int, Any] = {}
    lost = []
    for space in model.by_type("IfcSpace"):
        storey = _storey_of(space)
        if storey is None:
            lost.append(space.GlobalId)
            continue
        entities[storey.id()] = storey
        spaces.setdefault(storey.id(), []).append(space)
    found = [_storey(entity, spaces[number], shapes) for number, entity in entities.items()]
    found = [each for each in found if each.rooms]
    if not found:
        said = f"; {len(lost)} spaces belong to no storey" if lost else ""
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{file}: no IfcSpace on an IfcBuildingStorey has a floor{said}; rooms are read from spaces, which most"
            " programs export when rooms are placed and asked for",
        )
    return sorted(found, key=lambda each: each.level)


def _storey_of(element: Any) -> Any:
    """Return the storey that an element is in, directly or within something else; ``None`` for none."""
    for _ in range(8):
        if element is None or element.is_a("IfcBuildingStorey"):
            return element
        parents = [relation.RelatingObject for relation in getattr(element, "Decomposes", None) or ()]
        parents += [relation.RelatingStructure for relation in getattr(element, "ContainedInStructure", None) or ()]
        element = parents[0] if parents else None
    return None


def _storey(entity: Any, spaces: Sequence[Any], shapes: Shapes) -> _Storey:
    knowledge = default_knowledge()
    called = Counter(_text(space.LongName, space.Name) for space in spaces)
    numbers = Counter(_text(space.Name) for space in spaces)
    rooms: list[PlanRoom] = []
    ids: dict[int, str] = {}
    levels: list[float] = []
    for space in spaces:
        drawn = shapes.floor(space)
        if drawn is None:
            continue
        shape, level = drawn
        levels.append(level)
        number = _text(space.Name)
        name = _text(space.LongName, number) or f"Space {len(rooms) + 1}"
        if called[name] == 1 and not _IDENTIFIER.fullmatch(number):
            own = ""
        else:
            own = number if _IDENTIFIER.fullmatch(number) and numbers[number] == 1 else f"{name} {number or space.id()}"
            own = own if numbers[number] == 1 else f"{own} {space.id()}"
        ids[space.id()] = own or name
        rooms.append(
            PlanRoom(
                name=name,
                id=own,
                type=_known_type(_text(space.ObjectType), knowledge),
                polygon=_ring(shape.exterior.coords),
                holes=[_ring(hole.coords) for hole in shape.interiors],
                source=f"GlobalId {space.GlobalId}",
            )
        )
    level = sorted(levels)[len(levels) // 2] if levels else 0.0
    return _Storey(entity, level, rooms, ids)


def _known_type(said: str, knowledge: KnowledgeBase) -> str:
    """Return what a file says that a room is, where that means something."""
    if said and (core_kind(said, said, knowledge) or room_kind("", said, knowledge).known):
        return said
    return ""


def _ring(points: Any) -> Ring:
    return [(round(float(x), 4), round(float(y), 4)) for x, y, *_ in list(points)[:-1]]


def _named(storeys: Sequence[_Storey], name: str, file: Path) -> _Storey:
    names = [_text(each.entity.Name, each.entity.LongName) for each in storeys]
    if name in names:
        return storeys[names.index(name)]
    raise MansionError(
        ErrorCode.INVALID_PAYLOAD, f"{file}: there is no storey {name!r} with spaces; {choices(name, names, 'storeys')}"
    )


def _floors(storeys: Sequence[_Storey], *, alone: bool) -> list[PlanFloor]:
    """Return the floors with their numbers: 1 is the lowest that is not below the ground."""
    above = [k for k, each in enumerate(storeys) if each.level > _BELOW]
    ground = 0 if alone else (above[0] if above else len(storeys) - 1)
    floors = []
    for k, each in enumerate(storeys):
        height = _gross_height(each.entity)
        if k + 1 < len(storeys):
            height = round(storeys[k + 1].level - each.level, 3)
        fits = height is not None and _HEIGHTS[0] <= height <= _HEIGHTS[1]
        floors.append(
            PlanFloor(
                floor=k - ground + 1,
                height=height if fits else None,
                rooms=each.rooms,
                doors=each.doors,
                openings=each.openings,
                windows=each.windows,
            )
        )
    return floors


def _gross_height(storey: Any) -> float | None:
    """Return the height that a storey's quantities state, metres, where the file is in metres."""
    for relation in storey.IsDefinedBy:
        definition = relation.RelatingPropertyDefinition
        if definition.is_a("IfcElementQuantity"):
            for quantity in definition.Quantities:
                if quantity.Name == "GrossHeight" and quantity.is_a("IfcQuantityLength"):
                    return float(quantity.LengthValue)
    return None


def _add_filling(element: Any, storeys: dict[int, _Storey], shapes: Shapes, scale: float) -> None:
    """Add a door or a window to its storey, if that has rooms."""
    opening = next((relation.RelatingOpeningElement for relation in element.FillsVoids), None)
    if _is_level(_host(opening)):
        return
    width = None if element.OverallWidth is None else float(element.OverallWidth) * scale
    span = shapes.span(element, opening, width, _host(opening))
    storey = _home(element, span, storeys)
    if storey is None or span is None or _in_the_middle(span, storey):
        return
    source = f"GlobalId {element.GlobalId}"
    if element.is_a("IfcDoor"):
        storey.doors.append(
            PlanDoor(
                segment=span.segment,
                rooms=_beside(span, _joined(element, opening, storey), storey),
                kind=_door_kind(element),
                source=source,
            )
        )
    else:
        high = span.top > span.bottom
        storey.windows.append(
            PlanWindow(
                segment=span.segment,
                sill=round(max(span.bottom - storey.level, 0.0), 3) if high else None,
                height=round(span.top - span.bottom, 3) if high else None,
                source=source,
            )
        )


def _host(opening: Any) -> Any:
    """Return what an opening is cut into, ``None`` for nothing."""
    return None if opening is None else next((each.RelatingBuildingElement for each in opening.VoidsElements), None)


def _is_level(host: Any) -> bool:
    return host is not None and any(host.is_a(kind) for kind in ("IfcSlab", "IfcRoof", "IfcCovering"))


def _home(element: Any, span: Span | None, storeys: dict[int, _Storey]) -> _Storey | None:
    """Return the storey with rooms that an element is in; by its height where the file does not say."""
    entity = _storey_of(element)
    if entity is not None:
        return storeys.get(entity.id())
    near = [each for each in storeys.values() if span is not None and each.level <= span.bottom + _DOORWAY[0]]
    return max(near, key=lambda each: each.level, default=None)


def _joined(element: Any, opening: Any, storey: _Storey) -> list[str]:
    """Return the two rooms whose boundaries a door is part of, if the file says so."""
    relations = [*_boundaries(element), *(_boundaries(opening) if opening is not None else ())]
    rooms = list(dict.fromkeys(relation.RelatingSpace.id() for relation in relations if relation.RelatingSpace))
    if len(rooms) == 2 and all(room in storey.ids for room in rooms):
        return [storey.ids[room] for room in rooms]
    return []


def _in_the_middle(span: Span, storey: _Storey) -> bool:
    """Whether an opening is inside a room and far from its walls: the door of a cubicle."""
    middle = LineString(span.segment).centroid
    shapes = [Polygon(room.polygon) for room in storey.rooms]
    return any(shape.contains(middle) and shape.exterior.distance(middle) > _AT_WALL for shape in shapes)


def _beside(span: Span, names: list[str], storey: _Storey) -> list[str]:
    """Return the rooms of a door if it is at their walls: boundaries of some files name rooms farther away."""
    middle = LineString(span.segment).centroid
    shapes = {room.id or room.name: Polygon(room.polygon, room.holes) for room in storey.rooms}
    return names if all(shapes[name].distance(middle) <= _AT_WALL for name in names) else []


def _boundaries(element: Any) -> Sequence[Any]:
    return getattr(element, "ProvidesBoundaries", None) or ()


def _door_kind(element: Any) -> PlanDoorKind | None:
    said = _text(element.ObjectType)
    if said in _KINDS:
        return _KINDS[said]
    operation = str(getattr(element, "OperationType", None) or "")
    for relation in getattr(element, "IsTypedBy", None) or ():
        operation = operation or str(getattr(relation.RelatingType, "OperationType", None) or "")
    if operation.startswith("DOUBLE_DOOR"):
        return "double"
    return "garage" if operation == "ROLLINGUP" else None


def _add_unfilled(opening: Any, storeys: dict[int, _Storey], shapes: Shapes) -> None:
    """Add an opening that nothing fills where it reaches the floor and people can go through it."""
    host = _host(opening)
    if opening.HasFillings or host is None or not host.is_a("IfcWall"):
        return
    span = shapes.span(host, opening, None, host)
    storey = _home(host, span, storeys)
    if storey is None or span is None:
        return
    (ax, ay), (bx, by) = span.segment
    most, high, wide = _DOORWAY
    through = abs(span.bottom - storey.level) <= most and span.top - span.bottom >= high
    if through and (bx - ax) ** 2 + (by - ay) ** 2 >= wide**2:
        source = f"GlobalId {opening.GlobalId}"
        rooms = _beside(span, _joined(opening, None, storey), storey)
        storey.openings.append(PlanDoor(segment=span.segment, rooms=rooms, kind="doorway", source=source))


def _joined_already(storey: _Storey) -> set[frozenset[str]]:
    return {frozenset(door.rooms) for door in storey.openings if door.kind == "open"}


def _walls(model: Any, shapes: Shapes) -> list[Polygon]:
    """Return where walls stand, on all storeys."""
    standing = [shapes.footprint(wall) for kind in ("IfcWall", "IfcCurtainWall") for wall in model.by_type(kind)]
    return [shape for shape in standing if shape is not None]


def _add_open(element: Any, storeys: dict[int, _Storey]) -> None:
    """Add the boundary of two rooms that no wall parts."""
    storey = _home(element, None, storeys)
    rooms = [] if storey is None else _joined(element, None, storey)
    if storey is not None and rooms:
        storey.openings.append(PlanDoor(rooms=rooms, kind="open", source=f"GlobalId {element.GlobalId}"))
