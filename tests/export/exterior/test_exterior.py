"""Roofs cover the building, the plot lies around it, and nothing of either reaches into rooms."""

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

from mansion_export.exterior.lettering import lettering
from mansion_export.exterior.roofs import covering_rectangles
from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.model import Model, Node
from mansion_msgs_py.outside import GroundArea, Outside
from mansion_msgs_py.scene import FloorScene


def vertices(model: Model, node: Node) -> np.ndarray:
    own = np.concatenate([surface.vertices for surface in model.meshes[node.mesh].surfaces])
    c, s = np.cos(np.radians(node.rotation)), np.sin(np.radians(node.rotation))
    return own @ np.array([(c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)]) + np.array(node.position)


def of_group(models: list[Model], group: str) -> list[tuple[Node, np.ndarray]]:
    return [(node, vertices(model, node)) for model in models for node in model.nodes if node.group == group]


@pytest.fixture
def storeys(building: list[FloorScene]) -> list[FloorScene]:
    return building


def as_type(scenes: list[FloorScene], building_type: str, style: str = "") -> list[FloorScene]:
    return [msgspec.structs.replace(scene, building_type=building_type, style=style) for scene in scenes]


def ridge(models: list[Model]) -> float:
    """Return how far the roof rises above the walls of its storey, metres."""
    (found,) = [points for node, points in of_group(models, "ceiling") if node.id.endswith("/roof")]
    return float(np.ptp(found[:, 2]))


def test_homes_have_a_pitched_roof_and_offices_or_modern_houses_a_flat_one(storeys: list[FloorScene]) -> None:
    assert ridge(building_models(as_type(storeys, "office"))) < 1.4  # with the plant on it
    assert ridge(building_models(as_type(storeys, "house", "modern"))) < 0.8
    assert ridge(building_models(as_type(storeys, "house"))) > 1.5


def test_the_eaves_reach_beyond_the_walls_on_all_sides(storeys: list[FloorScene]) -> None:
    models = building_models(as_type(storeys, "villa"))
    (roof,) = [points for node, points in of_group(models, "ceiling") if node.id.endswith("/roof")]
    outline = np.array(storeys[-1].outline)
    assert (roof[:, :2].min(axis=0) < outline.min(axis=0) - 0.3).all()
    assert (roof[:, :2].max(axis=0) > outline.max(axis=0) + 0.3).all()


@pytest.mark.parametrize("building_type", ["house", "office"])
def test_the_plot_lies_outside_the_building_and_below_its_floor_but_for_what_grows(
    storeys: list[FloorScene], building_type: str
) -> None:
    models = building_models(as_type(storeys, building_type))
    inside = Polygon(storeys[0].outline)
    found = of_group(models, "site")
    names = {node.id.rpartition("/")[2].partition("_")[0] for node, _ in found}
    assert {"lawn", "path", "tree", "shrubs", "canopy", "landing"} <= names
    assert ("hedge" in names) == (building_type == "house")
    assert ("car" in names) == ("sign" in names) == (building_type == "office")
    assert ("parking" in names) == (building_type == "office")
    for node, points in found:
        assert not any(inside.buffer(-0.05).contains(Point(x, y)) for x, y in points[:, :2]), node.id
        if node.id.endswith(("lawn", "path", "parking", "landing")):
            assert points[:, 2].max() <= 0.0, node.id


def test_a_path_leads_from_each_outer_door_to_the_edge_of_the_plot(storeys: list[FloorScene]) -> None:
    models = building_models(as_type(storeys, "house"))
    (path,) = [points for node, points in of_group(models, "site") if node.id.endswith("/path")]
    (lawn,) = [points for node, points in of_group(models, "site") if node.id.endswith("/lawn")]
    doors = [door for door in storeys[0].doors if None in door.rooms]
    assert doors
    edge = box(*lawn[:, :2].min(axis=0), *lawn[:, :2].max(axis=0)).exterior
    assert min(edge.distance(Point(x, y)) for x, y in path[:, :2]) < 0.01
    for door in doors:
        middle = np.mean(np.array(door.segment), axis=0)
        assert np.linalg.norm(path[:, :2] - middle, axis=1).min() < 1.5


def test_a_view_without_ceilings_or_without_site_leaves_them_out(storeys: list[FloorScene]) -> None:
    assert of_group(building_models(storeys, site=False), "site") == []
    assert of_group(building_models(storeys, ceilings=False), "ceiling") == []
    roofs = {node.id for node, _ in of_group(building_models(storeys, ceilings=False, roofs=True), "ceiling")}
    assert roofs and all(name.endswith("/roof") or "/chimney_" in name for name in roofs)


def test_a_lower_storey_has_a_roof_where_the_one_above_draws_back(storeys: list[FloorScene]) -> None:
    first, *others = as_type(storeys, "office")
    x0, y0, x1, y1 = Polygon(first.outline).bounds
    wider = msgspec.structs.replace(first, outline=[(x0, y0), (x1 + 4.0, y0), (x1 + 4.0, y1), (x0, y1)])
    found = of_group(building_models([wider, *others]), "ceiling")
    roofs = [points for node, points in found if node.id == f"F{first.floor}/roof"]
    assert len(roofs) == 1
    assert roofs[0][:, 0].min() > x1 - 0.5


