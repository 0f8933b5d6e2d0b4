"""Draw the parts of a task from a building: a thing, where it goes, where the robot starts, and how to call them."""

from collections.abc import Sequence
from typing import Final, TypeVar

import numpy as np

from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.task import Need, TaskStart
from mansion_msgs_py.world import Pose2D
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.world import World
from mansion_tasks.tasks.words import colour_of
from mansion_tasks.words.nouns import plain

__all__ = ["SURFACES", "call_place", "call_room", "call_thing", "draw", "draw_start", "things"]

T = TypeVar("T")

SURFACES: Final = ("table", "desk", "bed", "sofa", "counter", "bench", "dresser", "sideboard", "nightstand", "island")
"""What a person would put something on: categories that end so."""

_ODD: Final = ("book_upright", "toilet_brush", "toilet_paper", "fire_extinguisher", "plunger")
"""Things that nobody asks a robot to bring."""


def draw(options: Sequence[T], rng: np.random.Generator) -> T | None:
    """Return one of some options, ``None`` when there are none."""
    return options[int(rng.integers(len(options)))] if options else None


def things(scene: FloorScene) -> list[SceneObject]:
    """Return what can be carried from a floor and be spoken of."""
    return [thing for thing in scene.objects if thing.pickupable and not thing.openable and thing.category not in _ODD]


def _room_of(thing: SceneObject, scene: FloorScene) -> SceneRoom:
    return next(room for room in scene.rooms if room.id == thing.room)


def call_room(room: SceneRoom, rng: np.random.Generator) -> str:
    """Return a room's type, or its name where that tells it from others."""
    named = room.name and plain(room.name) != plain(room.room_type)
    return plain(room.name if named and rng.random() < 0.5 else room.room_type)


def call_thing(thing: SceneObject, scene: FloorScene, building: LoadedBuilding, rng: np.random.Generator) -> Need:
    """Return how somebody may ask for a thing: by its floor, and perhaps its colour, its room and what it is on."""
    parent = next((entry for entry in scene.objects if entry.id == thing.parent), None)
    with_parent = parent is not None and rng.random() < 0.5
    with_room = rng.random() < 0.7
    relation = "room"
    if with_parent and thing.mount in ("surface", "inside"):
        relation = "on" if thing.mount == "surface" else "in"
    carrier = parent if relation != "room" else None
    return Need(
        noun=plain(thing.category),
        color=colour_of(thing) if rng.random() < 0.4 else "",
        relation="on" if relation == "on" else "in" if relation == "in" else "room",
        receptacle=plain(carrier.category) if carrier is not None else "",
        receptacle_color=colour_of(carrier) if carrier and rng.random() < 0.3 else "",
        room=call_room(_room_of(thing, scene), rng) if with_room else "",
        floor=scene.floor if len(building.floors) > 1 else None,
        role="target",
    )


def call_place(thing: SceneObject, scene: FloorScene, building: LoadedBuilding, rng: np.random.Generator) -> Need:
    """Return how somebody may name the thing where another one goes."""
    return Need(
        noun=plain(thing.category),
        color=colour_of(thing) if rng.random() < 0.3 else "",
        room=call_room(_room_of(thing, scene), rng),
        floor=scene.floor if len(building.floors) > 1 else None,
        role="destination",
    )


def draw_start(world: World, floor: int, rng: np.random.Generator) -> TaskStart | None:
    """Return the place of a room of a floor, the robot facing one of four ways."""
    rooms = [mark for mark in world.view(floor).landmarks if mark.kind == "room"]
    mark = draw(rooms, rng)
    if mark is None:
        return None
    yaw = 90.0 * int(rng.integers(4))
    return TaskStart(floor=floor, pose=Pose2D(x=mark.pose.x, y=mark.pose.y, yaw=yaw))
