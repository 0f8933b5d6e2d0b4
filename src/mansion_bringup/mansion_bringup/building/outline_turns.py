"""The form of an outline by its left and right turns."""

from mansion_msgs_py.shapes import Ring

__all__ = ["TURNS", "same_turns", "turns_of"]

TURNS = {"L": "LLLLLR", "U": "LLLLLLRR", "T": "LLLLRLLR", "H": "LLLLRRLLLLRR"}
"""Left and right turns of an outline that is walked counter-clockwise, from any corner."""


def turns_of(ring: Ring) -> str:
    """Return how an outline turns at each corner; points on a straight line are no corners."""
    crosses = [
        (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
        for (ax, ay), (bx, by), (cx, cy) in zip([ring[-1], *ring[:-1]], ring, [*ring[1:], ring[0]], strict=True)
    ]
    return "".join("L" if cross > 0 else "R" for cross in crosses if abs(cross) > 1e-6)


def same_turns(turns: str, word: str) -> bool:
    """Tell whether turns are those of a form, from any corner on."""
    return len(turns) == len(word) and turns in word * 2
