"""Occupancy map of a floor for the Navigation2 map server: trinary PGM and YAML."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_export.meshes.walls import WallBodies
from mansion_geometry.doorways import depth_of_doors, is_passable
from mansion_geometry.floor_grid import (
    FREE,
    OCCUPIED,
    RESOLUTION,
    UNKNOWN,
    GridFrame,
    fill_box,
    fill_rings,
    fill_strip,
    map_frame,
)
from mansion_geometry.object_footprints import stops_robots
from mansion_geometry.robot_body import CLEARANCE
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["FREE", "OCCUPIED", "UNKNOWN", "OccupancyMap", "map_files", "map_pgm", "map_yaml", "occupancy"]


@dataclass(frozen=True, slots=True)
class OccupancyMap:
    """What each cell of a storey is.

    Attributes
    ----------
    data : (rows, columns) array of int8
        `FREE`, `OCCUPIED` or `UNKNOWN`; row 0 is the lowest y, as in ``nav_msgs/OccupancyGrid``.
    frame : GridFrame
        Where the cells lie.
    """

    data: npt.NDArray[np.int8]
    frame: GridFrame

    @property
    def resolution(self) -> float:
        """Edge of a cell, metres."""
        return self.frame.resolution

    @property
    def origin(self) -> Point:
        """Lower left corner of the lower left cell, metres."""
        return self.frame.x0, self.frame.y0

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """Return the row and column of the cell that holds a point."""
        return self.frame.cell(x, y)


def occupancy(scene: FloorScene, resolution: float = RESOLUTION) -> OccupancyMap:
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
    frame = map_frame(scene, resolution)
    data = np.full(frame.shape, UNKNOWN, dtype=np.int16)
    for room in scene.rooms:
        if room.kind != "stair":
            fill_rings(data, frame, [room.polygon, *room.holes], FREE)
    for core in scene.cores:
        fill_rings(data, frame, [core.polygon], OCCUPIED if core.type == "stair" else FREE)
    bodies = WallBodies(scene)
    for wall in scene.walls:
        for box in bodies.boxes(wall):
            if box.center[2] - box.size[2] / 2 < CLEARANCE:
                fill_box(data, frame, box.center, box.size, box.rotation, OCCUPIED)
    for item in scene.objects:
        if stops_robots(item):
            fill_box(data, frame, item.position, item.size, item.rotation, OCCUPIED)
    depths = depth_of_doors(scene)
    for door in scene.doors:
        value = FREE if is_passable(door) else OCCUPIED
        fill_strip(data, frame, door.segment, depths[door.id], value, only=None if door.wall else UNKNOWN)
    return OccupancyMap(data.astype(np.int8), frame)


def map_files(scene: FloorScene) -> dict[str, bytes]:
    """Return ``map.pgm`` and ``map.yaml`` of a floor by their paths in the building's folder."""
    folder = floor_directory(scene.floor)
    return {f"{folder}/map.pgm": map_pgm(scene), f"{folder}/map.yaml": map_yaml(scene).encode()}


def map_pgm(scene: FloorScene, resolution: float = RESOLUTION) -> bytes:
    """Write the map as binary PGM: 254 free, 0 occupied, 205 unknown; first row is the highest y."""
    return pgm(occupancy(scene, resolution))


def pgm(grid: OccupancyMap) -> bytes:
    """Write an occupancy map as binary PGM."""
    shades = np.full(grid.data.shape, 205, dtype=np.uint8)
    shades[grid.data == FREE] = 254
    shades[grid.data == OCCUPIED] = 0
    height, width = shades.shape
    return f"P5\n{width} {height}\n255\n".encode() + shades[::-1].tobytes()


def map_yaml(scene: FloorScene, resolution: float = RESOLUTION, image: str = "map.pgm") -> str:
    """Write the map's metadata for ``nav2_map_server``.

    The threshold for free cells lies below the 0.196 that grey 205 stands for, so that unknown cells stay unknown.
    """
    frame = map_frame(scene, resolution)
    return (
        f"image: {image}\nmode: trinary\nresolution: {resolution:g}\n"
        f"origin: [{frame.x0:g}, {frame.y0:g}, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )
