"""A ball of the robot's breadth goes through every open doorway and through no closed one, in every physics format."""

from collections.abc import Sequence

import msgspec
import numpy as np
import pytest

from mansion_export.mjcf import floor_mjcf
from mansion_export.sdf import world_sdf
from mansion_export.usd import building_usd
from mansion_geometry.doorways import is_passable
from mansion_msgs_py.scene import Door, FloorScene
from read_colliders import Collider, sdf_colliders, usd_colliders

RADIUS = 0.2
"""Of the ball, metres."""

APPROACH = 0.5
"""Where the ball starts, and where it has passed: metres from the wall's centre line."""

LIFT = 0.05
"""Of the ball off the floor, metres."""


@pytest.fixture(params=[True, False], ids=["open", "closed"])
def floor(request, ground) -> FloorScene:
    """The sample's ground floor with a garage door, all leaves open or all closed, and nothing in the way."""
    outer = next(wall for wall in ground.walls if wall.exterior and wall.left == "F1/office_1" and _faces_south(wall))
    garage = Door(
        id="F1/garage_door",
        kind="garage",
        segment=((9.2, -0.1), (12.2, -0.1)),
        rooms=("F1/office_1", None),
        width=3.0,
        height=2.2,
        wall=outer.id,
    )
    doors = [msgspec.structs.replace(door, is_open=request.param) for door in (*ground.doors, garage)]
    return msgspec.structs.replace(ground, doors=doors, windows=[], objects=[])


def _faces_south(wall) -> bool:
    return all(y < 0.0 for _, y in wall.segment)


def way_of(door: Door) -> tuple[np.ndarray, np.ndarray]:
    """Return the middle of a doorway, where the ball's centre goes, and the unit vector through it."""
    (ax, ay), (bx, by) = door.segment
    along = np.array([bx - ax, by - ay]) / np.hypot(bx - ax, by - ay)
    return np.array([(ax + bx) / 2, (ay + by) / 2, RADIUS + LIFT]), np.array([-along[1], along[0], 0.0])


def passable(doors: Sequence[Door], colliders: Sequence[Collider]) -> dict[str, bool]:
    """Tell by its id through which door's middle the ball goes without touching anything."""
    found = {}
    for door in doors:
        middle, across = way_of(door)
        path = middle + np.linspace(-APPROACH, APPROACH, 51)[:, None] * across
        low, high = path.min(0) - RADIUS, path.max(0) + RADIUS
        near = [c for c in colliders if _meets(c, low, high)]
        found[door.id] = all(bool((c.distance(path) > RADIUS).all()) for c in near)
    return found


def _meets(collider: Collider, low: np.ndarray, high: np.ndarray) -> bool:
    points = collider.triangles.reshape(-1, 3)
    return bool((points.min(0) < high).all() and (points.max(0) > low).all())


@pytest.mark.parametrize("articulated", [False, True])
def test_a_ball_is_pushed_through_open_doors_and_against_closed_ones_in_mujoco(floor, articulated):
    mujoco = pytest.importorskip("mujoco")
    export = floor_mjcf(floor, "", articulated=articulated)
    balls = []
    for door in floor.doors:
        middle, across = way_of(door)
        place = " ".join(f"{value:.6f}" for value in middle - APPROACH * across)
        axis = " ".join(f"{value:.6f}" for value in across)
        balls.append(
            f'<body name="{door.id}/ball" pos="{place}"><joint name="{door.id}/way" type="slide" axis="{axis}" '
            f'damping="5"/><geom type="sphere" size="{RADIUS}" mass="1" contype="2" conaffinity="1"/></body>'
        )
    xml = export.xml.replace("</worldbody>", "".join(balls) + "</worldbody>")
    model = mujoco.MjModel.from_xml_string(xml, export.meshes)
    model.opt.gravity[:] = 0.0
    data = mujoco.MjData(model)
    for _ in range(500):
        for door in floor.doors:
            data.joint(f"{door.id}/way").qfrc_applied[0] = 5.0
        mujoco.mj_step(model, data)
    reached = {door.id: data.joint(f"{door.id}/way").qpos[0] > 2 * APPROACH for door in floor.doors}
    assert reached == {door.id: is_passable(door) for door in floor.doors}


@pytest.mark.parametrize("articulated", [False, True])
def test_a_ball_goes_through_open_doors_alone_among_the_colliders_of_a_usd_stage(floor, tmp_path, articulated):
    pytest.importorskip("pxr")
    path = tmp_path / "building.usdc"
    path.write_bytes(building_usd([floor], articulated=articulated))
    colliders = usd_colliders(path)
    assert passable(floor.doors, colliders) == {door.id: is_passable(door) for door in floor.doors}


@pytest.mark.parametrize("articulated", [False, True])
def test_a_ball_goes_through_open_doors_alone_among_the_colliders_of_a_gazebo_world(floor, articulated):
    export = world_sdf([floor], "", articulated=articulated)
    colliders = sdf_colliders(export.xml, export.meshes)
    assert passable(floor.doors, colliders) == {door.id: is_passable(door) for door in floor.doors}


@pytest.mark.parametrize("format_", ["usd", "sdf"])
def test_the_frame_of_a_door_and_the_walls_beside_it_are_in_the_way(ground, tmp_path, format_):
    if format_ == "usd":
        pytest.importorskip("pxr")
        path = tmp_path / "building.usdc"
        path.write_bytes(building_usd([ground]))
        colliders = usd_colliders(path)
    else:
        export = world_sdf([ground], "")
        colliders = sdf_colliders(export.xml, export.meshes)
    for door in (door for door in ground.doors if door.kind != "open"):
        (ax, ay), (bx, by) = door.segment
        jamb = np.array([[ax + 0.03 * (bx - ax), ay + 0.03 * (by - ay), 1.0]])
        mine = [c for c in colliders if c.id == door.id]
        assert mine, door.id
        assert min(float(c.distance(jamb)[0]) for c in mine) < 0.1
