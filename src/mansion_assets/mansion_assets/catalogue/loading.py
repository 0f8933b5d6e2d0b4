"""The loader of the catalogue: the package's data files and those of user folders."""

import os
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, Final, TypeVar

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.preferred_folders import preferred_folders
from mansion_assets.catalogue.receptacles import receptacles_of
from mansion_assets.catalogue.records import Arrangement, AssetRecord, CategoryRecord, Item, RoomRecord
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["DATA", "FOLDERS", "PIECES", "load_catalogue"]

DATA = Path(__file__).parent / "data"

PIECES: Final = ".pieces.json"
"""How the name of a file of convex pieces ends."""

T = TypeVar("T")


class _ThorTable(msgspec.Struct, frozen=True, kw_only=True):
    types: dict[str, list[tuple[str, float, float, float, str]]]


FOLDERS = "MANSION_CATALOGUE"
"""Environment variable with folders of a user's assets and room types, separated as in ``PATH``."""


def load_catalogue(extra: Sequence[Path] | None = None, *, preferred: Sequence[Path] | None = None) -> Catalogue:
    """Return the catalogue, with the assets and room types of user folders added.

    Parameters
    ----------
    extra : sequence of Path
        Folders with ``assets/*.json`` (one `AssetRecord` each, its GLB beside it), ``rooms/*.json`` (one `RoomRecord`
        each) and ``arrangements/*.json`` (one `Arrangement` each). A record replaces the package's of the same name.
        By default the folders that the environment variable ``MANSION_CATALOGUE`` names, so that every stage and
        export sees the same assets.
    preferred : sequence of Path
        Such folders whose assets come before others of their categories. Where neither is given, those of the context
        (`preferring`).

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a missing folder or GLB, ``INVALID_PAYLOAD`` with file and JSON path for a bad record.

    Notes
    -----
    Cached for each tuple of folders until a file is put into one; a catalogue is not written to.
    """
    if preferred is None:
        preferred = preferred_folders() if extra is None else ()
    if extra is None:
        extra = [Path(name) for name in os.environ.get(FOLDERS, "").split(os.pathsep) if name]
    first = tuple(Path(folder).resolve() for folder in preferred)
    others = tuple(folder for folder in (Path(folder).resolve() for folder in extra) if folder not in first)
    return _load(others, first, tuple(_stamp(folder) for folder in (*others, *first)))


_KINDS: Final = ("assets", "rooms", "arrangements")
"""Folders of a user's folder that hold records."""


def _stamp(folder: Path) -> tuple[int, ...]:
    """Return what tells a folder's content from an earlier one: files are put there by renaming them."""
    if not folder.is_dir():
        raise MansionError(ErrorCode.NOT_FOUND, f"no catalogue folder {folder}")
    return tuple(_changed(folder / kind) for kind in _KINDS)


def _changed(folder: Path) -> int:
    try:
        return folder.stat().st_mtime_ns
    except OSError:
        return 0


@lru_cache(maxsize=8)
def _load(extra: tuple[Path, ...], preferred: tuple[Path, ...], stamps: tuple[tuple[int, ...], ...]) -> Catalogue:
    records = [r for file in _files(DATA / "categories") for r in _read(list[CategoryRecord], file)]
    rooms = [r for file in _files(DATA / "rooms") for r in _read(list[RoomRecord], file)]
    arrangements = _read(list[Arrangement], DATA / "arrangements.json")
    own: list[tuple[Path, AssetRecord]] = []
    for folder in (*extra, *preferred):
        own += [(file, _read(AssetRecord, file)) for file in _files(folder / "assets")]
        rooms += [_read(RoomRecord, file) for file in _files(folder / "rooms")]
        arrangements += [_read(Arrangement, file) for file in _files(folder / "arrangements")]
    rooms = _with_user_assets(rooms, [record for _, record in own])
    used = _rooms_of_categories(rooms)
    thor = _read(_ThorTable, DATA / "thor.json").types
    assets = [a for record in records for a in _expand(record, thor, used.get(record.category, ()))]
    assets += [_user_asset(file, record, used.get(record.category, ())) for file, record in own]
    first = frozenset(record.key for file, record in own if file.parent.parent in preferred)
    return Catalogue(assets, rooms, arrangements, preferred=first)


def _files(folder: Path) -> list[Path]:
    """Return the records of a folder; files of pieces, which they name, are none."""
    found = folder.glob("*.json") if folder.is_dir() else ()
    return sorted(file for file in found if not file.name.endswith(PIECES))


def _read(kind: type[T], file: Path) -> T:
    try:
        return decode(kind, file.read_bytes())
    except MansionError as error:
        raise MansionError(
            error.code, f"{file.name}: {error.info.message}", path=error.info.path, details={"file": str(file)}
        ) from None


