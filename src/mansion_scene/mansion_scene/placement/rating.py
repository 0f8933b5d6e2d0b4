"""What a floor still lacks: copies that do not stand and relations that do not hold."""

from dataclasses import dataclass

import numpy as np

from mansion_geometry.boxes import gap_matrix
from mansion_scene.placement.floor import Floor, Placed
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.relations import LIMITS, relation_holds

__all__ = ["Rating", "rate", "relation_count"]


@dataclass(frozen=True)
class Rating:
    """How complete a floor is.

    Attributes
    ----------
    placed : int
        Copies that stand.
    held : int
        Relations and pairs that hold, over all copies.
    faulty : tuple of int
        Keys of copies with a relation that does not hold.
    """

    placed: int
    held: int
    faulty: tuple[int, ...]

    @property
    def value(self) -> float:
        """One number: a copy placed counts as much as three relations."""
        return 3.0 * self.placed + self.held


def relation_count(spec: Spec) -> int:
    """Return how many relations one copy is asked to hold, its pair among them."""
    return len(spec.relations) + (spec.link == "paired")


def rate(floor: Floor) -> Rating:
    """Count the placed copies and the relations that they hold."""
    held, faulty = 0, []
    for spec in floor.specs:
        if not relation_count(spec):
            continue
        paired = _paired(floor, spec)
        targets = [(kind, floor.boxes_of(target)) for kind, target in spec.relations]
        for copy in floor.copies(spec.index):
            box = np.array(copy.box)
            pose = box[None, :4]
            own = [bool(relation_holds(kind, pose, box[4], box[5], boxes)[0]) for kind, boxes in targets]
            if spec.link == "paired":
                own.append(copy.key in paired)
            held += sum(own)
            if not all(own):
                faulty.append(copy.key)
    return Rating(len(floor.placed), held, tuple(faulty))


def _paired(floor: Floor, spec: Spec) -> set[int]:
    """Return the keys of accessories that stand at an anchor of their own, the nearest pairs first."""
    if spec.link != "paired":
        return set()
    copies, hosts = floor.copies(spec.index), floor.boxes_of(spec.host)
    if not copies or not len(hosts):
        return set()

    def gaps(copy: Placed) -> list[float]:
        box = np.array(copy.box)
        return [float(g) for g in gap_matrix(box[None, :4], box[4], box[5], hosts)[0]]

    pairs = sorted((gap, i, j) for i, copy in enumerate(copies) for j, gap in enumerate(gaps(copy)))
    used: set[int] = set()
    taken: set[int] = set()
    for gap, i, j in pairs:
        if gap <= LIMITS["around"] and i not in used and j not in taken:
            used.add(i)
            taken.add(j)
    return {copies[i].key for i in used}
