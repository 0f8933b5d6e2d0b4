"""A budget of candidate layouts: searches count what they look at, never the time it takes."""

from dataclasses import dataclass

__all__ = ["Budget"]


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
