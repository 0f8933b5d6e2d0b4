"""The plan symbol of a stair: treads, landing, handrail gap and the arrow that points up."""

import numpy as np
from mansion_msgs_py.scene import SceneCore

from mansion_scene.export.plan.palette import INK
from mansion_scene.export.plan.shapes import Area, Frame, Label, Line, Shape, rectangle
from mansion_scene.export.shafts import Shaft

__all__ = ["stair_shapes"]

TREAD = 0.28
LANDING = 1.1


def stair_shapes(core: SceneCore, shaft: Shaft, floor: int) -> list[Shape]:
    """Draw a dog-leg stair seen from this floor; local y points to the door, x along it.

    The flight that leaves this floor starts beside the door on the left; the landing lies at the far end.
    """
    frame = Frame(shaft.x, shaft.y, shaft.rotation)
    a, b = shaft.width / 2, shaft.depth / 2
    top = max(floor for floor in core.floors) if core.floors else floor
    far, near = -b + min(LANDING, 0.3 * shaft.depth), b - min(LANDING, 0.28 * shaft.depth)
    count = max(3, int((near - far) / TREAD))
    ink = INK["core_line"]
    shapes: list[Shape] = []
    for y in np.linspace(near, far, count + 1).tolist():
        shapes.append(Line(frame.place([(-a, y), (-0.06, y)]), ink, 0.015))
        shapes.append(Line(frame.place([(0.06, y), (a, y)]), ink, 0.015))
    well = rectangle(-0.06, far, 0.06, near)
    shapes.append(Area(frame.place(well), "#ffffff", ink, 0.02))
    goes_up = floor < top
    x = -a / 2 if goes_up else a / 2
    path = [(x, near + 0.35), (x, far - 0.4), (-x, far - 0.4), (-x, near + 0.1)]
    shapes.append(Line(frame.place(path), INK["text"], 0.025))
    tip = [(-x - 0.12, near - 0.12), (-x, near + 0.12), (-x + 0.12, near - 0.12)]
    shapes.append(Area(frame.place(tip), INK["text"], width=0.0))
    at = frame.place([(x, near + 0.55)])[0]
    shapes.append(Label(at, "UP" if goes_up else "DN", 0.2, INK["text"], bold=True))
    return shapes
