"""The world in a Rerun recording: floors, objects and closed doors, the robot with its way, and changes in words."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import atan2, cos, hypot, radians, sin
from typing import Any, Final

import msgspec

from mansion_bringup.rerun_files.rrd_file import RrdFile
from mansion_export.glb import write_glb
from mansion_export.meshes.building_model import floor_model
from mansion_export.meshes.materials import hex_color
from mansion_geometry.robot_body import CLEARANCE
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.world import ObjectState, Pose2D
from mansion_skills.world.objects import ObjectTable

__all__ = ["BuildingDrawing", "changes_of"]

_STRUCTURE: Final = ("structure", "cores", "windows")
_LEAF: Final = 0.05
"""Thickness of a closed door, metres."""

_NO_LEAF: Final = ("open", "doorway", "frame")
_DOOR: Final = (140, 100, 60)
_ROBOT: Final = (255, 120, 0)

Place = tuple[int, str]
"""A floor and a room, as far as entities are concerned."""


class BuildingDrawing:
    """Draws the floors of a building, and what changed on them.

    Parameters
    ----------
    file : RrdFile
    scenes : sequence of FloorScene
        All floors, as they are before the recording.
    """

    def __init__(self, file: RrdFile, scenes: Sequence[FloorScene]) -> None:
        import rerun

        self._rerun: Any = rerun
        self._file = file
        self._scenes = {scene.floor: scene for scene in scenes}
        self._changed: dict[str, ObjectState] = {}
        self._open: dict[str, bool] = {}
        self._ways = 0
        self._held: str | None = None
        self._begun = False
        for scene in scenes:
            self._draw_structure(scene)

    def _draw_structure(self, scene: FloorScene) -> None:
        """Draw what never changes: walls, floors, stairs and windows, without ceilings, as one mesh a floor."""
        rerun, half = self._rerun, radians(90.0) / 2
        root = ["building", _floor_name(scene.floor)]
        self._file.show(root, rerun.Transform3D(translation=(0.0, 0.0, scene.elevation)))
        model = floor_model(msgspec.structs.replace(scene, objects=[]), ceilings=False)
        nodes = tuple(node for node in model.nodes if node.group in _STRUCTURE)
        glb = write_glb([replace(model, elevation=0.0, nodes=nodes)], scene.building_id)
        upright = rerun.Quaternion(xyzw=(sin(half), 0.0, 0.0, cos(half)))  # glTF has y up
        mesh = rerun.Asset3D(contents=glb, media_type="model/gltf-binary")
        self._file.show([*root, "structure"], mesh, rerun.InstancePoses3D(quaternions=[upright]))
        outlines = [[(x, y, 0.01) for x, y in (*room.polygon, room.polygon[0])] for room in scene.rooms]
        names = [room.name or room.room_type for room in scene.rooms]
        self._file.show([*root, "rooms"], rerun.LineStrips3D(outlines, radii=0.02, labels=names, show_labels=False))

    def update(self, objects: ObjectTable, doors: Mapping[str, bool], time: int) -> list[str]:
        """Draw the objects and doors that are not as they were, and say what changed.

        Parameters
        ----------
        objects : ObjectTable
        doors : mapping
            Door id to whether it stands open, for doors that are not as in their scene.
        time : int
            Nanoseconds on the recording's clock.
        """
        said: list[str] = []
        rooms: set[Place] = set()
        if not self._begun:
            rooms = {_place(objects.state(name)) for name in objects if objects.state(name).floor is not None}
        for name in sorted({*objects.changed, *self._changed}):
            before, after = self._changed.get(name, objects.first(name)), objects.state(name)
            if before != after:
                rooms |= {_place(state) for state in (before, after) if state.floor is not None}
                said += changes_of(before, after) if self._begun else []
        self._changed = dict(objects.changed)
        for place in sorted(rooms):
            self._draw_objects(place, objects, time)
        said += self._update_doors(doors, time)
        self._begun = True
        return said

    def _draw_objects(self, place: Place, objects: ObjectTable, time: int) -> None:
        floor, room = place
        here = [state for state in objects.on_floor(floor) if _place(state) == place and state.position is not None]
        kinds = [objects.kinds[state.id] for state in here]
        colors = [tuple(round(255 * part) for part in hex_color(kind.color)) for kind in kinds]
        boxes = self._rerun.Boxes3D(
            centers=[state.position for state in here],
            sizes=[kind.size for kind in kinds],
            quaternions=[self._turn(state.rotation) for state in here],
            colors=colors,
            labels=[state.id for state in here],
            show_labels=False,
            fill_mode="solid",
        )
        self._file.show(["building", _floor_name(floor), "objects", *room.split("/")[-1:]], boxes, time=time)

    def _update_doors(self, doors: Mapping[str, bool], time: int) -> list[str]:
        said = []
        for floor, scene in self._scenes.items():
            is_open = {each.id: doors.get(each.id, each.is_open) for each in scene.doors if each.kind not in _NO_LEAF}
            moved = [name for name, now in is_open.items() if self._open.get(name) != now]
            if self._begun:
                said += [f"{name}: {'open' if is_open[name] else 'closed'}" for name in moved]
            if moved:
                self._draw_doors(floor, [each for each in scene.doors if is_open.get(each.id) is False], time)
            self._open |= is_open
        return said

    def _draw_doors(self, floor: int, closed: Iterable[Door], time: int) -> None:
        shut = list(closed)
        along = [(b[0] - a[0], b[1] - a[1]) for a, b in (each.segment for each in shut)]
        boxes = self._rerun.Boxes3D(
            centers=[_middle(each) for each in shut],
            sizes=[(hypot(*way), _LEAF, each.height) for way, each in zip(along, shut)],
            quaternions=[self._turn_by(atan2(y, x)) for x, y in along],
            colors=[_DOOR] * len(shut),
            labels=[each.id for each in shut],
            show_labels=False,
            fill_mode="solid",
        )
        self._file.show(["building", _floor_name(floor), "closed_doors"], boxes, time=time)

    def show_robot(self, radius: float) -> None:
        """Give the robot a body, which goes with the poses of the messages."""
        body = self._rerun.Cylinders3D(
            lengths=[CLEARANCE], radii=[radius], centers=[(0.0, 0.0, CLEARANCE / 2)], colors=[_ROBOT], fill_mode="solid"
        )
        self._file.show(["mansion", "robot_pose"], body)

    def drive(self, points: Sequence[tuple[float, float]], height: float, time: int) -> None:
        """Add a way that the robot drove, at a height in the building, to those before it."""
        way = [(x, y, height + 0.05) for x, y in points]
        self._file.show(
            ["path", str(self._ways)], self._rerun.LineStrips3D([way], colors=[_ROBOT], radii=0.03), time=time
        )
        self._ways += 1

    def hold(self, held: str | None, pose: Pose2D, height: float, time: int) -> None:
        """Show what the robot has in its hand, above it."""
        if held is None and self._held is None:
            return
        self._held = held
        shape = self._rerun.Clear(recursive=False)
        if held is not None:
            shape = self._rerun.Points3D([(pose.x, pose.y, height + CLEARANCE)], radii=0.08, labels=[held])
        self._file.show(["held"], shape, time=time)

    def _turn(self, degrees: float) -> Any:
        return self._turn_by(radians(degrees))

    def _turn_by(self, angle: float) -> Any:
        return self._rerun.Quaternion(xyzw=(0.0, 0.0, sin(angle / 2), cos(angle / 2)))


def changes_of(before: ObjectState, after: ObjectState) -> list[str]:
    """Return what has changed about an object, one line each.

    Examples
    --------
    >>> mug = ObjectState(id="mug_1", floor=1, room="F1/kitchen", states={"filled": True})
    >>> changes_of(mug, ObjectState(id="mug_1", held_by="default", states={"filled": False}))
    ['mug_1: in the hand of default', 'mug_1: filled is False']
    """
    moved = [f"{after.id}: {_where(after)}"] if _where(before) != _where(after) else []
    return moved + [
        f"{after.id}: {key} is {after.states.get(key)}"
        for key in sorted({*before.states, *after.states})
        if before.states.get(key) != after.states.get(key)
    ]


def _where(state: ObjectState) -> str:
    if state.held_by is not None:
        return f"in the hand of {state.held_by}"
    if state.parent is not None and state.mount in ("surface", "inside"):
        return f"{'on' if state.mount == 'surface' else 'in'} {state.parent}"
    return f"in {state.room or 'no room'}"


def _place(state: ObjectState) -> Place:
    return state.floor or 0, state.room or "elsewhere"


def _floor_name(floor: int) -> str:
    return f"floor_{floor}".replace("-", "m")


def _middle(door: Door) -> tuple[float, float, float]:
    (ax, ay), (bx, by) = door.segment
    return (ax + bx) / 2, (ay + by) / 2, door.height / 2
