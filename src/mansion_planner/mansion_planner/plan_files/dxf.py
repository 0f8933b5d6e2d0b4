"""Drawings in DXF as plans: closed polylines as rooms, texts in them as names, doors and windows by layer."""

import importlib
import re
import statistics
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import shapely
from shapely.geometry import MultiLineString, Polygon
from shapely.geometry import Point as Place

from mansion_msgs_py.building_plan import BuildingPlan, PlanDoor, PlanFloor, PlanRoom, PlanWindow
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Point, Segment
from mansion_msgs_py.wording import choices
from mansion_planner.plan_files.dxf_openings import Arc, Mark, door_segment, is_double, joined_marks, window_segment

__all__ = ["plan_from_dxf"]

_ROLES: Final[Mapping[str, re.Pattern[str]]] = {
    "doors": re.compile(r"door|tür|tuer|porte", re.IGNORECASE),
    "windows": re.compile(r"window|glaz|fenster|fenetre", re.IGNORECASE),
    "openings": re.compile(r"opening|passage", re.IGNORECASE),
    "rooms": re.compile(r"room|space|area|raum|zone", re.IGNORECASE),
}
"""What is on a layer, by words in its name; the first that fits."""

_FLOOR: Final = re.compile(r"(?:^|[-_ ])(?:F|FLOOR|LEVEL)[-_ ]?(-?\d{1,2})(?=$|[-_ ])", re.IGNORECASE)
_MEASURE: Final = re.compile(r"[\d.,\s]*(m2|m²|sqm|qm|sq\.? ?ft|m|mm|cm)?\.?", re.IGNORECASE)
_METRES: Final = 6
_FLAT: Final = 0.005
"""Metres by which curves are drawn straight."""

_UNITLESS: Final = ((500.0, 1.0), (1e6, 0.01))
"""Median area of a room up to which a drawing without units is in metres, and in centimetres."""


@dataclass
class _Storey:
    rooms: list[PlanRoom] = field(default_factory=list)
    shapes: list[Polygon] = field(default_factory=list)
    texts: list[tuple[Point, str]] = field(default_factory=list)
    marks: dict[str, list[Mark]] = field(default_factory=dict)


def plan_from_dxf(file: Path, layers: Mapping[str, str], storey: str = "") -> BuildingPlan:
    """Return the plan that a drawing holds.

    Parameters
    ----------
    file : Path
    layers : mapping of str to str
        Names of layers by what is on them (``rooms``, ``names``, ``doors``, ``windows``, ``openings``), where their own
        names do not tell.
    storey : str
        Number of the one storey that is meant; all when empty.

    Raises
    ------
    MansionError
        ``NOT_FOUND``; ``UNAVAILABLE`` where ezdxf is not installed; ``INVALID_PAYLOAD`` for what is no drawing, or one
        without rooms.
    """
    _check_roles(layers)
    library, drawing = _opened(file)
    entities = list(drawing.modelspace())
    role_of = _roles(entities, layers, file)
    scale = _scale(library, drawing, [e for e in entities if role_of.get(e.dxf.layer) == "rooms"])
    storeys: dict[int, _Storey] = {}
    for entity in entities:
        floor = storeys.setdefault(_floor_of(entity.dxf.layer), _Storey())
        _add(floor, entity, role_of.get(entity.dxf.layer, ""), layers.get("names", ""), scale)
    texts = storeys.get(1, _Storey()).texts
    floors = {number: each for number, each in storeys.items() if each.shapes}
    if not floors:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file}: no closed polyline on {_said(role_of)}")
    if storey:
        names = [str(number) for number in sorted(floors)]
        if storey not in names:
            told = choices(storey, names, "floors")
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file}: there is no floor {storey!r} in it; {told}")
        floors = {1: floors[int(storey)]}
    return BuildingPlan(
        name=file.stem.replace("_", " "), floors=[_floor(number, floors[number], texts) for number in sorted(floors)]
    )


def _check_roles(layers: Mapping[str, str]) -> None:
    known = [*_ROLES, "names"]
    for name in layers:
        if name not in known:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"--layers {name}=...: {choices(name, known, 'kinds')}")


