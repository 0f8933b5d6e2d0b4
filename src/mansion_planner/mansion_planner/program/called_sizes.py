"""How large a building is that its brief calls small or large, compared with the usual one of its kind."""

from typing import Final

from mansion_knowledge import BuildingType
from mansion_planner.brief.bounds import Limit
from mansion_planner.brief.facts import BriefFacts

__all__ = ["called_bound", "called_size", "within_called"]

_SMALL, _LARGE = 0.88, 1.1
"""Shares of the usual gross area that bound what is called small or large."""

_WITHIN: Final = 0.04
"""Share by which a planned area stays within its bound: whole metres and walls move it."""

_SET_BACK: Final = 0.22
"""Share by which the ground floor of a house exceeds it: the storeys above may be set back."""


def called_size(facts: BriefFacts) -> str:
    """Return what the brief calls the building, ``small`` or ``large``; empty for neither."""
    return next((word for word, _ in facts.size if word in ("small", "large")), "")


def called_bound(facts: BriefFacts, building: BuildingType, storeys: int | None) -> tuple[float | None, Limit]:
    """Return the gross area that bounds a building which is called small or large, and which way.

    An area that the brief states says itself what is meant; then there is no bound.

    Parameters
    ----------
    storeys : int, optional
        How many are stated; the usual number where none is.
    """
    size = called_size(facts)
    if not size or facts.area or facts.floor_area:
        return None, ""
    usual = _usual_storey(building) * (storeys or building.floors[0])
    if size == "large":
        return float(round(_LARGE * usual)), "least"
    return float(round(building.small * (storeys or 1) if building.small else _SMALL * usual)), "most"


def _usual_storey(building: BuildingType) -> float:
    """Return the usual area of a storey; houses are drawn from the least to the greatest that is usual."""
    least, most = building.floor_area
    return (least + most) / 2.0 if building.parti == "house" else most


def within_called(area: float, facts: BriefFacts, building: BuildingType, storeys: int, stated: int | None) -> float:
    """Return the area of a storey, lessened or raised to what the building is called.

    Parameters
    ----------
    area : float
        What a storey has otherwise, square metres.
    storeys : int
        How many it has.
    stated : int, optional
        How many are stated.
    """
    bound, limit = called_bound(facts, building, stated)
    if bound is None:
        return area
    if limit == "least":
        spare = _SET_BACK if building.parti == "house" and storeys > 1 else _WITHIN
        return max(area, (1.0 + spare) * bound / storeys)
    return min(area, (1.0 - _WITHIN) * bound / storeys)
