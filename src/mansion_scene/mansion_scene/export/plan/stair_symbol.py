"""The plan symbol of a stair: treads, landings and handrails of its flights, and the way up."""

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import Box3, SceneCore, StairDetails
from mansion_msgs_py.shapes import Point, Ring
from mansion_scene.export.plan.palette import INK
from mansion_scene.export.plan.shapes import Area, Label, Line, Shape, rectangle

__all__ = ["stair_shapes"]

LETTER = 0.2


def stair_shapes(core: SceneCore) -> list[Shape]:
    """Draw the flights that leave a floor upwards, or, on the top floor, the opening to those below."""
    details = core.details
    if not isinstance(details, StairDetails):
        return []
    shapes: list[Shape] = []
    if details.treads:
        for low, high in (*details.landings, *details.treads):
            corners = rectangle(low[0], low[1], high[0], high[1])
            shapes.append(Area(corners, "#ffffff", INK["core_line"], 0.015))
        shapes += _rails(details)
        shapes += _way_up(details)
    elif details.floor_opening:
        shapes += _open_below(details.floor_opening)
    return shapes


def _rails(details: StairDetails) -> list[Shape]:
    return [
        Line([(a[0], a[1]), (b[0], b[1])], INK["core_line"], 0.04)
        for a, b in details.rails
        if (a[0], a[1]) != (b[0], b[1])
    ]


def _way_up(details: StairDetails) -> list[Shape]:
    """A line along the middles of the steps in walking order, with an arrow at its upper end."""
    path = _corners([_middle(box) for box in details.treads])
    if len(path) < 2:
        return []
    tip, before = np.array(path[-1]), np.array(path[-2])
    ahead = (tip - before) / max(float(np.hypot(*(tip - before))), 1e-9)
    aside = np.array([-ahead[1], ahead[0]])
    arrow = [tip + 0.12 * ahead, tip - 0.1 * ahead + 0.1 * aside, tip - 0.1 * ahead - 0.1 * aside]
    start, following = np.array(path[0]), np.array(path[1])
    back = (start - following) / max(float(np.hypot(*(start - following))), 1e-9)
    label = start + back * (0.5 * LETTER + 0.22)
    return [
        Line(path, INK["text"], 0.025),
        Area([(float(x), float(y)) for x, y in arrow], INK["text"], width=0.0),
        Label((float(label[0]), float(label[1])), "UP", LETTER, INK["text"], bold=True),
    ]


def _middle(box: Box3) -> npt.NDArray[np.float64]:
    low, high = np.array(box[0]), np.array(box[1])
    middle: npt.NDArray[np.float64] = ((low + high) / 2)[:2]
    return middle


def _corners(points: list[npt.NDArray[np.float64]]) -> list[Point]:
    """Keep the ends of straight runs; a turn between two flights goes round by the landing."""
    path = [points[0]]
    for i in range(1, len(points) - 1):
        before, after = points[i] - points[i - 1], points[i + 1] - points[i]
        if abs(before[0] * after[1] - before[1] * after[0]) > 1e-6 or float(before @ after) < 0:
            path.append(points[i])
    path.append(points[-1])
    turned: list[npt.NDArray[np.float64]] = []
    for i, point in enumerate(path):
        if i > 0 and i + 1 < len(path) and i % 2 == 0:
            run = path[i - 1] - (path[i - 2] if i > 1 else path[i - 1])
            length = float(np.hypot(*run))
            if length > 1e-6 and float(np.hypot(*(point - path[i - 1]))) > 0.4:
                out = run / length * 0.5
                turned += [path[i - 1] + out, point + out]
        turned.append(point)
    return [(float(x), float(y)) for x, y in turned]


def _open_below(opening: Ring) -> list[Shape]:
    points = np.array(opening, dtype=float)
    (x0, y0), (x1, y1) = points.min(0).tolist(), points.max(0).tolist()
    return [
        Area(opening, "#ffffff", INK["core_line"], 0.03),
        Line([(x0, y0), (x1, y1)], INK["core_line"], 0.015, 0.15),
        Line([(x0, y1), (x1, y0)], INK["core_line"], 0.015, 0.15),
        Label(((x0 + x1) / 2, (y0 + y1) / 2), "DN", LETTER, INK["text"], bold=True),
    ]
