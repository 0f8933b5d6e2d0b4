"""Rooms and workplaces for the people that a brief names."""

from collections.abc import Mapping, Sequence

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.object_kinds import answers
from mansion_msgs_py.program import RequestedObject
from mansion_planner.brief.facts import OccupantFact, RoomFact
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.household import FOR_VISITORS, STUDIO
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.storeys import entries_of

__all__ = ["SLEPT_IN_TOGETHER", "bed_rooms", "people_rooms", "place_requests", "place_rooms", "professional_rooms"]

_STAFF = frozenset({"employee", "worker", "staff", "visitor", "teacher", "family"})
"""Occupants who do not count among those that a building's rooms serve."""

_VISITORS = frozenset({"visitor", "guest", "customer", "client", "patient", "family", "child", "kid"})
"""Occupants who have no place of work."""

_HOUSEHOLD = frozenset({"family", "people", "person", "resident", "adult", "inhabitant", "kid", "child"})

_SHARING = frozenset({"student", "flatmate", "roommate", "housemate", "tenant", "lodger", "apprentice", "trainee"})
"""People who share a home and have a bedroom each."""

_USABLE = 0.6
"""Share of a storey that its rooms take beside corridors, walls and cores."""

_ENTRANCE = 50.0
"""Square metres of the entrance storey for its lobby and what belongs to it."""

_USUAL = 14.0
"""Least square metres that a stated room takes when places are shared out over storeys."""

_MOST_PLACES = 0.8
"""Greatest share of what a storey has free for its places: people there meet, and go to the toilet."""

_WORTH = 0.5
"""Share of the roomiest storey's places below which a storey has none."""


def people_rooms(decisions: Decisions, knowledge: KnowledgeBase) -> tuple[RoomFact, str] | None:
    """Return the rooms that stated occupants need (classrooms for pupils, bedrooms for a family), and the reason."""
    facts, seats = decisions.facts, decisions.building.seats
    if not facts.occupants:
        return None
    people = facts.occupants[0]
    stated = {fact.room_type for fact in facts.rooms if fact.count is not None}
    if decisions.building.family == "home" and people.noun in _HOUSEHOLD | _SHARING:
        unnumbered = {fact.room_type for fact in facts.rooms} if people.noun in _SHARING else set()
        own = (stated | unnumbered) - {FOR_VISITORS}
        if decisions.building.hub == STUDIO or any(knowledge.room(name).counts_as == "bedroom" for name in own):
            return None
        count = max(1, min(_sleepers(people), 8))
        return RoomFact("bedroom", "bedroom", people.span, count), f"{count} bedrooms for {people.count} people"
    if seats is None or people.noun in _STAFF:
        return None
    kind = knowledge.room(seats.room_type)
    if kind.name in stated:
        return None
    count = max(1, -(-people.count // int(seats.area or 1)))
    return RoomFact(kind.name, kind.name, people.span, count), f"{count} x {kind.name} for {people.count} people"


def _sleepers(people: OccupantFact) -> int:
    """Return how many bedrooms the people of a home need: parents share one, and so do couples."""
    if people.noun in _SHARING:
        return people.count
    return people.count + 1 if people.noun in ("kid", "child") else people.count - 1


def professional_rooms(decisions: Decisions, knowledge: KnowledgeBase) -> list[tuple[RoomFact, str]]:
    """Return rooms of which each person of a profession has one, and the reason: four doctors have four such rooms.

    Hospitals and schools, which have rooms for the people they serve, and homes are not planned so.
    """
    building = decisions.building
    if building.family == "home" or building.seats is not None:
        return []
    stated = {fact.room_type for fact in decisions.facts.rooms if fact.count is not None}
    found = []
    for people in decisions.facts.occupants:
        name = knowledge.groups.room_of.get(people.noun, "")
        if name and name not in stated:
            fact = RoomFact(name, name, people.span, people.count)
            found.append((fact, f"{people.count} x {name}, one for each {people.noun}"))
    return found


SLEPT_IN_TOGETHER = frozenset({"bunk_room", "hostel_dorm", "nap_room", "hospital_ward"})
"""Types of rooms with several beds."""

_SEVERAL_BEDS = 3


def bed_rooms(decisions: Decisions) -> frozenset[str]:
    """Return the names of rooms with several beds whose number the brief says."""
    return frozenset(
        wanted.room
        for wanted in decisions.facts.objects
        if wanted.room_type in SLEPT_IN_TOGETHER and (wanted.count or 0) >= _SEVERAL_BEDS and not wanted.excluded
        and answers("bed", wanted.category or "")
    )  # fmt: skip


def place_rooms(
    decisions: Decisions, storeys: Sequence[Storey], wanted: Mapping[int, Sequence[RoomFact]]
) -> tuple[RoomFact, float, list[int]] | None:
    """Return the room in which stated occupants have a place each, its area, square metres, and the storeys with one.

    Parameters
    ----------
    wanted : mapping of int to sequence of RoomFact
        What the brief asks for on each storey: the fuller a storey is, the fewer places it takes.
    """
    people, entry = _placed_people(decisions), decisions.building.places
    if people is None or entry is None or any(fact.room_type == entry.room_type for fact in decisions.facts.rooms):
        return None
    free = {
        storey.index: _USABLE * decisions.area
        - sum(fact.area or _USUAL for fact in wanted[storey.index])
        - (_ENTRANCE if storey.role in ("ground", "single") else 0.0)
        for storey in storeys
        if storey.index >= 1 and any(listed.room_type == entry.room_type for listed in entries_of(storey))
    }
    most = max(free.values(), default=0.0)
    floors = [floor for floor, area in free.items() if area > 0.0 and area >= _WORTH * most]
    if not floors:
        return None
    area = min((entry.area or 1.0) * people.count / len(floors), _MOST_PLACES * most)
    return RoomFact(entry.room_type, entry.room_type, people.span, 1), area, floors


def place_requests(
    decisions: Decisions, rooms: Sequence[tuple[Storey, PlannedRoom]]
) -> dict[tuple[int, str], RequestedObject]:
    """Return the work places of stated occupants by storey and room, shared out by the areas of the rooms."""
    people, building = _placed_people(decisions), decisions.building
    if people is None or building.places is None:
        return {}
    hosts = [(storey, room) for storey, room in rooms if room.kind.name == building.places.room_type]
    whole, left, found = sum(room.area for _, room in hosts), people.count, {}
    for storey, room in hosts:
        count = min(round(people.count * room.area / whole + 0.49), left)
        left -= count
        if count:
            words = building.place.rpartition("_")[2]
            found[storey.index, room.id] = RequestedObject(category=building.place, count=count, words=words)
    return found


def _placed_people(decisions: Decisions) -> OccupantFact | None:
    """Return the occupants who have a place of work each, unless the brief states the places themselves."""
    facts, building = decisions.facts, decisions.building
    counted = any(
        answers(building.place, fact.category) or answers(fact.category, building.place)
        for fact in facts.objects
        if fact.category and fact.count
    )
    if building.places is None or counted:
        return None
    return next((people for people in facts.occupants if people.noun not in _VISITORS), None)
