"""Meshes: walls close, polygons triangulate, and the 3D formats load with our ids."""

import json
import math

import msgspec
import numpy as np
import pytest
import shapely
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

from mansion_assets.catalogue import load_catalogue
from mansion_assets.materials import art, material_set, set_of, texture_set
from mansion_export.glb import building_glb, floor_glb
from mansion_export.html import view_page
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.meshes.building_model import floor_model, object_parts
from mansion_export.meshes.solids import triangulate
from mansion_export.meshes.walls import WallBodies
from mansion_export.mjcf import floor_mjcf
from mansion_export.pictures.overview import overview_png
from mansion_msgs_py.scene import SceneObject, StairDetails


@settings(deadline=None, max_examples=60)
@given(radii=st.lists(st.floats(1.0, 6.0), min_size=4, max_size=14), hole=st.floats(0.1, 0.6))
def test_triangles_cover_a_star_shaped_polygon_with_a_hole(radii, hole):
    angles = np.linspace(0, 2 * math.pi, len(radii), endpoint=False)
    ring = [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles)]
    polygon = Polygon(ring, [list(Point(0, 0).buffer(hole, 2).exterior.coords)[:-1]])
    if not polygon.is_valid:
        return
    points, faces = triangulate(polygon)
    corners = points[faces]
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    areas = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(polygon.area, rel=1e-6)


@settings(deadline=None, max_examples=6)
@given(corners=st.integers(500, 3000), teeth=st.floats(0.5, 0.95), courtyard=st.booleans())
def test_triangles_cover_a_polygon_of_many_corners(corners, teeth, courtyard):
    angles = np.linspace(0, 2 * math.pi, 2 * (corners // 2), endpoint=False)
    radii = np.where(np.arange(len(angles)) % 2 == 0, 20.0, 20.0 * teeth)
    holes = [Point(0, 0).buffer(5.0, 150).exterior.coords[:-1]] if courtyard else []
    polygon = Polygon(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]), holes)
    points, faces = triangulate(polygon)
    a, b, c = (points[faces[:, k]] for k in range(3))
    areas = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(polygon.area, rel=1e-9)
    assert polygon.buffer(1e-9).contains(shapely.multipoints((a + b + c) / 3))


def test_walls_close_at_corners_and_leave_their_openings(ground):
    bodies = WallBodies(ground)
    shapes = []
    for wall in ground.walls:
        (ax, ay), (bx, by) = wall.segment
        length = math.hypot(bx - ax, by - ay)
        ux, uy = (bx - ax) / length, (by - ay) / length
        half = wall.thickness / 2
        for low, high in bodies.pieces(wall):
            xs = [ax + ux * t + s * uy * half for t in (low, high) for s in (-1, 1)]
            ys = [ay + uy * t - s * ux * half for t in (low, high) for s in (-1, 1)]
            shapes.append(box(min(xs), min(ys), max(xs), max(ys)))
    body = unary_union(shapes)
    for corner in ((-0.1, -0.1), (14.1, -0.1), (14.1, 10.1), (-0.1, 10.1)):
        assert body.contains(Point(corner))
    for door in ground.doors:
        if door.kind != "open":
            (ax, ay), (bx, by) = door.segment
            assert not body.intersects(Point((ax + bx) / 2, (ay + by) / 2))


def test_glb_loads_with_our_ids_and_named_materials(building):
    content = building_glb(building)
    assert content == building_glb(list(reversed(building)))
    length = int.from_bytes(content[12:16], "little")
    document = json.loads(content[20 : 20 + length])
    names = {node["name"] for node in document["nodes"]}
    for scene in building:
        items = [*scene.rooms, *scene.walls, *scene.windows, *scene.objects]
        assert {item.id for item in items} <= names
    assert all(material["name"] for material in document["materials"])
    tables = [node for node in document["nodes"] if "dining_table" in node["name"]]
    assert len(tables) == 2
    assert len({node["mesh"] for node in tables}) == 1, "the same asset is one mesh"


def test_glb_is_y_up_with_floors_at_their_elevations(building, tmp_path):
    path = tmp_path / "building.glb"
    path.write_bytes(building_glb(building, site=False))
    loaded = trimesh.load(path)
    low, high = loaded.bounds
    assert high[1] == pytest.approx(3.4 + 3.2 + 0.66, abs=0.01)
    assert low[1] == pytest.approx(-0.2, abs=0.01)
    assert (low[2], high[2]) == pytest.approx((-10.25, 0.25), abs=0.03), "plan y is -z"
    place = loaded.graph.get("F2/bedroom_1/bed_1")[0][:3, 3]
    assert place == pytest.approx((1.0, 3.7, -9.0))


