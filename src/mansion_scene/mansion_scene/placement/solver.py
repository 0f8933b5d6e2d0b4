"""The placement solver of a room: several constructions, the best of which is improved.

What failed in a construction comes earlier in the next: squeaky wheel optimization (D. E. Joslin and D. P. Clements,
"Squeaky Wheel Optimization", Journal of Artificial Intelligence Research 10, 1999). Improvement is large neighbourhood
search (P. Shaw, "Using Constraint Programming and Local Search Methods to Solve Vehicle Routing Problems", CP 1998): a
bounded number of moves removes some copies around what is missing or misplaced and places them anew, and each is kept
only where the room is no worse.
"""

from collections.abc import Sequence

import numpy as np

from mansion_geometry.boxes import rotation_of
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.placement import Discarded, PlacedObject, PlacementResult, PlacementRoom
from mansion_scene.placement.construct import Construction, construct
from mansion_scene.placement.floor import Effort, Floor, Placed
from mansion_scene.placement.groups import Group, Spec, make_groups
from mansion_scene.placement.options import PlacementOptions
from mansion_scene.placement.relations import FIRST, Rating, rate, relation_count
from mansion_scene.placement.room_model import RoomModel, build_room

__all__ = ["improve", "solve_room"]


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
    """Remove a misplaced copy and some others, near it or drawn at random."""
    keys: set[int] = set()
    by_key = {copy.key: copy for copy in floor.placed}
    if not by_key:
        return
    kept = _in_runs(floor, rating)
    pool = [copy for copy in floor.placed if not specs[copy.spec].rows and copy.key not in kept] or floor.placed
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
    floor.remove(keys | _members(floor, keys, every=bool(rng.random() < 0.5)) - kept)


def _in_runs(floor: Floor, rating: Rating) -> set[int]:
    """Return the keys of worktops and appliances that stand in a run, which is kept or given up as a whole."""
    fitted = {copy.key for copy in floor.placed if floor.specs[copy.spec].role.fitment}
    return fitted if fitted.isdisjoint(rating.faulty) else set()


def _wanted_at(floor: Floor, copy: Placed, rng: np.random.Generator) -> Placed:
    """Return the copy near which a misplaced one should be: one that it relates to, or itself."""
    spec = floor.specs[copy.spec]
    targets = [target for kind, target in spec.relations if kind != "far"]
    targets += [spec.host] if spec.host >= 0 else []
    there = [c for target in targets for c in floor.copies(target)]
    if not there or rng.random() < 0.3:
        return copy
    return there[int(rng.integers(len(there)))]


def _members(floor: Floor, keys: set[int], *, every: bool) -> set[int]:
    """Return the keys of the members removed with their anchor: pairs and seats around it, or `every` member."""

    def goes(copy: Placed) -> bool:
        return copy.host in keys and (every or floor.specs[copy.spec].link in ("paired", "around"))

    return {copy.key for copy in floor.placed if goes(copy)}


def _recreate(build: Construction, specs: Sequence[Spec]) -> None:
    """Place missing copies, mostly the large ones first: with all relations, then with as many as can hold."""
    missing = [spec for spec in specs if build.missing(spec) > 0 and not spec.rows]
    noise = build.rng.uniform(0.3, 1.7, len(missing))
    depth = {spec.index: _depth(spec, specs) for spec in missing}
    ranked = sorted(
        zip(missing, noise),
        key=lambda m: (not m[0].first, depth[m[0].index], -m[0].size[0] * m[0].size[1] * float(m[1])),
    )
    for strict in (True, False):
        for spec, _ in ranked:
            if build.missing(spec) > 0:
                build.place_copies(spec, strict=strict)


def _depth(spec: Spec, specs: Sequence[Spec]) -> int:
    """Return how many hosts are above an object."""
    return 0 if spec.host < 0 else 1 + _depth(specs[spec.host], specs)


def solve_room(room: PlacementRoom, seed: int, options: PlacementOptions) -> PlacementResult:
    """Place a room's objects (see `mansion_scene.placement.place_room`)."""
    model = build_room(room, options)
    specs, groups = make_groups(room)
    rng = item_generator(seed, "place", room.room_id)
    floor = _search(model, specs, groups, rng, options)
    return _result(room, specs, floor)


def _search(
    model: RoomModel, specs: list[Spec], groups: list[Group], rng: np.random.Generator, options: PlacementOptions
) -> Floor:
    """Construct a few times, with what failed coming earlier each time; then improve the best.

    The margins of comfort are given up only where something is missing with them.
    """
    asked = sum(spec.quantity for spec in specs)
    goal = 3.0 * asked + sum(spec.quantity * (relation_count(spec) + FIRST * spec.first) for spec in specs)
    boost = dict.fromkeys((g.anchor.index for g in groups), 0)
    best: tuple[float, Construction] | None = None
    effort = Effort(options.effort)
    roomy = True
    for attempt in range(max(1, options.attempts)):
        floor = Floor(model, specs, options, effort, roomy=roomy)
        order = sorted(groups, key=lambda g: g.priority - boost[g.anchor.index])
        aisle = model.aisle * (1.0, 0.75, 0.6)[min(attempt, 2)]
        build = construct(floor, specs, order, rng, aisle=aisle)
        rating = rate(floor)
        if best is None or rating.value > best[0]:
            best = rating.value, build
        missing = asked - rating.placed
        if rating.value >= goal or effort.spent > (1.0 if missing else 0.5) * effort.limit:
            break
        # One or two left over may find room with another order; many will not with these margins.
        roomy = not options.tight or (missing <= 0.1 * asked and (attempt < 1 or not missing))
        for group in groups:
            if any(floor.count(s.index) < s.quantity for s in (group.anchor, *group.members)):
                boost[group.anchor.index] += 1
    assert best is not None
    return _improved(best[1], specs, asked, goal, options)


def _improved(build: Construction, specs: list[Spec], asked: int, goal: float, options: PlacementOptions) -> Floor:
    floor, rating = improve(build, specs, moves=options.moves, goal=goal)
    if options.tight and rating.placed < asked:
        build.floor = floor.copy()
        build.floor.relax()
        floor.effort.extend(1.75)
        floor, _ = improve(build, specs, moves=2 * options.moves, goal=goal)
    return floor


def _result(room: PlacementRoom, specs: list[Spec], floor: Floor) -> PlacementResult:
    placements: list[PlacedObject] = []
    discarded: list[Discarded] = []
    for spec in specs:
        copies = floor.copies(spec.index)
        placements += [_placed(room.room_id, spec, number, copy) for number, copy in enumerate(copies, 1)]
        lost = spec.quantity - len(copies)
        if lost:
            discarded.append(Discarded(name=spec.name, count=lost, reason=_reason(spec, len(copies))))
    return PlacementResult(room_id=room.room_id, placements=placements, discarded=discarded)


def _placed(room_id: str, spec: Spec, number: int, copy: Placed) -> PlacedObject:
    x, y, ux, uy = copy.box[:4]
    return PlacedObject(
        id=f"{room_id}/{spec.name}_{number}",
        name=spec.name,
        center=(round(x, 6) + 0.0, round(y, 6) + 0.0),
        rotation=rotation_of(ux, uy),
        size=copy.size,
    )


def _reason(spec: Spec, placed: int) -> str:
    if spec.rows and placed:
        return f"the {spec.rows} x {spec.cols} matrix was reduced to {placed} copies: no larger one fits"
    if spec.where == "edge":
        return "no wall has free length for it that keeps doors clear and everything reachable"
    return "no free place keeps it clear of others, doors clear and everything reachable"
