"""Stairs and lifts of a plan: treads with handrails and an arrow up or down, cabins with a cross."""

import numpy as np
import numpy.typing as npt

from mansion_export.meshes.door_sides import Shaft, shaft_of
from mansion_export.plan.palette import INK
from mansion_export.plan.shapes import Area, Canvas, Frame, Label, Line, Shape, rectangle
from mansion_msgs_py.scene import Box3, FloorScene, SceneCore, StairDetails
from mansion_msgs_py.shapes import Point

__all__ = ["draw_cores", "stair_shapes"]

LETTER = 0.3
"""Height of the letters of UP and DN, metres."""

ASIDE = 0.62
"""From the first step to the middle of its word, metres; the floor landing is 0.9 m deep at least."""

Vector = npt.NDArray[np.float64]


def draw_cores(scene: FloorScene) -> list[Canvas]:
    """Draw the cores as they are on this floor: treads and the way up, or the lift's cabin."""
    canvases = []
    for core in scene.cores:
        shapes: list[Shape] = [Area(core.polygon, INK["core"], width=0.0)]
        served = ", ".join(str(floor) for floor in core.floors)
        if core.type == "stair":
            shapes += stair_shapes(core)
        else:
            shapes += _lift(shaft_of(core, scene))
        canvases.append(Canvas("cores", tuple(shapes), core.id, f"{core.id}: floors {served}"))
    return canvases


def _lift(shaft: Shaft) -> list[Shape]:
    """Draw the cabin with its cross, its opening towards the landing door."""
    a, b = shaft.width / 2 - 0.16, shaft.depth / 2 - 0.16
    frame = Frame(shaft.x, shaft.y, shaft.rotation)
    cabin = rectangle(-a, -b, a, b)
    size = float(np.clip(0.22 * min(shaft.width, shaft.depth), 0.14, 0.3))
    return [
        Area(frame.place(cabin), "#ffffff", INK["core_line"], 0.03),
        Line(frame.place([cabin[0], cabin[2]]), INK["core_line"], 0.015),
        Line(frame.place([cabin[1], cabin[3]]), INK["core_line"], 0.015),
        Label((shaft.x, shaft.y), "Lift", size, INK["text"], bold=True),
    ]


def stair_shapes(core: SceneCore) -> list[Shape]:
    """Draw the flights that are seen on a floor, with an arrow for each way that leads off it.

    Where stairs lead both up and down, the flight down lies under the second flight up: each arrow keeps to a
    flight of its own, as drawings cut them.
    """
    details = core.details
    if not isinstance(details, StairDetails):
        return []
    shapes: list[Shape] = []
    if details.treads:
        shapes += _flights(details)
        path = _corners([_middle(box) for box in details.treads])
        if not details.floor_opening:
            return shapes + _walking_line(path, "UP")
        return shapes + _walking_line(path[:2], "UP") + _walking_line(path[:-3:-1], "DN")
    if details.floor_opening:
        shapes += _flights_below(details)
    return shapes


def _flights(details: StairDetails) -> list[Shape]:
    shapes: list[Shape] = []
    for low, high in (*details.landings, *details.treads):
        corners = rectangle(low[0], low[1], high[0], high[1])
        shapes.append(Area(corners, "#ffffff", INK["core_line"], 0.015))
    return shapes + _rails(details)


def _rails(details: StairDetails) -> list[Shape]:
    return [
        Line([(a[0], a[1]), (b[0], b[1])], INK["core_line"], 0.04)
        for a, b in details.rails
        if (a[0], a[1]) != (b[0], b[1])
    ]


def _walking_line(path: list[Point], word: str) -> list[Shape]:
    """Draw a line along the middles of the steps in walking order, an arrow at its end, a word before its start."""
    if len(path) < 2:
        return []
    tip, ahead = np.array(path[-1]), _unit(path[-2], path[-1])
    aside = np.array([-ahead[1], ahead[0]])
    arrow = [tip + 0.14 * ahead, tip - 0.14 * ahead + 0.13 * aside, tip - 0.14 * ahead - 0.13 * aside]
    label = np.array(path[0]) - ASIDE * _unit(path[0], path[1])
    return [
        Line(path, INK["text"], 0.03),
        Area([(float(x), float(y)) for x, y in arrow], INK["text"], width=0.0),
        Label((float(label[0]), float(label[1])), word, LETTER, INK["text"], bold=True),
    ]


def _unit(start: Point, end: Point) -> Vector:
    way = np.array(end) - np.array(start)
    unit: Vector = way / max(float(np.hypot(*way)), 1e-9)
    return unit


def _middle(box: Box3) -> Vector:
    low, high = np.array(box[0]), np.array(box[1])
    middle: Vector = ((low + high) / 2)[:2]
    return middle


def _corners(points: list[Vector]) -> list[Point]:
    """Keep the ends of straight runs; a turn between two flights goes round by the landing."""
    path = [points[0]]
    for i in range(1, len(points) - 1):
        before, after = points[i] - points[i - 1], points[i + 1] - points[i]
        if abs(before[0] * after[1] - before[1] * after[0]) > 1e-6 or float(before @ after) < 0:
            path.append(points[i])
    path.append(points[-1])
    turned: list[Vector] = []
    for i, point in enumerate(path):
        if i > 0 and i + 1 < len(path) and i % 2 == 0:
            run = path[i - 1] - (path[i - 2] if i > 1 else path[i - 1])
            length = float(np.hypot(*run))
            if length > 1e-6 and float(np.hypot(*(point - path[i - 1]))) > 0.4:
                out = run / length * 0.5
                turned += [path[i - 1] + out, point + out]
        turned.append(point)
    return [(float(x), float(y)) for x, y in turned]


def _flights_below(details: StairDetails) -> list[Shape]:
    """Draw the flights that come up to a top floor, whose own scene has no steps but their depth and a guard.

    The guard closes the left flight's end, so the way down starts to the right of it.
    """
    start, end = (np.array(point[:2]) for point in details.rails[0])
    right, left = _unit(tuple(start), tuple(end)), np.array(start)
    opening = np.array(details.floor_opening) - left
    forward = np.array([-right[1], right[0]])
    if float((opening @ forward).mean()) < 0.0:
        forward = -forward
    length, width = float((opening @ forward).max()), float((opening @ right).max())
    flight, going = details.width, details.going
    steps = int((length - min(flight, 1.2) + 0.05) / going)

    def at(along: float, across: float) -> Point:
        x, y = left + along * forward + across * right
        return float(x), float(y)

    shapes: list[Shape] = [Area(details.floor_opening, "#ffffff", INK["core_line"], 0.03)]
    for side in ((0.0, flight), (width - flight, width)):
        shapes += [
            Line([at(k * going, side[0]), at(k * going, side[1])], INK["core_line"], 0.015) for k in range(steps + 1)
        ]
    far, turn = steps * going, steps * going + 0.5
    well = [at(0.0, flight), at(far, flight), at(far, width - flight), at(0.0, width - flight)]
    shapes += [Line(well, INK["core_line"], 0.04), Line([at(0.0, 0.0), at(0.0, flight)], INK["core_line"], 0.06)]
    lanes = (width - flight / 2, flight / 2)
    path = [at(0.5 * going, lanes[0]), at(turn, lanes[0]), at(turn, lanes[1]), at(0.5 * going, lanes[1])]
    return shapes + _walking_line(path, "DN")
