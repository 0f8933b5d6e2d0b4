"""The few shapes that a plan is drawn with, in plan metres; both writers know only these."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.shapes import Point

__all__ = ["Area", "Canvas", "Frame", "Label", "Line", "Shape", "arc", "circle", "rectangle"]

Points: TypeAlias = Sequence[Point]


@dataclass(frozen=True, slots=True)
class Area:
    """A filled polygon; `holes` are left out of the filling. Widths are metres."""

    points: Points
    fill: str | None
    stroke: str | None = None
    width: float = 0.015
    holes: tuple[Points, ...] = ()


@dataclass(frozen=True, slots=True)
class Line:
    """An open polyline; `dash` is the length of strokes and gaps in metres, 0 for none."""

    points: Points
    stroke: str
    width: float = 0.015
    dash: float = 0.0


@dataclass(frozen=True, slots=True)
class Label:
    """One line of text, centred on `at` unless `anchor` says otherwise; `angle` counter-clockwise degrees."""

    at: Point
    text: str
    size: float
    color: str = "#2f3440"
    anchor: Literal["start", "middle", "end"] = "middle"
    bold: bool = False
    angle: float = 0.0
    halo: bool = True


Shape: TypeAlias = Area | Line | Label


@dataclass(frozen=True, slots=True)
class Canvas:
    """What belongs together: the shapes of one room, wall, door or object.

    Attributes
    ----------
    id : str
        Id of the scene's element; empty for decoration.
    title : str
        What a viewer shows when it is pointed at.
    """

    layer: str
    shapes: tuple[Shape, ...]
    id: str = ""
    title: str = ""


@dataclass(frozen=True, slots=True)
class Frame:
    """Position and heading of something: local x along its front edge, y towards its front."""

    x: float
    y: float
    rotation: float

    def place(self, points: Points) -> list[Point]:
        """Bring local points into the plan."""
        angle = np.radians(self.rotation)
        c, s = float(np.cos(angle)), float(np.sin(angle))
        return [(self.x + c * u - s * v, self.y + s * u + c * v) for u, v in points]


def rectangle(x0: float, y0: float, x1: float, y1: float) -> list[Point]:
    """Return the corners of an upright rectangle, counter-clockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def arc(center: Point, radius: float, start: float, end: float, steps: int = 14) -> list[Point]:
    """Return points of a circular arc from `start` to `end` degrees."""
    angles: npt.NDArray[np.float64] = np.radians(np.linspace(start, end, steps + 1))
    xs = center[0] + radius * np.cos(angles)
    ys = center[1] + radius * np.sin(angles)
    return list(zip(xs.tolist(), ys.tolist()))


def circle(center: Point, radius: float, radius_y: float | None = None, steps: int = 18) -> list[Point]:
    """Return points of a circle or, with `radius_y`, of an ellipse."""
    angles: npt.NDArray[np.float64] = np.linspace(0.0, 2.0 * np.pi, steps, endpoint=False)
    xs = center[0] + radius * np.cos(angles)
    ys = center[1] + (radius if radius_y is None else radius_y) * np.sin(angles)
    return list(zip(xs.tolist(), ys.tolist()))
