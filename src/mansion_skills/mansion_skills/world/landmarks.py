"""Places of a floor that a robot can be sent to: cores and rooms."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import dist

import numpy as np

from mansion_msgs_py.world import Pose2D
from mansion_skills.navigation.floor_map import FloorMap
from mansion_skills.navigation.search import NO_CELL, best_cells, clearance, region_of

__all__ = ["Landmark", "floor_landmarks", "landmark_named"]

GENERIC = {"elevator": "elevator", "lift": "elevator", "stairs": "stair", "stair": "stair"}


@dataclass(frozen=True)
class Landmark:
    """A named pose on a floor; `kind` is ``room``, ``stair`` or ``elevator``."""

    name: str
    kind: str
    floor: int
    pose: Pose2D


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
    distance = clearance(grid.blocked)
    reached = np.zeros_like(grid.blocked)
    starts = [(core.entrance[0], core.entrance[1]) for core in scene.cores]
    starts += [(scene.spawn.x, scene.spawn.y)] if scene.spawn else []
    for x, y in starts:
        row, column = grid.frame.cell(x, y)
        if grid.frame.holds(row, column) and not reached[row, column]:
            reached |= region_of(grid.blocked, row, column)
    cells = best_cells(grid.rooms, distance, reached, len(scene.rooms))
    for number, room in enumerate(scene.rooms, start=1):
        cell = int(cells[number])
        if room.kind in ("stair", "elevator") or cell == NO_CELL:
            continue
        x, y = grid.frame.center(cell // grid.frame.columns, cell % grid.frame.columns)
        pose = Pose2D(x=round(x, 3), y=round(y, 3))
        found.append(Landmark(room.id, "room", scene.floor, pose))
    return found


def landmark_named(
    name: str, landmarks: Iterable[Landmark], floor: int, position: tuple[float, float]
) -> Landmark | None:
    """Return the landmark of that name: an id with or without its floor, or the nearest core of a kind."""
    wanted = name.strip().casefold()
    known = list(landmarks)
    for landmark in known:
        if landmark.name.casefold() in (wanted, f"f{floor}/{wanted}"):
            return landmark
    kind = GENERIC.get(wanted)
    cores = [entry for entry in known if entry.kind == kind]
    return min(cores, key=lambda c: dist(position, (c.pose.x, c.pose.y)), default=None)
