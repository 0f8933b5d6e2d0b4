"""Toilets of the entrance storey as the rules of building ask: for men, for women, and one for wheelchairs."""

import math
from collections.abc import Sequence

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["toilet_areas"]

_STALL = 5.0
"""Square metres of a restroom for one water closet or urinal, with its basin and the way to it."""

_LEAST = 8.0
"""Square metres of a restroom for one sex."""

_SEXES = ("mens_restroom", "womens_restroom")


def toilet_areas(storey: Storey, rooms: Sequence[PlannedRoom], knowledge: KnowledgeBase) -> dict[str, float]:
    """Return the toilets that a storey is to have for its occupants, by name: square metres of each.

    None where the rules ask for no separate ones there: upper storeys, dwellings, few occupants.
    """
    norms = load_norms()
    family, kind = storey.use.family, storey.use.name
    rule = norms.rules["separate_toilets"]
    if storey.role not in ("single", "ground") or not rule.holds_for(family):
        return {}
    every = [room for top in rooms for room in top.each()]
    people = sum(norms.people(room.kind.name, room.area, knowledge) for room in every)
    people += norms.people(storey.hub.name, storey.hub.usual, knowledge)
    if people <= rule.limit(kind, family):
        return {}
    closets = [
        math.ceil(people / 2 / norms.rules[name].limit(kind, family))
        for name in ("water_closets_men", "water_closets_women")
    ]
    areas = {name: max(_LEAST, _STALL * number) for name, number in zip(_SEXES, closets)}
    return {**areas, "accessible_toilet": knowledge.room("accessible_toilet").usual}
