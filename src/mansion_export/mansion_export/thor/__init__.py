"""AI2-THOR house JSON, schema 1.0.0: what ``CreateHouse`` reads, and a validator that needs no Unity.

Its axes, and what else of the format the skills' AI2-THOR engine needs too, are in `mansion_geometry.thor`.
"""

from mansion_export.thor.house import house
from mansion_export.thor.validation import HouseFault, validate_house
from mansion_export.thor.vocabulary import SCHEMA

__all__ = ["SCHEMA", "HouseFault", "house", "validate_house"]
