"""Toilets of public buildings as the rules of building ask: for men, for women, and one for wheelchairs."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import msgspec

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.storey_rooms import fit_areas

__all__ = ["TOILETS", "Served", "served_by", "with_public_toilets"]

_STALL, _BASIN = 5.75, 8.0
"""Square metres of a restroom for each water closet or urinal, and for each washbasin, with the ways to them."""

_WALLS = 1.6
"""Square metres of a restroom that its walls take."""

_WOMENS = 2.0
"""Least water closets of a restroom for women: one alone makes a queue (planning practice)."""

_MENS = 0.75
"""Least area of a restroom for men to that for women (planning practice: as many fixtures, some of them urinals)."""

_OF_CHILDREN = 3.0
"""Least water closets of a washroom for small children, who go there in groups with two adults."""

_CHILDRENS = frozenset({"kindergarten_classroom", "nursery_room"})
"""Rooms of children who go to washrooms of their own."""

_OF_PUPILS = {"mens_restroom": "boys' toilets", "womens_restroom": "girls' toilets"}

_OF_GUESTS = frozenset({"restaurant", "ballroom", "conference_hall"})
"""Rooms of a hotel that many people visit who do not sleep there."""

_LOOSE = 0.4
"""Share of a storey's rooms without a stated area from which on toilets take more than the rules ask for."""

_LEAST = 8.0
"""Square metres of a restroom for one sex."""

_MOST_SHARE = 0.15
"""Share of a storey's rooms that toilets may take beyond those of its own list: a small storey keeps its rooms."""

_TURNING = 10.0
"""Square metres of a restroom from which a wheelchair turns between its fixtures."""

_DRAWN = 1.05
"""People that rooms hold as they are drawn, to those by their planned areas: walls give and take a little."""

TOILETS = ("restroom", "toilet", "accessible_toilet")
"""Types of rooms that "the toilets" of a building may be."""


@dataclass(frozen=True)
class Served:
    """People on some storeys, and the water closets and washbasins that these have for them."""

    people: float = 0.0
    closets: int = 0
    basins: int = 0

    def __add__(self, other: "Served") -> "Served":
        return Served(self.people + other.people, self.closets + other.closets, self.basins + other.basins)


def served_by(storey: Storey, hub: float, knowledge: KnowledgeBase) -> Served:
    """Return the people of a storey with its rooms and a hub of `hub` square metres, and what its toilets hold."""
    every = [room for top in storey.rooms for room in top.each()]
    people = load_norms().people(storey.hub.name, hub, knowledge) + _people_in(storey.rooms, knowledge)
    toilets = [room.area - _WALLS for room in every if room.kind.name in TOILETS]
    closets, basins = (sum(max(1, int(area / each)) for area in toilets) for each in (_STALL, _BASIN))
    return Served(people, closets, basins)


def with_public_toilets(
    storey: Storey,
    rooms: Sequence[PlannedRoom],
    allocation: Allocation,
    knowledge: KnowledgeBase,
    hub: float,
    others: Served = Served(),
    capacity: float = 0.0,
) -> list[PlannedRoom]:
    """Return the rooms of a storey of a public building with the toilets of the rules.

    Those of the entrance storey also serve people for whom the other storeys have too few; an upper storey has toilets
    only where its own list has. Toilets that the brief counts, sizes or refuses stay as they are.

    Parameters
    ----------
    hub : float
        Square metres of the storey's hub, where it is its main room.
    others : Served
        The building's other storeys.
    capacity : float
        Square metres to which the rooms grow together, and with them the number of people; 0 where they keep theirs.
    """
    kept = list(rooms)
    own = [room for room in kept if room.kind.name in TOILETS]
    entrance = storey.role in ("single", "ground")
    if _is_settled(storey, kept, allocation) or storey.role == "basement" or not (own or entrance):
        return kept
    before, whole = sum(room.gross for room in own), sum(room.gross for room in kept)
    grown = fit_areas(kept, capacity) if capacity else kept
    need = _need_of(storey, kept, grown, knowledge, hub, others if entrance else Served())
    roomy = sum(room.gross for room in kept if not room.fixed) > _LOOSE * whole
    choices = _choices(need, kept, knowledge, accessible=entrance, roomy=roomy) if need is not None else []
    for number, wanted in enumerate(choices):
        most = _MOST_SHARE * (whole + (hub if number else 0.0)) + before
        fitting = _within(wanted, most)
        if fitting:
            place = kept.index(own[0]) if own else len(kept)
            rest = [room for room in kept if room not in own]
            asked = [room for room in own if room.stated]
            called = [_called(room, storey) for room in fitting]
            return [*rest[:place], *(_serving(room, asked) for room in called), *rest[place:]]
    return kept


def _is_settled(storey: Storey, rooms: Sequence[PlannedRoom], allocation: Allocation) -> bool:
    """Whether the brief counts, sizes or refuses the toilets of a storey; one of children may be several."""
    facts = [fact for fact in allocation.wanted.get(storey.index, ()) if fact.room_type in TOILETS]
    if not facts:
        return not all(allocation.adds(name, storey.index) for name in TOILETS)
    children = any(room.kind.name in _CHILDRENS for top in rooms for room in top.each())
    return any(fact.area or (fact.count or 0) > int(children) for fact in facts)


def _called(toilet: PlannedRoom, storey: Storey) -> PlannedRoom:
    """Return a toilet under the name of those who use it where these are no men and women: the pupils of a school."""
    label = _OF_PUPILS.get(toilet.base, "") if storey.use.name == "school" else ""
    return msgspec.structs.replace(toilet, label=label) if label else toilet


