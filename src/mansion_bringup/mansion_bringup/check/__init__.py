"""``mansion check``: a building verified from its geometry and its request, with code apart from the stages'.

Nothing here calls the planner, the solver or the scene package, so that a fault of theirs cannot hide itself.
"""

from mansion_bringup.check.building import check_building, check_floors
from mansion_bringup.check.fault import Fault

__all__ = ["Fault", "check_building", "check_floors"]
