"""Cells of lift cabins and of the openings to stairs: free on the published map, although no robot drives there."""

from collections.abc import Iterable
from math import atan2, degrees, hypot

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Segment
from mansion_skills.navigation.raster import GridFrame, fill_box, fill_ring

__all__ = ["shaft_cells"]

_NONE, _CABIN, _OPENING = 0, 1, 2


def shaft_cells(scene: FloorScene, frame: GridFrame, leafless: Iterable[str]) -> npt.NDArray[np.bool_]:
    """Return the cells that the floor's ``map.pgm`` has free inside and at the mouths of its cores.

    Parameters
    ----------
    scene : FloorScene
    frame : GridFrame
    leafless : iterable of str
        Kinds of doors that are always open.

    Returns
    -------
    array of bool, shape (rows, columns)
    """
    marks = np.zeros((frame.rows, frame.columns), dtype=np.int16)
    for core in scene.cores:
        if core.type == "elevator":
            fill_ring(marks, frame, core.polygon, _CABIN)
    thickness = {wall.id: wall.thickness for wall in scene.walls}
    for wall in scene.walls:
        _fill(marks, frame, wall.segment, wall.thickness, wall.thickness, _NONE)
    names = {core.id for core in scene.cores}
    for door in scene.doors:
        if names.intersection(str(name) for name in door.rooms):
            passable = door.is_open or door.kind in leafless
            depth = thickness.get(door.wall, 0.12)
            _fill(marks, frame, door.segment, 0.0, depth, _OPENING if passable else _NONE)
    free: npt.NDArray[np.bool_] = marks != _NONE
    return free


def _fill(
    marks: npt.NDArray[np.int16], frame: GridFrame, segment: Segment, longer: float, depth: float, value: int
) -> None:
    (ax, ay), (bx, by) = segment
    size = (hypot(bx - ax, by - ay) + longer, depth)
    middle = ((ax + bx) / 2, (ay + by) / 2)
    fill_box(marks, frame, middle, size, degrees(atan2(by - ay, bx - ax)), value)