def test_surfaces_face_outwards(ground):
    model = floor_model(ground)
    shown = {node.id: node.mesh for node in model.nodes}
    for name in ("F1/wall_1", "F1/slab"):
        surfaces = model.meshes[shown[name]].surfaces
        volume = 0.0
        for surface in surfaces:
            a, b, c = (surface.vertices[surface.faces[:, i]] for i in range(3))
            volume += float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6
        assert volume > 0


def test_a_floor_alone_and_a_view_from_above_leave_things_out(ground):
    assert b"/ceiling" in floor_glb(ground)
    assert b"/ceiling" not in floor_glb(ground, ceilings=False)


def test_mujoco_loads_the_floor_and_names_bodies_after_objects(ground, tmp_path):
    mujoco = pytest.importorskip("mujoco")
    export = floor_mjcf(ground)
    folder = tmp_path / "floors" / "floor_1"
    folder.mkdir(parents=True)
    (tmp_path / "meshes").mkdir()
    for name, content in export.meshes.items():
        (tmp_path / "meshes" / name).write_bytes(content)
    (folder / "model.xml").write_text(export.xml, encoding="utf-8")
    model = mujoco.MjModel.from_xml_path(str(folder / "model.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert data.ncon == 0
    for item in (*ground.objects, *ground.walls, *ground.windows):
        assert mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, item.id) > 0
    bed = ground.objects[0]
    assert data.body(bed.id).xpos == pytest.approx(bed.position)
    assert model.njnt == 0


def test_mujoco_drops_free_objects_on_what_carries_them(ground):
    mujoco = pytest.importorskip("mujoco")
    cup = next(item for item in ground.objects if item.pickupable)
    others = [item for item in ground.objects if item is not cup]
    raised = msgspec.structs.replace(cup, position=(6.8, 7.9, 1.2))
    ground = msgspec.structs.replace(ground, objects=[*others, raised])
    export = floor_mjcf(ground, "", free_pickupables=True)
    model = mujoco.MjModel.from_xml_string(export.xml, export.meshes)
    data = mujoco.MjData(model)
    for _ in range(300):
        mujoco.mj_step(model, data)
    assert data.body(cup.id).xpos[2] == pytest.approx(0.75 + cup.size[2] / 2, abs=0.01)


def test_mujoco_leaves_free_objects_where_they_lie_in_and_on_others(ground):
    mujoco = pytest.importorskip("mujoco")
    shelf = SceneObject(
        id="F1/kitchen/shelf",
        room="F1/kitchen",
        category="unknown_shelf",
        asset="unknown_shelf",
        position=(7.0, 8.5, 0.5),
        rotation=90.0,
        size=(0.8, 0.4, 1.0),
        receptacle=True,
    )
    crate = copied(shelf, "crate", (6.0, 7.5, 0.2), (0.6, 0.5, 0.4), "floor", None)
    inner = copied(shelf, "box", (7.02, 8.6, 0.36), (0.2, 0.2, 0.2), "inside", shelf.id)
    top = copied(shelf, "cup", (7.0, 8.7, 1.05), (0.1, 0.1, 0.1), "surface", shelf.id)
    can = copied(shelf, "can", (6.1, 7.5, 0.15), (0.1, 0.1, 0.2), "inside", crate.id)
    under = copied(shelf, "bag", (7.0, 8.2, 0.15), (0.2, 0.2, 0.3), "floor", None)
    things = [crate, inner, top, can, under]
    ground = msgspec.structs.replace(ground, objects=[shelf, *things])
    export = floor_mjcf(ground, "", free_pickupables=True)
    model = mujoco.MjModel.from_xml_string(export.xml, export.meshes)
    data = mujoco.MjData(model)
    for _ in range(500):
        mujoco.mj_step(model, data)
    assert not any(warning.number for warning in data.warning)
    for thing in things:
        assert data.body(thing.id).xpos == pytest.approx(thing.position, abs=0.01), thing.id


def copied(like, name, position, size, mount, parent):
    """An object that can be picked up."""
    return msgspec.structs.replace(
        like,
        id=f"F1/kitchen/{name}",
        position=position,
        size=size,
        rotation=10.0,
        mount=mount,
        parent=parent,
        pickupable=True,
    )


def test_mujoco_has_memory_for_the_pairs_of_a_floor_of_many_objects(ground):
    mujoco = pytest.importorskip("mujoco")
    first = ground.objects[0]
    copies = [
        msgspec.structs.replace(
            first,
            id=f"F1/kitchen/thing_{i}",
            asset="no_asset",
            size=(0.1, 0.1, 0.1),
            position=(0.2 * (i % 40), 0.2 * (i // 40), 0.5),
        )
        for i in range(1500)
    ]
    export = floor_mjcf(msgspec.structs.replace(ground, objects=copies), "")
    model = mujoco.MjModel.from_xml_string(export.xml, export.meshes)
    assert model.narena >= 8 * model.nbody**2


def test_the_page_carries_everything_and_fetches_nothing(building):
    page = view_page(building)
    assert page == view_page(building_glb(building))
    assert "{{" not in page
    for word in ("http://", "https://", "src=", "@import", "fetch("):
        assert word not in page


def test_the_overview_has_a_picture_for_each_floor(building):
    content = overview_png(building, width=600)
    assert content == overview_png(list(reversed(building)), width=600)
    assert content.startswith(b"\x89PNG")


def test_floors_that_share_a_folder_never_give_one_name_to_two_meshes(building):
    for scene, risers in zip(building, (2, 0)):
        treads = [((i * 0.3, 0.0, 0.0), (i * 0.3 + 0.3, 1.2, 0.18 * (i + 1))) for i in range(risers)]
        index, stair = next((i, core) for i, core in enumerate(scene.cores) if core.type == "stair")
        details = StairDetails(
            form="dog_leg",
            risers=risers,
            riser=0.18,
            going=0.3,
            width=1.2,
            floor_landing=[],
            treads=treads,
            rails=[((0.0, 0.0, 1.0), (1.0 + risers, 0.0, 1.0))],
        )
        scene.cores[index] = msgspec.structs.replace(stair, id="stair_1", details=details)
    files = {}
    for scene in building:
        for name, data in floor_mjcf(scene).meshes.items():
            assert files.setdefault(name, data) == data, name


def test_glb_carries_each_texture_once_and_shows_tiles_in_true_size(building):
    data = building_glb(building)
    length = int.from_bytes(data[12:16], "little")
    document, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    pictures = []
    for image in document["images"]:
        view = document["bufferViews"][image["bufferView"]]
        pictures.append(binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])
        assert pictures[-1].startswith(b"\xff\xd8\xff") and image["mimeType"] == "image/jpeg"
    assert len(set(pictures)) == len(pictures) == len(document["textures"])
    textured = [m for m in document["materials"] if "baseColorTexture" in m["pbrMetallicRoughness"]]
    assert {"white_drywall", "light_wood", "painted_wood"} <= {m["name"] for m in textured}
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            look = document["materials"][primitive["material"]]["pbrMetallicRoughness"]
            assert ("TEXCOORD_0" in primitive["attributes"]) == ("baseColorTexture" in look)
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        size = {5126: 4, 5123: 2, 5125: 4}[accessor["componentType"]] * {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[
            accessor["type"]
        ]
        assert accessor["byteOffset"] + accessor["count"] * size <= view["byteLength"]
    node = next(node for node in document["nodes"] if node["name"] == "F1/living_room_1")
    mesh = document["meshes"][node["mesh"]]
    floor = mesh["primitives"][0]["attributes"]
    places, normals, tiles = (_read(document, binary, floor[name]) for name in ("POSITION", "NORMAL", "TEXCOORD_0"))
    top = normals[:, 1] > 0.9
    name = document["materials"][mesh["primitives"][0]["material"]]["name"]
    size = material_set(set_of(name)).size
    assert np.ptp(tiles[top], axis=0) * size == pytest.approx(np.ptp(places[top][:, [0, 2]], axis=0), abs=1e-3)


def _read(document, binary, index):
    accessor = document["accessors"][index]
    start = document["bufferViews"][accessor["bufferView"]]["byteOffset"] + accessor["byteOffset"]
    width = {"VEC2": 2, "VEC3": 3}[accessor["type"]]
    return np.frombuffer(binary, np.float32, accessor["count"] * width, start).reshape(-1, width)


def test_paintings_of_one_asset_show_several_pictures_each_the_same_every_time(ground):
    key = next(a.key for a in load_catalogue().by_category("painting"))
    wall = [msgspec.structs.replace(ground.objects[0], id=f"F1/hub/painting_{k}", asset=key) for k in range(12)]
    parts = [list(object_parts(msgspec.structs.replace(ground, objects=wall))) for _ in range(2)]
    shown = [{s.material.texture for s in surfaces} & _pictures() for _, surfaces in parts[0]]
    assert all(len(each) == 1 for each in shown) and len(set.union(*shown)) >= 4
    assert [node.mesh for node, _ in parts[0]] == [node.mesh for node, _ in parts[1]]


def _pictures():
    return {set_of(name) for name in art()}


def test_an_object_painted_red_keeps_its_grain_and_turns_red(ground):
    plain, red = (
        next(
            surface.material
            for surface in asset_surfaces("console_table_4", load_catalogue(), color)
            if surface.material.texture == "veneer"
        )
        for color in ("", "#b01010")
    )
    assert plain.texture == red.texture
    tint = texture_set(red.texture).tint(red.color)
    assert tint[0] > 0.6 and max(tint[1:]) < 0.1
