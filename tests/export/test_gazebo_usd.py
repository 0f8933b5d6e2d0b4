"""Gazebo worlds and USD stages hold every element under our ids."""

import sys
import xml.etree.ElementTree as ElementTree

import pytest

from mansion_export.mjcf import floor_mjcf
from mansion_export.sdf import world_sdf
from mansion_export.usd import building_usd
from mansion_msgs_py.errors import MansionError


def test_world_has_a_static_model_for_each_floor_at_its_elevation(building):
    root = ElementTree.fromstring(world_sdf(building).xml)
    models = root.findall("world/model")
    assert [model.get("name") for model in models] == ["floor_1", "floor_2"]
    assert {model.findtext("static") for model in models} == {"true"}
    assert models[1].findtext("pose") == "0 0 3.4 0 0 0"


def test_links_carry_our_ids_once_and_every_mesh_is_there(building):
    export = world_sdf(building, "meshes")
    for scene, model in zip(building, ElementTree.fromstring(export.xml).findall("world/model"), strict=True):
        names = [link.get("name") for link in model.findall("link")]
        assert len(names) == len(set(names))
        assert {item.id for item in (*scene.objects, *scene.walls, *scene.rooms)} <= set(names)
    uris = {uri.text for uri in ElementTree.fromstring(export.xml).iter("uri")}
    assert uris == {f"meshes/{name}" for name in export.meshes}


def test_gazebo_and_mujoco_share_their_meshes(ground):
    mine, theirs = world_sdf([ground]).meshes, floor_mjcf(ground).meshes
    shared = set(mine) & set(theirs)
    assert len(shared) > 20
    assert all(mine[name] == theirs[name] for name in shared)


def test_walls_and_furniture_collide(ground):
    model = ElementTree.fromstring(world_sdf([ground]).xml).find("world/model")
    boxes = {link.get("name"): len(link.findall("collision")) for link in model.findall("link")}
    assert boxes["F1/bedroom_1/bed_1"] == 1
    assert boxes["F1/living_room_1/rug_9"] == 0
    assert all(boxes[wall.id] > 0 for wall in ground.walls)


def test_usd_stage_is_z_up_in_metres_and_instances_carry_ids(building, tmp_path):
    usd = pytest.importorskip("pxr.Usd")
    geometry = pytest.importorskip("pxr.UsdGeom")
    path = tmp_path / "building.usdc"
    path.write_bytes(building_usd(building))
    stage = usd.Stage.Open(str(path))
    assert geometry.GetStageUpAxis(stage) == geometry.Tokens.z
    assert geometry.GetStageMetersPerUnit(stage) == 1.0
    ids = {prim.GetAttribute("mansion:id").Get() for prim in stage.Traverse() if prim.HasAttribute("mansion:id")}
    for scene in building:
        assert {item.id for item in (*scene.objects, *scene.walls)} <= ids


def test_without_usd_core_the_error_says_what_to_install(building, monkeypatch):
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(MansionError, match="usd-core") as caught:
        building_usd(building)
    assert caught.value.code == "UNAVAILABLE"
