"""Observations of the environment: their spaces, and the encoding of the world into them."""

from dataclasses import dataclass
from math import cos, radians, sin
from typing import Any, Final

import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from mansion_geometry.compiled import Ints
from mansion_geometry.floor_grid import RESOLUTION
from mansion_language.colours import COLOURS, colour_of
from mansion_msgs_py.task import Task
from mansion_skills.navigation.grid_kernels import cast_rays
from mansion_skills.skills.visibility import REACH, VIEW_ANGLE, VIEW_RANGE
from mansion_tasks.env.visibility import View
from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["BEAMS", "SCAN_RANGE", "SLOTS", "ObservationEncoder", "Vocabulary", "state_space"]

SLOTS: Final = 24
"""Objects in view that an observation describes, the nearest first."""

BEAMS: Final = 24
"""Laser beams around the robot, the first one straight ahead, counter-clockwise."""

SCAN_RANGE: Final = 12.0
"""Range of the laser, metres."""

FEATURES: Final = 7
"""Features of an object in view: distance / 8 m, bearing / 45°, in reach, pickupable, receptacle, openable, open."""

Values = dict[str, Any]
Floats = npt.NDArray[np.float32]


@dataclass(frozen=True)
class Vocabulary:
    """What the numbers of an observation stand for; 0 is nothing everywhere.

    Attributes
    ----------
    categories : tuple of str
        Category ``k`` of objects is ``categories[k - 1]``.
    rooms : tuple of str
        Room ``k`` is ``rooms[k - 1]``, an id.
    floors : tuple of int
        Floor ``k`` is ``floors[k]``.
    """

    categories: tuple[str, ...]
    rooms: tuple[str, ...]
    floors: tuple[int, ...]

    @classmethod
    def of(cls, sandbox: Sandbox) -> "Vocabulary":
        """Return the vocabulary of a building."""
        building = sandbox.building
        kinds = sandbox.world.objects.kinds.values()
        rooms = [room.id for floor in building.floors for room in building.scene(floor).rooms]
        categories = sorted({kind.category for kind in kinds})
        return cls(tuple(categories), tuple(rooms), tuple(building.floors))

    def category(self, name: str) -> int:
        """Return a category's number, 0 for none."""
        return self.categories.index(name) + 1 if name in self.categories else 0


def state_space(categories: int, rooms: int, floors: int) -> spaces.Dict:
    """Return the space of the observations without pictures, for at most that many of each."""
    categories, rooms = categories + 1, rooms + 1
    colours = len(COLOURS) + 1
    return spaces.Dict(
        {
            "floor": spaces.Discrete(floors),
            "room": spaces.Discrete(rooms),
            "pose": spaces.Box(-1e4, 1e4, (4,), np.float32),
            "pitch": spaces.Box(-1.0, 1.0, (1,), np.float32),
            "held": spaces.Discrete(categories),
            "lift_open": spaces.Discrete(2),
            "scan": spaces.Box(0.0, SCAN_RANGE, (BEAMS,), np.float32),
            "objects": spaces.Box(-1.0, 1.0, (SLOTS, FEATURES), np.float32),
            "categories": spaces.MultiDiscrete(np.full(SLOTS, categories)),
            "colours": spaces.MultiDiscrete(np.full(SLOTS, colours)),
            "goal": spaces.MultiDiscrete([categories, colours, floors + 1, categories, rooms, floors + 1]),
            "time_left": spaces.Box(0.0, 1.0, (1,), np.float32),
        }
    )


_BEAM_ANGLES: Final = np.arange(BEAMS) * (2.0 * np.pi / BEAMS)


