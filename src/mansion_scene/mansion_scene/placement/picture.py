"""Pictures of placements: footprints with their fronts, doors with the areas kept clear, windows."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from mansion_geometry.boxes import box_corners, unit_vector
from mansion_msgs_py.placement import PlacementResult, PlacementRoom

__all__ = ["draw_placements"]

_COLOURS = (
    *("#c8d9e8", "#e8d3b9", "#cfe3c8", "#e6c9cf", "#d6cfe6", "#e9e3b5"),
    *("#c5e0dd", "#e3d0c0", "#d9d9d9", "#bfcfe6", "#e2c6e0", "#d3e6b8"),
)


def draw_placements(
    rooms: Sequence[PlacementRoom],
    results: Sequence[PlacementResult],
    path: Path,
    *,
    columns: int = 2,
    labels: bool = True,
) -> None:
    """Draw rooms with their placed objects into one picture file (format by its suffix).

    Parameters
    ----------
    rooms, results : sequences of equal length
    path : Path
    columns : int
        Rooms in a line of the picture.
    labels : bool
        Whether footprints carry their object's name.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    lines = -(-len(rooms) // columns)
    figure = Figure(figsize=(6.0 * columns, 5.0 * lines), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(lines, columns, squeeze=False).ravel()
    for axis in axes[len(rooms) :]:
        axis.set_axis_off()
    for axis, room, result in zip(axes, rooms, results):
        _draw_room(axis, room, result, labels=labels)
    figure.savefig(path, dpi=80)


def _draw_room(axis: Any, room: PlacementRoom, result: PlacementResult, *, labels: bool) -> None:
    asked = sum(obj.quantity for obj in room.objects)
    axis.set_title(f"{room.room_id}: {len(result.placements)} of {asked}", fontsize=9)
    axis.set_aspect("equal")
    axis.set_axis_off()
    for ring in (room.polygon, *room.holes):
        points = np.array([*ring, ring[0]])
        axis.plot(points[:, 0], points[:, 1], color="#333333", linewidth=2)
    for openings, colour in ((room.windows, "#5aa9e6"), (room.doors, "#ffffff")):
        for opening in openings:
            ends = np.array(opening.segment)
            axis.plot(ends[:, 0], ends[:, 1], color=colour, linewidth=3)
    colours = {obj.name: _COLOURS[i % len(_COLOURS)] for i, obj in enumerate(room.objects)}
    for item in result.placements:
        u = np.array(unit_vector(item.rotation))
        v = np.array([-u[1], u[0]])
        centre = np.array(item.center)
        width, depth, _ = item.size
        corners = box_corners(np.array([*centre, *u, width / 2, depth / 2]))
        axis.fill(*corners.T, facecolor=colours[item.name], edgecolor="#444444", linewidth=0.7)
        front = centre + v * depth / 2
        nose = min(width, depth) * 0.25
        axis.fill(*np.array([front - u * nose, front + u * nose, front - v * nose]).T, color="#44444466")
        if labels:
            turn = 0 if abs(u[0]) * width + abs(u[1]) * depth > 0.6 * width else 90
            axis.text(*centre, item.name.replace("_", "\n"), fontsize=4.5, ha="center", va="center", rotation=turn)
