"""What is seen of a stair beyond its floor: the walls of its shaft, and the flights that come up from below."""

from collections.abc import Iterator
from math import atan2, degrees, hypot
from xml.etree.ElementTree import Element

from mansion_msgs_py.scene import FloorScene, SceneCore, StairDetails

__all__ = ["BELOW", "SHAFT", "shaft_boxes"]

SHAFT, BELOW = "/shaft", "/below"
"""Added to a stair's id: the bodies of its shaft, and of the flights below."""

SKIN = 0.03
"""Thickness of what stands for the walls beyond, metres."""


def shaft_boxes(scene: FloorScene) -> Iterator[tuple[str, list[Element]]]:
    """Yield for each stair the name of its shaft's body and its boxes, without a material.

    Where stairs lead on, the walls go on for a storey, up to a lid and down to a bottom; else the lid is the ceiling.
    """
    for core in scene.cores:
        details = core.details
        if not isinstance(details, StairDetails):
            continue
        top = max((wall.height for wall in scene.walls), default=2.8)
        lid = top + scene.height if details.ceiling_opening else top
        boxes = [_plate(core, lid)]
        if details.ceiling_opening:
            boxes += _ring(core, top, lid)
        if details.floor_opening:
            boxes += _ring(core, -scene.height, 0.0)
            boxes.append(_plate(core, -scene.height))
        yield core.id + SHAFT, boxes


def _ring(core: SceneCore, low: float, high: float) -> list[Element]:
    """Boxes along the outline, inside of it."""
    ring, boxes = core.polygon, []
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]]):
        length = hypot(bx - ax, by - ay)
        inward = (-(by - ay) / length * SKIN / 2, (bx - ax) / length * SKIN / 2)
        x, y = (ax + bx) / 2 + inward[0], (ay + by) / 2 + inward[1]
        box = _box((x, y, (low + high) / 2), (length, SKIN, high - low))
        box.set("euler", f"0 0 {degrees(atan2(by - ay, bx - ax)):g}")
        boxes.append(box)
    return boxes


def _plate(core: SceneCore, z: float) -> Element:
    xs, ys = zip(*core.polygon)
    middle = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, z)
    return _box(middle, (max(xs) - min(xs), max(ys) - min(ys), SKIN))


def _box(center: tuple[float, float, float], size: tuple[float, float, float]) -> Element:
    return Element(
        "geom",
        type="box",
        pos=" ".join(f"{value:g}" for value in center),
        size=" ".join(f"{value / 2:g}" for value in size),
        rgba="0.62 0.61 0.59 1",
    )
