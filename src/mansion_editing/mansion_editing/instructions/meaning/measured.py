"""Which of several things an adjective of size means: the tall lamp, a bigger rug."""

from collections.abc import Callable, Sequence
from typing import Final

from mansion_editing.instructions.phrases.nouns import COMPARATIVES, is_comparative
from mansion_editing.instructions.phrases.runs import SIDES
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point3

__all__ = ["compares", "told_by_size"]

MARGIN: Final = 1.2
"""How many times a thing must be as large as the next one, so that it is plain which is meant."""


def _area(size: Point3) -> float:
    return size[0] * size[1]


def _height(size: Point3) -> float:
    return size[2]


def _length(size: Point3) -> float:
    return max(size[:2])


_MEASURES: Final[dict[str, tuple[Callable[[Point3], float], float]]] = {
    "large": (_area, 1.0), "small": (_area, -1.0), "tall": (_height, 1.0), "low": (_height, -1.0),
    "long": (_length, 1.0),
}  # fmt: skip


def compares(hints: Sequence[str], new: Point3, old: Point3) -> bool:
    """Whether one size is to another as the comparatives among some adjectives say."""
    for hint in filter(is_comparative, hints):
        measure, sign = _MEASURES[COMPARATIVES[hint]]
        small, great = (measure(old), measure(new)) if sign > 0 else (measure(new), measure(old))
        if great < small * _CLEARLY:
            return False
    return True


_CLEARLY: Final = 1.05
"""How many times a thing must be as large as another to be a larger one."""


def told_by_size(items: Sequence[SceneObject], hints: Sequence[str]) -> list[SceneObject]:
    """Return the one of several that adjectives of size plainly tell; all where they do not."""
    for hint in hints:
        if hint in SIDES:
            continue
        measure, sign = _MEASURES[COMPARATIVES.get(hint, hint)]
        ordered = sorted(items, key=lambda item: (-sign * measure(item.size), item.id))
        if len(ordered) < 2:
            continue
        first, second = measure(ordered[0].size), measure(ordered[1].size)
        if max(first, second) >= MARGIN * min(first, second) > 0.0:
            return ordered[:1]
    return list(items)
