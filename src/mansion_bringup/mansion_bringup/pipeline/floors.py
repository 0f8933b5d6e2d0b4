"""One floor through the stages: layout (shared by copies), then scene."""

import traceback
from collections.abc import Callable
from typing import TypeVar

from mansion_bringup.pipeline.stages import Stages
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest, PlanReply

__all__ = ["at_stage", "distinct_floors", "furnish", "source_floor", "solve"]

T = TypeVar("T")


def at_stage(stage: str, call: Callable[[], T]) -> T:
    """Run one stage; any failure becomes a `MansionError` that names it."""
    try:
        return call()
    except MansionError as error:
        if error.stage not in ("", stage):
            error.info.details["part"] = error.stage
        error.info.details["stage"] = stage
        raise
    except Exception as error:
        raise MansionError(
            ErrorCode.INTERNAL,
            f"{type(error).__name__}: {error}",
            details={"stage": stage, "traceback": traceback.format_exc(limit=8)},
        ) from error


def source_floor(plan: PlanReply, index: int) -> int:
    """Return the position of the floor whose layout floor number `index` (a position too) shares."""
    copied = plan.program.floors[index].copy
    if copied is None:
        return index
    numbers = [floor.index for floor in plan.program.floors]
    return source_floor(plan, numbers.index(copied))


def distinct_floors(plan: PlanReply) -> list[int]:
    """Return the positions of the floors that have a layout of their own."""
    return sorted({source_floor(plan, index) for index in range(len(plan.program.floors))})


def solve(stages: Stages, plan: PlanReply, index: int) -> FloorLayout:
    """Lay out the floor at position `index` (Algorithm 1, line 8)."""
    floor = plan.program.floors[index].index
    return at_stage(f"solve_floor (floor {floor})", lambda: stages.solve(plan.problems[index]))


def furnish(stages: Stages, plan: PlanReply, layout: FloorLayout, index: int) -> FloorScene:
    """Furnish the floor at position `index` (Algorithm 1, lines 9 to 17)."""
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
        building_type=program.building_type,
        style=program.style,
        seed=program.seed,
        planner="llm" if plan.llm is not None else "rules",
        description=program.description if plan.llm is not None else "",
    )
    return at_stage(f"furnish_floor (floor {floor.index})", lambda: stages.furnish(request))
