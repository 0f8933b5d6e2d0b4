"""Where a robot can go: occupancy grids, paths on a floor, routes between floors, and what a laser sees."""

from mansion_msgs_py.late_imports import importing

__all__ = ["warm"]


def warm() -> None:
    """Compile and cache the navigation kernels, so that a first robot need not wait."""
    with importing:
        import numpy as np

        from mansion_geometry.disc_cells import region_of
        from mansion_msgs_py.scene import FloorScene, SceneRoom
        from mansion_skills.navigation.floor_map import Body, FloorMap
        from mansion_skills.navigation.grid_kernels import best_cells, cast_rays, clearance, sees
        from mansion_skills.navigation.paths import find_path, free_run

    square = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]
    room = SceneRoom(id="F1/room", room_type="room", kind="main", polygon=square, net_polygon=square, area=9.0)
    scene = FloorScene(
        building_id="warm", floor=1, floors=1, label="G", elevation=0.0, height=3.0,
        outline=square, rooms=[room], walls=[], doors=[],
    )  # fmt: skip
    floor = FloorMap(scene, 0.2)
    floor.update([Body("F1/room/box_1", (1.5, 1.5, 0.2), (0.3, 0.3, 0.4), 0.0, False, 1)], {})
    find_path(floor.blocked, floor.frame, (0.5, 0.5), (2.5, 2.5))
    free_run(floor.blocked, floor.frame, (0.5, 0.5), 0.0, 1.0)
    reached = region_of(floor.blocked, *floor.frame.cell(0.5, 0.5))
    best_cells(floor.rooms, clearance(floor.blocked), reached, 1)
    cast_rays(floor.occupied, 20.0, 20.0, np.array([0.0, 1.0]), 50.0)
    sees(floor.view, 20.0, 20.0, 30.0, 30.0, 1.0, np.array([1], dtype=np.int16))