def _expand(
    record: CategoryRecord, thor: dict[str, list[tuple[str, float, float, float, str]]], rooms: tuple[str, ...]
) -> list[Asset]:
    """Return the assets of a category: AI2-THOR's first, then our own variants."""
    out: list[Asset] = []
    rows = thor.get(record.thor, ()) if record.thor else ()
    for number, (asset_id, w, d, h, flags) in enumerate(rows):
        if record.thor_match in asset_id:
            out.append(_variant(record, number, asset_id, (w, d, h), rooms, flags))
    count = max(len(record.sizes), len(record.finishes)) if record.sizes else 0
    for number in range(count):
        size = record.sizes[number % len(record.sizes)]
        out.append(_variant(record, number, f"{record.category}_{number + 1}", size, rooms, None))
    return out


def _variant(
    record: CategoryRecord,
    number: int,
    key: str,
    size: tuple[float, float, float],
    rooms: tuple[str, ...],
    flags: str | None,
) -> Asset:
    size = (max(size[0], 0.003), max(size[1], 0.003), max(size[2], 0.003))
    surfaces, volumes = receptacles_of(record.recipe, size, record.parameters)
    materials = dict(record.materials)
    if record.finishes:
        materials["main"] = record.finishes[number % len(record.finishes)]
    return Asset(
        key=key,
        category=record.category,
        name=record.name or record.category.replace("_", " "),
        size=size,
        synonyms=tuple(record.synonyms),
        asset_id=None if flags is None else key,
        thor_type="" if flags is None else record.thor,
        mount=record.mount,
        pickupable=record.pickupable if flags is None else "p" in flags,
        receptacle=bool(surfaces or volumes),
        openable=record.openable if flags is None else "o" in flags,
        toggleable=record.toggleable if flags is None else "t" in flags,
        surfaces=surfaces,
        volumes=volumes,
        rooms=rooms,
        materials=materials,
        recipe=record.recipe,
        parameters=record.parameters,
        tags=tuple(record.tags),
    )


def _user_asset(file: Path, record: AssetRecord, rooms: tuple[str, ...]) -> Asset:
    glb = _file_beside(file, record.glb, "GLB file", "$.glb")
    pieces = _file_beside(file, record.pieces, "file of pieces", "$.pieces")
    if glb is None and not record.recipe:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{file.name}: an asset needs `glb` or `recipe`",
            path="$.glb",
            details={"file": str(file)},
        )
    surfaces, volumes = tuple(record.surfaces), tuple(record.volumes)
    if record.recipe and not surfaces and not volumes:
        surfaces, volumes = receptacles_of(record.recipe, record.size, record.parameters)
    return Asset(
        key=record.key,
        category=record.category,
        name=record.name or record.category.replace("_", " "),
        size=record.size,
        synonyms=tuple(record.synonyms),
        asset_id=record.asset_id,
        mount=record.mount,
        pickupable=record.pickupable,
        receptacle=bool(surfaces or volumes),
        openable=record.openable or bool(record.joints),
        toggleable=record.toggleable,
        surfaces=surfaces,
        volumes=volumes,
        rooms=tuple(sorted({*rooms, *record.rooms})),
        materials=record.materials,
        recipe=record.recipe,
        parameters=record.parameters,
        glb=glb,
        tags=tuple(record.tags),
        joints=tuple(record.joints),
        pieces=pieces,
        mass=record.mass,
        source=record.source,
        author=record.author,
        licence=record.licence,
        sha256=record.sha256,
        record=str(file),
    )


def _file_beside(record: Path, name: str | None, what: str, place: str) -> str | None:
    if name is None:
        return None
    path = (record.parent / name).resolve()
    if not path.is_file():
        raise MansionError(
            ErrorCode.NOT_FOUND, f"{record.name}: no {what} {name}", path=place, details={"file": str(record)}
        )
    return str(path)


def _with_user_assets(rooms: list[RoomRecord], assets: list[AssetRecord]) -> list[RoomRecord]:
    """Add one floor item for each user asset to the room types that it names."""
    out = {room.room_type: room for room in rooms}
    for record in assets:
        if record.mount != "floor":
            continue
        for name in record.rooms:
            room = out.get(name)
            if room is None or any(i.category == record.category for i in room.floor or ()):
                continue
            item = Item(name=record.category, category=record.category, global_="edge")
            out[name] = msgspec.structs.replace(room, floor=[*(room.floor or []), item])
    return list(out.values())


def _rooms_of_categories(rooms: list[RoomRecord]) -> dict[str, tuple[str, ...]]:
    used: dict[str, dict[str, None]] = {}
    for room in rooms:
        items: list[Any] = [*(room.floor or ()), *(room.wall or ()), *(room.ceiling or ())]
        for item in items:
            names = [item.category] if isinstance(item.category, str) else item.category
            for name in names:
                used.setdefault(name, {})[room.room_type] = None
    return {category: tuple(sorted(types)) for category, types in used.items()}
