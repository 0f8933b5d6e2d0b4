"""Parts that move have joints that stand as the scene has them, at the same poses in every physics format."""

import re
import xml.etree.ElementTree as ElementTree

import msgspec
import numpy as np
import pytest

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.meshes import links, mesh
from mansion_export.mjcf import floor_mjcf
from mansion_export.sdf import world_sdf
from mansion_export.usd import building_usd
from mansion_msgs_py.scene import FloorScene, SceneObject
from read_colliders import pose_of

FURNITURE = (
    "fridge",
    "microwave",
    "stove",
    "washing_machine",
    "wardrobe",
    "executive_desk",
    "wheelie_bin",
    "nightstand",
)
"""One of each kind of joint: upright and level hinges, drawers, lids."""

PASSES = 0.003
"""Metres by which two parts may overlap on the way."""

CATALOGUE = load_catalogue()
ASSETS = [CATALOGUE.by_category(name)[-1] for name in FURNITURE]


def furnished(floor: FloorScene, *, is_open: bool, stretched: bool = True) -> FloorScene:
    """Return a floor with all doors and all furniture open or closed, each piece turned, and stretched where asked."""
    doors = [msgspec.structs.replace(door, is_open=is_open) for door in floor.doors]
    items = [_item(asset, i, is_open=is_open, stretched=stretched) for i, asset in enumerate(ASSETS)]
    return msgspec.structs.replace(floor, doors=doors, objects=items)


def _item(asset: Asset, i: int, *, is_open: bool, stretched: bool) -> SceneObject:
    w, d, h = asset.size
    size = (w * 1.1, d, h * 1.2) if stretched else asset.size
    return SceneObject(
        id=f"F1/hub/{asset.category}",
        room="F1/hub",
        category=asset.category,
        asset=asset.key,
        position=(4.0 * i, 20.0, size[2] / 2),
        rotation=90.0 * i,
        size=size,
        pickupable=True,
        states={"open": is_open},
    )


def mujoco_model(floor: FloorScene, **options):
    mujoco = pytest.importorskip("mujoco")
    export = floor_mjcf(floor, "", articulated=True, **options)
    model = mujoco.MjModel.from_xml_string(export.xml, export.meshes)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return mujoco, model, data


def mujoco_poses(floor: FloorScene) -> dict[str, np.ndarray]:
    """Return the poses of all parts that move, (4, 4), by body."""
    _, model, data = mujoco_model(floor)
    found = {}
    for j in range(model.njnt):
        body = model.body(model.jnt_bodyid[j])
        found[body.name] = np.eye(4)
        found[body.name][:3, :3] = data.xmat[body.id].reshape(3, 3)
        found[body.name][:3, 3] = data.xpos[body.id]
    return found


@pytest.mark.parametrize("is_open", [True, False])
def test_joints_stand_as_the_scene_has_its_doors_and_furniture(ground, is_open):
    _, model, data = mujoco_model(furnished(ground, is_open=is_open))
    leaves = [f"{door.id}/leaf" for door in ground.doors if door.kind not in ("open", "frame")]
    names = [model.jnt(j).name for j in range(model.njnt)]
    assert all(any(name.startswith(leaf) for name in names) for leaf in leaves)
    assert sum(name.startswith("F1/hub/") for name in names) == sum(len(links(asset)) - 1 for asset in ASSETS)
    low, high = model.jnt_range.T
    assert data.qpos == pytest.approx(high if is_open else low)
    assert (low == 0.0).all() and (high > 0.05).all()


@pytest.mark.parametrize("is_open", [True, False])
def test_a_leaf_on_its_joint_is_where_the_fixed_one_is(ground, is_open):
    mujoco = pytest.importorskip("mujoco")
    floor = furnished(ground, is_open=is_open)
    fixed = floor_mjcf(floor, "")
    model = mujoco.MjModel.from_xml_string(fixed.xml, fixed.meshes)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for name, pose in mujoco_poses(floor).items():
        if "/leaf" in name:
            assert data.body(name).xpos == pytest.approx(pose[:3, 3], abs=1e-4)
            assert data.body(name).xmat.reshape(3, 3) == pytest.approx(pose[:3, :3], abs=1e-4)


@pytest.mark.parametrize("is_open", [True, False])
def test_gazebo_has_the_parts_where_mujoco_has_them_and_limits_from_there(ground, is_open):
    floor = furnished(ground, is_open=is_open)
    expected = mujoco_poses(floor)
    seen = 0
    for model in ElementTree.fromstring(world_sdf([floor], "", articulated=True).xml).findall("world/model"):
        poses = {link.get("name"): pose_of(model) @ pose_of(link) for link in model.findall("link")}
        for joint in model.findall("joint"):
            if joint.get("type") == "fixed":
                continue
            part = joint.findtext("child")
            name = model.get("name") if joint.findtext("parent") == "world" else f"{model.get('name')}/{part}"
            assert poses[part] == pytest.approx(expected[name], abs=1e-4)
            low, high = (float(joint.findtext(f"axis/limit/{side}")) for side in ("lower", "upper"))
            assert (high if is_open else low) == 0.0 and high > low
            seen += 1
    assert seen == len(expected)


