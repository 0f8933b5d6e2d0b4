"""A building of one room for a brief that asks for a room and names no building: "a classroom with 20 desks"."""

import math
from dataclasses import replace

from shapely.geometry import Polygon, box

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_planner.brief.facts import BriefFacts, ObjectFact, RoomFact
from mansion_planner.program.furniture_areas import furniture_areas

__all__ = ["as_lone_room", "lone_outline", "lone_room"]

_LARGEST = 1200.0
"""Most square metres of a building of one room."""


def lone_room(facts: BriefFacts, knowledge: KnowledgeBase) -> RoomFact | None:
    """Return the one room that a brief asks for, if it asks for nothing else and names no building.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> from mansion_planner.brief import read_brief
    >>> base = default_knowledge()
    >>> lone_room(read_brief("a classroom with 20 desks", base), base).room_type
    'classroom'
    >>> lone_room(read_brief("a house with a classroom", base), base) is None
    True
    """
    named = facts.building or facts.building_name or facts.uses or facts.trades or facts.households
    storeys = facts.basements or facts.copies or any(floors.value > 1 for floors in facts.floors)
    stairs = any(not name.startswith("no_") for name, _ in facts.vertical)
    if named or storeys or stairs or facts.adjacent or facts.apart or len(facts.rooms) != 1:
        return None
    room = facts.rooms[0]
    kind = knowledge.room(room.room_type)
    placed = any((ref.kind, ref.last) != ("number", 1) for ref in room.floors)
    suite = kind.suite and not room.suite  # a hotel room has a bathroom, and with it a hotel around it
    several = room.count != 1 or room.unit or kind.unit or suite
    return None if several or placed or not room.known or kind.zone == "circulation" else room


def as_lone_room(
    building: BuildingType, facts: BriefFacts, room: RoomFact, knowledge: KnowledgeBase
) -> tuple[BuildingType, BriefFacts]:
    """Return a building that is the room, with what the brief says that the room has for itself, and the facts of it.

    Parameters
    ----------
    building : BuildingType
        The one that such a room suggests.
    """
    kind = knowledge.room(room.room_type)
    furniture = furniture_areas([room], [_in_room(thing, room) for thing in facts.objects]).get(room.name, 0.0)
    area = room.area or (None if room.suite else next((quantity.value for quantity in facts.area), None))
    beside = sum((child.area or knowledge.room(child.room_type).usual) * (child.count or 1) for child in room.suite)
    usual = min((area or max(kind.usual, furniture)) + beside, _LARGEST)
    alone = replace(
        building, floors=(1, 1), floor_area=(usual, usual), hub=kind.name, hub_upper="", parti="hall",
        storeys=dict.fromkeys(building.storeys, ()), main=frozenset(), needed=frozenset(), seats=None, places=None,
    )  # fmt: skip
    named = replace(room, name=kind.name, label=room.label or room.name.replace("_", " "), area=area, suite=())
    furnished = [_in_room(thing, named) if thing.room in ("", room.name) else thing for thing in facts.objects]
    return alone, replace(facts, rooms=[named, *room.suite], objects=furnished)


def lone_outline(area: float) -> Polygon:
    """Return the outline of a room that stands alone, a rectangle in steps of a tenth of a metre.

    Examples
    --------
    >>> lone_outline(20.0).bounds
    (0.0, 0.0, 5.0, 4.0)
    """
    depth = max(round(math.sqrt(area / _OBLONG) / _STEP) * _STEP, _STEP)
    return box(0.0, 0.0, round(area / depth, 1), depth)


_OBLONG, _STEP = 1.3, 0.5
"""Length of a room that stands alone, in those of its depth; and the steps of its depth, metres."""


def _in_room(thing: ObjectFact, room: RoomFact) -> ObjectFact:
    return replace(thing, room=room.name, room_type=room.room_type)
