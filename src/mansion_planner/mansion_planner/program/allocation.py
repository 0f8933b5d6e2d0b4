"""Share the rooms that the brief asks for out over the storeys, and tell which a storey may add to them."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from mansion_knowledge import KnowledgeBase, RoomEntry, RoomType
from mansion_msgs_py.program import TraceEntry
from mansion_planner.brief.facts import RoomFact
from mansion_planner.brief_checks import check_number
from mansion_planner.program.decisions import Decisions, note
from mansion_planner.program.furniture_areas import furniture_area, furniture_areas, usual_number
from mansion_planner.program.household import STUDIO, private_types
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.step_record import Record
from mansion_planner.program.storeys import entries_of, floors_of

__all__ = ["MANY", "Allocation", "allocate"]


@dataclass(frozen=True)
class Allocation:
    """Counts of the rooms that the brief asks for, by storey.

    Attributes
    ----------
    wanted : dict of int to list of RoomFact
        One fact for each room, by storey.
    settled : frozenset of str
        Room types whose number the brief settles; no storey adds more.
    unwanted : dict of int to frozenset of str
        Room types that the brief does not want on a storey.
    complete : frozenset of int
        Storeys on which the brief wants no room but those that it names.
    furniture : dict of str to float
        Square metres that the furniture wanted in rooms of a name needs.
    households : dict of str to RoomFact
        What every unit holds that a storey adds by itself, by the room type that it counts as.
    """

    wanted: dict[int, list[RoomFact]] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    unwanted: dict[int, frozenset[str]] = field(default_factory=dict)
    complete: frozenset[int] = frozenset()
    furniture: dict[str, float] = field(default_factory=dict)
    households: dict[str, RoomFact] = field(default_factory=dict)

    def added(self, entry: RoomEntry, knowledge: KnowledgeBase) -> PlannedRoom:
        """Return a room of a storey's list, with the rooms that the brief gives to every such unit."""
        kind = knowledge.room(entry.room_type)
        fact = self.households.get(kind.counts_as)
        if fact is not None:
            return planned_room(knowledge.room(fact.room_type), knowledge, fact=fact)
        return planned_room(kind, knowledge, area=entry.area)

    def adds(self, room_type: str, floor: int) -> bool:
        """Whether a storey may have rooms of a type that the brief does not ask for."""
        refused = room_type in self.settled or room_type in self.unwanted.get(floor, ())
        return floor not in self.complete and not refused


