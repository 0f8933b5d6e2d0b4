"""Random numbers of the kernels: the state is an array of one integer, so that a seed decides every draw."""

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import Ints

__all__ = ["draw", "uniform"]


@kernel
def draw(rng: Ints) -> int:
    """Return 31 random bits and advance `rng` (a 64-bit linear congruential generator with output mixing)."""
    x = rng[0] * 6364136223846793005 + 1442695040888963407
    rng[0] = x
    y = (x >> 33) & 0x7FFFFFFF
    return int((y ^ (y >> 15)) & 0x7FFFFFFF)


@kernel
def uniform(rng: Ints) -> float:
    """Return a random number in [0, 1)."""
    return draw(rng) / 2147483648.0
