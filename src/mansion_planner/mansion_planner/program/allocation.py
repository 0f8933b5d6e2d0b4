"""Share the rooms that the brief asks for out over the storeys, and tell which a storey may add to them."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from mansion_knowledge import KnowledgeBase, RoomEntry
from mansion_msgs_py.program import TraceEntry
from mansion_planner.brief.facts import RoomFact
from mansion_planner.brief_checks import check_number
from mansion_planner.program.building_size import tells_program
from mansion_planner.program.decisions import Decisions, note
from mansion_planner.program.furniture_areas import furniture_area, furniture_areas, usual_number
from mansion_planner.program.household import FOR_VISITORS, private_types
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.people_rooms import bed_rooms, people_rooms, place_rooms, professional_rooms
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.step_record import Record
from mansion_planner.program.storey_choice import floors_for, in_order, is_free_bathroom, number_of
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
    places : frozenset of str
        Names of rooms that are as large as the places of those who work or sleep there need, whatever is usual.
    households : dict of str to RoomFact
        What every unit holds that a storey adds by itself, by the room type that it counts as.
    told : bool
        The brief tells what the building holds, so that it is as large as that.
    """

    wanted: dict[int, list[RoomFact]] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    unwanted: dict[int, frozenset[str]] = field(default_factory=dict)
    complete: frozenset[int] = frozenset()
    furniture: dict[str, float] = field(default_factory=dict)
    places: frozenset[str] = frozenset()
    households: dict[str, RoomFact] = field(default_factory=dict)
    told: bool = False

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


MANY = 6
"""Number of pieces from which furniture that the brief puts in no room gets a room that usually has as many."""

_IN_STEAD = 0.5
"""Share of the pieces usual in the building's own room for them that a stated room takes to get them instead."""


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
            name
            for storey in storeys
            for name in (storey.hub.name, *(entry.room_type for entry in entries_of(storey)))
            if not floors or storey.index in floors
        ]
        best = max(own, key=holds, default="")
        if stated and not (best and _IN_STEAD * holds(best) > max(holds(fact.room_type) for fact in stated)):
            out.append((max(stated, key=lambda fact: holds(fact.room_type)), 0.0))
        elif best and holds(best) >= MANY / 2:
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
    for_people = people_rooms(decisions, knowledge)
    professional = professional_rooms(decisions, knowledge)
    for fact, effect in [*([for_people] if for_people is not None else []), *professional]:
        note(trace, fact.span, effect)
    facts += [for_people[0]] if for_people is not None else []
    wanted: dict[int, list[RoomFact]] = {storey.index: [] for storey in storeys}
    for_furniture = _furniture_rooms(decisions, knowledge, storeys)
    furniture = furniture_areas(decisions.facts.rooms, decisions.facts.objects)
    for fact, area in for_furniture:
        furniture[fact.name] = max(area, furniture.get(fact.name, 0.0))
    asked = [
        *facts,
        *(fact for fact, _ in professional),
        *(fact for fact, _ in for_furniture if fact not in decisions.facts.rooms),
    ]
    for fact in in_order(asked, decisions, knowledge):
        check_number(fact.name, number_of(fact), len(storeys))
        floors, where = floors_for(fact, knowledge, decisions, storeys, wanted)
        for floor, number in Counter(floors).items():
            check_number(fact.name, number, 1)
            wanted[floor] += [fact] * number
        note(trace, fact.span, f"{fact.name} x{number_of(fact)}{where}")
    rank = {id(fact): number for number, fact in enumerate(asked)}
    for rooms in wanted.values():
        rooms.sort(key=lambda fact: (is_free_bathroom(fact, decisions), rank[id(fact)]))
    places = place_rooms(decisions, storeys, wanted)
    if places is not None:
        fact, area, on = places
        for floor in on:
            wanted[floor].append(fact)
        furniture[fact.name] = max(area, furniture.get(fact.name, 0.0))
        note(trace, fact.span, f"{fact.name} of about {area:.0f} m2 on storey {', '.join(str(floor) for floor in on)}")
    allocation = Allocation(
        wanted=wanted,
        settled=_settled_types(facts, decisions, knowledge).union(fact.room_type for fact, _ in professional),
        unwanted=_unwanted_types(wanted, decisions, knowledge),
        complete=_complete_storeys(decisions, storeys),
        furniture=furniture,
        places=bed_rooms(decisions) | (frozenset() if places is None else {places[0].name}),
        households={knowledge.room(fact.room_type).counts_as: fact for fact in decisions.facts.households},
        told=tells_program(decisions.facts, decisions.building, knowledge),
    )
    return allocation, Record(tuple(trace))


