"""Load, validate and extend the knowledge base.

Three files of one format each: ``room_types.csv``, ``building_types.toml`` and ``styles.toml``. A user's folder with
files of the same names adds records, or replaces those of the same name.
"""

import csv
import io
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, get_args

from mansion_knowledge.types import (
    BuildingType,
    Family,
    Finish,
    Parti,
    RoomEntry,
    RoomType,
    Storey,
    Style,
    Zone,
    parse_entry,
)
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["KnowledgeBase", "default_knowledge", "load_knowledge"]

_DATA = Path(__file__).parent / "data"
_STOREYS = ("single", "ground", "second", "upper", "top", "basement")
_WALLS = ("dry", "wet", "circulation", "industrial")
_FLAGS = ("daylight", "wet", "open", "flex", "unit")


@dataclass(frozen=True)
class KnowledgeBase:
    """Room types, building types and styles by name."""

    rooms: dict[str, RoomType]
    buildings: dict[str, BuildingType]
    styles: dict[str, Style]

    def room(self, name: str) -> RoomType:
        """Return the room type of that name, or the one most like storage for an unknown name."""
        return self.rooms.get(name) or self.rooms["storage"]


@cache
def default_knowledge() -> KnowledgeBase:
    """Return the knowledge base that Mansion ships, loaded once."""
    return load_knowledge()


def load_knowledge(folders: Sequence[Path] = ()) -> KnowledgeBase:
    """Load the shipped knowledge base and what the user's folders add to it.

    Parameters
    ----------
    folders : sequence of Path
        Each may hold ``room_types.csv``, ``building_types.toml`` and ``styles.toml``; later ones win.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming file, record and fault; ``NOT_FOUND`` for a folder that does not exist.
    """
    rooms: dict[str, RoomType] = {}
    buildings: dict[str, BuildingType] = {}
    styles: dict[str, Style] = {}
    for folder in (_DATA, *folders):
        if not folder.is_dir():
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no knowledge folder {folder}")
        rooms |= _read_rooms(folder / "room_types.csv")
        styles |= _read_styles(folder / "styles.toml")
        buildings |= _read_buildings(folder / "building_types.toml")
    knowledge = KnowledgeBase(rooms, buildings, styles)
    _check_references(knowledge)
    return knowledge


def _fault(file: Path, record: str, what: str) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"knowledge file {file.name}, record {record!r}: {what}",
        details={"file": file.name, "record": record},
    )


def _read_rooms(file: Path) -> dict[str, RoomType]:
    if not file.exists():
        return {}
    rooms: dict[str, RoomType] = {}
    for row in csv.DictReader(io.StringIO(file.read_text(encoding="utf-8"))):
        name = row.get("name") or "?"
        try:
            room = _room(row)
        except (TypeError, ValueError, AttributeError) as error:
            raise _fault(file, name, str(error)) from None
        if name in rooms:
            raise _fault(file, name, "listed twice")
        rooms[name] = room
    return rooms


def _room(row: dict[str, str]) -> RoomType:
    least, usual, most = (float(row[key]) for key in ("least", "usual", "most"))
    if not 1.0 <= least <= usual <= most:
        raise ValueError(f"areas must be 1 <= least <= usual <= most, not {least}, {usual}, {most}")
    flags = row["flags"].split()
    for flag in flags:
        if flag not in _FLAGS:
            raise ValueError(f"flag {flag!r} is none of {', '.join(_FLAGS)}")
    return RoomType(
        name=row["name"],
        least=least,
        usual=usual,
        most=most,
        zone=_one_of(Zone, row["zone"]),
        storey=_one_of(Storey, row["floors"]),
        finish=_one_of(Finish, row["finish"]),
        synonyms=_parts(row["synonyms"]),
        near=_parts(row["near"]),
        daylight="daylight" in flags,
        wet="wet" in flags,
        open="open" in flags,
        flexible="flex" in flags,
        unit="unit" in flags,
        suite=tuple(parse_entry(part) for part in _parts(row["suite"])),
    )


def _parts(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(";") if part.strip())


def _one_of(kind: Any, value: Any) -> Any:
    choices = get_args(kind)
    if value not in choices:
        raise ValueError(f"{value!r} is none of {', '.join(choices)}")
    return value


def _read_toml(file: Path) -> dict[str, Any]:
    if not file.exists():
        return {}
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeError) as error:
        raise _fault(file, "", str(error)) from None


def _read_styles(file: Path) -> dict[str, Style]:
    styles: dict[str, Style] = {}
    for name, record in _read_toml(file).items():
        try:
            floors, walls = dict(record["floors"]), dict(record["walls"])
            missing = [key for key in get_args(Finish) if key not in floors]
            missing += [key for key in _WALLS if key not in walls]
            if missing:
                raise ValueError(f"no material for {', '.join(missing)}")
            styles[name] = Style(name, tuple(record.get("synonyms", ())), floors, walls)
        except (KeyError, TypeError, ValueError) as error:
            raise _fault(file, name, str(error)) from None
    return styles


def _read_buildings(file: Path) -> dict[str, BuildingType]:
    buildings: dict[str, BuildingType] = {}
    for name, record in _read_toml(file).items():
        try:
            buildings[name] = _building(name, record)
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise _fault(file, name, str(error)) from None
    return buildings


def _building(name: str, record: dict[str, Any]) -> BuildingType:
    floors = tuple(int(value) for value in record["floors"])
    areas = tuple(float(value) for value in record["floor_area"])
    if len(floors) != 2 or not 1 <= floors[0] <= floors[1]:
        raise ValueError(f"floors must be [usual, most], not {list(floors)}")
    if len(areas) != 2 or not 15.0 <= areas[0] <= areas[1]:
        raise ValueError(f"floor_area must be [least, usual], not {list(areas)}")
    storeys = {key: tuple(parse_entry(entry) for entry in record[key]) for key in _STOREYS if key in record}
    if "single" not in storeys:
        raise ValueError('has no "single" storey')
    seats = record.get("seats") or record.get("beds")
    return BuildingType(
        name=name,
        synonyms=tuple(record.get("synonyms", ())),
        family=_one_of(Family, record["family"]),
        floors=(floors[0], floors[1]),
        floor_area=(areas[0], areas[1]),
        hub=record["hub"],
        hub_upper=record.get("hub_upper", record["hub"]),
        parti=_one_of(Parti, record["parti"]),
        height=float(record.get("height", 3.3)),
        style=record.get("style", "neutral"),
        people=float(record["people"]),
        storeys=storeys,
        seats=parse_entry(seats) if seats else None,
        stretcher=bool(record.get("stretcher", False)),
    )


def _check_references(knowledge: KnowledgeBase) -> None:
    """Every room type and style that a record names must exist."""

    def check(record: str, entries: Sequence[RoomEntry]) -> None:
        for entry in entries:
            if entry.room_type not in knowledge.rooms:
                raise MansionError(
                    ErrorCode.INVALID_PAYLOAD,
                    f"knowledge record {record!r} names the unknown room type {entry.room_type!r}",
                    details={"record": record, "room_type": entry.room_type},
                )

    for room in knowledge.rooms.values():
        check(room.name, room.suite)
        check(room.name, [RoomEntry(name) for name in room.near])
    for building in knowledge.buildings.values():
        check(building.name, [RoomEntry(building.hub), RoomEntry(building.hub_upper)])
        for entries in building.storeys.values():
            check(building.name, entries)
        if building.seats is not None:
            check(building.name, [building.seats])
        if building.style not in knowledge.styles:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"knowledge record {building.name!r} names the unknown style {building.style!r}",
                details={"record": building.name},
            )
