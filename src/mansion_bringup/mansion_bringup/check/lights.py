"""Checks that every lamp is in the room that it lights."""

from collections.abc import Iterator
from typing import Final

from shapely import Point, Polygon

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import room_area
from mansion_msgs_py.scene import FloorScene

__all__ = ["check_lights"]

BESIDE: Final = 0.3
"""Metres by which a lamp may lie off its room: on the face of a wall, say."""


def check_lights(scene: FloorScene) -> Iterator[Fault]:
    """Yield lamps that are not in their rooms; the sun is nowhere in particular."""
    rooms = {room.id: room for room in scene.rooms}
    outline = Polygon(scene.outline, scene.holes)
    for light in scene.lights:
        if light.kind == "directional":
            continue
        x, y, z = light.position
        room = rooms.get(light.room or "")
        if light.room is not None and room is None:
            yield Fault("LIGHT_ROOM", light.id, f"is in {light.room!r}, which does not exist")
            continue
        place = outline if room is None else room_area(room)
        ceiling = scene.height if room is None else room.ceiling_height
        if place.distance(Point(x, y)) > BESIDE or not -BESIDE <= z <= ceiling + BESIDE:
            yield Fault("LIGHT_OUTSIDE", light.id, f"is outside {light.room or 'the building'}")
