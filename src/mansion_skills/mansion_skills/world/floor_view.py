"""One floor as a robot finds it: scene, grids, landmarks, and its doors and objects as they are now."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import dist

import numpy as np

from mansion_geometry.compiled import Bools
from mansion_geometry.disc_cells import region_of
from mansion_language.core_words import CORE_WORDS
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.world import ObjectState, Pose2D
from mansion_skills.navigation.floor_map import Body, FloorMap
from mansion_skills.navigation.grid_kernels import NO_CELL, best_cells, clearance
from mansion_skills.world.objects import ObjectTable

__all__ = ["FloorView", "Landmark", "bodies_of", "floor_landmarks", "landmark_named", "reached_cells"]

FEW_DOORS = 4
"""Most doors that are redrawn one by one; when more have moved, the grids are made again."""


@dataclass(frozen=True)
class Landmark:
    """A named pose on a floor; `kind` is ``room``, ``stair`` or ``elevator``, `called` what people call a room."""

    name: str
    kind: str
    floor: int
    pose: Pose2D
    called: tuple[str, ...] = ()


def floor_landmarks(grid: FloorMap) -> list[Landmark]:
    """Return the cores and rooms of a floor, each with a pose where a robot can stand.

    A room's pose is its point with the most free space around, among those that can be reached from the floor's
    cores or its spawn pose.
    """
    scene = grid.scene
    found = [
        Landmark(core.id, core.type, scene.floor, Pose2D(x=x, y=y, yaw=yaw))
        for core in scene.cores
        for x, y, yaw in [core.entrance]
    ]
    cells = best_cells(grid.rooms, clearance(grid.blocked), reached_cells(grid), len(scene.rooms))
    for number, room in enumerate(scene.rooms, start=1):
        cell = int(cells[number])
        if room.kind in ("stair", "elevator") or cell == NO_CELL:
            continue
        x, y = grid.frame.center(cell // grid.frame.columns, cell % grid.frame.columns)
        pose = Pose2D(x=round(x, 3), y=round(y, 3))
        called = tuple(name for name in (room.name, *room.aliases) if name)
        found.append(Landmark(room.id, "room", scene.floor, pose, called))
    return found


def reached_cells(grid: FloorMap) -> Bools:
    """Return the cells that a robot can be in and reach from the floor's cores or its spawn pose."""
    scene = grid.scene
    reached = np.zeros_like(grid.blocked)
    starts = [(core.entrance[0], core.entrance[1]) for core in scene.cores]
    starts += [(scene.spawn.x, scene.spawn.y)] if scene.spawn else []
    for x, y in starts:
        row, column = grid.frame.cell(x, y)
        if grid.frame.holds(row, column) and not reached[row, column]:
            reached |= region_of(grid.blocked, row, column)
    return reached


def landmark_named(
    name: str, landmarks: Iterable[Landmark], floor: int, position: tuple[float, float]
) -> Landmark | None:
    """Return the landmark of that name: an id with or without its floor, a core by its kind, the nearest, or a room.

    A room goes by what people call it: by its name before the other names of rooms.
    """
    wanted = name.strip().casefold()
    known = list(landmarks)
    for landmark in known:
        if landmark.name.casefold() in (wanted, f"f{floor}/{wanted}"):
            return landmark
    kind = CORE_WORDS.get(wanted)
    cores = [entry for entry in known if entry.kind == kind]
    if cores:
        return min(cores, key=lambda c: dist(position, (c.pose.x, c.pose.y)))
    ranked = [
        (rank, number)
        for number, landmark in enumerate(known)
        for rank, name in enumerate(landmark.called)
        if name.casefold() == wanted
    ]
    return known[min(ranked)[1]] if ranked else None


def bodies_of(floor: int, objects: ObjectTable) -> list[Body]:
    """Return what is on a floor, numbered for its view grid."""
    found = []
    for number, state in enumerate(objects.on_floor(floor), start=1):
        kind = objects.kinds[state.id]
        assert state.position is not None
        found.append(
            Body(
                id=state.id,
                position=state.position,
                size=kind.size,
                rotation=state.rotation,
                carried=state.mount in ("surface", "inside"),
                number=number,
            )
        )
    return found


def _unmoved(states: list[ObjectState], before: list[ObjectState]) -> bool:
    """Whether objects are where they were, whatever else has changed."""
    return len(states) == len(before) > 0 and all(
        a is b or (a.id, a.position, a.rotation, a.mount) == (b.id, b.position, b.rotation, b.mount)
        for a, b in zip(states, before)
    )


class FloorView:
    """A loaded floor (skill card UseElevator, steps 2 and 3).

    Parameters
    ----------
    scene : FloorScene
    objects : ObjectTable
    doors : mapping
        Door id to whether it stands open, for doors that are not as in the scene.
    radius : float
        Robot's radius, metres.
    """

    def __init__(self, scene: FloorScene, objects: ObjectTable, doors: Mapping[str, bool], radius: float) -> None:
        self.scene = scene
        self.floor = scene.floor
        self.doors: dict[str, Door] = {door.id: door for door in scene.doors}
        self._objects = objects
        self.numbers: dict[str, int] = {}
        self._states: list[ObjectState] = []
        self.map = FloorMap(scene, radius)
        self.refresh({})
        self.landmarks: list[Landmark] = floor_landmarks(self.map)
        if any(name in self.doors for name in doors):
            self.refresh(doors)

    def refresh(self, doors: Mapping[str, bool]) -> None:
        """Bring the grids up to date with doors and objects."""
        is_open = {name: doors.get(name, door.is_open) for name, door in self.doors.items()}
        states = [state for state in self._objects.on_floor(self.floor) if state.mount not in ("surface", "inside")]
        moved = [name for name in is_open if self.map.is_open.get(name) != is_open[name]]
        if len(moved) <= FEW_DOORS and _unmoved(states, self._states):
            for name in moved:
                self.map.swing(name, is_open=is_open[name])
            return
        self._states = states
        bodies = bodies_of(self.floor, self._objects)
        self.numbers = {body.id: body.number for body in bodies}
        self.map.update(bodies, is_open)
