"""Read a brief in English into facts."""

from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief

__all__ = ["BriefFacts", "read_brief"]
