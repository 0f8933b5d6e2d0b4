"""Objects of a room whose floor or doors changed: those that still fit stay, the others get a new place.

What leaned on a wall that moved goes with it, and so does what stood close to that. What is left without a place is
put where the room is free, furniture at walls first, or is left out.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import msgspec
from shapely import LineString

from mansion_assets.catalogue import Catalogue
from mansion_editing.state import SceneState
from mansion_editing.structure.standing_checks import RoomSpace, collides, shifted, turned_about
from mansion_editing.structure.wall_moves import MovedWall
from mansion_editing.tools.destinations import InRoom
from mansion_editing.tools.floor_places import free_floor_places
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.shapes import Point

__all__ = ["Settled", "settle"]

_LEANING = 0.25
"""Metres between what leans on a wall and the wall's centre line."""

_TOGETHER = 0.15
"""Metres between furniture that belongs together, a desk and its chair."""

_STEP = 0.25
_MOST_PLACES = 200


@dataclass
class Settled:
    """The objects of a room after a change.

    Attributes
    ----------
    objects : list of SceneObject
        In the order of before.
    went_along : list of str
        Ids of what went with a wall.
    placed : list of str
        Ids of what was put elsewhere.
    lost : list of SceneObject
        What found no place.
    """

    objects: list[SceneObject] = field(default_factory=list)
    went_along: list[str] = field(default_factory=list)
    placed: list[str] = field(default_factory=list)
    lost: list[SceneObject] = field(default_factory=list)


def settle(
    space: RoomSpace,
    objects: Sequence[SceneObject],
    moves: Sequence[MovedWall],
    scene: FloorScene,
    catalogue: Catalogue,
) -> Settled:
    """Return where the objects of a room stand after walls or doors of it changed.

    Parameters
    ----------
    space : RoomSpace
        The room as it is now.
    objects : sequence of SceneObject
        Objects of the room before the change.
    moves : sequence of MovedWall
        Walls of the room that moved.
    scene : FloorScene
        The floor as it is now, with any objects: only its rooms and doors count.
    catalogue : Catalogue
    """
    roots = [item for item in objects if item.parent is None]
    now = {item.id: item for item in roots}
    for move in moves:
        now |= _carried_along(space, now, move)
    unsettled = [item for item in now.values() if not space.holds(item)]
    standing = [item for item in now.values() if item not in unsettled]
    result = Settled(went_along=[item.id for item in standing if item.position != _before(roots, item.id).position])
    room = _Room(space, scene, catalogue, standing)
    for item in sorted(unsettled, key=lambda item: -item.size[0] * item.size[1]):
        found = room.place(item)
        if found is None:
            result.lost.append(item)
        else:
            result.placed.append(found.id)
    final = {item.id: item for item in room.standing}
    result.objects = list(_with_carried(objects, final))
    return result


def _before(items: Iterable[SceneObject], name: str) -> SceneObject:
    return next(item for item in items if item.id == name)


def _carried_along(space: RoomSpace, before: Mapping[str, SceneObject], move: MovedWall) -> dict[str, SceneObject]:
    """Return the objects shifted that leaned on a wall, with those close to them, where all of them fit."""
    line = LineString(move.segment)
    now = dict(before)
    leaning = [item for item in before.values() if _leans(item, line)]
    for first in leaning:
        if first.mount == "wall":
            groups = [[first]]
        else:
            groups = [_cluster(first, list(now.values())), [first]]
        for group in groups:
            ids = {item.id for item in group}
            carried = [shifted(item, move.shift) for item in group]
            others = [(item, footprint(item)) for item in now.values() if item.id not in ids]
            if all(space.holds(item) and not collides(item, footprint(item), others) for item in carried):
                now.update({item.id: item for item in carried})
                break
    return now


def _leans(item: SceneObject, line: LineString) -> bool:
    return (
        item.mount in ("floor", "wall")
        and item.size[2] > WALKABLE_HEIGHT
        and footprint(item).distance(line) <= _LEANING
    )