def _opened(file: Path) -> tuple[Any, Any]:
    try:
        library = importlib.import_module("ezdxf")
        recover = importlib.import_module("ezdxf.recover")
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE, "DXF files need the package ezdxf: pip install 'mansion[dxf]'"
        ) from error
    if not file.is_file():
        raise MansionError(ErrorCode.NOT_FOUND, f"{file}: there is no such file; expected a drawing in DXF")
    try:
        return library, library.readfile(str(file))
    except (OSError, UnicodeError, library.DXFError):
        pass
    try:
        return library, recover.readfile(str(file))[0]
    except (OSError, UnicodeError, ValueError, library.DXFError) as error:
        reason = (str(error).strip() or type(error).__name__).splitlines()[0]
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file} is not a DXF file: {reason}") from None


def _roles(entities: Sequence[Any], layers: Mapping[str, str], file: Path) -> dict[str, str]:
    """Return what is on each layer: as it is said, else by its name; on the only layer with polylines are rooms."""
    there = list(dict.fromkeys(entity.dxf.layer for entity in entities))
    for kind, name in layers.items():
        if name not in there:
            told = choices(name, there, "layers")
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file}: nothing is on a layer {name!r} ({kind}); {told}")
    said = {name: kind for kind, name in layers.items()}
    roles = {}
    for name in there:
        kinds = (kind for kind, words in _ROLES.items() if kind not in layers and words.search(name))
        roles[name] = said.get(name) or next(kinds, "")
    if "rooms" not in roles.values():
        drawn = list(dict.fromkeys(e.dxf.layer for e in entities if _is_ring(e) and not roles[e.dxf.layer]))
        if len(drawn) != 1:
            told = f"{file}: it has no closed polyline; draw one around each room, on a layer called rooms"
            if drawn:
                where = ", ".join(drawn)
                told = f"{file}: no layer is called rooms; closed polylines are on {where}: say --layers rooms=NAME"
            raise MansionError(ErrorCode.INVALID_PAYLOAD, told)
        roles[drawn[0]] = "rooms"
    return roles


def _said(roles: Mapping[str, str]) -> str:
    return ", ".join(repr(name) for name, kind in roles.items() if kind == "rooms")


def _is_ring(entity: Any) -> bool:
    return entity.dxftype() in ("LWPOLYLINE", "POLYLINE") and bool(entity.is_closed or _ends_meet(entity))


def _ends_meet(entity: Any) -> bool:
    points = _points(entity, 1.0)
    return len(points) > 3 and Place(points[0]).distance(Place(points[-1])) < 1e-6


def _scale(library: Any, drawing: Any, rooms: Sequence[Any]) -> float:
    """Return the metres of a unit: by ``$INSUNITS``, else by how large rooms are."""
    units = importlib.import_module("ezdxf.units")
    code = int(drawing.header.get("$INSUNITS", 0))
    if code:
        return float(units.conversion_factor(units.InsertUnits(code), units.InsertUnits(_METRES)))
    areas = [Polygon(points).area for room in rooms if _is_ring(room) and len(points := _points(room, 1.0)) > 2]
    typical = statistics.median(areas) if areas else 0.0
    return next((scale for most, scale in _UNITLESS if typical <= most), 0.001)


def _floor_of(layer: str) -> int:
    found = _FLOOR.search(layer)
    return int(found.group(1)) if found else 1


def _points(entity: Any, scale: float) -> list[Point]:
    """Return the corners of a line, a polyline or a curve, metres; none of what has no path."""
    path = importlib.import_module("ezdxf.path")
    try:
        made = path.make_path(entity)
    except (TypeError, ValueError):
        return []
    return [(round(p.x * scale, 5), round(p.y * scale, 5)) for p in made.flattening(_FLAT / scale)]


def _add(floor: _Storey, entity: Any, role: str, names: str, scale: float) -> None:
    """Add an entity to its storey."""
    kind, layer = entity.dxftype(), entity.dxf.layer
    if kind in ("TEXT", "MTEXT", "ATTDEF"):
        if not names or layer == names:
            floor.texts += _text(entity, scale)
        return
    if kind == "INSERT" and not names:
        floor.texts += [text for attribute in entity.attribs for text in _text(attribute, scale)]
    if kind == "INSERT" and not role:
        role = next((each for each in ("doors", "windows") if _ROLES[each].search(entity.dxf.name)), "")
    if role == "rooms" and _is_ring(entity):
        ring = _points(entity, scale)
        ring = ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring
        if len(ring) > 2:
            floor.shapes.append(Polygon(ring))
            floor.rooms.append(PlanRoom(polygon=ring, source=f"handle {entity.dxf.handle}"))
    elif role in ("doors", "windows", "openings"):
        mark = _mark(entity, scale)
        if mark.points:
            floor.marks.setdefault(f"{role} block" if kind == "INSERT" else role, []).append(mark)


