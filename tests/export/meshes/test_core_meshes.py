"""Lifts and stairs are marked over their doors, on the side from which one comes."""

from math import cos, radians, sin

import msgspec
import numpy as np
import pytest

from mansion_export.meshes.building_model import floor_model
from mansion_export.meshes.core_meshes import core_sign
from mansion_msgs_py.scene import FloorScene, SceneCore


def door_of(scene: FloorScene, core: SceneCore):
    return next(door for door in scene.doors if door.id == core.door)


@pytest.mark.parametrize("kind", ["stair", "elevator"])
def test_a_sign_hangs_over_the_door_on_the_side_of_its_entrance(ground, kind):
    ground = msgspec.structs.replace(ground, building_type="office")
    core = next(core for core in ground.cores if core.type == kind)
    plate, letters = core_sign(ground, core)
    door, yaw = door_of(ground, core), radians(core.entrance[2])
    middle = np.mean(door.segment, axis=0)
    outward = np.array([cos(yaw), sin(yaw)])
    wall = next(wall for wall in ground.walls if wall.id == door.wall)
    for surface in (plate, letters):
        away = (surface.vertices[:, :2] - middle) @ outward
        assert away.min() >= wall.thickness / 2 - 1e-9
        assert away.max() < 0.2
        assert surface.vertices[:, 2].max() <= wall.height + 1e-9
    assert plate.vertices[:, 2].min() > door.height
    face = ((plate.vertices[:, :2] - middle) @ outward).max()
    assert ((letters.vertices[:, :2] - middle) @ outward).max() > face, "letters stand out"


def test_the_letters_read_from_left_to_right_as_one_faces_them(ground):
    ground = msgspec.structs.replace(ground, building_type="office")
    core = next(core for core in ground.cores if core.type == "elevator")
    yaw = radians(core.entrance[2])
    left = np.array([sin(yaw), -cos(yaw)])
    letters = core_sign(ground, core)[1].vertices
    across = letters[:, :2] @ left
    low = letters[:, 2] < letters[:, 2].min() + 0.02
    foot, whole = across[low], (across.min(), across.max())
    # An L has its foot at the left end, a T has none at the right one.
    assert foot.max() == pytest.approx(whole[1])
    assert foot.min() > whole[0] + 0.03


def test_nobody_puts_a_sign_over_the_stairs_at_home(ground):
    ground = msgspec.structs.replace(ground, building_type="single_family_house")
    signs = {core.type: bool(core_sign(ground, core)) for core in ground.cores}
    assert signs == {"stair": False, "elevator": True}


def test_the_floors_model_has_the_signs(ground):
    ground = msgspec.structs.replace(ground, building_type="office")
    nodes = {node.id for node in floor_model(ground).nodes}
    assert {f"{core.id}/sign" for core in ground.cores} <= nodes
