"""Load, validate and extend the knowledge base.

Six files of one format each: ``room_types.csv``, ``room_words.csv``, ``telling_words.csv``, ``building_types.toml``,
``building_groups.toml`` and ``styles.toml``. A user's folder with files of the same names adds records, or replaces
those of the same name.
"""

import csv
import io
import os
import tomllib
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, TypeAlias, get_args

from mansion_knowledge.types import (
    BuildingGroups,
    BuildingType,
    Family,
    Finish,
    Parti,
    RoomEntry,
    RoomType,
    RoomWord,
    Storey,
    Style,
    Zone,
    parse_entry,
)
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["FOLDERS", "KnowledgeBase", "default_knowledge", "load_knowledge"]

FOLDERS = "MANSION_KNOWLEDGE"
"""Environment variable with folders of a user's knowledge, separated as in ``PATH``."""

_DATA = Path(__file__).parent / "data"
_STOREYS = ("single", "ground", "second", "upper", "top", "basement")
_WALLS = ("dry", "wet", "circulation", "industrial")
_FLAGS = ("daylight", "wet", "open", "flex", "unit", "sleeping", "toilet", "food", "common", "whole")
_OWN = ("name", "synonyms", "kin")
"""Cells of a room type that its kin does not fill."""

_FACTS = ("classes", "uses", "keeps", "called")
_LEVELS = ("", "goal", "talk", "loose")


@dataclass(frozen=True, eq=False)
class KnowledgeBase:
    """Room types, words in names of rooms, building types and styles, each by name; groups of building types.

    `telling` maps words to the room type that they suggest before a general noun: a "weights corner" is part of a gym.
    """

    rooms: dict[str, RoomType]
    words: dict[str, RoomWord]
    telling: dict[str, str]
    buildings: dict[str, BuildingType]
    styles: dict[str, Style]
    groups: BuildingGroups

    def room(self, name: str) -> RoomType:
        """Return the room type of that name, or the one most like storage for an unknown name."""
        return self.rooms.get(name) or self.rooms["storage"]

    def is_dwelling(self, building_type: str) -> bool:
        """Whether people live in a building of a type in households; of one that is not known its name tells.

        A nursing home and a media house are none, whatever their names.
        """
        known = self.buildings.get(building_type.lower().replace(" ", "_"))
        by_name = self.groups.is_dwelling(building_type)
        return by_name if known is None else known.family == "home" or (known.family == "lodging" and by_name)


def default_knowledge() -> KnowledgeBase:
    """Return the knowledge base that Mansion ships, with the folders that ``MANSION_KNOWLEDGE`` names; loaded once."""
    return load_knowledge()


def load_knowledge(folders: Sequence[Path] = ()) -> KnowledgeBase:
    """Load the shipped knowledge base and what the user's folders add to it.

    Parameters
    ----------
    folders : sequence of Path
        Each may hold any of the six files. They follow those that the environment variable ``MANSION_KNOWLEDGE``
        names for every stage and export at once; later ones win.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming file, record and fault; ``NOT_FOUND`` for a folder that does not exist.

    Notes
    -----
    Cached for each tuple of folders; a knowledge base is not written to.
    """
    return _load((*_named(os.environ.get(FOLDERS, "")), *folders))


@lru_cache(maxsize=8)
def _named(listed: str) -> tuple[Path, ...]:
    return tuple(Path(name) for name in listed.split(os.pathsep) if name)


@lru_cache(maxsize=8)
def _load(folders: tuple[Path, ...]) -> KnowledgeBase:
    rows: dict[str, tuple[Path, _Row]] = {}
    words: dict[str, RoomWord] = {}
    telling: dict[str, tuple[Path, _Row]] = {}
    buildings: dict[str, BuildingType] = {}
    styles: dict[str, Style] = {}
    groups: dict[str, dict[str, Any]] = {}
    for folder in (_DATA, *folders):
        if not folder.is_dir():
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no knowledge folder {folder}")
        added = _read_rows(folder / "room_types.csv", "name")
        rows = _without_names(rows, _names_of(added)) | added
        words |= {name: _word(file, row) for name, (file, row) in _read_rows(folder / "room_words.csv", "word").items()}
        telling |= _read_rows(folder / "telling_words.csv", "word")
        styles |= _read_styles(folder / "styles.toml")
        own = _read_buildings(folder / "building_types.toml")
        buildings = _without_synonyms(buildings, {name for kind in own.values() for name in kind.synonyms}) | own
        for name, record in _read_toml(folder / "building_groups.toml").items():
            groups[name] = groups.get(name, {}) | record
    known = _rooms(rows)
    knowledge = KnowledgeBase(known, words, _telling(telling, known), buildings, styles, _groups(groups))
    _check_references(knowledge)
    return knowledge


def _fault(file: Path, record: str, what: str) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"knowledge file {file.name}, record {record!r}: {what}",
        details={"file": file.name, "record": record},
    )


