"""Sessions and their skills: loading, taking turns, cancelling, saving."""

from mansion_skills.engine.engine import Engine

__all__ = ["Engine"]