@pytest.mark.parametrize("is_open", [True, False])
def test_usd_has_the_parts_where_mujoco_has_them_as_bodies_with_mass(ground, is_open, tmp_path):
    pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom, UsdPhysics

    floor = furnished(ground, is_open=is_open)
    expected = mujoco_poses(floor)
    path = tmp_path / "building.usdc"
    path.write_bytes(building_usd([floor], articulated=True))
    stage = Usd.Stage.Open(str(path))
    cache = UsdGeom.XformCache()
    bodies = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    joints = [UsdPhysics.Joint(prim) for prim in stage.Traverse() if prim.IsA(UsdPhysics.Joint)]
    assert {str(target) for joint in joints for target in joint.GetBody1Rel().GetTargets()} == {
        str(prim.GetPath()) for prim in bodies
    }
    for prim in bodies:
        pose = np.array(cache.GetLocalToWorldTransform(prim)).T
        assert pose == pytest.approx(expected[prim.GetAttribute("mansion:id").Get()], abs=1e-4)
        assert UsdPhysics.MassAPI(prim).GetMassAttr().Get() > 0.0
    assert len(bodies) == len(expected)
    for joint in joints:
        frames = []
        for target, place in (
            (joint.GetBody0Rel(), joint.GetLocalPos0Attr()),
            (joint.GetBody1Rel(), joint.GetLocalPos1Attr()),
        ):
            body = stage.GetPrimAtPath(target.GetTargets()[0])
            frames.append(np.array([*place.Get(), 1.0]) @ np.array(cache.GetLocalToWorldTransform(body)))
        if joint.GetPrim().IsA(UsdPhysics.RevoluteJoint):
            assert frames[0] == pytest.approx(frames[1], abs=1e-4)


def test_a_part_swept_through_its_range_passes_through_no_other(ground):
    floor = msgspec.structs.replace(furnished(ground, is_open=False, stretched=False), doors=[])
    mujoco = pytest.importorskip("mujoco")
    export = floor_mjcf(floor, "", articulated=True)
    # The export lets a part and its own body overlap; here they may not.
    xml = re.sub(r"  <contact>.*?</contact>\n", "", export.xml, flags=re.DOTALL)
    model = mujoco.MjModel.from_xml_string(xml, export.meshes)
    data = mujoco.MjData(model)
    assert model.njnt > 15
    for joint in range(model.njnt):
        for share in np.linspace(0.0, 1.0, 9):
            data.qpos[:] = 0.0
            data.qpos[joint] = share * model.jnt_range[joint][1]
            mujoco.mj_forward(model, data)
            deepest = min((float(contact.dist) for contact in data.contact), default=0.0)
            assert deepest > -PASSES, (model.jnt(joint).name, share)


@pytest.mark.parametrize("is_open", [True, False])
def test_furniture_rests_with_its_parts_open_and_closed(ground, is_open):
    ring = [(-10.0, 10.0), (60.0, 10.0), (60.0, 30.0), (-10.0, 30.0)]
    hall = msgspec.structs.replace(ground.rooms[0], polygon=ring, net_polygon=ring)
    floor = msgspec.structs.replace(
        furnished(ground, is_open=is_open, stretched=False), doors=[], rooms=[hall], walls=[], windows=[], cores=[]
    )
    mujoco, model, data = mujoco_model(floor, free_pickupables=True)
    before, places = data.qpos.copy(), data.xpos.copy()
    for _ in range(1000):
        mujoco.mj_step(model, data)
    assert not any(warning.number for warning in data.warning)
    for item in floor.objects:
        body = model.body(item.id).id
        assert np.linalg.norm(data.xpos[body] - places[body]) < 0.02, item.id
    for j in range(model.njnt):
        if model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE:
            k = model.jnt_qposadr[j]
            assert data.qpos[k] == pytest.approx(before[k], abs=0.05 * model.jnt_range[j][1]), model.jnt(j).name


def test_what_an_open_part_shows_is_no_part_of_the_closed_mesh() -> None:
    for asset in ASSETS:
        whole = sum(len(part.faces) for part in mesh(asset))
        parts = sum(len(part.faces) for link in links(asset) for part in link.parts)
        trays = sum(link.name.startswith("drawer") for link in links(asset)) * 4 * 12
        assert parts == whole + trays


def test_without_the_option_nothing_has_a_joint(ground):
    floor = furnished(ground, is_open=True)
    assert "<joint" not in floor_mjcf(floor, "").xml
    assert "<joint" not in world_sdf([floor], "").xml
