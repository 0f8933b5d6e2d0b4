"""From the street one sees what kind of building it is; nothing of that stands in rooms or on ways."""

import msgspec
import numpy as np
import pytest
from shapely.geometry import MultiPoint, Polygon

from mansion_export.exterior.fronts import front_of
from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.model import Model, Node
from mansion_export.presentation import main_door
from mansion_msgs_py.scene import FloorScene


@pytest.fixture
def storeys(building: list[FloorScene]) -> list[FloorScene]:
    return building


def as_type(scenes: list[FloorScene], building_type: str) -> list[FloorScene]:
    return [msgspec.structs.replace(scene, building_type=building_type) for scene in scenes]


def points(model: Model, node: Node) -> np.ndarray:
    own = np.concatenate([surface.vertices for surface in model.meshes[node.mesh].surfaces])
    c, s = np.cos(np.radians(node.rotation)), np.sin(np.radians(node.rotation))
    scaled = own * np.array(node.scale)
    return scaled @ np.array([(c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)]) + np.array(node.position)


def outside(scenes: list[FloorScene]) -> dict[str, np.ndarray]:
    return {
        node.id: points(model, node)
        for model in building_models(scenes)
        for node in model.nodes
        if node.group == "site" or "/chimney_" in node.id
    }


@pytest.mark.parametrize(
    ("building_type", "shown"),
    [
        ("cinema", {"F1/marquee"}),
        ("church", {"F1/porch", "F1/steeple"}),
        ("town_hall", {"F1/portal", "F1/flagpole"}),
        ("kindergarten", {"F1/porch", "F1/plot/fence", "F1/plot/playground"}),
        ("restaurant_building", {"F1/plot/terrace"}),
        ("office", set()),
    ],
)
def test_each_kind_of_building_shows_what_it_is(storeys: list[FloorScene], building_type: str, shown: set[str]) -> None:
    told = {"marquee", "steeple", "portal", "porch", "flagpole", "fence", "playground", "terrace"}
    found = {name for name in outside(as_type(storeys, building_type)) if name.rpartition("/")[2] in told}
    assert found == shown


def test_what_people_call_a_building_counts_before_its_type(storeys: list[FloorScene]) -> None:
    scenes = [msgspec.structs.replace(scene, called="railway station") for scene in as_type(storeys, "ferry_terminal")]
    assert "F1/platform" in outside(scenes)
    assert "F1/platform" not in outside(as_type(storeys, "ferry_terminal"))


def test_trees_stand_behind_the_front(storeys: list[FloorScene]) -> None:
    ground = as_type(storeys, "office")[0]
    front = front_of(ground)
    assert front is not None
    for name, corners in outside([ground]).items():
        if "/tree_" in name:
            middle = corners[:, :2].mean(axis=0) - np.array(front.middle)
            assert float(middle @ np.array(front.out)) < 0.0


@pytest.mark.parametrize(
    "building_type", ["cinema", "school", "restaurant_building", "museum", "chalet", "fire_station"]
)
def test_nothing_of_it_reaches_into_rooms(storeys: list[FloorScene], building_type: str) -> None:
    ground = storeys[0]
    rooms = Polygon(ground.outline, ground.holes)
    told = ("marquee", "posters", "portal", "porch", "banners", "awnings", "flagpole", "fence", "playground", "terrace")
    for name, corners in outside(as_type(storeys, building_type)).items():
        if any(word in name for word in told):
            assert MultiPoint(corners[:, :2]).convex_hull.intersection(rooms).area < 0.01 or "fence" in name


def test_a_roofed_entrance_takes_the_place_of_its_canopy(storeys: list[FloorScene]) -> None:
    door = main_door(storeys[0])
    assert door is not None
    assert f"{door.id}/canopy" in outside(as_type(storeys, "office"))
    assert f"{door.id}/canopy" not in outside(as_type(storeys, "cinema"))


def test_a_chimney_stands_over_each_fireplace(storeys: list[FloorScene]) -> None:
    scenes = as_type(storeys, "house")
    assert not [name for name in outside(scenes) if "chimney" in name]
    bed = next(thing for thing in scenes[0].objects if thing.mount == "floor")
    scenes[0] = msgspec.structs.replace(scenes[0], objects=[msgspec.structs.replace(bed, category="fireplace")])
    (chimney,) = [corners for name, corners in outside(scenes).items() if "chimney" in name]
    assert abs(chimney[:, 0].mean() - bed.position[0]) < 0.2 and abs(chimney[:, 1].mean() - bed.position[1]) < 0.2
    assert chimney[:, 2].max() > max(wall.height for wall in scenes[-1].walls) + 1.0


def test_the_same_building_looks_the_same(storeys: list[FloorScene]) -> None:
    first, again = (outside(as_type(storeys, "kindergarten")) for _ in range(2))
    assert list(first) == list(again)
    assert all(np.array_equal(first[name], again[name]) for name in first)
