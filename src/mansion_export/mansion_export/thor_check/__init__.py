"""A validator of AI2-THOR house JSON that needs no Unity."""

from mansion_export.thor_check.fault import HouseFault
from mansion_export.thor_check.validate import LEAST_POSITIONS, validate_house

__all__ = ["LEAST_POSITIONS", "HouseFault", "validate_house"]