def _text(entity: Any, scale: float) -> Iterator[tuple[Point, str]]:
    """Yield a text and where it begins: its first line that is no measure."""
    said = entity.plain_text() if hasattr(entity, "plain_text") else entity.dxf.text
    lines = [line.strip() for line in str(said).splitlines()]
    name = next((line for line in lines if line and not _MEASURE.fullmatch(line)), "")
    if name:
        at = entity.dxf.insert
        yield (float(at.x) * scale, float(at.y) * scale), name[:200]


def _mark(entity: Any, scale: float) -> Mark:
    """Return what an entity, or all of a block, draws of an opening."""
    parts = importlib.import_module("ezdxf.disassemble").recursive_decompose([entity])
    lines, arcs = [], []
    for part in parts:
        points = _points(part, scale)
        if part.dxftype() == "ARC" and points:
            centre = part.ocs().to_wcs(part.dxf.center)
            arcs.append(Arc((float(centre.x) * scale, float(centre.y) * scale), (points[0], points[-1])))
        elif len(points) > 1:
            lines.append(tuple(points))
    return Mark(tuple(lines), tuple(arcs), str(entity.dxf.handle))


def _floor(number: int, storey: _Storey, common: Iterable[tuple[Point, str]]) -> PlanFloor:
    """Return a storey with the names of its rooms, its doors and windows."""
    kept = [k for k, shape in enumerate(storey.shapes) if not _is_outline(k, storey.shapes)]
    shapes = [storey.shapes[k] for k in kept]
    names = _names(shapes, storey.texts or list(common))
    rooms = [
        PlanRoom(name=name, polygon=storey.rooms[k].polygon, source=storey.rooms[k].source)
        for k, name in zip(kept, names)
    ]
    faces = shapely.union_all([MultiLineString([shape.exterior.coords]) for shape in shapes])
    doors = [
        PlanDoor(segment=_rounded(place), kind="double" if is_double(mark) else None, source=f"handle {mark.handle}")
        for mark in _openings(storey, "doors")
        if (place := door_segment(mark, faces)) is not None
    ]
    openings = [
        PlanDoor(segment=_rounded(place), kind="doorway", source=f"handle {mark.handle}")
        for mark in _openings(storey, "openings")
        if (place := window_segment(mark)) is not None
    ]
    windows = [
        PlanWindow(segment=_rounded(place), source=f"handle {mark.handle}")
        for mark in _openings(storey, "windows")
        if (place := window_segment(mark)) is not None
    ]
    return PlanFloor(floor=number, rooms=rooms, doors=doors, openings=openings, windows=windows)


def _openings(storey: _Storey, role: str) -> list[Mark]:
    """Return the openings of a kind: each block is one, loose lines are put together."""
    return [*storey.marks.get(f"{role} block", ()), *joined_marks(storey.marks.get(role, ()), role)]


def _is_outline(number: int, shapes: Sequence[Polygon]) -> bool:
    """Whether a polyline goes around other rooms, as the outline of a dwelling does."""
    around = shapes[number].buffer(0)
    inside = [k for k, shape in enumerate(shapes) if k != number and around.contains(shape.representative_point())]
    return len(inside) > 1 and sum(shapes[k].area for k in inside) > 0.5 * around.area


def _names(shapes: Sequence[Polygon], texts: Iterable[tuple[Point, str]]) -> list[str]:
    """Return the name of each room: the first text in it, and in no smaller one."""
    names = [""] * len(shapes)
    for point, text in texts:
        inside = [k for k, shape in enumerate(shapes) if shape.buffer(0).intersects(Place(point))]
        if inside:
            smallest = min(inside, key=lambda k: shapes[k].area)
            names[smallest] = names[smallest] or text
    return names


def _rounded(segment: Segment) -> Segment:
    (ax, ay), (bx, by) = segment
    return (round(ax, 4), round(ay, 4)), (round(bx, 4), round(by, 4))
