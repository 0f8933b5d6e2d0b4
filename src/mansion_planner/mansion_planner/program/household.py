"""The rooms of a dwelling or another unit: those that the brief states, and what it needs besides."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_knowledge import KnowledgeBase, RoomEntry, RoomType
from mansion_planner.brief.facts import RoomFact

__all__ = ["FOR_VISITORS", "STUDIO", "household_of", "is_whole", "main_room", "private_types", "use_of"]

_SMALL, _LARGE = 48.0, 95.0
"""Square metres below which a dwelling has one bedroom by default, and from which on it has three."""

FOR_VISITORS = "guest_room"
"""The room type in which nobody of a household sleeps."""

_LIVING = "living_room"
_DWELLING = "apartment"


def _need(kind: RoomType) -> str:
    """Return what a room serves in a household, of which each has one at least: sleeping, cooking, washing."""
    if kind.counts_as == "bedroom":
        return "sleeping"
    if kind.name.endswith("kitchen") or kind.counts_as == "kitchen":
        return "cooking"
    if kind.name in ("bathroom", "ensuite_bathroom"):
        return "washing"
    return ""


STUDIO = "studio_room"
"""The room type in which people both live and sleep."""

_TO_LIVE_IN = frozenset({"living_room", "lounge", "common_room", STUDIO})


def use_of(kind: RoomType) -> str:
    """Return which of the four things that no home does without a room serves: living, sleeping, cooking, washing."""
    return "living" if kind.name in _TO_LIVE_IN else _need(kind)


def is_whole(fact: RoomFact, knowledge: KnowledgeBase) -> bool:
    """Whether the area stated for a unit is that of all its rooms, rather than of a hotel room without its bathroom."""
    return fact.unit and not knowledge.room(fact.room_type).sleeping and fact.room_type != "hotel_suite"


def main_room(fact: RoomFact, knowledge: KnowledgeBase) -> RoomFact | None:
    """Return the stated living room of a dwelling, which is its main room, or none."""
    if not knowledge.room(fact.room_type).unit and fact.room_type not in ("hotel_suite", "common_room"):
        return None
    return next((child for child in fact.suite if child.room_type == _LIVING), None)


def household_of(fact: RoomFact, knowledge: KnowledgeBase) -> tuple[list[RoomFact], list[RoomEntry]]:
    """Return the rooms besides the main one that a unit holds: as stated, and what it has by default.

    A default room is left out where the brief states one that serves the same; a dwelling of any sort has a place to
    cook and one to wash.
    """
    kind = knowledge.room(fact.room_type)
    main = main_room(fact, knowledge)
    stated = [child for child in fact.suite if child is not main]
    needs = {_need(knowledge.room(child.room_type)) for child in stated}
    usual: Sequence[RoomEntry] = kind.suite
    if not kind.unit and "sleeping" in needs:
        usual = knowledge.room(_DWELLING).suite
    added = [entry for entry in usual if _need(knowledge.room(entry.room_type)) not in needs]
    return stated, _for_area(added, fact.area, knowledge)


def _for_area(entries: list[RoomEntry], area: float | None, knowledge: KnowledgeBase) -> list[RoomEntry]:
    """Return default rooms with as many bedrooms as suit the area of a dwelling."""
    beds = [entry for entry in entries if _need(knowledge.room(entry.room_type)) == "sleeping"]
    if area is None or not beds:
        return entries
    others = [entry for entry in entries if entry not in beds]
    if area < _SMALL:
        return [replace(beds[0], count=1), *others]
    return [*beds, *beds[:1], *others] if area >= _LARGE else entries


def _is_dwelling(fact: RoomFact, knowledge: KnowledgeBase) -> bool:
    inner = (knowledge.room(child.room_type) for child in fact.suite)
    return knowledge.room(fact.room_type).unit or any(_need(kind) == "sleeping" for kind in inner)


def private_types(facts: Sequence[RoomFact], knowledge: KnowledgeBase) -> set[str]:
    """Return the room types that a storey with dwellings does not add outside them: where people sleep, cook and wash.

    Beside a single dwelling there may be rooms for guests; several are what their storey is for.
    """
    dwellings = [fact for fact in facts if fact.unit and _is_dwelling(fact, knowledge)]
    if not dwellings:
        return set()
    several = len(dwellings) > 1
    return {name for name, kind in knowledge.rooms.items() if _need(kind) or (several and kind.sleeping)}
