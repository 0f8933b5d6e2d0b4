"""Files of plans, in Mansion's own JSON and in formats of other programs, as `BuildingPlan`."""

from mansion_planner.plan_files.reading import EXTRAS, extra_for, read_plan

__all__ = ["EXTRAS", "extra_for", "read_plan"]