_Row: TypeAlias = Mapping[str, str]


def _read_rows(file: Path, key: str) -> dict[str, tuple[Path, _Row]]:
    """Read the rows of a table by name, each with its file; cells that a row lacks are empty."""
    if not file.exists():
        return {}
    rows: dict[str, tuple[Path, _Row]] = {}
    for cells in csv.DictReader(io.StringIO(file.read_text(encoding="utf-8"))):
        row = {column: text for column, text in cells.items() if isinstance(text, str)}
        name = row.get(key) or "?"
        if name in rows:
            raise _fault(file, name, "listed twice")
        rows[name] = (file, row)
    return rows


def _names_of(rows: Mapping[str, tuple[Path, _Row]]) -> dict[str, str]:
    """Return which room type of a file each name and synonym belongs to.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` where two have the same.
    """
    owners = {name.replace("_", " "): name for name in rows}
    for name, (file, row) in rows.items():
        for phrase in _parts(row.get("synonyms", "")):
            owner = owners.setdefault(phrase, name)
            if owner != name:
                raise _fault(file, name, f"{phrase!r} is a name of {owner!r} too; take it out of one of them")
    return owners


def _without_names(rows: Mapping[str, tuple[Path, _Row]], claimed: Container[str]) -> dict[str, tuple[Path, _Row]]:
    """Return rows without the synonyms that a later folder claims for room types of its own."""
    return {
        name: (file, {**row, "synonyms": ";".join(p for p in _parts(row.get("synonyms", "")) if p not in claimed)})
        for name, (file, row) in rows.items()
    }


def _rooms(rows: Mapping[str, tuple[Path, _Row]]) -> dict[str, RoomType]:
    rooms = {}
    for name, (file, row) in rows.items():
        try:
            rooms[name] = _room(_filled(row, rows))
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise _fault(file, name, str(error)) from None
    return rooms


def _filled(row: _Row, rows: Mapping[str, tuple[Path, _Row]]) -> _Row:
    """Return a row whose empty cells are those of its kin, or of the kin of that."""
    lineage = [row.get("name", "")]
    filled, kin = dict(row), row.get("kin")
    while kin:
        if kin not in rows:
            raise ValueError(f"kin {kin!r} is not a room type")
        if kin in lineage:
            raise ValueError(f"{' -> '.join([*lineage, kin])} is kin of itself")
        lineage.append(kin)
        other = rows[kin][1]
        filled |= {column: text for column, text in other.items() if column not in _OWN and not filled.get(column)}
        kin = other.get("kin")
    return filled


def _room(row: _Row) -> RoomType:
    least, usual, most = (float(row[key]) for key in ("least", "usual", "most"))
    if not 1.0 <= least <= usual <= most:
        raise ValueError(f"areas must be 1 <= least <= usual <= most, not {least}, {usual}, {most}")
    flags = row.get("flags", "").split()
    for flag in flags:
        if flag not in _FLAGS:
            raise ValueError(f"flag {flag!r} is not one of {', '.join(_FLAGS)}")
    return RoomType(
        name=row["name"],
        least=least,
        usual=usual,
        most=most,
        zone=_one_of(Zone, row["zone"]),
        storey=_one_of(Storey, row["floors"]),
        finish=_one_of(Finish, row["finish"]),
        synonyms=_parts(row.get("synonyms", "")),
        near=_parts(row.get("near", "")),
        daylight="daylight" in flags,
        wet="wet" in flags,
        open="open" in flags,
        flexible="flex" in flags,
        unit="unit" in flags,
        sleeping="sleeping" in flags,
        toilet="toilet" in flags,
        food="food" in flags,
        common="common" in flags,
        whole="whole" in flags,
        suite=tuple(parse_entry(part) for part in _parts(row.get("suite", ""))),
        kin=row.get("kin", ""),
        suggests=row.get("suggests", ""),
        counts_as=row.get("counts_as") or row["name"],
        stack=int(row.get("stack") or 0),
    )


def _telling(rows: Mapping[str, tuple[Path, _Row]], rooms: Container[str]) -> dict[str, str]:
    for word, (file, row) in rows.items():
        if row.get("room_type") not in rooms:
            raise _fault(file, word, f"{row.get('room_type', '')!r} is not a room type")
    return {word: row["room_type"] for word, (_, row) in rows.items()}


def _word(file: Path, row: _Row) -> RoomWord:
    classes, uses, keeps, called = (tuple(row.get(fact, "").split()) for fact in _FACTS)
    groups = []
    for text in called:
        group, _, level = text.partition(":")
        if level not in _LEVELS:
            raise _fault(file, row.get("word", "?"), f"{text!r} is not a group of names or GROUP:goal, :talk or :loose")
        groups.append((group, level))
    return RoomWord(
        word=row.get("word", ""),
        like=row.get("like", ""),
        classes=classes,
        colour=row.get("colour", ""),
        thor=row.get("thor", ""),
        uses=uses,
        keeps=keeps,
        called=tuple(groups),
    )


