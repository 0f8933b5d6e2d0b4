"""The improvement pass: take some copies away around what is missing or misplaced, and place them anew.

Large neighbourhood search ("ruin and recreate"): a bounded number of moves, each kept only where the room is no worse.
"""

from collections.abc import Sequence

import numpy as np

from mansion_scene.placement.construct import Construction
from mansion_scene.placement.floor import Floor, Placed
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.rating import Rating, rate

__all__ = ["improve"]


def improve(build: Construction, specs: Sequence[Spec], *, moves: int, goal: float) -> tuple[Floor, Rating]:
    """Improve a construction's floor.

    Parameters
    ----------
    build : Construction
        Its floor is the start; it ends with the best floor.
    specs : sequence of Spec
    moves : int
        Most moves.
    goal : float
        Rating value at which nothing is left to improve.

    Returns
    -------
    The best floor and its rating.
    """
    rating = rate(build.floor)
    for _ in range(moves):
        if rating.value >= goal or build.floor.effort.over:
            break
        before = build.floor
        build.floor = before.copy()
        _ruin(build.floor, rating, specs, build.rng)
        _recreate(build, specs)
        after = rate(build.floor)
        if after.value >= rating.value:
            rating = after
        else:
            build.floor = before
    return build.floor, rating


def _ruin(floor: Floor, rating: Rating, specs: Sequence[Spec], rng: np.random.Generator) -> None:
    """Take away a misplaced copy and some others near it or like it."""
    keys: set[int] = set()
    by_key = {copy.key: copy for copy in floor.placed}
    if not by_key:
        return
    pool = [copy for copy in floor.placed if not specs[copy.spec].rows] or floor.placed
    if rating.faulty and rng.random() < 0.8:
        faulty = by_key[rating.faulty[int(rng.integers(len(rating.faulty)))]]
        keys.add(faulty.key)
        centre = _wanted_at(floor, faulty, rng)
    else:
        centre = pool[int(rng.integers(len(pool)))]
    extra = 1 + int(rng.integers(4))
    if rng.random() < 0.7:
        distance = [float(np.hypot(c.box[0] - centre.box[0], c.box[1] - centre.box[1])) for c in pool]
        order = np.argsort(np.array(distance), kind="stable")[: 2 * extra + 1]
        order = rng.permutation(order)[: extra + 1]
    else:
        order = rng.permutation(len(pool))[:extra]
    keys |= {pool[int(i)].key for i in order}
    floor.take(keys | _members(floor, keys, every=bool(rng.random() < 0.5)))


def _wanted_at(floor: Floor, copy: Placed, rng: np.random.Generator) -> Placed:
    """Return where a misplaced copy should be: at a copy that it relates to, or where it is."""
    spec = floor.specs[copy.spec]
    targets = [target for kind, target in spec.relations if kind != "far"]
    targets += [spec.host] if spec.host >= 0 else []
    there = [c for target in targets for c in floor.copies(target)]
    if not there or rng.random() < 0.3:
        return copy
    return there[int(rng.integers(len(there)))]


def _members(floor: Floor, keys: set[int], *, every: bool) -> set[int]:
    """Return the keys of what goes with its anchor: pairs and seats around it, or `every` member."""

    def goes(copy: Placed) -> bool:
        return copy.host in keys and (every or floor.specs[copy.spec].link in ("paired", "around"))

    return {copy.key for copy in floor.placed if goes(copy)}


def _recreate(build: Construction, specs: Sequence[Spec]) -> None:
    """Place what is missing, mostly the large first: with all relations, then with as many as can hold."""
    missing = [spec for spec in specs if build.missing(spec) > 0 and not spec.rows]
    noise = build.rng.uniform(0.3, 1.7, len(missing))
    depth = {spec.index: _depth(spec, specs) for spec in missing}
    ranked = sorted(zip(missing, noise), key=lambda m: (depth[m[0].index], -m[0].size[0] * m[0].size[1] * float(m[1])))
    for strict in (True, False):
        for spec, _ in ranked:
            if build.missing(spec) > 0:
                build.place_copies(spec, strict=strict)


def _depth(spec: Spec, specs: Sequence[Spec]) -> int:
    """Return how many hosts are above an object."""
    return 0 if spec.host < 0 else 1 + _depth(specs[spec.host], specs)