class ObservationEncoder:
    """Encodes the world as a value of `state_space`.

    Parameters
    ----------
    sandbox : Sandbox
    vocabulary : Vocabulary
        Objects of categories that it lacks are nothing.
    """

    def __init__(self, sandbox: Sandbox, vocabulary: Vocabulary) -> None:
        self._sandbox = sandbox
        kinds = sandbox.world.objects.kinds
        self._rooms = {name: number for number, name in enumerate(vocabulary.rooms, start=1)}
        self._floors = {floor: number for number, floor in enumerate(vocabulary.floors)}
        numbers = {name: number for number, name in enumerate(vocabulary.categories, start=1)}
        self._category = {name: numbers.get(kind.category, 0) for name, kind in kinds.items()}
        colour_numbers = {name: number for number, name in enumerate(COLOURS, start=1)}
        self._row = {name: row for row, name in enumerate(kinds)}
        colours = {name: colour_numbers.get(colour_of(kind.material), 0) for name, kind in kinds.items()}
        self._codes = np.array([(self._category[name], colours[name]) for name in kinds], dtype=np.int64).reshape(-1, 2)
        self._traits = np.array(
            [(kind.pickupable, kind.receptacle, kind.openable) for kind in kinds.values()], dtype=np.float32
        ).reshape(-1, 3)
        self._colour_numbers = colour_numbers

    def goal(self, task: Task) -> Ints:
        """Encode what the task asks for.

        Category, colour and floor (one more than its number) of the object, the first of several, then category, room
        and floor of where it goes; 0 where the task leaves it open.
        """
        values = np.zeros(6, dtype=np.int64)
        targets = [name for goal in task.goals for name in goal.objects]
        places = [name for goal in task.goals for name in goal.receptacles if name not in targets]
        rooms = [name for goal in task.goals for name in goal.rooms]
        values[0] = self._category.get(targets[0], 0) if targets else 0
        values[3] = self._category.get(places[0], 0) if places else 0
        values[4] = self._rooms.get(rooms[0], 0) if rooms else 0
        for need in reversed(task.needs):
            floor = 0 if need.floor is None else self._floors.get(need.floor, -1) + 1
            if need.role == "target":
                values[1], values[2] = self._colour_numbers.get(need.color, 0), floor
            elif need.role == "destination":
                values[5] = floor
        return values

    def state(self, view: View, goal: Ints, time_left: float) -> Values:
        """Return the values of `state_space` now."""
        sandbox = self._sandbox
        world, robot = sandbox.world, sandbox.robot
        grid = world.view(robot.floor).map
        pose = robot.pose
        heading = radians(pose.yaw)
        held = world.objects.held_by(robot.session)
        room = grid.room_at(pose.x, pose.y)
        row, column = grid.frame.coordinates(pose.x, pose.y)
        scan = cast_rays(grid.occupied, row, column, heading + _BEAM_ANGLES, SCAN_RANGE / RESOLUTION)
        objects, categories, colours = self._object_arrays(view)
        lifts = world.lifts
        is_open = robot.call is not None and lifts[robot.call].is_open_at(robot.floor)
        return {
            "floor": np.int64(self._floors[robot.floor]),
            "room": np.int64(self._rooms.get(room or "", 0)),
            "pose": np.array([pose.x, pose.y, cos(heading), sin(heading)], dtype=np.float32),
            "pitch": np.array([robot.pitch / 60.0], dtype=np.float32),
            "held": np.int64(0 if held is None else self._category[held]),
            "lift_open": np.int64(is_open),
            "scan": np.minimum(scan * RESOLUTION, SCAN_RANGE).astype(np.float32),
            "objects": objects,
            "categories": categories,
            "colours": colours,
            "goal": goal.copy(),
            "time_left": np.array([time_left], dtype=np.float32),
        }

    def _object_arrays(self, view: View) -> tuple[npt.NDArray[np.float32], Ints, Ints]:
        objects = np.zeros((SLOTS, FEATURES), dtype=np.float32)
        codes = np.zeros((SLOTS, 2), dtype=np.int64)
        count = min(SLOTS, len(view.ids))
        if count:
            away = view.distances[:count]
            objects[:count, 0] = away / VIEW_RANGE
            objects[:count, 1] = np.clip(view.bearings[:count] / (VIEW_ANGLE / 2), -1.0, 1.0)
            objects[:count, 2] = away <= REACH
            rows = [self._row[name] for name in view.ids[:count]]
            objects[:count, 3:6] = self._traits[rows]
            objects[:count, 6] = view.is_open[:count]
            codes[:count] = self._codes[rows]
        return objects, codes[:, 0].copy(), codes[:, 1].copy()
