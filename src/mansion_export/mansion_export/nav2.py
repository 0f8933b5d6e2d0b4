"""Occupancy map of a floor for the Navigation2 map server: trinary PGM and YAML."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_export.solids import Box, segment_box
from mansion_export.walls import WallBodies
from mansion_geometry.robot_body import CLEARANCE, in_the_way
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.scene import Door, FloorScene, SceneObject
from mansion_msgs_py.shapes import Point

__all__ = [
    "FREE",
    "OCCUPIED",
    "UNKNOWN",
    "OccupancyMap",
    "blocks_robot",
    "map_files",
    "map_pgm",
    "map_yaml",
    "occupancy",
]

FREE, OCCUPIED, UNKNOWN = 0, 100, -1
"""Values of ``nav_msgs/OccupancyGrid``."""

MARGIN = 0.5
"""Unknown metres around the building."""

LEAFLESS = ("open", "doorway", "frame")


@dataclass(frozen=True, slots=True)
class OccupancyMap:
    """A grid over the floor.

    Attributes
    ----------
    data : (height, width) array of int8
        `FREE`, `OCCUPIED` or `UNKNOWN`; row 0 is the lowest y, as in ``nav_msgs/OccupancyGrid``.
    resolution : float
        Metres a cell.
    origin : (x, y)
        Lower left corner of the lower left cell in the floor's frame.
    """

    data: npt.NDArray[np.int8]
    resolution: float
    origin: Point

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """Return the row and column of the cell that holds a point."""
        column = int(np.floor((x - self.origin[0]) / self.resolution))
        row = int(np.floor((y - self.origin[1]) / self.resolution))
        return row, column


def occupancy(scene: FloorScene, resolution: float = 0.05) -> OccupancyMap:
    """Rasterise a floor.

    Rooms and lift cabins are free; walls, closed doors, stairs (a wheeled robot would fall) and whatever stands or
    hangs between `FLAT` and `CLEARANCE` are occupied; outside is unknown. A cell that an obstacle touches by more than
    its half is occupied.

    Parameters
    ----------
    scene : FloorScene
    resolution : float
        Metres a cell.

    Returns
    -------
    OccupancyMap
    """
    grid = _Grid.around(scene, resolution)
    for ring, holes in _floors(scene):
        grid.fill(ring, FREE, holes)
    for core in scene.cores:
        grid.fill(core.polygon, OCCUPIED if core.type == "stair" else FREE)
    bodies = WallBodies(scene)
    for wall in scene.walls:
        for box in bodies.boxes(wall):
            if box.center[2] - box.size[2] / 2 < CLEARANCE:
                grid.block(box)
    for item in scene.objects:
        if blocks_robot(item):
            grid.block(Box(item.position, item.size, item.rotation))
    thickness = {wall.id: wall.thickness for wall in scene.walls}
    for door in scene.doors:
        box = segment_box(door.segment, thickness.get(door.wall, 0.12), door.height)
        grid.block(box, FREE if _passable(door) else OCCUPIED, only=None if door.wall else UNKNOWN)
    return OccupancyMap(grid.data, resolution, grid.origin)


def map_files(scene: FloorScene) -> dict[str, bytes]:
    """Return ``map.pgm`` and ``map.yaml`` of a floor by their paths in the building's folder."""
    folder = floor_directory(scene.floor)
    return {f"{folder}/map.pgm": map_pgm(scene), f"{folder}/map.yaml": map_yaml(scene).encode()}


def map_pgm(scene: FloorScene, resolution: float = 0.05) -> bytes:
    """Write the map as binary PGM: 254 free, 0 occupied, 205 unknown; first row is the highest y."""
    return pgm(occupancy(scene, resolution))


def pgm(grid: OccupancyMap) -> bytes:
    """Write an occupancy map as binary PGM."""
    shades = np.full(grid.data.shape, 205, dtype=np.uint8)
    shades[grid.data == FREE] = 254
    shades[grid.data == OCCUPIED] = 0
    height, width = shades.shape
    return f"P5\n{width} {height}\n255\n".encode() + shades[::-1].tobytes()


