"""Place the objects of one room: constructions under changing priorities, the best of them, improved."""

from dataclasses import dataclass

import numpy as np

from mansion_geometry.boxes import rotation_of
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.placement import Discarded, PlacedObject, PlacementResult, PlacementRoom
from mansion_scene.placement.construct import construct
from mansion_scene.placement.floor import Floor, Placed
from mansion_scene.placement.groups import Group, Spec, make_groups
from mansion_scene.placement.options import PlacementOptions
from mansion_scene.placement.relations import relation_holds
from mansion_scene.placement.room import RoomModel, build_room

__all__ = ["solve_room"]


@dataclass(frozen=True)
class _Rating:
    """How complete a floor is; compared in this order."""

    placed: int
    relations: int

    @property
    def value(self) -> float:
        return 3.0 * self.placed + self.relations


def solve_room(room: PlacementRoom, seed: int, options: PlacementOptions) -> PlacementResult:
    """Place a room's objects (see `mansion_scene.placement.place_room`)."""
    model = build_room(room, options)
    specs, groups = make_groups(room)
    rng = item_generator(seed, "place", room.room_id)
    floor = _search(model, specs, groups, rng, options)
    return _result(room, specs, floor)


def _search(
    model: RoomModel,
    specs: list[Spec],
    groups: list[Group],
    rng: np.random.Generator,
    options: PlacementOptions,
) -> Floor:
    """Construct repeatedly: what failed comes earlier the next time (squeaky wheel), clearances shrink."""
    asked = sum(spec.quantity for spec in specs)
    wanted = asked + sum(spec.quantity * _relation_count(spec) for spec in specs)
    boost = dict.fromkeys((g.anchor.index for g in groups), 0.0)
    best: tuple[float, Floor] | None = None
    for attempt in range(max(1, options.attempts)):
        roomy = attempt < 3 or not options.tight
        floor = Floor(model, specs, options, roomy=roomy)
        aisle = model.aisle * (1.0, 0.75, 0.6, 0.5)[min(attempt, 3)]
        order = sorted(groups, key=lambda g: g.priority - boost[g.anchor.index])
        construct(floor, specs, order, rng, aisle=aisle)
        rating = _rate(floor)
        value = rating.value + (0.5 if roomy else 0.0)
        if best is None or value > best[0]:
            best = value, floor
        if rating.placed == asked and rating.placed + rating.relations >= wanted:
            break
        for group in groups:
            if any(floor.count(s.index) < s.quantity for s in (group.anchor, *group.members)):
                boost[group.anchor.index] += 1.0
    assert best is not None
    return best[1]


def _relation_count(spec: Spec) -> int:
    return len(spec.relations) + (spec.link == "paired")


def _rate(floor: Floor) -> _Rating:
    """Count the placed copies and the relations that they hold."""
    held = 0
    for spec in floor.specs:
        boxes = floor.boxes_of(spec.index)
        for box in boxes:
            pose = box[None, :4].copy()
            for kind, target in spec.relations:
                held += int(relation_holds(kind, pose, box[4], box[5], floor.boxes_of(target))[0])
        if spec.link == "paired":
            hosts = floor.boxes_of(spec.host)
            near = relation_holds(
                "around", boxes[:, :4].copy(), spec.size[0] / 2, spec.size[1] / 2, hosts
            )
            held += min(int(near.sum()), len(hosts))
    return _Rating(len(floor.placed), held)


def _result(room: PlacementRoom, specs: list[Spec], floor: Floor) -> PlacementResult:
    placements: list[PlacedObject] = []
    discarded: list[Discarded] = []
    for spec in specs:
        copies = floor.copies(spec.index)
        placements += [
            _placed(room.room_id, spec, number, copy) for number, copy in enumerate(copies, 1)
        ]
        lost = spec.quantity - len(copies)
        if lost:
            discarded.append(
                Discarded(name=spec.name, count=lost, reason=_reason(spec, len(copies)))
            )
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