def _people_rooms(decisions: Decisions, knowledge: KnowledgeBase) -> tuple[RoomFact, str] | None:
    """Return the rooms that stated occupants need (classrooms for pupils, bedrooms for a family), and that in words."""
    facts, seats = decisions.facts, decisions.building.seats
    if not facts.occupants:
        return None
    people = facts.occupants[0]
    stated = {fact.room_type for fact in facts.rooms if fact.count is not None}
    if decisions.building.family == "home" and people.noun in (
        "family",
        "people",
        "person",
        "resident",
        "adult",
        "inhabitant",
        "kid",
        "child",
    ):
        if decisions.building.hub == STUDIO or any(knowledge.room(name).counts_as == "bedroom" for name in stated):
            return None
        grown = people.count if people.noun not in ("kid", "child") else people.count + 2
        count = max(1, min(grown - 1, 8))
        return RoomFact("bedroom", "bedroom", people.span, count), f"{count} bedrooms for {people.count} people"
    if seats is None or people.noun in ("employee", "worker", "staff", "visitor", "teacher", "family"):
        return None
    kind = knowledge.room(seats.room_type)
    if kind.name in stated:
        return None
    count = max(1, -(-people.count // int(seats.area or 1)))
    return RoomFact(kind.name, kind.name, people.span, count), f"{count} x {kind.name} for {people.count} people"


MANY = 6
"""From so many pieces on, furniture that the brief puts in no room gets one that usually has as many."""


def _furniture_rooms(
    decisions: Decisions, knowledge: KnowledgeBase, storeys: Sequence[Storey]
) -> list[tuple[RoomFact, float]]:
    """Return the rooms for many pieces of furniture that the brief puts in none, and the square metres that they need.

    A room of the brief that usually has many takes them, else one of the building's own.
    """
    out = []
    for wanted in decisions.facts.objects:
        if wanted.room or wanted.excluded or not wanted.category or (wanted.count or 0) < MANY:
            continue

        def holds(room_type: str, category: str = wanted.category) -> float:
            return usual_number(room_type, category, knowledge.room(room_type).usual)

        floors = set(floors_of(wanted.floors, decisions))
        stated = [
            fact
            for fact in decisions.facts.rooms
            if holds(fact.room_type) >= MANY / 2
            and not (floors and fact.floors and floors.isdisjoint(floors_of(fact.floors, decisions)))
        ]
        own = [
            entry.room_type
            for storey in storeys
            for entry in entries_of(storey)
            if not floors or storey.index in floors
        ]
        if stated:
            out.append((max(stated, key=lambda fact: holds(fact.room_type)), 0.0))
        elif own and max(holds(name) for name in own) >= MANY / 2:
            best = max(own, key=holds)
            out.append((RoomFact(best, best, wanted.span, 1, floors=wanted.floors, each=wanted.each), 0.0))
        else:
            continue
        out[-1] = (out[-1][0], furniture_area(out[-1][0].room_type, wanted))
    return out


def allocate(decisions: Decisions, knowledge: KnowledgeBase, storeys: Sequence[Storey]) -> tuple[Allocation, Record]:
    """Distribute the rooms that the brief asks for over the storeys.

    A room that the brief asks for by name is built although another statement excludes its kind.
    """
    trace: list[TraceEntry] = []
    facts = list(decisions.facts.rooms)
    for_people = _people_rooms(decisions, knowledge)
    if for_people is not None:
        fact, effect = for_people
        note(trace, fact.span, effect)
        facts.append(fact)
    wanted: dict[int, list[RoomFact]] = {storey.index: [] for storey in storeys}
    for_furniture = _furniture_rooms(decisions, knowledge, storeys)
    furniture = furniture_areas(decisions.facts.rooms, decisions.facts.objects)
    for fact, area in for_furniture:
        furniture[fact.name] = max(area, furniture.get(fact.name, 0.0))
    asked = [*facts, *(fact for fact, _ in for_furniture if fact not in decisions.facts.rooms)]
    for fact in sorted(asked, key=lambda fact: _is_free_bathroom(fact, decisions)):  # once bedrooms have their storeys
        check_number(fact.name, _number_of(fact), len(storeys))
        floors, where = _floors_for(fact, knowledge, decisions, storeys, wanted)
        for floor, number in Counter(floors).items():
            check_number(fact.name, number, 1)
            wanted[floor] += [fact] * number
        note(trace, fact.span, f"{fact.name} x{_number_of(fact)}{where}")
    allocation = Allocation(
        wanted=wanted,
        settled=_settled_types(facts, decisions, knowledge),
        unwanted=_unwanted_types(wanted, decisions, knowledge),
        complete=_complete_storeys(decisions, storeys),
        furniture=furniture,
        households={knowledge.room(fact.room_type).counts_as: fact for fact in decisions.facts.households},
    )
    return allocation, Record(tuple(trace))


def _complete_storeys(decisions: Decisions, storeys: Sequence[Storey]) -> frozenset[int]:
    """Return the storeys on which the brief names all rooms."""
    if decisions.facts.only:
        return frozenset(storey.index for storey in storeys)
    return frozenset(floor for _, refs in decisions.facts.only_on for floor in floors_of(refs, decisions))


def _settled_types(facts: Iterable[RoomFact], decisions: Decisions, knowledge: KnowledgeBase) -> frozenset[str]:
    """Return the room types whose number the brief settles, or that it excludes and does not ask for by name."""
    asked = {fact.room_type for fact in decisions.facts.rooms}
    refused = {name for name, _ in decisions.facts.excluded} | set(decisions.facts.combined)
    refused -= asked
    settled = refused.union(*(group for group in _REFUSED_TOGETHER if group & refused)) - asked
    for fact in facts:
        settled.update(*(_LEAVES_OUT.get(child.room_type, ()) for child in fact.suite))
        if not fact.unit:
            settled.update(child.room_type for child in fact.suite if not knowledge.room(child.room_type).wet)
        kind = knowledge.room(fact.room_type)
        if fact.count is not None and not (kind.common and fact.count == 1):
            settled.update(name for name, other in knowledge.rooms.items() if other.counts_as == kind.counts_as)
            settled.update(next((group for group in _SAME_USE if kind.name in group), ()))
            if kind.name == "private_office" and decisions.building.family != "office":
                settled.add("open_office")  # a factory with two offices has no third one
            if fact.count > 1:
                settled.update(_same_head(fact.name, knowledge))
                settled.update(_LEAVES_OUT.get(kind.name, ()))
            if fact.name == "bedroom" and fact.count > 1:
                settled |= _GUESTS_ROOMS - asked  # a hotel with twenty bedrooms has no other rooms to sleep in
    return frozenset(settled)


def _unwanted_types(
    wanted: Mapping[int, list[RoomFact]], decisions: Decisions, knowledge: KnowledgeBase
) -> dict[int, frozenset[str]]:
    """Return the room types that a storey adds none of: those that the brief excludes there or that are in a unit."""
    unwanted = {floor: frozenset(private_types(facts, knowledge)) for floor, facts in wanted.items()}
    for name, ref, _ in decisions.facts.excluded_on:
        like = next((group for group in _SAME_USE if name in group), frozenset())
        for floor in floors_of((ref,), decisions):
            unwanted[floor] = unwanted.get(floor, frozenset()) | {name} | like | _same_head(name, knowledge)
    return unwanted


_SAME_USE = (
    frozenset({"treatment_room", "dental_room", "consultation_room"}),
    frozenset({"cinema_hall", "auditorium"}),
    frozenset({"toilet", "restroom"}),
    frozenset({"classroom", "training_room"}),
    frozenset({"dorm_room", "hostel_dorm", "bunk_room", "holding_cell"}),
)
"""Room types that stand for each other: a stated number of one leaves no room for another."""

_REFUSED_TOGETHER = (frozenset({"cafeteria", "cafe", "restaurant"}),)
"""Room types of which a brief that refuses one by name wants none of the others."""

_LEAVES_OUT = {
    "bathroom": frozenset({"restroom", "toilet"}),
    "bedroom": frozenset({"nap_room"}),
    "judges_chamber": frozenset({"judges_chamber"}),
    "living_room": frozenset({"lounge"}),
}
"""Room types that a storey adds none of where the brief counts rooms, or gives to units, of another."""

_GUESTS_ROOMS = frozenset({"hotel_room", "hotel_suite", "resident_room", "patient_room", "dorm_room", "hostel_dorm"})
"""Rooms for those who sleep in a building that is no home; a brief may call them bedrooms."""

_GENERAL_HEADS = frozenset({"room", "hall", "area", "store", "storage", "space", "centre", "center", "section"})


def _same_head(name: str, knowledge: KnowledgeBase) -> set[str]:
    """Return the room types whose name ends in the same noun: a number of "offices" holds for every kind of office.

    Where the noun is of any room, what stands before it counts: "shower rooms" hold for a shower area.
    """
    use, _, head = name.rpartition("_")
    if head in _GENERAL_HEADS:
        return {room for room in knowledge.rooms if use and room in {f"{use}_{other}" for other in _GENERAL_HEADS}}
    heads = next((group for group in _HEADS_ALIKE if head in group), {head})
    return {room for room in knowledge.rooms if room.rpartition("_")[2] in heads}


_HEADS_ALIKE = (frozenset({"lab", "laboratory"}),)
"""Nouns that mean the same at the end of a room's name."""


def _number_of(fact: RoomFact) -> int:
    return fact.count if fact.count is not None else 2


def _floors_for(
    fact: RoomFact,
    knowledge: KnowledgeBase,
    decisions: Decisions,
    storeys: Sequence[Storey],
    wanted: Mapping[int, Sequence[RoomFact]],
) -> tuple[list[int], str]:
    """Return the storeys of a fact's rooms, one entry for each room, and where the brief itself puts them, in words.

    Parameters
    ----------
    wanted : mapping of int to sequence of RoomFact
        What the storeys have so far: a room that the brief leaves free goes to the emptiest.
    """
    above = [storey.index for storey in storeys if storey.index >= 1]
    count = _number_of(fact)
    if fact.floors:
        chosen = [f for f in floors_of(fact.floors, decisions) if f in wanted] or [above[-1]]
        found: list[int] = []
        for number, floor in enumerate(chosen):
            found += [floor] * (count if fact.each else count // len(chosen) + (number < count % len(chosen)))
        return found, f" on storey {', '.join(str(floor) for floor in chosen)}"
    if fact.each:
        return [floor for floor in above for _ in range(count)], " on every storey"
    floors = _preferred(knowledge.room(fact.room_type), decisions, storeys)
    if _is_free_bathroom(fact, decisions):
        return _by_bedrooms(count, floors, wanted, knowledge), ""
    beside = _beside(fact, decisions, wanted)
    if beside and count == 1:
        floors = beside
    return _emptiest(fact, count, floors, wanted), ""


def _emptiest(fact: RoomFact, count: int, floors: Sequence[int], wanted: Mapping[int, Sequence[RoomFact]]) -> list[int]:
    """Return a storey for each of `count` rooms: the one where the brief asks for the least area so far."""
    areas = {floor: [other.area or _USUAL for other in wanted[floor]] for floor in floors}
    found = []
    for _ in range(count):
        floor = min(floors, key=lambda f: (sum(areas[f]), f))
        areas[floor].append(fact.area or _USUAL)
        found.append(floor)
    return found


def _is_free_bathroom(fact: RoomFact, decisions: Decisions) -> bool:
    """Whether a bathroom of a home is for the planner to put on a storey."""
    beside = any(fact.name in (a.first_name, a.second_name) for a in decisions.facts.adjacent)
    free = not fact.floors and not fact.each and not beside
    return free and fact.room_type == "bathroom" and decisions.building.family == "home"


_BY_DAY = 1.5
"""Bedrooms that a storey without any counts for when bathrooms are shared out over the storeys of a home."""


def _by_bedrooms(
    count: int, floors: Sequence[int], wanted: Mapping[int, Sequence[RoomFact]], knowledge: KnowledgeBase
) -> list[int]:
    """Return a storey for each of `count` bathrooms: the one with the most bedrooms for each bathroom there."""

    def number(floor: int, kind: str) -> int:
        return sum(knowledge.room(fact.room_type).counts_as == kind for fact in wanted[floor])

    bathrooms = {floor: number(floor, "bathroom") for floor in floors}
    found: list[int] = []
    for _ in range(count):
        floor = max(floors, key=lambda f: ((number(f, "bedroom") or _BY_DAY) / (bathrooms[f] + 1), -f))
        bathrooms[floor] += 1
        found.append(floor)
    return found


_USUAL = 14.0
"""Square metres that a room without a stated area counts for when rooms are shared out over storeys."""


def _beside(fact: RoomFact, decisions: Decisions, wanted: Mapping[int, Sequence[RoomFact]]) -> list[int]:
    """Return the storeys of the rooms that this one is to stand beside, once they have theirs."""
    names = {a.second_name if a.first_name == fact.name else a.first_name for a in decisions.facts.adjacent
             if fact.name in (a.first_name, a.second_name)}  # fmt: skip
    return [floor for floor, facts in sorted(wanted.items()) if any(other.name in names for other in facts)]


def _preferred(kind: RoomType, decisions: Decisions, storeys: Sequence[Storey]) -> list[int]:
    above = [storey.index for storey in storeys if storey.index >= 1]
    below = [storey.index for storey in storeys if storey.index < 1]
    home = decisions.building.family == "home"
    if kind.storey == "basement" and below:
        return below
    if kind.name in ("bathroom", "toilet") and home:
        return above[1:] + above[:1] if len(above) > 1 else above
    if kind.storey == "ground":
        if kind.name in ("classroom", "shop"):
            return above
        return above[:1]
    if kind.storey == "upper":
        return above[1:] or above
    if kind.storey == "top":
        return above[-1:]
    return above
