"""A floor's compiled model: which geom belongs to what and to which rooms, and how bodies are moved."""

from collections.abc import Container, Iterable, Mapping
from math import cos, radians, sin
from typing import Any

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import FloorScene
from mansion_skills.vision.frame import Names
from mansion_skills.vision.mjcf_model import OFF, ON, PART, CameraModel
from mansion_skills.vision.portals import Wedge

__all__ = ["ANYWHERE", "FloorModel", "Turn", "turn_about_z"]

SHOWN, HIDDEN = 0, 5
"""Geom groups."""

ANYWHERE, NOWHERE = 0, -1
"""Numbers of rooms: of what is always drawn, and of what never is."""

LANDING_PARTS = ("call_panel", "sign")
"""Bodies of a core that are seen from outside, though its door is shut."""

SMALLEST = 0.6
"""What would be a disc of fewer pixels in radius is left out."""

Turn = tuple[float, float, float, float]
"""A unit quaternion, w first."""


def turn_about_z(degrees: float) -> Turn:
    """Return the quaternion of a turn about the vertical axis."""
    half = radians(degrees) / 2
    return cos(half), 0.0, 0.0, sin(half)


class FloorModel:
    """What MuJoCo needs to draw one floor.

    Parameters
    ----------
    source : CameraModel
    scene : FloorScene
    table : Names
        The camera's table of names.

    Attributes
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
    bodies : dict
        Name to number.
    label : (geoms,) array of int32
        Index in the camera's table of names of each geom.
    """

    def __init__(self, source: CameraModel, scene: FloorScene, table: Names) -> None:
        import mujoco

        self.model: Any = mujoco.MjModel.from_xml_string(source.document, source.files)
        self.data: Any = mujoco.MjData(self.model)
        self._settlers = (mujoco.mj_kinematics, mujoco.mj_camlight)
        model = self.model
        names = [model.body(i).name for i in range(model.nbody)]
        self.bodies: dict[str, int] = {name: i for i, name in enumerate(names)}
        self._first_geom: npt.NDArray[np.int32] = np.asarray(model.body_geomadr)
        self._geom_count: npt.NDArray[np.int32] = np.asarray(model.body_geomnum)
        self._home = (model.body_pos.copy(), model.body_quat.copy())
        owner = np.asarray(model.geom_bodyid)
        known = np.array([table.index(element_of(name, table)) for name in names], dtype=np.int32)
        self.label: npt.NDArray[np.int32] = known[owner]
        self.rooms = {room.id: number for number, room in enumerate(scene.rooms, start=1)}
        for core in scene.cores:
            self.rooms.setdefault(core.id, len(self.rooms) + 1)
        self._room = self._rooms_of(names, scene)[owner]
        self._level = np.ones(len(owner), dtype=np.float32)
        material = np.asarray(model.geom_matid)
        self._plain = model.geom_rgba.copy()
        self._color = np.where((material >= 0)[:, None], model.mat_rgba[material], self._plain)
        self._material = material.copy()
        self._switches = self._switch_materials()
        self._stale = True

    def _rooms_of(self, names: list[str], scene: FloorScene) -> npt.NDArray[np.int32]:
        """Return two rooms for each body; it is drawn when one of them is seen."""
        sides: dict[str, tuple[str | None, str | None]] = {}
        for wall in scene.walls:
            sides[wall.id] = (wall.left, wall.right)
        for door in scene.doors:
            sides[door.id] = door.rooms
        for window in scene.windows:
            sides[window.id] = (window.room, window.room)
        for name in self.rooms:
            sides[name] = (name, name)
        for core in scene.cores:
            for part in LANDING_PARTS:
                sides[f"{core.id}/{part}"] = sides.get(core.door, (core.id, None))
        for item in scene.objects:
            sides[item.id] = (item.room, item.room)
        numbers = np.full((len(names), 2), ANYWHERE, dtype=np.int32)
        for i, name in enumerate(names):
            element = element_of(name, sides)
            first, second = sides.get(element, (None, None))
            if element in sides and not (first is None and second is None):
                numbers[i] = [self.rooms.get(side or "", NOWHERE) for side in (first, second)]
        return numbers

    def _switch_materials(self) -> dict[int, tuple[int, int]]:
        """Return, for each material that can shine, those of its states on and off."""
        model = self.model
        number = {model.mat(i).name: i for i in range(model.nmat)}
        return {i: (number[name + ON], number[name + OFF]) for name, i in number.items() if name + ON in number}

    def geoms(self, body: str) -> slice:
        """Return where the geoms of a body are."""
        i = self.bodies[body]
        first = int(self._first_geom[i])
        return slice(first, first + int(self._geom_count[i])) if first >= 0 else slice(0, 0)

    def home(self, body: str) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Return the pose that the file gives a body: position, and quaternion."""
        i = self.bodies[body]
        return self._home[0][i], self._home[1][i]

    def place(self, body: str, position: Iterable[float], turn: Iterable[float]) -> None:
        """Move a body."""
        i = self.bodies[body]
        self.model.body_pos[i] = tuple(position)
        self.model.body_quat[i] = tuple(turn)
        self._stale = True

    def put_into(self, body: str, room: str | None, *, shown: bool = True) -> None:
        """Say in which room a body is drawn; in all when that is not known."""
        number = self.rooms.get(room, ANYWHERE) if room is not None else ANYWHERE
        self._room[self.geoms(body)] = number if shown else NOWHERE

    def switch(self, body: str, *, on: bool) -> None:
        """Let the lamps and screens of a body shine, or not."""
        for geom in range(*self.geoms(body).indices(self.model.ngeom)):
            states = self._switches.get(int(self._material[geom]))
            if states is not None:
                chosen = states[0 if on else 1]
                self.model.geom_matid[geom] = chosen
                self._color[geom] = self.model.mat_rgba[chosen]
        self._paint()

    def light(self, room: str, level: float) -> None:
        """Set how bright a room is, 0 to 1."""
        number = self.rooms[room]
        inside = (self._room == number).any(axis=1)
        self._level[inside] = level
        self._paint()

    def _paint(self) -> None:
        """Darken what is in dark rooms; the colour that the file gives means: as the material."""
        dark = self._level < 1.0
        dimmed = self._color.copy()
        dimmed[:, :3] *= self._level[:, None]
        self.model.geom_rgba[:] = np.where(dark[:, None], dimmed, self._plain)

    def settle(self) -> None:
        """Compute where the geoms and lights are, when something has moved."""
        if self._stale:
            for settle in self._settlers:
                settle(self.model, self.data)
            self._stale = False

    def show(
        self, rooms: Mapping[str, Wedge] | None, eye: npt.NDArray[np.float64], heading: float, focal: float
    ) -> npt.NDArray[np.intp]:
        """Choose what is drawn: what lies in the wedge of its room and is not too small to be seen.

        Parameters
        ----------
        rooms : mapping, optional
            The rooms that can be seen, each with its wedge; ``None`` for all.
        eye : (3,) array
        heading : float
            Degrees.
        focal : float
            Pixels.

        Returns
        -------
        array of int
            The geoms that are drawn, ascending.
        """
        model = self.model
        offset = np.asarray(self.data.geom_xpos) - eye
        radius = np.asarray(model.geom_rbound)
        shown = (self._room != NOWHERE).any(axis=1)
        if rooms is not None:
            shown &= self._in_wedges(rooms, offset[:, :2], radius, heading)
        away = np.sqrt((offset * offset).sum(axis=1))
        shown &= radius * focal >= SMALLEST * np.maximum(away - radius, 0.0)
        model.geom_group[:] = np.where(shown, SHOWN, HIDDEN)
        return np.flatnonzero(shown)

    def _in_wedges(
        self,
        rooms: Mapping[str, Wedge],
        offset: npt.NDArray[np.float64],
        radius: npt.NDArray[np.float64],
        heading: float,
    ) -> npt.NDArray[np.bool_]:
        """Whether the bounding sphere of each geom reaches into the wedge of one of its rooms."""
        edges = np.zeros((max(self.rooms.values(), default=0) + 2, 4))
        seen = np.zeros(len(edges), dtype=bool)
        axis = radians(heading)
        for name, wedge in rooms.items():
            number = self.rooms.get(name)
            if number is None:
                continue
            seen[number] = True
            if wedge.high - wedge.low < radians(179.0):
                low, high = axis + wedge.low, axis + wedge.high
                edges[number] = (-sin(low), cos(low), sin(high), -cos(high))
        seen[ANYWHERE] = True
        inside = np.zeros(len(radius), dtype=bool)
        for side in (0, 1):
            room = self._room[:, side]
            bounds = edges[room]
            right = (bounds[:, :2] * offset).sum(axis=1) >= -radius
            left = (bounds[:, 2:] * offset).sum(axis=1) >= -radius
            inside |= seen[room] & right & left
        return inside


def element_of(body: str, known: Container[str]) -> str:
    """Return the id of the element that a body is a part of: a leaf's door, a landing's stair."""
    name = body.partition(PART)[0]
    while name not in known and "/" in name:
        name = name.rpartition("/")[0]
    return name if name in known else body
