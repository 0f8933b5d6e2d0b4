"""Options of the floor solver, with the defaults of section C.2 where it names one, its budget, and shapes of rooms."""

from dataclasses import dataclass, field
from typing import Final

from mansion_geometry.wall_sizes import ADJACENT_WALL

__all__ = ["ANY", "Budget", "EnergyWeights", "RoomShape", "SearchWeights", "SolverOptions", "shape_of"]


@dataclass(frozen=True)
class EnergyWeights:
    """Weights **w** of the energy of section C.2; from the record of ``benchmarks/floorplans/tune_weights.py``."""

    ratio: float = 0.516
    seed: float = 0.027
    corner: float = 0.258
    wall: float = 0.198


@dataclass(frozen=True)
class SearchWeights:
    """Weights of the wall search's energy in the order of ``Goal.weights``.

    Attributes
    ----------
    area, seed
        Relative area error; distance of centroid and seed in units of the room's side.
    corner, compact
        Corners beyond four; perimeter beyond that of a rectangle of 1 : 2.6.
    access, adjacent
        Edges that are not realised.
    thin
        Narrow places and pinches, as a share of the room's area (of 6 m2 in larger rooms).
    apart
        Metres of wall between rooms without an edge (only where the graph states neighbourhoods).
    straddle
        Metres of structural wall inside a room.
    wall
        Missing contact with the envelope, for rooms without a seed.
    narrow
        Rooms with any narrow place.
    """

    area: float = 1.0
    seed: float = 2.0
    corner: float = 0.05
    compact: float = 0.3
    access: float = 4.0
    adjacent: float = 3.0
    thin: float = 2.0
    apart: float = 0.3
    straddle: float = 3.0
    wall: float = 0.15
    narrow: float = 0.0


@dataclass(frozen=True)
class SolverOptions:
    """Options of `solve_floor`. Budgets count candidate layouts, never seconds.

    Attributes
    ----------
    retries, batch, base_radius, radius_gain, radius_growth
        ``N_retry``, ``B``, ``r_base`` (grid cells), ``k`` and the ratio of successive gamma of Algorithm 3.
    energy : EnergyWeights
        Weights of its score.
    wall_search : bool
        Move walls after the cut rounds; without it the result is that of the published algorithm.
    round_candidates : int
        Candidates of all cut rounds together, divided by the number of rooms, when the wall search follows.
    seeded_proposals, proposals : int
        Candidates of one coarse search per room, with seeds and without. Without seeds, a valid one gets as many again;
        on large floors the search is twice as long instead.
    attempts : int
        Most wall searches, as long as edges are unmet or rooms narrow.
    candidates : int
        Most candidate layouts (grown or moved) looked at for one floor, in all.
    spacing, unseeded_spacing : float
        Least distance of grid lines of the first search, with seeds and without, metres; it grows with the floor.
    cells : float
        About the most cells of the first search's grid; it decides what a candidate costs on large floors.
    min_width : float
        Minimum width of a room where its node gives none, metres.
    adjacent_wall : float
        Least length of wall that an ``adjacent`` edge needs, metres.
    seeded, unseeded : SearchWeights
        Weights of the wall search where most rooms have a seed, and where not.
    """

    retries: int = 10
    batch: int = 100
    base_radius: float = 2.0
    radius_gain: float = 4.0
    radius_growth: float = 1.25
    energy: EnergyWeights = field(default_factory=EnergyWeights)
    wall_search: bool = True
    round_candidates: int = 400
    seeded_proposals: int = 600
    proposals: int = 350
    attempts: int = 24
    candidates: int = 600_000
    spacing: float = 0.4
    unseeded_spacing: float = 0.6
    cells: float = 900.0
    min_width: float = 1.2
    adjacent_wall: float = ADJACENT_WALL
    seeded: SearchWeights = field(default_factory=lambda: SearchWeights(thin=0.7, narrow=0.1))
    unseeded: SearchWeights = field(
        default_factory=lambda: SearchWeights(area=3.2, corner=0.32, compact=0.7, thin=3.0, wall=0.1, narrow=0.5)
    )


@dataclass
class Budget:
    """How many candidate layouts may still be looked at.

    Examples
    --------
    >>> budget = Budget(150)
    >>> budget.take(100), budget.take(100), budget.take(100), budget.used
    (100, 50, 0, 150)
    """

    limit: int
    used: int = 0

    @property
    def left(self) -> int:
        """Candidates that may still be taken."""
        return max(0, self.limit - self.used)

    def take(self, wanted: int) -> int:
        """Take up to `wanted` candidates and return how many were granted."""
        granted = max(0, min(wanted, self.left))
        self.used += granted
        return granted


@dataclass(frozen=True)
class RoomShape:
    """Preferences for the rooms of one kind, each a factor of a weight of `SearchWeights` or a length.

    Attributes
    ----------
    compact : float
        Factor of the weight of a perimeter beyond `detour`.
    detour : float
        Compactness (perimeter / 4 sqrt(area)) up to which proportions cost nothing: 1 is a square, 1.01 a rectangle of
        1 : 1.33, 1.12 one of 1 : 2.6.
    corner : float
        Factor of the weight of each corner beyond four.
    wall : float
        Factor of the weight of missing contact with the envelope.
    facade : float
        Contact with the envelope that is wanted, in units of the square root of the room's area.
    """

    compact: float = 1.0
    detour: float = 1.12
    corner: float = 1.0
    wall: float = 1.0
    facade: float = 0.6


ANY: Final = RoomShape()
"""A room of which nothing more is known: a rectangle that touches the envelope."""

_BEDROOM: Final = RoomShape(compact=3.0, detour=1.02, corner=1.4)
"""Bedrooms of real flats (ResPlan) are 1 : 1.24 and fill .95 of their rectangle; those of a free search 1 : 1.7, .85.

Chosen on 20 plans; what else was tried is in docs/floor_solver.md.
"""

_SHAPES: Final[dict[str, RoomShape]] = {"bedroom": _BEDROOM, "master_bedroom": _BEDROOM}


def shape_of(room_type: str) -> RoomShape:
    """Return the shape that rooms of a type should have.

    Examples
    --------
    >>> shape_of("bedroom").detour < shape_of("storage").detour
    True
    """
    return _SHAPES.get(room_type, ANY)
