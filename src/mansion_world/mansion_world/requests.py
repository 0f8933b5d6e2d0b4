"""Sources of a world's requests: drawn from a mixture here, read from a list in `brief_list`."""

from dataclasses import dataclass
from typing import Final, Protocol

from mansion_msgs_py.codec import encode
from mansion_world.mixture import MOST_FLOOR_AREA, Mixture
from mansion_world.sampling import WorldRequest, sample
from mansion_world.world_folder import WorldFolder

__all__ = ["MOST_ATTEMPTS", "Requests", "Sampled", "Terms"]

MOST_ATTEMPTS: Final = 10
"""Requests for one place of a sampled world before it is left empty."""


@dataclass(frozen=True)
class Terms:
    """What is asked of the buildings beside their requests.

    Attributes
    ----------
    attempts : int
        Requests for one place before it is left empty.
    floor_area : float
        Greatest area of a floor, m2.
    distinct : bool
        Whether a building that is nearly the same as an earlier one is set aside.
    """

    attempts: int
    floor_area: float
    distinct: bool


_TERMS: Final = Terms(MOST_ATTEMPTS, MOST_FLOOR_AREA, distinct=True)


class Requests(Protocol):
    """The requests of a world by index and attempt, the same in every process and at every call."""

    @property
    def seed(self) -> int:
        """The world's seed."""

    @property
    def origin(self) -> str:
        """What the requests follow from besides the seed, as ``world.json`` keeps it."""

    @property
    def terms(self) -> Terms:
        """What is asked of the buildings beside their requests."""

    def at(self, index: int, attempt: int = 0) -> WorldRequest:
        """Return a request; `attempt` is below `Terms.attempts`."""

    def prepare(self, world: WorldFolder) -> None:
        """Fit what earlier runs left in the folder to these requests, before any work."""


@dataclass(frozen=True)
class Sampled:
    """Requests drawn from a mixture."""

    seed: int
    mix: Mixture
    terms: Terms = _TERMS

    @property
    def origin(self) -> str:
        """The mixture."""
        return encode(self.mix)

    def at(self, index: int, attempt: int = 0) -> WorldRequest:
        """Return the request that `sample` draws."""
        return sample(index, self.seed, self.mix, attempt=attempt)

    def prepare(self, world: WorldFolder) -> None:
        """Leave the folder as it is: seed and mixture are those of the earlier run."""
