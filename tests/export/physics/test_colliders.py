"""Furniture collides with the same convex pieces in every physics format."""

import msgspec
import numpy as np
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.meshes import collision_pieces
from mansion_export.mjcf import floor_mjcf
from mansion_export.sdf import world_sdf
from mansion_export.usd import building_usd
from mansion_msgs_py.scene import FloorScene, SceneObject
from read_colliders import sdf_colliders, usd_colliders

CATEGORIES = ("dining_table", "swivel_chair", "bookshelf", "bed", "bin", "vase", "sofa", "fridge")


@pytest.fixture
def furnished(ground) -> FloorScene:
    """The ground floor with furniture of the catalogue, turned and stretched."""
    known = load_catalogue()
    assets = [known.by_category(name)[-1] for name in CATEGORIES if known.by_category(name)]
    items = [
        SceneObject(
            id=f"F1/hub/{asset.category}_{i}",
            room="F1/hub",
            category=asset.category,
            asset=asset.key,
            position=(1.5 * i, 3.0, asset.size[2] * 0.55),
            rotation=30.0 * i,
            size=(asset.size[0] * 1.2, asset.size[1], asset.size[2] * 1.1),
        )
        for i, asset in enumerate(assets)
    ]
    return msgspec.structs.replace(ground, objects=items)


def boxes_of(colliders, item) -> np.ndarray:
    """Return the bounds of an object's colliders, sorted, (n, 6)."""
    bounds = [
        [*c.triangles.reshape(-1, 3).min(axis=0), *c.triangles.reshape(-1, 3).max(axis=0)]
        for c in colliders
        if c.id == item.id
    ]
    return np.array(sorted(np.round(bounds, 3).tolist()))


def test_usd_and_gazebo_have_the_same_pieces_at_the_same_places(furnished, tmp_path):
    pytest.importorskip("pxr")
    path = tmp_path / "building.usdc"
    path.write_bytes(building_usd([furnished]))
    export = world_sdf([furnished], "")
    usd, sdf = usd_colliders(path), sdf_colliders(export.xml, export.meshes)
    known = load_catalogue()
    for item in furnished.objects:
        mine, theirs = boxes_of(usd, item), boxes_of(sdf, item)
        assert len(mine) == len(collision_pieces(known.asset(item.asset)))
        assert mine == pytest.approx(theirs, abs=3e-3)


def test_mujoco_has_these_pieces_and_rests_what_is_put_on_a_table_on_its_top(furnished):
    mujoco = pytest.importorskip("mujoco")
    known = load_catalogue()
    table = furnished.objects[0]
    export = floor_mjcf(furnished, "")
    top = table.position[2] + table.size[2] / 2
    upper = f'<body name="upper" pos="{table.position[0]} {table.position[1]} {top + 0.2}"><freejoint/>'
    upper += '<geom type="box" size="0.1 0.1 0.1" mass="1"/></body>'
    low = f'<body name="low" pos="{table.position[0]} {table.position[1]} 0.15"><freejoint/>'
    low += '<geom type="box" size="0.1 0.1 0.1" mass="1"/></body>'
    xml = export.xml.replace("</worldbody>", upper + low + "</worldbody>")
    model = mujoco.MjModel.from_xml_string(xml, export.meshes)
    for item in furnished.objects:
        body = model.body(item.id)
        colliding = [i for i in range(model.ngeom) if model.geom_bodyid[i] == body.id and model.geom_contype[i]]
        assert len(colliding) == len(collision_pieces(known.asset(item.asset)))
    data = mujoco.MjData(model)
    for _ in range(400):
        mujoco.mj_step(model, data)
    assert data.body("upper").xpos[2] == pytest.approx(top + 0.1, abs=0.01)
    assert data.body("low").xpos[2] == pytest.approx(0.1, abs=0.01)
