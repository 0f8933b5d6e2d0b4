"""The floors that a camera keeps loaded, which are the last it used, and how it draws them."""

from collections import OrderedDict
from dataclasses import dataclass
from math import atan2, pi, radians, sin, tan

import numpy as np

from mansion_skills.vision.floor_model import FloorModel
from mansion_skills.vision.frame import Frame, Intrinsics, Names
from mansion_skills.vision.mjcf_model import ModelFile, camera_model
from mansion_skills.vision.portals import SEE_THROUGH, Portals, Wedge
from mansion_skills.vision.renderer import CameraPose, Parts, Renderer
from mansion_skills.vision.world_sync import WorldSync, guests_of
from mansion_skills.world.floor_exports import MODEL, exported, made
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["KEPT", "Floors"]

KEPT = 3
"""Floors that stay loaded."""


@dataclass
class _Loaded:
    model: FloorModel
    sync: WorldSync
    renderer: Renderer
    portals: Portals
    guests: list[str]


class Floors:
    """Draws any floor of a world; called in the thread that owns the OpenGL context.

    Parameters
    ----------
    world : World
    names : Names
    width, height : int
        Size of the largest picture, pixels.
    """

    def __init__(self, world: World, names: Names, width: int, height: int) -> None:
        self.world = world
        self._names = names
        self._size = width, height
        self._files: OrderedDict[int, ModelFile] = OrderedDict()
        self._loaded: OrderedDict[int, _Loaded] = OrderedDict()

    def close(self) -> None:
        """Free all floors."""
        while self._loaded:
            self._loaded.popitem()[1].renderer.close()

    @property
    def loaded(self) -> list[int]:
        """The floors that are loaded, ascending."""
        return sorted(self._loaded)

    def synchronise(self, floor: int, robot: RobotBody) -> None:
        """Load a floor when that is needed, and bring it up to date; the caller holds the world's lock."""
        loaded = self._loaded.get(floor)
        known = loaded.model.bodies if loaded is not None else self._file(floor).bodies
        guests = guests_of(self.world, floor, known)
        if loaded is None or not set(guests) <= set(loaded.guests):
            if loaded is not None:
                loaded.renderer.close()
                guests = guests_of(self.world, floor, self._file(floor).bodies)
            loaded = self._loaded[floor] = self._load(floor, guests)
        self._loaded.move_to_end(floor)
        while len(self._loaded) > KEPT:
            self._loaded.popitem(last=False)[1].renderer.close()
        loaded.sync.synchronise(robot)

    def _file(self, floor: int) -> ModelFile:
        """Return a floor's model, on disk or made here; few are kept, since only loading needs them."""
        if floor not in self._files:
            building = self.world.building
            path = exported(building, floor, MODEL)
            if path is None:
                self._files[floor] = ModelFile.made(made(building, floor, MODEL))
            else:
                self._files[floor] = ModelFile.read(path)
        self._files.move_to_end(floor)
        while len(self._files) > KEPT:
            self._files.popitem(last=False)
        return self._files[floor]

    def _load(self, floor: int, guests: list[str]) -> _Loaded:
        world = self.world
        scene = world.view(floor).scene
        homes = {
            name: number
            for number in world.building.floors
            for name in (item.id for item in world.building.scene(number).objects)
            if name in guests
        }
        below = max((f for f in world.building.floors if f < floor), default=None)
        source = camera_model(
            self._file(floor),
            scene,
            world.objects.kinds,
            # A scene that was edited while the world was loaded may have lost some.
            [(self._file(homes[name]), name) for name in guests if name in self._file(homes[name]).bodies],
            None if below is None else (self._file(below), scene.elevation - world.building.entry(below).elevation),
        )
        model = FloorModel(source, scene, self._names)
        sync = WorldSync(world, floor, model, self._names)
        return _Loaded(model, sync, Renderer(model, *self._size), Portals(scene), guests)

    def draw(self, floor: int, eye: CameraPose, intrinsics: Intrinsics, parts: Parts) -> Frame:
        """Draw a floor that `synchronise` has brought up to date."""
        loaded = self._loaded[floor]
        view = self.world.view(floor)
        room = view.map.room_at(eye.x, eye.y)
        rooms = None
        if room is not None:
            doors = view.doors
            closed = [name for name in loaded.sync.closed_doors() if doors[name].kind not in SEE_THROUGH]
            wedge = wedge_of(intrinsics, eye.pitch)
            rooms = loaded.portals.visible(room, (eye.x, eye.y), eye.yaw, wedge, closed)
        place = np.array([eye.x, eye.y, eye.z])
        geoms = loaded.model.show(rooms, place, eye.yaw, intrinsics.focal)
        rgb, depth, labels = loaded.renderer.draw(eye, intrinsics, geoms, parts)
        return Frame(rgb, depth, labels, self._names.table)


def wedge_of(intrinsics: Intrinsics, pitch: float) -> Wedge:
    """Return the directions in plan that a tilted picture covers: those of its widest corner."""
    across = intrinsics.width / 2 / intrinsics.focal
    up = tan(radians(intrinsics.vertical_fov) / 2)
    tilt = radians(abs(pitch))
    ahead = np.cos(tilt) - up * sin(tilt)
    half = pi if ahead <= 0.05 else atan2(across, float(ahead))
    return Wedge(-half, half)
