"""The floor that furniture needs which a brief wants in a room without a stated area."""

from collections.abc import Sequence

from mansion_knowledge.object_kinds import added_for, answers
from mansion_msgs_py.late_imports import importing
from mansion_planner.brief.facts import ObjectFact, RoomFact

__all__ = ["furniture_area", "furniture_areas", "usual_number", "usually_has"]

_BESIDE, _BEFORE = 0.5, 0.9
"""Free floor beside and before a piece, metres."""

_PACKED = 0.75
"""Share of a room's floor that its furniture covers with the free floor around it."""

_ROW, _TABLE, _PAIRED = 1.3, 2.3, 2.6
"""Floor of a seat in a row, at a table, and at a desk of its own, square metres."""

_ABREAST, _LEGS = 0.15, 0.6
"""Free floor beside and before a seat that stands among others, metres."""

_AT_ASKED_TABLE = 1.1
"""Floor of a seat besides that of the table that is asked for with it, square metres."""

_ANY = "room"
"""A room of no particular type."""

_REST = 4.0
"""Floor for the other furniture of such a room, square metres."""


def furniture_areas(rooms: Sequence[RoomFact], objects: Sequence[ObjectFact]) -> dict[str, float]:
    """Return the square metres that the wanted furniture needs in each such room, by the room's name.

    The empty name is for furniture that the brief wants in no particular room.
    """
    counts = {"": 1} | {room.name: room.count or 2 for room in rooms}
    types = {"": _ANY} | {room.name: room.room_type for room in rooms}
    out: dict[str, float] = {}
    for name in types:
        wanted = [o for o in objects if o.room == name and o.category and not o.excluded]
        total = sum(
            _piece(o, types[name], wanted) * _share(o, counts[name])
            for number, o in enumerate(wanted)
            if o not in wanted[:number]
        )
        if total > 0.0:
            out[name] = total + _REST
    return out


def furniture_area(room_type: str, wanted: ObjectFact) -> float:
    """Return the square metres of a room of a type that has one kind of furniture asked for, all of it."""
    return _piece(wanted, room_type, [wanted]) * (wanted.count or 2) + _REST


def _share(wanted: ObjectFact, rooms: int) -> float:
    """Return how many pieces one of the rooms gets."""
    count = 2 if wanted.count is None else wanted.count
    return count if wanted.each or count == 1 else -(-count // rooms)


def _piece(wanted: ObjectFact, room_type: str, others: Sequence[ObjectFact]) -> float:
    """Return the floor that one piece needs in a room of a type."""

    if answers("chair", wanted.category):
        if any(answers(table, o.category) for o in others for table in ("dining_table", "desk")):
            return _AT_ASKED_TABLE
        return _seat(room_type, wanted.category)
    width, depth = _typical_size(room_type, wanted.category)
    return (width + _BESIDE) * (depth + _BEFORE) / _PACKED if width else 0.0


def _typical_size(room_type: str, category: str) -> tuple[float, float]:
    """Return width and depth of the middle one, by size, of what answers for a category; (0, 0) for nothing on floors.

    The room's own furniture comes first: a desk of an office is an office desk.
    """
    with importing:
        from mansion_assets.catalogue import load_catalogue

    catalogue = load_catalogue()
    own = [
        [
            name
            for name in ([item.category] if isinstance(item.category, str) else item.category)
            if answers(category, name)
        ]
        for item in catalogue.room_program(room_type).floor
    ]
    names = next((names for names in own if names), [added_for(category)])
    assets = [asset for asset in catalogue.choose_from(names) if asset.mount == "floor" and asset.recipe != "rug"]
    assets.sort(key=lambda asset: (asset.footprint, asset.key))
    return assets[len(assets) // 2].size[:2] if assets else (0.0, 0.0)


def _seat(room_type: str, category: str) -> float:
    """Return the floor of a seat as rooms of the type have them."""
    with importing:
        from mansion_assets.catalogue import load_catalogue

    catalogue = load_catalogue()
    for item in catalogue.room_program(room_type).floor:
        names = [item.category] if isinstance(item.category, str) else item.category
        if not any(answers("chair", name) and answers(category, name) for name in names):
            continue
        if any(asset.recipe == "seat_row" for asset in catalogue.choose_from(names)):
            return _ROW
        if item.paired:
            return _PAIRED
        if any(relation.kind == "around" for relation in item.relative):
            return _TABLE
    width, depth = _typical_size(room_type, category)
    return (width + _ABREAST) * (depth + _LEGS) / _PACKED


def usually_has(room_type: str, category: str) -> bool:
    """Whether rooms of a type have furniture of a category, or that answers for it, without being asked."""
    with importing:
        from mansion_assets.catalogue import load_catalogue

    card = load_catalogue().room_program(room_type)
    held = [item.category for item in card.floor] + [item.category for item in card.rugs]
    held += [item.category for item in (*card.wall, *card.ceiling)]
    names = [name for one in held for name in ([one] if isinstance(one, str) else one)]
    return any(answers(category, name) for name in names)


def usual_number(room_type: str, category: str, area: float) -> float:
    """Return about how many pieces of a category rooms of a type and an area (m2) have without being asked."""
    with importing:
        from mansion_assets.catalogue import load_catalogue

    card = load_catalogue().room_program(room_type)
    numbers: dict[str, float] = {}
    most = 0.0
    for item in card.floor:
        count = item.count
        if isinstance(count, int):
            number = float(count)
        elif count.each:
            number = numbers.get(count.each, 0.0) * count.times
        else:
            number = (count.min + count.max) / 2 if count.per is None else area / count.per
            number = min(max(number, count.min), count.max)
        numbers[item.name] = number = numbers.get(item.paired, number)
        names = [item.category] if isinstance(item.category, str) else item.category
        if item.min_area <= area and any(answers(category, name) for name in names):
            most = max(most, number)
    return most