def with_terrace(scenes: list[FloorScene]) -> tuple[list[FloorScene], Polygon]:
    """Make the largest room of the highest storey a roof terrace."""
    *lower, top = scenes
    largest = max(top.rooms, key=lambda room: room.area)
    rooms = [msgspec.structs.replace(r, room_type="roof_terrace") if r is largest else r for r in top.rooms]
    return [*lower, msgspec.structs.replace(top, rooms=rooms)], Polygon(largest.net_polygon)


@pytest.mark.parametrize("building_type", ["house", "office"])
def test_no_roof_covers_a_roof_terrace(storeys: list[FloorScene], building_type: str) -> None:
    scenes, terrace = with_terrace(as_type(storeys, building_type))
    models = building_models(scenes)
    (found,) = [(m, node) for m in models for node in m.nodes if node.id.endswith("/roof")]
    # Eaves and copings may overhang it by the breadth of a hand or two.
    inner = terrace.buffer(-0.6)
    for surface in found[0].meshes[found[1].mesh].surfaces:
        for triangle in surface.vertices[surface.faces]:
            plan = Polygon(triangle[:, :2])
            assert not plan.is_valid or plan.intersection(inner).area < 1e-6


def test_the_name_stands_over_the_main_door_outside_the_wall(storeys: list[FloorScene]) -> None:
    scenes = as_type(storeys, "cinema")
    (sign,) = [points for node, points in of_group(building_models(scenes), "site") if node.id.endswith("/sign")]
    door = max((door for door in scenes[0].doors if None in door.rooms), key=lambda door: door.width)
    assert sign[:, 2].min() > door.height
    middle = np.mean(np.array(door.segment), axis=0)
    assert np.abs(sign[:, :2] - middle).max() < 4.0
    assert Polygon(scenes[0].outline).distance(Point(sign[:, :2].mean(axis=0))) > 0.2


def test_letters_differ_and_others_are_blanks() -> None:
    shapes = [lettering(letter) for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZ"]
    assert all(shape.bounds[1::2] == pytest.approx((0.0, 1.0), abs=0.01) for shape in shapes)
    assert len({shape.wkb for shape in shapes}) == 26
    assert lettering("7 !").is_empty


@settings(max_examples=50, deadline=None)
@given(st.lists(st.tuples(st.integers(1, 9), st.integers(1, 9)), min_size=1, max_size=4))
def test_rectangles_cover_a_plan_of_right_angles_and_nothing_else(corners: list[tuple[int, int]]) -> None:
    # Boxes that share their lower left corner make a stepped plan without holes.
    plan = unary_union([box(0, 0, x, y) for x, y in corners])
    rectangles = covering_rectangles(plan)
    assert unary_union([box(*rectangle) for rectangle in rectangles]).symmetric_difference(plan).area < 1e-6


def test_a_plan_that_is_no_sum_of_rectangles_has_none() -> None:
    assert covering_rectangles(Polygon([(0, 0), (5, 0), (3, 4)])) == []
    assert covering_rectangles(box(0, 0, 9, 9).difference(box(3, 3, 6, 6))) == []


def with_outside(scenes: list[FloorScene], outside: Outside, grounds: list[GroundArea]) -> list[FloorScene]:
    return [
        msgspec.structs.replace(scene, outside=outside, grounds=grounds if scene.floor == 1 else msgspec.UNSET)
        for scene in scenes
    ]


def test_a_roof_is_as_the_brief_has_it_whatever_the_type(storeys: list[FloorScene]) -> None:
    def materials(models: list[Model]) -> set[str]:
        (roof,) = [node for model in models for node in model.nodes if node.id.endswith("/roof")]
        (mesh,) = [model.meshes[roof.mesh] for model in models if roof in model.nodes]
        return {surface.material.name for surface in mesh.surfaces}

    pitched = building_models(with_outside(as_type(storeys, "office"), Outside(roof="hip", covering="thatch"), []))
    assert ridge(pitched) > 1.5 and "thatch" in materials(pitched)
    planted = building_models(with_outside(as_type(storeys, "house"), Outside(roof="flat", covering="lawn"), []))
    assert ridge(planted) < 1.0 and "lawn" in materials(planted)


def test_the_plot_shows_what_the_brief_lays_on_it_and_grows_to_hold_it(storeys: list[FloorScene]) -> None:
    x0, y0, x1, y1 = Polygon(storeys[0].outline).bounds
    grounds = [
        GroundArea(use="garden", polygon=list(box(x1 + 3, y0, x1 + 15, y1 + 6).exterior.coords)[:4]),
        GroundArea(use="pool", polygon=list(box(x1 + 6, y0 + 3, x1 + 10, y0 + 11).exterior.coords)[:4]),
        GroundArea(use="parking", polygon=list(box(x0 - 19, y0, x0 - 3, y0 + 10).exterior.coords)[:4], count=7),
    ]
    scenes = with_outside(as_type(storeys, "house"), Outside(), grounds)
    models = building_models(scenes)
    site = {node.id: points for node, points in of_group(models, "site")}
    lawn = site["F1/plot/lawn"]
    assert lawn[:, 0].max() > x1 + 15 and lawn[:, 0].min() < x0 - 19
    water = site["F1/plot/pool_2_water"]
    assert water[:, 0].min() == pytest.approx(x1 + 6) and water[:, 1].max() == pytest.approx(y0 + 11)
    asphalt = site["F1/plot/parking_3_surface"]
    assert np.ptp(asphalt[:, 0]) == pytest.approx(16.0)
    lines = {round(float(x), 2) for x in site["F1/plot/parking_3_bays"][:, 0]}
    assert min(lines) < x0 - 18 and max(lines) > x0 - 4  # a row on either side of the way
