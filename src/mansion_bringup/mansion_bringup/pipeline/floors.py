"""The stages of one floor: its layout, the best of several where one falls short, and its furniture."""

import traceback
from collections.abc import Callable, Sequence
from concurrent.futures import BrokenExecutor
from typing import Final, TypeVar

import msgspec

from mansion_bringup.pipeline.layout_choice import reseeded, shortfall
from mansion_bringup.pipeline.stages import Stages
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest, PlanReply

__all__ = ["at_stage", "distinct_floors", "furnish", "solve", "source_floor"]

T = TypeVar("T")

_MISSED_SHARE: Final = 0.02
"""Share of a floor that rooms may miss before the places of the sketch, and other draws, are tried."""


def at_stage(stage: str, call: Callable[[], T]) -> T:
    """Run one stage; any failure becomes a `MansionError` that names the stage."""
    try:
        return call()
    except MansionError as error:
        part = {"part": error.stage} if error.stage not in ("", stage) else {}
        raise error.with_details(**part, stage=stage) from error
    except BrokenExecutor:
        raise
    except Exception as error:
        raise MansionError(
            ErrorCode.INTERNAL,
            f"{type(error).__name__}: {error}",
            details={"stage": stage, "traceback": traceback.format_exc(limit=8)},
        ) from error


def source_floor(plan: PlanReply, index: int) -> int:
    """Return the position of the floor whose layout the floor at position `index` shares."""
    copied = plan.program.floors[index].copy
    if copied is None:
        return index
    numbers = [floor.index for floor in plan.program.floors]
    return source_floor(plan, numbers.index(copied))


def distinct_floors(plan: PlanReply) -> list[int]:
    """Return the positions of the floors that have a layout of their own."""
    return sorted({source_floor(plan, index) for index in range(len(plan.program.floors))})


def solve(stages: Stages, plan: PlanReply, index: int) -> FloorLayout:
    """Lay out the floor at position `index` (Algorithm 1, line 8).

    Where the layout misses areas or relations or cuts a room off, the sketch of a floor that is solved freely because
    its sketch could not give what is asked, and other draws, are tried; the layout that meets most is taken.
    """
    problem = plan.problems[index]

    def laid_out(problem: FloorProblem) -> FloorLayout:
        return at_stage(f"solve_floor (floor {plan.program.floors[index].index})", lambda: stages.solve(problem))

    layout = laid_out(problem)
    fallback = plan.fallbacks[index] if plan.fallbacks else None
    best = (shortfall(plan, index, layout), layout)
    tolerated = _MISSED_SHARE * sum(node.area or 0.0 for node in problem.nodes)
    for other in (*filter(None, [fallback]), *reseeded(problem)):
        if best[0] <= (False, tolerated):
            break
        tried = laid_out(other)
        found = (shortfall(plan, index, tried), tried)
        best = found if found[0] < best[0] else best
    return best[1]


def furnish(
    stages: Stages, plan: PlanReply, layout: FloorLayout, index: int, libraries: Sequence[str] = ()
) -> FloorScene:
    """Furnish the floor at position `index` (Algorithm 1, lines 9 to 17), with own assets of libraries first."""
    program = plan.program
    floor = program.floors[index]
    request = FurnishRequest(
        building_id=program.building_id,
        floor=floor,
        floors=[entry.index for entry in program.floors],
        labels=[entry.label for entry in program.floors],
        connectivity=program.vertical_connectivity,
        topology=plan.topologies[index],
        layout=layout,
        building_type=program.kind,
        called=program.building_type if program.planned_like else msgspec.UNSET,
        style=program.style,
        outside=program.outside,
        seed=program.seed,
        planner="llm" if plan.llm is not None else "rules",
        description=program.description if plan.llm is not None else "",
        assets=tuple(libraries) or msgspec.UNSET,
    )
    return at_stage(f"furnish_floor (floor {floor.index})", lambda: stages.furnish(request))
