"""What became of every wish of a brief: derived from the plan, or from the finished floors where there are some."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Final

import msgspec

from mansion_bringup.building.building_wishes import BUILDING_JUDGES
from mansion_bringup.building.interior_wishes import INTERIOR_JUDGES
from mansion_bringup.building.judged_building import JudgedBuilding, finished_building, planned_building
from mansion_bringup.building.room_wishes import ROOM_JUDGES
from mansion_bringup.building.verdicts import Judge, Verdict, comma_separated
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.wishes import Wish

__all__ = ["receipt", "receipt_of_plan"]


def receipt(wishes: Iterable[Wish], program: BuildingProgram, scenes: Sequence[FloorScene]) -> list[Wish]:
    """Return the wishes with the status that the finished floors give them.

    Parameters
    ----------
    wishes : iterable of Wish
    program : BuildingProgram
    scenes : sequence of FloorScene
        All floors.
    """
    state = finished_building(program, scenes)
    return [_judged(wish, state) for wish in wishes]


def receipt_of_plan(program: BuildingProgram, topologies: Sequence[FloorTopology]) -> list[Wish]:
    """Return a plan's wishes with the status that they are going to have if every later stage keeps to the plan."""
    state = planned_building(program, topologies)
    return [_judged(wish, state) for wish in program.wishes]


def _judged(wish: Wish, state: JudgedBuilding) -> Wish:
    if wish.kind == "unread":
        return msgspec.structs.replace(wish, status="not_understood")
    verdict = _JUDGES[wish.kind](wish, state)
    reason = verdict.reason
    if verdict.status != "not_met" and wish.reason and wish.kind in ("room", "building_type", "object"):
        reason = f"{wish.reason}; {reason}" if reason else wish.reason
        verdict = Verdict("partly", reason, verdict.rooms, verdict.objects)
    elif verdict.status == "met" and wish.value.unheeded and wish.kind != "object":
        reason = f"nothing was made of {comma_separated([repr(word) for word in wish.value.unheeded])}"
        verdict = Verdict("partly", reason, verdict.rooms, verdict.objects)
    return msgspec.structs.replace(
        wish, status=verdict.status, reason=reason, rooms=list(verdict.rooms), objects=list(verdict.objects)
    )


_JUDGES: Final[Mapping[str, Judge]] = {**BUILDING_JUDGES, **ROOM_JUDGES, **INTERIOR_JUDGES}
