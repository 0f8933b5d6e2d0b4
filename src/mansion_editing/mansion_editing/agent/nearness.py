"""What stands next to what."""

import math
from typing import Final

from mansion_editing.agent.facts import Scope, Thing
from mansion_editing.agent.looking import Look, find_things
from mansion_editing.state import SceneState
from mansion_msgs_py.editing import ObjectInfo

__all__ = ["NEXT_TO", "beside", "references"]

NEXT_TO: Final = 0.6
"""Greatest free distance between things that are next to each other, metres."""


def references(where: Scope, state: SceneState) -> Look:
    """Find what a scope names as ``near``, within the rest of the scope."""
    around = Scope(where.relation, where.receptacle, where.rooms, where.floor, where.colour)
    return (yield from find_things(Thing(where.near, 0), around, state))


def beside(item: ObjectInfo, anchor: ObjectInfo, state: SceneState) -> bool:
    """Whether two objects of one room have at most `NEXT_TO` between them."""
    one, other = state.find(item.id), state.find(anchor.id)
    if one is None or other is None or item.room != anchor.room or item.floor != anchor.floor:
        return False
    reach = sum(max(thing.size[:2]) / 2 for _, thing in (one, other))
    return math.dist(one[1].position[:2], other[1].position[:2]) - reach <= NEXT_TO