def _cluster(first: SceneObject, items: Sequence[SceneObject]) -> list[SceneObject]:
    """Return an object and the furniture that stands close to it."""
    shape = footprint(first)
    close = [
        item
        for item in items
        if item.id != first.id and item.mount == "floor" and footprint(item).distance(shape) <= _TOGETHER
    ]
    return [first, *close]


def _with_carried(objects: Sequence[SceneObject], roots: dict[str, SceneObject]) -> Iterator[SceneObject]:
    """Yield objects with what they carry, in the order of before; what stood on something lost is lost."""
    before = {item.id: item for item in objects}
    after: dict[str, SceneObject | None] = {}

    def pose(item: SceneObject) -> SceneObject | None:
        if item.id not in after:
            if item.parent is None:
                after[item.id] = roots.get(item.id)
            elif item.parent not in before:
                after[item.id] = item
            else:
                carrier = before[item.parent]
                moved = pose(carrier)
                after[item.id] = (
                    None if moved is None else item if moved == carrier else turned_about(item, carrier, moved)
                )
        return after[item.id]

    for item in objects:
        there = pose(item)
        if there is not None:
            yield there


class _Room:
    """A room while objects without a place are put into it."""

    def __init__(
        self, space: RoomSpace, scene: FloorScene, catalogue: Catalogue, standing: Sequence[SceneObject]
    ) -> None:
        self.space, self.scene, self.catalogue = space, scene, catalogue
        self.standing = list(standing)

    def place(self, item: SceneObject) -> SceneObject | None:
        """Put an object at the free place nearest to where it was; None where there is none."""
        others = [(other, footprint(other)) for other in self.standing]
        for trial in sorted(self._poses(item), key=lambda pose: round(_distance(pose, item), 3))[:_MOST_PLACES]:
            if self.space.holds(trial) and not collides(trial, footprint(trial), others):
                self.standing.append(trial)
                return trial
        return None

    def _poses(self, item: SceneObject) -> Iterator[SceneObject]:
        if item.mount == "wall":
            yield from self._on_walls(item)
        elif item.mount == "floor" and item.size[2] > WALKABLE_HEIGHT:
            scene = msgspec.structs.replace(self.scene, objects=self.standing)
            state = SceneState([scene], self.catalogue)
            for x, y, rotation in free_floor_places(state, item, InRoom(scene.floor, self.space.room)):
                yield _at(item, (x, y), rotation)
        else:
            yield from self._under_or_over(item)

    def _on_walls(self, item: SceneObject) -> Iterator[SceneObject]:
        for (ax, ay), (bx, by), rotation in self.space.walls:
            length = math.dist((ax, ay), (bx, by))
            slack = length - item.size[0]
            if slack < 0:
                continue
            ux, uy = (bx - ax) / length, (by - ay) / length
            deep = item.size[1] / 2 + 0.005
            for k in range(int(slack / _STEP) + 1):
                along = item.size[0] / 2 + min(k * _STEP, slack)
                yield _at(item, (ax + ux * along - uy * deep, ay + uy * along + ux * deep), rotation)

    def _under_or_over(self, item: SceneObject) -> Iterator[SceneObject]:
        """Yield places of what hangs from the ceiling, or lies flat on the floor."""
        x0, y0, x1, y1 = self.space.net.bounds
        for i in range(int((x1 - x0) / _STEP) + 1):
            for j in range(int((y1 - y0) / _STEP) + 1):
                yield _at(item, (x0 + _STEP * i, y0 + _STEP * j), item.rotation)


def _at(item: SceneObject, point: Point, rotation: float) -> SceneObject:
    position = (round(point[0], 4), round(point[1], 4), item.position[2])
    return msgspec.structs.replace(item, position=position, rotation=round(rotation % 360.0, 4))


def _distance(one: SceneObject, other: SceneObject) -> float:
    return math.dist(one.position[:2], other.position[:2])
