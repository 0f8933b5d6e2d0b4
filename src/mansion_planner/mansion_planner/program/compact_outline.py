"""Outlines of homes that are too small for wings: an L of two short arms that the rooms share freely."""

from dataclasses import replace

from shapely import affinity
from shapely.geometry import Polygon

from mansion_geometry.randomness import item_generator
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.shape_sizes import least_area

__all__ = ["compact_l", "with_compact_outline"]

_LEAST = 48.0
"""Least gross area of a storey with two arms of rooms, square metres."""

_LEAST_WITH_STAIR = 70.0


def with_compact_outline(decisions: Decisions, area: float, stairs: int) -> Decisions:
    """Return decisions with an outline of its own for an L-shaped home whose storeys are too small for wings.

    Parameters
    ----------
    decisions : Decisions
    area : float
        Gross area of a storey, square metres.
    stairs : int
    """
    shapes = decisions.facts.shapes
    wanted = bool(shapes) and shapes[0][0] == "L" and decisions.building.family == "home" and decisions.outline is None
    too_small = area < 0.98 * least_area("L", stairs)
    if not wanted or not too_small or area < (_LEAST_WITH_STAIR if stairs else _LEAST):
        return decisions
    return replace(decisions, outline=compact_l(area, decisions.seed), free_form=True)


def compact_l(area: float, seed: int) -> Polygon:
    """Return an L-shaped outline whose arms are 0.5 to 0.58 of its length and depth, turned and mirrored by the seed.

    Examples
    --------
    >>> outline = compact_l(64.0, 3)
    >>> round(outline.area, 1), len(outline.exterior.coords) - 1
    (64.0, 6)
    """
    generator = item_generator(seed, "compact outline")
    ratio, across, along = generator.uniform((1.0, 0.5, 0.5), (1.3, 0.58, 0.58)).tolist()
    share = 1.0 - (1.0 - across) * (1.0 - along)
    length = round((area * ratio / share) ** 0.5, 1)
    arm = round(across * length, 1)
    # The depth is what is left to choose, so that the area is met exactly.
    depth = area / (length - (length - arm) * (1.0 - along))
    notch = along * depth
    outline = Polygon([(0.0, 0.0), (length, 0.0), (length, notch), (arm, notch), (arm, depth), (0.0, depth)])
    if generator.random() < 0.5:
        outline = affinity.scale(outline, xfact=-1.0, origin=(length / 2, 0.0))
    if generator.random() < 0.5:
        outline = affinity.scale(outline, yfact=-1.0, origin=(0.0, depth / 2))
    return Polygon(outline.exterior.coords).normalize().reverse()
