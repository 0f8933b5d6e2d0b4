"""Choose the storeys of the rooms that a brief asks for: as it says, else where such rooms usually lie."""

from collections.abc import Mapping, Sequence

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_planner.brief.facts import RoomFact
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.hall_wings import is_free_for_wing, is_hall_of_wing
from mansion_planner.program.model import Storey
from mansion_planner.program.storeys import entries_of, floors_of

__all__ = ["floors_for", "in_order", "is_free_bathroom", "number_of"]


def number_of(fact: RoomFact) -> int:
    """Return how many rooms a fact asks for; two where it says only that there are several."""
    return fact.count if fact.count is not None else 2


def floors_for(
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
    count = number_of(fact)
    if fact.floors and not _named_with_others(fact, decisions):
        chosen = [f for f in floors_of(fact.floors, decisions) if f in wanted] or [above[-1]]
        found: list[int] = []
        for number, floor in enumerate(chosen):
            found += [floor] * (count if fact.each else count // len(chosen) + (number < count % len(chosen)))
        return found, f" on storey {', '.join(str(floor) for floor in chosen)}"
    if fact.each:
        return [floor for floor in above for _ in range(count)], " on every storey"
    paired = _with_counterpart(fact, wanted)
    if paired:
        return [paired[0]] * count, ""
    if is_free_bathroom(fact, decisions):
        return _by_bedrooms(count, _preferred(fact, knowledge, decisions, storeys, wanted), wanted, knowledge), ""
    beside = _beside(fact, decisions, wanted)
    if not beside or count > 1:
        partners = _with_partners(fact, knowledge, storeys, wanted)
        beside = partners or _preferred(fact, knowledge, decisions, storeys, wanted)
    return _emptiest(fact, count, beside, wanted, knowledge, decisions), ""


_SEXES = frozenset({"man", "woman", "boy", "girl", "lady", "gent", "gentleman", "male", "female"})


def _with_counterpart(fact: RoomFact, wanted: Mapping[int, Sequence[RoomFact]]) -> list[int]:
    """Return the storeys of the same room for the other sex: changing rooms for men and for women lie together."""
    user, _, room = fact.name.partition("_")
    if user not in _SEXES or fact.name in {other.name for facts in wanted.values() for other in facts}:
        return []
    others = {f"{sex}_{room}" for sex in _SEXES - {user}}
    return [floor for floor, facts in sorted(wanted.items()) if any(other.name in others for other in facts)]


def _named_with_others(fact: RoomFact, decisions: Decisions) -> bool:
    """Whether a storey stands after another room of a list, which visitors do not come to first as they do to this one.

    "A service counter and offices on the second floor" has its counter at the entrance.
    """
    if fact.room_type not in _AT_THE_DOOR - {"indoor_pool"} or fact.each:
        return False
    others = [other.span for other in decisions.facts.rooms if other is not fact]
    others += [use.span for use in decisions.facts.uses]
    return all(
        ref.kind == "number" and any(fact.span.end <= span.start and span.end <= ref.span.start for span in others)
        for ref in fact.floors
    )


def in_order(facts: Sequence[RoomFact], decisions: Decisions, knowledge: KnowledgeBase) -> list[RoomFact]:
    """Return facts in the order in which they get their storeys.

    Rooms that follow others come after these, and free bathrooms come once bedrooms have their storeys. Several
    of a kind for any storey of a public building come after those for one storey, and fill up what these leave.
    """
    home = decisions.building.family == "home"

    def turn(fact: RoomFact) -> int:
        if is_free_bathroom(fact, decisions):
            return 3
        kind = knowledge.room(fact.room_type)
        if not fact.floors and _follows(kind):
            return 2
        several = number_of(fact) > 1 and not (home or fact.floors or fact.each)
        return int(several and kind.storey == "any")

    return sorted(facts, key=turn)


def _emptiest(
    fact: RoomFact,
    count: int,
    floors: Sequence[int],
    wanted: Mapping[int, Sequence[RoomFact]],
    knowledge: KnowledgeBase,
    decisions: Decisions,
) -> list[int]:
    """Return a storey for each of `count` rooms: the one where the brief asks for the least area so far.

    A hall that gets a wing of its own takes none of its storey.
    """
    wing = is_free_for_wing(decisions)

    def counted(other: RoomFact) -> float:
        area = _area(other, knowledge)
        return 0.0 if wing and is_hall_of_wing(knowledge.room(other.room_type), area) else area

    areas = {floor: [counted(other) for other in wanted[floor]] for floor in floors}
    found = []
    for _ in range(count):
        floor = min(floors, key=lambda f: (sum(areas[f]), f))
        areas[floor].append(_area(fact, knowledge))
        found.append(floor)
    return found


def _area(fact: RoomFact, knowledge: KnowledgeBase) -> float:
    """Return the stated or usual area of one of the rooms of a fact, square metres."""
    return fact.area or knowledge.room(fact.room_type).usual


def is_free_bathroom(fact: RoomFact, decisions: Decisions) -> bool:
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


def _beside(fact: RoomFact, decisions: Decisions, wanted: Mapping[int, Sequence[RoomFact]]) -> list[int]:
    """Return the storeys of the rooms that this one is to stand beside, once they have theirs."""
    names = {a.second_name if a.first_name == fact.name else a.first_name for a in decisions.facts.adjacent
             if fact.name in (a.first_name, a.second_name)}  # fmt: skip
    return [floor for floor, facts in sorted(wanted.items()) if any(other.name in names for other in facts)]


_FOLLOWERS = frozenset(
    {"bar", "control_room", "sound_control_room", "dressing_room", "judges_chamber", "walk_in_closet"}
)
"""Rooms that no one serves in, and that belong to others as those of service do."""


_ANYWHERE = frozenset({"corridor", "lobby", "storage", "restroom"})
"""Rooms of every storey, beside which others lie without belonging to them."""


def _follows(kind: RoomType) -> bool:
    """Whether a room belongs on the storey of those that it serves: a kitchen, a changing room, a cold store."""
    serves = kind.zone == "service" or kind.name in _FOLLOWERS
    return serves and not kind.toilet and not _ANYWHERE.issuperset(kind.near)


def _with_partners(
    fact: RoomFact, knowledge: KnowledgeBase, storeys: Sequence[Storey], wanted: Mapping[int, Sequence[RoomFact]]
) -> list[int]:
    """Return the storeys with rooms that one follows: of the brief, else of the building's own lists; or none.

    A room that usually lies on the ground floor follows those alone that the brief puts elsewhere.
    """
    kind = knowledge.room(fact.room_type)
    if not _follows(kind):
        return []
    served = {*kind.near} - _ANYWHERE
    asked = [
        floor for floor, facts in sorted(wanted.items())
        if any(other.room_type in served and (other.floors or kind.storey == "any") for other in facts)
    ]  # fmt: skip
    if asked or kind.storey != "any":
        return asked
    return [
        storey.index for storey in storeys
        if storey.index >= 1 and _types_of(storey) & served
    ]  # fmt: skip


def _types_of(storey: Storey) -> set[str]:
    """Return the types of a storey's hub and of the rooms of its own list."""
    return {storey.hub.name, *(entry.room_type for entry in entries_of(storey))}


_FULL = 0.9
"""Share of a storey of stated area that its rooms take at their usual sizes when no more belong there."""


def _preferred(
    fact: RoomFact,
    knowledge: KnowledgeBase,
    decisions: Decisions,
    storeys: Sequence[Storey],
    wanted: Mapping[int, Sequence[RoomFact]],
) -> list[int]:
    """Return the storeys on which such rooms usually lie."""
    kind = knowledge.room(fact.room_type)
    above = [storey.index for storey in storeys if storey.index >= 1]
    below = [storey.index for storey in storeys if storey.index < 1]
    if kind.storey == "basement" and below:
        return below
    if kind.name in ("bathroom", "toilet") and decisions.building.family == "home":
        return above[1:] + above[:1] if len(above) > 1 else above
    if kind.storey in ("ground", "basement"):
        if kind.zone == "service" or kind.name in _AT_THE_DOOR:
            return above[:1]
        repeated = any(kind.name in _types_of(storey) for storey in storeys if storey.index >= 2)
        taken = sum(_area(other, knowledge) for other in (*wanted[above[0]], *[fact] * number_of(fact)))
        full = decisions.area_stated and taken > _FULL * decisions.area
        return above if repeated or full else above[:1]
    if kind.storey == "upper":
        return above[1:] or above
    if kind.storey == "top":
        return above[-1:]
    return above


_AT_THE_DOOR = frozenset({"reception", "ticket_office", "service_counter", "indoor_pool"})
"""Rooms that visitors come to first, and those too heavy for other storeys, however full the entrance storey is."""
