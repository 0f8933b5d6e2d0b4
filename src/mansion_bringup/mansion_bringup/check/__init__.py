"""``mansion check``: a building verified from its geometry and its request, with code apart from the stages'.

Nothing here imports a stage, the catalogue or an export, so that a fault of theirs cannot hide itself; a contract of
import-linter keeps it so. `mansion_bringup.verify` adds the checks of formats.
"""

from mansion_bringup.check.building import check_building, check_floors
from mansion_bringup.check.fault import Fault

__all__ = ["Fault", "check_building", "check_floors"]
