"""Place the objects of one room: constructions under changing priorities, the best of them, improved."""

import numpy as np

from mansion_geometry.boxes import rotation_of
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.placement import Discarded, PlacedObject, PlacementResult, PlacementRoom
from mansion_scene.placement.construct import Construction, construct
from mansion_scene.placement.effort import Effort
from mansion_scene.placement.floor import Floor, Placed
from mansion_scene.placement.groups import Group, Spec, make_groups
from mansion_scene.placement.improve import improve
from mansion_scene.placement.options import PlacementOptions
from mansion_scene.placement.rating import rate, relation_count
from mansion_scene.placement.room import RoomModel, build_room

__all__ = ["solve_room"]


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
    """Construct a few times, what failed earlier each time (squeaky wheel); then improve the best.

    The margins of comfort are given up only where something is missing with them.
    """
    asked = sum(spec.quantity for spec in specs)
    goal = 3.0 * asked + sum(spec.quantity * relation_count(spec) for spec in specs)
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
        floor.effort.limit *= 1.75
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