def _parts(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(";") if part.strip())


def _one_of(kind: Any, value: Any) -> Any:
    choices = get_args(kind)
    if value not in choices:
        raise ValueError(f"{value!r} is not one of {', '.join(choices)}")
    return value


def _read_toml(file: Path) -> dict[str, Any]:
    if not file.exists():
        return {}
    try:
        records = tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeError) as error:
        raise _fault(file, "", str(error)) from None
    return {name: _like_another(file, name, record, records) for name, record in records.items()}


def _like_another(file: Path, name: str, record: Any, records: dict[str, Any]) -> Any:
    """Fill a record with what the one that its ``like`` names has; synonyms are its own."""
    if not isinstance(record, dict) or "like" not in record:
        return record
    other = records.get(record["like"])
    if not isinstance(other, dict) or "like" in other:
        raise _fault(file, name, f"like = {record['like']!r} must name a record of the same file without a `like`")
    return {"synonyms": []} | {key: value for key, value in other.items() if key != "synonyms"} | record


def _read_styles(file: Path) -> dict[str, Style]:
    styles: dict[str, Style] = {}
    for name, record in _read_toml(file).items():
        try:
            floors, walls = dict(record["floors"]), dict(record["walls"])
            missing = [key for key in get_args(Finish) if key not in floors]
            missing += [key for key in _WALLS if key not in walls]
            if missing:
                raise ValueError(f"no material for {', '.join(missing)}")
            styles[name] = Style(
                name, tuple(record.get("synonyms", ())), floors, walls, like=str(record.get("like", ""))
            )
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


def _without_synonyms(buildings: Mapping[str, BuildingType], claimed: Container[str]) -> dict[str, BuildingType]:
    """Return building types without the synonyms that a later folder claims for its own."""
    return {
        name: replace(kind, synonyms=tuple(phrase for phrase in kind.synonyms if phrase not in claimed))
        for name, kind in buildings.items()
    }


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
    seats, places = record.get("seats") or record.get("beds"), record.get("places")
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
        places=parse_entry(places) if places else None,
        place=str(record.get("place", "")),
        filler=tuple(str(name) for name in record.get("filler", ())),
        stretcher=bool(record.get("stretcher", False)),
        like=str(record.get("like", "")),
        heads=tuple(str(head) for head in record.get("heads", ())),
        main=frozenset(str(name) for name in record.get("main", ())),
        needed=frozenset(str(name) for name in record["needed"]) if "needed" in record else None,
        small=float(record.get("small", 0.0)),
    )


def _groups(record: Mapping[str, Any]) -> BuildingGroups:
    try:
        return BuildingGroups(
            filler={
                family if family == "other" else _one_of(Family, family): tuple(rooms)
                for family, rooms in record["filler"].items()
            },
            dwellings=frozenset(record["dwelling"]["words"]),
            facades={
                name: (frozenset(facade["words"]), tuple(facade["materials"]))
                for name, facade in record["facade"].items()
            },
            roofs={
                name: (frozenset(roof["words"]), tuple(roof["forms"]))
                for name, roof in record["roof"].items()
                if name != "flat"
            },
            outside={
                name: (frozenset(group["words"]), tuple(group["shows"])) for name, group in record["outside"].items()
            },
            flat_styles=frozenset(record["roof"]["flat"]),
            style_facades={name: tuple(materials) for name, materials in record["facade_of_style"].items()},
            trims={name: (str(plinth), str(surround)) for name, (plinth, surround) in record.get("trims", {}).items()},
            room_of={str(noun): str(room) for noun, room in record.get("room_of", {}).items()},
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise _fault(Path("building_groups.toml"), "", str(error)) from None


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
        check(room.name, [RoomEntry(name) for name in (*room.near, room.counts_as)])
        if room.suggests and room.suggests not in knowledge.buildings:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"knowledge record {room.name!r} names the unknown building type {room.suggests!r}",
                details={"record": room.name, "building_type": room.suggests},
            )
    for family, fillers in knowledge.groups.filler.items():
        check(family, [RoomEntry(name) for name in fillers])
    check("room_of", [RoomEntry(name) for name in knowledge.groups.room_of.values()])
    for building in knowledge.buildings.values():
        check(building.name, [RoomEntry(building.hub), RoomEntry(building.hub_upper)])
        for entries in building.storeys.values():
            check(building.name, entries)
        check(
            building.name,
            [RoomEntry(name) for name in (*building.filler, *sorted(building.main | (building.needed or set())))],
        )
        check(building.name, [entry for entry in (building.seats, building.places) if entry is not None])
        if building.style not in knowledge.styles:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"knowledge record {building.name!r} names the unknown style {building.style!r}",
                details={"record": building.name},
            )