def _complete_storeys(decisions: Decisions, storeys: Sequence[Storey]) -> frozenset[int]:
    """Return the storeys on which the brief names all rooms; all of them where its building has none of its own."""
    if decisions.facts.only or decisions.building.alone:
        return frozenset(storey.index for storey in storeys)
    return frozenset(floor for _, refs in decisions.facts.only_on for floor in floors_of(refs, decisions))


def _settled_types(facts: Iterable[RoomFact], decisions: Decisions, knowledge: KnowledgeBase) -> frozenset[str]:
    """Return the room types whose number the brief settles, or that it excludes and does not ask for by name."""
    asked = {fact.room_type for fact in decisions.facts.rooms}
    refused = {name for name, _ in decisions.facts.excluded} | set(decisions.facts.combined)
    refused -= asked
    settled = refused.union(*(group for group in _REFUSED_TOGETHER if group & refused)) - asked
    for fact in facts:
        if decisions.building.family != "home":  # guests of a home use no bathroom of a bedroom
            settled.update(*(_LEAVES_OUT.get(child.room_type, ()) for child in fact.suite))
        if not fact.unit:
            settled.update(child.room_type for child in fact.suite if not knowledge.room(child.room_type).wet)
        kind = knowledge.room(fact.room_type)
        if kind.name == "private_office" and decisions.building.family != "office":
            settled.add("open_office")  # a factory with offices of its own has no office floor
        one_of_several = fact.count == 1 and (kind.common or kind.name == "master_suite")
        if kind.name == FOR_VISITORS and decisions.building.family == "home":
            settled.add(kind.name)  # those who live there sleep in rooms of their own
        elif kind.name == "hotel_suite" and fact.floors and decisions.building.family == "lodging":
            settled.add(kind.name)  # other storeys of a hotel have plain rooms
        elif fact.count is not None and not one_of_several:
            settled.update(name for name, other in knowledge.rooms.items() if other.counts_as == kind.counts_as)
            settled.update(next((group for group in _SAME_USE if kind.name in group), ()))
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
    for floor, facts in wanted.items():
        for alike in (_KITCHENS, _FOR_MEALS, _RECEIVING):
            if any(fact.room_type in alike for fact in facts):
                unwanted[floor] |= alike
        if decisions.building.family == "lodging" and any(fact.room_type == "dining_room" for fact in facts):
            unwanted[floor] |= _FOR_MEALS  # guests have breakfast there
        if any(
            fact.room_type == "kitchen_diner" or (fact.room_type == "living_room" and "dining" in fact.name)
            for fact in facts
        ):
            unwanted[floor] |= {"dining_room"}
    for floor in unwanted:
        unwanted[floor] |= _told_elsewhere(floor, decisions, knowledge)
    for name, ref, _ in decisions.facts.excluded_on:
        like = next((group for group in _SAME_USE if name in group), frozenset())
        for floor in floors_of((ref,), decisions):
            unwanted[floor] = unwanted.get(floor, frozenset()) | {name} | like | _same_head(name, knowledge)
    return unwanted


def _told_elsewhere(floor: int, decisions: Decisions, knowledge: KnowledgeBase) -> frozenset[str]:
    """Return the room types that fill other storeys, as the brief says: "offices on the second floor"."""
    facts = decisions.facts
    several = [fact for fact in facts.rooms if fact.floors and fact.count is None and not fact.each]
    names = {fact.room_type for fact in several if floor not in floors_of(fact.floors, decisions)}
    for use in facts.uses:
        if use.floors and floor not in floors_of(use.floors, decisions):
            lists = knowledge.buildings[use.building_type].storeys.values()
            names |= {entry.room_type for entries in lists for entry in entries if entry.repeat}
    return frozenset(names) if decisions.building.family != "mixed" else frozenset()


_SAME_USE = (
    frozenset({"treatment_room", "dental_room", "consultation_room"}),
    frozenset({"cinema_hall", "auditorium"}),
    frozenset({"tv_studio", "recording_studio", "photo_studio"}),
    frozenset({"toilet", "restroom"}),
    frozenset({"classroom", "training_room"}),
    frozenset({"teachers_room", "break_room"}),
    frozenset({"dorm_room", "hostel_dorm", "bunk_room", "holding_cell"}),
)
"""Room types that stand for each other: a stated number of one leaves no room for another."""

_KITCHENS = frozenset({"kitchen", "open_kitchen", "commercial_kitchen", "shared_kitchen"})
"""Rooms to cook in: a storey for which the brief asks one gets no other of another kind."""

_FOR_MEALS = frozenset({"cafeteria", "cafe", "restaurant"})
"""Rooms that people eat in: a storey for which the brief asks one gets no other that nobody asks for."""

_RECEIVING = frozenset({"reception", "ticket_office", "service_counter", "check_in_hall"})
"""Rooms with a desk where visitors are received, of which the same holds."""

_REFUSED_TOGETHER = (_FOR_MEALS, frozenset({"toilet", "restroom"}))
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
