"""AI2-THOR house JSON, schema 1.0.0, as ``CreateHouse`` reads it."""

from mansion_export.thor.house import SCHEMA, house

__all__ = ["SCHEMA", "house"]
