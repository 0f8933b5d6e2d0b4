"""Upper storeys of a house that are shorter than its ground floor, where their rooms need less."""

import math
from collections.abc import Sequence
from dataclasses import replace

from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.program import TraceEntry
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import Massing, Storey
from mansion_planner.program.step_record import Record
from mansion_planner.program.storey_forms import capacity
from mansion_planner.program.storey_rooms import listed_area

__all__ = ["set_back", "setback_record"]

_SPARE = 0.2
"""Share of a storey that its rooms may leave before it is set back."""

_LEAST = 2.0
"""Least setback, metres."""

_MOST = 0.45
"""Greatest share of the ground floor's length by which an upper storey is set back."""


def set_back(
    decisions: Decisions, massing: Massing, storeys: Sequence[Storey], allocation: Allocation, knowledge: KnowledgeBase
) -> list[Storey]:
    """Return the storeys with those above the ground floor shortened, all by the same length, to what their rooms need.

    Nothing changes where the brief says anything of areas or of the outline.
    """
    upper = [storey for storey in storeys if storey.index >= 2]
    if not upper or not _is_free(decisions, massing, upper):
        return list(storeys)
    spare = math.inf
    for storey in upper:
        room = capacity(massing, storey)
        left = room - listed_area(storey, allocation, knowledge)
        spare = min(spare, left if left > _SPARE * room else 0.0)
    setback = float(math.floor(min(spare / (massing.depth - massing.corridor), _MOST * massing.length)))
    if setback < _LEAST:
        return list(storeys)
    return [replace(storey, setback=setback) if storey.index >= 2 else storey for storey in storeys]


def _is_free(decisions: Decisions, massing: Massing, upper: Sequence[Storey]) -> bool:
    """Whether it is a house with a plain outline that nobody stated, its upper storeys unlike the ground floor."""
    facts = decisions.facts
    house = decisions.building.family == "home" and decisions.building.parti == "house"
    stated = decisions.area_stated or decisions.outline is not None or facts.shapes or facts.setback or facts.protruding
    plain = not massing.wings and not massing.hall and len(massing.cores) == 1
    return house and plain and not stated and all(storey.copy is None or storey.copy >= 2 for storey in upper)


def setback_record(decisions: Decisions, storeys: Sequence[Storey]) -> Record:
    """Return the note on storeys that are set back although the brief does not ask for it."""
    setback = max((storey.setback for storey in storeys), default=0.0)
    if decisions.facts.setback or not setback:
        return Record()
    effect = f"storeys above the ground floor are {setback:g} m shorter: their rooms need no more"
    return Record((TraceEntry(words="", effect=effect),))
