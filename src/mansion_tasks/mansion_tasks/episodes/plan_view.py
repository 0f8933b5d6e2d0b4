"""A floor from above, with the way that the robot went: a picture that needs no renderer."""

from collections.abc import Sequence
from math import cos, radians, sin
from typing import Any

from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point
from mansion_skills.world.objects import corners
from mansion_skills.world.world import World

__all__ = ["plan_view"]

ROOM, CORE, THING, WALL = (243, 238, 228), (205, 214, 226), (208, 201, 190), (80, 80, 80)
EDGE = (168, 160, 148)
TARGET, GOAL, WAY, ROBOT = (214, 60, 40), (250, 214, 130), (70, 120, 200), (30, 80, 170)
MARGIN = 10


def plan_view(
    world: World,
    floor: int,
    way: Sequence[Point],
    yaw: float,
    *,
    size: int = 300,
    targets: frozenset[str] = frozenset(),
    goals: frozenset[str] = frozenset(),
) -> Any:
    """Return a Pillow image of a floor, as large as the floor's shape lets it be.

    Parameters
    ----------
    way : sequence of points
        Where the robot was on this floor, the present place last.
    yaw : float
        Degrees; the robot's arrow.
    size : int
        Pixels of the longer side.
    targets, goals : sets of ids
        Objects drawn in red; rooms and objects drawn in yellow.
    """
    from PIL import Image, ImageDraw

    scene = world.building.scene(floor)
    to, shape = _scale(scene, size)
    picture = Image.new("RGB", shape, (255, 255, 255))
    drawing = ImageDraw.Draw(picture)
    for room in scene.rooms:
        fill = GOAL if room.id in goals else ROOM
        drawing.polygon([to(p) for p in room.polygon], fill=fill, outline=WALL)
    for core in scene.cores:
        drawing.polygon([to(p) for p in core.polygon], fill=CORE, outline=WALL)
    for state in world.objects.on_floor(floor):
        kind = world.objects.kinds[state.id]
        if state.position is None or (kind.mount in ("ceiling", "wall") and state.id not in targets):
            continue
        fill = TARGET if state.id in targets else GOAL if state.id in goals else THING
        drawing.polygon([to(p) for p in corners(state, kind)], fill=fill, outline=EDGE)
        if state.id in targets:
            x, y = to((state.position[0], state.position[1]))
            drawing.ellipse((x - 5, y - 5, x + 5, y + 5), outline=TARGET, width=2)
    for door in scene.doors:
        drawing.line([to(p) for p in door.segment], fill=(255, 255, 255), width=3)
    if len(way) > 1:
        drawing.line([to(p) for p in way], fill=WAY, width=2)
    if way:
        _robot(drawing, to(way[-1]), yaw)
    return picture


def _robot(drawing: Any, place: tuple[float, float], yaw: float) -> None:
    x, y = place
    tip, left, right = (
        (x + r * cos(radians(yaw + a)), y - r * sin(radians(yaw + a))) for r, a in ((11, 0), (8, 140), (8, -140))
    )
    drawing.polygon([tip, left, right], fill=ROBOT, outline=(255, 255, 255))


def _scale(scene: FloorScene, size: int) -> tuple[Any, tuple[int, int]]:
    """Return the map from the plan's metres to pixels, y down, and the size of the picture."""
    xs, ys = [p[0] for p in scene.outline], [p[1] for p in scene.outline]
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    factor = (size - 2 * MARGIN) / max(high_x - low_x, high_y - low_y)

    def to(point: Point) -> tuple[float, float]:
        return MARGIN + (point[0] - low_x) * factor, MARGIN + (high_y - point[1]) * factor

    right, bottom = to((high_x, low_y))
    return to, (round(right) + MARGIN, round(bottom) + MARGIN)
