"""Stairs with treads and an arrow, lifts with a cross."""

import numpy as np

from mansion_export.plan.palette import INK
from mansion_export.plan.shapes import Area, Canvas, Frame, Label, Line, Shape, rectangle
from mansion_export.plan.stair_symbol import stair_shapes
from mansion_export.shafts import Shaft, shaft_of
from mansion_msgs_py.scene import FloorScene

__all__ = ["draw_cores"]


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
    """The cabin with its cross; the opening towards the landing door."""
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