def map_yaml(scene: FloorScene, resolution: float = 0.05, image: str = "map.pgm") -> str:
    """Write the map's metadata for ``nav2_map_server``.

    The threshold for free cells lies below the 0.196 that grey 205 stands for, so that unknown cells stay unknown.
    """
    x, y = _Grid.around(scene, resolution).origin
    return (
        f"image: {image}\nmode: trinary\nresolution: {resolution:g}\n"
        f"origin: [{x:g}, {y:g}, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )


def _floors(scene: FloorScene) -> list[tuple[Sequence[Point], Sequence[Sequence[Point]]]]:
    return [(room.polygon, room.holes) for room in scene.rooms if room.kind != "stair"]


def _passable(door: Door) -> bool:
    return door.kind in LEAFLESS or door.is_open


def blocks_robot(item: SceneObject) -> bool:
    """Tell whether an object stands or hangs between `FLAT` and `CLEARANCE`; what furniture carries does not count."""
    bottom, top = item.position[2] - item.size[2] / 2, item.position[2] + item.size[2] / 2
    carried = item.mount in ("surface", "inside")
    return not carried and in_the_way(bottom, top)


@dataclass(frozen=True, slots=True)
class _Grid:
    data: npt.NDArray[np.int8]
    resolution: float
    origin: Point

    @staticmethod
    def around(scene: FloorScene, resolution: float) -> "_Grid":
        """An unknown grid around the floor, its origin on a multiple of the resolution."""
        points = [*scene.outline, *(point for room in scene.rooms for point in room.polygon)]
        points += [point for wall in scene.walls for point in wall.segment]
        points += [point for core in scene.cores for point in core.polygon]
        corners = np.array(points, dtype=float)
        low = np.floor((corners.min(0) - MARGIN) / resolution)
        high = np.ceil((corners.max(0) + MARGIN) / resolution)
        width, height = (high - low).astype(int).tolist()
        origin = (round(float(low[0]) * resolution, 9), round(float(low[1]) * resolution, 9))
        return _Grid(np.full((height, width), UNKNOWN, dtype=np.int8), resolution, origin)

    def _window(self, points: npt.NDArray[np.float64]) -> tuple[slice, slice]:
        low = np.floor((points.min(0) - self.origin) / self.resolution).astype(int) - 1
        high = np.ceil((points.max(0) - self.origin) / self.resolution).astype(int) + 1
        rows, columns = self.data.shape
        return (
            slice(max(int(low[1]), 0), min(int(high[1]), rows)),
            slice(max(int(low[0]), 0), min(int(high[0]), columns)),
        )

    def _centers(self, window: tuple[slice, slice]) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        rows, columns = window
        xs = self.origin[0] + (np.arange(columns.start, columns.stop) + 0.5) * self.resolution
        ys = self.origin[1] + (np.arange(rows.start, rows.stop) + 0.5) * self.resolution
        return xs[None, :], ys[:, None]

    def fill(self, ring: Sequence[Point], value: int, holes: Sequence[Sequence[Point]] = ()) -> None:
        """Set the cells whose centres lie in a polygon (even-odd rule)."""
        points = np.asarray(ring, dtype=float)
        window = self._window(points)
        xs, ys = self._centers(window)
        inside = np.zeros((ys.shape[0], xs.shape[1]), dtype=bool)
        for loop in (points, *(np.asarray(hole, dtype=float) for hole in holes)):
            for (ax, ay), (bx, by) in zip(loop, np.roll(loop, -1, axis=0)):
                if ay != by:
                    crosses = (bx - ax) * (ys - ay) / (by - ay) + ax
                    inside ^= ((ay > ys) != (by > ys)) & (xs < crosses)
        self.data[window][inside] = value

    def block(self, box: Box, value: int = OCCUPIED, only: int | None = None) -> None:
        """Set the cells whose centres lie in a box, or within half a cell of a thin one."""
        angle = np.radians(box.rotation)
        c, s = float(np.cos(angle)), float(np.sin(angle))
        a = max(box.size[0], self.resolution) / 2 + 1e-6
        b = max(box.size[1], self.resolution) / 2 + 1e-6
        reach = np.array([abs(c) * a + abs(s) * b, abs(s) * a + abs(c) * b])
        center = np.array(box.center[:2])
        window = self._window(np.array([center - reach, center + reach]))
        xs, ys = self._centers(window)
        dx, dy = xs - center[0], ys - center[1]
        inside = (np.abs(c * dx + s * dy) <= a) & (np.abs(c * dy - s * dx) <= b)
        if only is not None:
            inside &= self.data[window] == only
        self.data[window][inside] = value
