"""Equal meshes of all floors are one, whatever the elements are called."""

import json
from collections import Counter

import msgspec

from mansion_export.glb import building_glb
from mansion_export.meshes.building_model import building_models, floor_model
from mansion_export.mjcf import floor_mjcf
from mansion_msgs_py.scene import FloorScene


def storey(scene: FloorScene, floor: int) -> FloorScene:
    """The same storey with another number in all its ids."""
    old, new = f'"F{scene.floor}/'.encode(), f'"F{floor}/'.encode()
    raised = msgspec.json.decode(msgspec.json.encode(scene).replace(old, new), type=FloorScene)
    return msgspec.structs.replace(raised, floor=floor, elevation=scene.elevation + 4.0)


def test_equal_storeys_share_all_their_meshes(ground):
    first, second = floor_model(ground), floor_model(storey(ground, 2))
    assert {node.id for node in first.nodes}.isdisjoint(node.id for node in second.nodes if node.id.startswith("F"))
    assert first.meshes.keys() == second.meshes.keys()
    assert floor_mjcf(ground).meshes == floor_mjcf(storey(ground, 2)).meshes


def test_a_glb_of_equal_storeys_has_no_mesh_twice(ground):
    content = building_glb([ground, storey(ground, 2), storey(ground, 3)])
    document = json.loads(content[20 : 20 + int.from_bytes(content[12:16], "little")])
    times = Counter(mesh["name"] for mesh in document["meshes"])
    assert set(times.values()) == {1}
    used = Counter(node["mesh"] for node in document["nodes"] if "mesh" in node)
    walls = [i for i, mesh in enumerate(document["meshes"]) if mesh["name"].startswith("wall:")]
    assert walls and all(used[i] >= 3 for i in walls)


def test_what_differs_has_a_mesh_of_its_own(ground):
    room = ground.rooms[0]
    other = msgspec.structs.replace(
        storey(ground, 2),
        rooms=[msgspec.structs.replace(each, floor_material="dark_tiles") for each in storey(ground, 2).rooms],
    )
    first, second = floor_model(ground), floor_model(other)
    mesh = {node.id: node.mesh for model in (first, second) for node in model.nodes}
    assert mesh[room.id] != mesh[room.id.replace("F1/", "F2/")]
    assert mesh[room.id].partition(":")[0] == mesh[room.id.replace("F1/", "F2/")].partition(":")[0]


def test_every_node_finds_the_mesh_that_it_names(building):
    for model in building_models(building):
        assert {node.mesh for node in model.nodes} == set(model.meshes)
        assert all(name == mesh.name for name, mesh in model.meshes.items())
