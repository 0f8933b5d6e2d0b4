"""A budget of search that counts work, never time, so that results do not depend on the machine."""

from dataclasses import dataclass

__all__ = ["Effort"]


@dataclass
class Effort:
    """Work spent on a room: about one unit for two microseconds of a desktop core.

    Attributes
    ----------
    limit : float
        Where improvement ends.
    spent : float
    """

    limit: float
    spent: float = 0.0

    def search(self, poses: int, boxes: int) -> None:
        """Count one search over `poses` against `boxes`."""
        self.spent += 600.0 + 0.3 * poses + 0.008 * poses * boxes

    def flood(self, cells: int) -> None:
        """Count one examination of reachability on a grid of `cells`."""
        self.spent += 120.0 + 0.006 * cells

    @property
    def over(self) -> bool:
        """Whether the limit is reached."""
        return self.spent >= self.limit