def _serving(toilet: PlannedRoom, asked: Sequence[PlannedRoom]) -> PlannedRoom:
    """Return a toilet that is also one of those that the brief asks for, without saying how many or how large."""
    if not asked:
        return toilet
    names = dict.fromkeys(name for room in asked for name in (room.base, room.kind.name) if name != toilet.kind.name)
    label = toilet.label or toilet.base.replace("mens_", "men's ").replace("_", " ")
    return msgspec.structs.replace(toilet, stated=True, label=label, serves_as=(*toilet.serves_as, *names))


@dataclass(frozen=True)
class _Need:
    """What the toilets of a storey are for: shares of water closets for men and for women, and washbasins.

    Attributes
    ----------
    separate : bool
        Men and women have toilets of their own.
    one_each : bool
        One water closet is enough for each.
    children : bool
        They are for small children, boys and girls alike.
    """

    closets: dict[str, float]
    basins: float
    separate: bool
    one_each: bool
    children: bool = False


def _need_of(
    storey: Storey,
    rooms: Sequence[PlannedRoom],
    grown: Sequence[PlannedRoom],
    knowledge: KnowledgeBase,
    hub: float,
    others: Served,
) -> _Need | None:
    """Return what a storey needs for its own people, and for those of other storeys that have too few.

    Toilets grow with the other rooms, so that their fixtures are counted for `rooms` as they are chosen; whether men
    and women have their own depends on how many people the `grown` rooms hold.
    """
    norms, family, kind = load_norms(), storey.use.family, storey.use.name
    rule = norms.rules["separate_toilets"]
    if not rule.holds_for(family) and not any(room.kind.name in _OF_GUESTS for room in rooms):
        return None
    passing = norms.people(storey.hub.name, hub, knowledge)
    here, later = (passing + _people_in(each, knowledge) for each in (rooms, grown))
    people = here + others.people
    limits = {name: norms.rules[f"water_closets_{name}"].limit(kind, family) for name in ("men", "women")}
    closets = {
        name: max(math.ceil(people / 2 / limit) - others.closets / 2, here / 2 / limit)
        for name, limit in limits.items()
    }
    basins = people / norms.rules["washbasins"].limit(kind, family) - others.basins
    one_each = all(people / 2 <= limit for limit in limits.values())
    children = any(room.kind.name in _CHILDRENS for top in rooms for room in top.each())
    separate = round(_DRAWN * max(here, later) + others.people) > rule.limit(kind, family)
    return _Need(closets, basins, separate, one_each, children)


def _people_in(rooms: Sequence[PlannedRoom], knowledge: KnowledgeBase) -> float:
    norms = load_norms()
    return sum(norms.people(room.kind.name, room.area, knowledge) for top in rooms for room in top.each())


def _choices(
    need: _Need, rooms: Sequence[PlannedRoom], knowledge: KnowledgeBase, *, accessible: bool, roomy: bool
) -> list[list[PlannedRoom]]:
    """Return the toilets that a storey may have, the best first, then for small storeys; none where its own do.

    Where one water closet is enough for each sex, two accessible toilets may serve instead of separate restrooms
    (International Plumbing Code 2018, 403.2.1).
    """
    kind = knowledge.room("accessible_toilet")
    small = planned_room(kind, knowledge, area=kind.least)
    if not need.separate:
        return [[small]] if accessible and not any(_serves_wheelchairs(room) for room in rooms) else []
    least = {"men": 1.0, "women": _WOMENS if roomy else 1.0}
    least = dict.fromkeys(least, _OF_CHILDREN) if need.children else least
    areas = {name: _area_for(max(need.closets[name], least[name]), need.basins / 2) for name in need.closets}
    areas["men"] = max(areas["men"], _MENS * areas["women"])
    toilets = []
    for name, area in areas.items():
        room = planned_room(knowledge.room("restroom"), knowledge, area=area)
        called = "childrens_washroom" if need.children else f"{name}s_restroom"
        toilets.append(msgspec.structs.replace(room, id=called, base=called))
    if not accessible and not roomy:
        return [toilets]
    best = [*toilets, planned_room(kind, knowledge)]
    if not accessible:
        return [best, toilets]
    return [best, [small, small]] if need.one_each else [best]


def _within(toilets: list[PlannedRoom], most: float) -> list[PlannedRoom]:
    """Return toilets of `most` square metres, restrooms no smaller than their least; none where they do not fit."""
    over = sum(room.gross for room in toilets) - most
    spare = sum(max(room.area - _LEAST, 0.0) for room in toilets)
    if over <= 0.0:
        return toilets
    if over > spare:
        return []
    return [
        msgspec.structs.replace(room, area=room.area - max(room.area - _LEAST, 0.0) * over / spare) for room in toilets
    ]


def _area_for(closets: float, basins: float) -> float:
    """Return the square metres of a restroom by its numbers of closets and washbasins; with one of each it is small."""
    several = [each * math.ceil(number) for each, number in ((_STALL, closets), (_BASIN, basins)) if number > 1]
    return max([_LEAST, *(area + _WALLS for area in several)])


def _serves_wheelchairs(room: PlannedRoom) -> bool:
    """Whether a wheelchair turns in a toilet; bathrooms of other kinds are left as they are."""
    return room.kind.toilet and (room.kind.name in ("accessible_toilet", "bathroom") or room.area >= _TURNING)
