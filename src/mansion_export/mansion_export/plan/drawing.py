"""A whole plan: layers from the floor up, with title, dimensions, scale bar and north arrow."""

from dataclasses import dataclass

import numpy as np

from mansion_export.plan.cores import draw_cores
from mansion_export.plan.furniture import draw_furniture
from mansion_export.plan.labels import draw_rooms, label_rooms
from mansion_export.plan.openings import draw_doors, draw_walls, draw_windows
from mansion_export.plan.palette import INK
from mansion_export.plan.shapes import Area, Canvas, Label, Line, Shape, circle, rectangle
from mansion_export.presentation import floor_title
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.wording import counted

__all__ = ["Drawing", "draw_plan"]


@dataclass(frozen=True, slots=True)
class Drawing:
    """Canvases in the order in which they are drawn, and the plan rectangle that they fill."""

    x0: float
    y0: float
    x1: float
    y1: float
    title: str
    canvases: tuple[Canvas, ...]

    @property
    def width(self) -> float:
        """Width in plan metres."""
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        """Height in plan metres."""
        return self.y1 - self.y0


def draw_plan(scene: FloorScene) -> Drawing:
    """Draw the floor plan of a scene.

    Parameters
    ----------
    scene : FloorScene

    Returns
    -------
    Drawing
        Shapes in plan metres, y up.
    """
    x0, y0, x1, y1 = _extent(scene)
    unit = _unit(x1 - x0, y1 - y0)
    canvases = [
        *draw_rooms(scene),
        *draw_cores(scene),
        *draw_furniture(scene),
        *draw_walls(scene),
        *draw_windows(scene),
        *draw_doors(scene),
        *label_rooms(scene),
        Canvas("frame", tuple(_dimensions(x0, y0, x1, y1, unit))),
        Canvas("frame", tuple(_heading(scene, x0, x1, y1, unit))),
        Canvas("frame", tuple(_scale_bar(x0, y0 - 2.1 * unit, x1 - x0, unit))),
        Canvas("frame", tuple(_north(x1 - 0.6 * unit, y1 + 1.35 * unit, unit))),
    ]
    margin = 1.0 * unit
    return Drawing(
        x0 - margin - 0.8 * unit,
        y0 - margin - 2.2 * unit,
        x1 + margin,
        y1 + margin + 1.6 * unit,
        floor_title(scene),
        tuple(canvases),
    )


def _extent(scene: FloorScene) -> tuple[float, float, float, float]:
    """Return the bounds of the outer faces of the walls."""
    points = [*scene.outline, *(p for room in scene.rooms for p in room.polygon)]
    points += [p for core in scene.cores for p in core.polygon]
    for wall in scene.walls:
        half = wall.thickness / 2
        points += [(x + sx, y + sy) for x, y in wall.segment for sx, sy in _corners(half)]
    corners = np.array(points, dtype=float)
    (x0, y0), (x1, y1) = corners.min(0).tolist(), corners.max(0).tolist()
    return x0, y0, x1, y1


def _corners(half: float) -> tuple[tuple[float, float], tuple[float, float]]:
    return (-half, -half), (half, half)


def _unit(width: float, height: float) -> float:
    """Return the size of the lettering outside the plan, which reads alike on small and large floors."""
    return float(np.clip(max(width, height) / 24.0, 0.5, 3.0))


def _heading(scene: FloorScene, x0: float, x1: float, y1: float, unit: float) -> list[Shape]:
    area = sum(room.area for room in scene.rooms if room.kind not in ("stair", "elevator"))
    rooms = sum(room.kind not in ("stair", "elevator") for room in scene.rooms)
    things = counted(len(scene.objects), "object")
    facts = f"{area:.0f} m² in {counted(rooms, 'room')}, {things}, level {scene.elevation:+.2f} m"
    # Both lines end before the north arrow.
    width = x1 - x0 - 1.8 * unit
    title = min(0.72 * unit, width / (0.68 * len(floor_title(scene))))
    small = min(0.4 * unit, width / (0.56 * len(facts)))
    return [
        Label((x0, y1 + 1.55 * unit), floor_title(scene), title, INK["text"], "start", bold=True, halo=False),
        Label((x0, y1 + 0.8 * unit), facts, small, INK["muted"], "start", halo=False),
    ]


def _dimensions(x0: float, y0: float, x1: float, y1: float, unit: float) -> list[Shape]:
    """Draw the overall dimensions below and to the left of the plan."""
    gap, tick, ink = 0.75 * unit, 0.16 * unit, INK["muted"]
    width = 0.02 * unit
    y, x = y0 - gap, x0 - gap
    return [
        Line([(x0, y), (x1, y)], ink, width),
        *(Line([(p - tick, y - tick), (p + tick, y + tick)], ink, 2 * width) for p in (x0, x1)),
        Label(((x0 + x1) / 2, y - 0.36 * unit), f"{x1 - x0:.2f} m", 0.4 * unit, ink, halo=False),
        Line([(x, y0), (x, y1)], ink, width),
        *(Line([(x - tick, p - tick), (x + tick, p + tick)], ink, 2 * width) for p in (y0, y1)),
        Label((x - 0.36 * unit, (y0 + y1) / 2), f"{y1 - y0:.2f} m", 0.4 * unit, ink, angle=90.0, halo=False),
    ]


def _scale_bar(x: float, y: float, width: float, unit: float) -> list[Shape]:
    """Draw a scale bar of four fields in round metres, about a quarter of the plan long."""
    step = next(s for s in (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0) if 4 * s > 0.2 * width)
    thick = 0.16 * unit
    shapes: list[Shape] = []
    for i in range(4):
        fill = INK["text"] if i % 2 == 0 else INK["paper"]
        field = rectangle(x + i * step, y, x + (i + 1) * step, y + thick)
        shapes.append(Area(field, fill, INK["text"], 0.02 * unit))
    for i in (0, 2, 4):
        text = f"{i * step:g} m" if i == 4 else f"{i * step:g}"
        at = (x + i * step, y - 0.32 * unit)
        shapes.append(Label(at, text, 0.36 * unit, INK["muted"], halo=False))
    return shapes


def _north(x: float, y: float, unit: float) -> list[Shape]:
    """Draw the north arrow: north is the plan's +y, from which the sun's azimuth is counted."""
    r = 0.62 * unit
    needle = [(x - 0.28 * r, y - 0.72 * r), (x, y + 0.9 * r), (x, y - 0.45 * r)]
    other = [(x + 0.28 * r, y - 0.72 * r), (x, y + 0.9 * r), (x, y - 0.45 * r)]
    return [
        Area(circle((x, y), r, steps=40), None, INK["muted"], 0.03 * unit),
        Area(needle, INK["text"], INK["text"], 0.015 * unit),
        Area(other, INK["paper"], INK["text"], 0.015 * unit),
        Label((x, y + 1.28 * r), "N", 0.4 * unit, INK["text"], bold=True, halo=False),
    ]
