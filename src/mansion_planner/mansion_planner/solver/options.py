"""Options of the floor solver, with the defaults of the supplement's section C.2 where it names one."""

from dataclasses import dataclass, field

__all__ = ["EnergyWeights", "SearchWeights", "SolverOptions"]


@dataclass(frozen=True)
class EnergyWeights:
    """Weights **w** of the energy of section C.2; chosen by ``benchmarks/tune_weights.py``."""

    ratio: float = 0.55
    seed: float = 0.15
    corner: float = 0.20
    wall: float = 0.10


@dataclass(frozen=True)
class SearchWeights:
    """Weights of the wall search's energy (order of `objective.WEIGHTS`)."""

    area: float = 1.0
    seed: float = 2.0
    corner: float = 0.05
    compact: float = 0.3
    access: float = 4.0
    adjacent: float = 1.5
    thin: float = 2.0
    apart: float = 0.3
    straddle: float = 3.0
    wall: float = 0.15


@dataclass(frozen=True)
class SolverOptions:
    """Options of `solve_floor`. Budgets count candidate layouts, never seconds.

    Attributes
    ----------
    retries, batch, base_radius, radius_gain, radius_growth
        ``N_retry``, ``B``, ``r_base`` (grid cells), ``k`` and the ratio of successive gamma of Algorithm 3.
    candidates : int
        Most candidate layouts (grown, moved or constructed) looked at for one floor.
    min_width : float
        Minimum width of a room where its node gives none, metres.
    adjacent_wall : float
        Least length of wall that an ``adjacent`` edge needs, metres.
    """

    retries: int = 10
    batch: int = 100
    base_radius: float = 2.0
    radius_gain: float = 4.0
    radius_growth: float = 1.25
    candidates: int = 200_000
    min_width: float = 1.2
    adjacent_wall: float = 0.3
    energy: EnergyWeights = field(default_factory=EnergyWeights)
    search: SearchWeights = field(default_factory=SearchWeights)
