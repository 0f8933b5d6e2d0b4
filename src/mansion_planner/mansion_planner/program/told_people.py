"""For how many people a brief says that its building is."""

from typing import Final

from mansion_knowledge import BuildingType
from mansion_planner.brief.facts import BriefFacts, Span

__all__ = ["people_of"]

_DESKS: Final = frozenset({"desk", "office_desk", "standing_desk"})


def people_of(facts: BriefFacts, building: BuildingType) -> tuple[int, Span | None]:
    """Return how many people a building is for, and the words that say so; 0 where none do.

    An office is for those who sit at the desks that are counted, unless its brief tells people or storeys.
    """
    if facts.occupants:
        return sum(people.count for people in facts.occupants), facts.occupants[0].span
    desks = [
        thing
        for thing in facts.objects
        if thing.category in _DESKS and not (thing.each or thing.excluded or thing.floors)
    ]
    if building.family != "office" or not desks or facts.floors:
        return 0, None
    return sum(thing.count or 0 for thing in desks), desks[0].span
