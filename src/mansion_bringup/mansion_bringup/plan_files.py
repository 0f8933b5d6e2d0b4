"""Plans from files, with the optional dependency that reads them."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

from mansion_bringup.extras import ensure_extra
from mansion_msgs_py.building_plan import BuildingPlan
from mansion_planner.plan_files import extra_for, read_plan

__all__ = ["plan_from_file"]


def plan_from_file(
    path: Path, complete: Sequence[Literal["doors", "windows"]] = (), layers: Mapping[str, str] | None = None
) -> BuildingPlan:
    """Read a plan as `mansion_planner.plan_files.read_plan` does, installing what that needs where that may be done."""
    if extra := extra_for(path):
        ensure_extra(extra)
    return read_plan(path, complete=complete, layers=layers)
