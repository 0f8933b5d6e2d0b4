"""Files of plans are read by their ending and by what is in them."""

import json
import sys
from pathlib import Path
from typing import Any

import pytest

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.errors import MansionError
from mansion_planner.plan_files import extra_for, read_plan

SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3]]


def written(folder: Path, value: Any, name: str = "plan.json") -> Path:
    """Write a value as JSON and return the file."""
    path = folder / name
    path.write_text(json.dumps(value), encoding="utf-8")
    return path


def test_our_own_json(tmp_path: Path) -> None:
    path = written(tmp_path, {"name": "Hut", "floors": [{"rooms": [{"name": "Room", "polygon": SQUARE}]}]})
    plan = read_plan(path, complete=["doors"])
    assert (plan.name, plan.complete) == ("Hut", ["doors"])
    assert plan.floors[0].rooms[0].polygon[2] == (4.0, 3.0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[1, 2", "is not JSON"),
        ('{"rooms": []}', "expected a plan"),
        ('{"floors": [{"rooms": [{"name": "Room", "outline": []}]}]}', "outline"),
        ('{"type": "FeatureCollection", "features": 3}', "has features"),
    ],
)
def test_what_is_no_plan_is_refused_with_the_file(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "plan.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(MansionError, match=message) as refusal:
        read_plan(path)
    assert "plan.json" in refusal.value.info.message


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match=r"nothing\.json"):
        read_plan(tmp_path / "nothing.json")


def test_geojson_has_rooms_doors_and_windows_by_floor(tmp_path: Path) -> None:
    def feature(shape: str, coordinates: Any, **properties: Any) -> dict[str, Any]:
        return {"type": "Feature", "geometry": {"type": shape, "coordinates": coordinates}, "properties": properties}

    features = [
        feature("Polygon", [[*SQUARE, SQUARE[0]]], name="Bedroom", floor=2),
        feature("LineString", [[1, 0, 2.5], [2, 0, 2.5]], kind="window", floor=2, sill=0.4),
        feature("Point", [4, 1], floor=2, width=0.8, rooms=["Bedroom", "outside"]),
        feature("Polygon", [SQUARE], name="Shop", type="shop", colour="red"),
    ]
    collection = {"type": "FeatureCollection", "features": features, "floors": [{"floor": 2, "height": 3.1}]}
    plan = read_plan(written(tmp_path, collection, "plan.geojson"))
    upper, ground = plan.floors
    assert (upper.floor, upper.height, ground.floor) == (2, 3.1, 1)
    assert upper.rooms[0].polygon == [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
    assert upper.windows[0].segment == ((1.0, 0.0), (2.0, 0.0))
    assert (upper.windows[0].sill, upper.doors[0].at, upper.doors[0].width) == (0.4, (4.0, 1.0), 0.8)
    assert ground.rooms[0].type == "shop"


@pytest.mark.parametrize(
    "feature",
    [
        {"geometry": None},
        {"geometry": {"type": "Point", "coordinates": [1, 1]}, "properties": {"kind": "room"}},
        {"geometry": {"type": "Polygon", "coordinates": []}},
        {"geometry": {"type": "Point", "coordinates": [1, 1]}, "properties": {"kind": "sofa"}},
        {"geometry": {"type": "MultiPoint", "coordinates": [[1, 1]]}},
    ],
)
def test_a_feature_at_fault_is_named(tmp_path: Path, feature: dict[str, Any]) -> None:
    path = written(tmp_path, {"type": "FeatureCollection", "features": [feature]})
    with pytest.raises(MansionError) as refusal:
        read_plan(path)
    assert refusal.value.info.path.startswith("$.features[0]")


PROBLEM: dict[str, Any] = {
    "plan_id": "a",
    "boundary": [[0, 0], [8, 0], [8, 4], [0, 4]],
    "nodes": [
        {"id": "hall", "type": "main", "area": 12.0},
        {"id": "den", "type": "Entities", "area": 14.0, "room_type": "bedroom"},
        {"id": "bath", "type": "Entities", "area": 6.0},
    ],
    "edges": [{"source": "hall", "target": "den"}, {"source": "hall", "target": "bath"}],
}


def test_a_problem_of_the_solver_is_a_plan_that_it_draws(tmp_path: Path) -> None:
    floor = read_plan(written(tmp_path, PROBLEM)).floors[0]
    assert [(room.id, room.area) for room in floor.rooms] == [("hall", 12.0), ("den", 14.0), ("bath", 6.0)]
    assert floor.outline[2] == (8.0, 4.0)
    assert [door.rooms for door in floor.doors] == [["hall", "den"], ["hall", "bath"]]


def test_the_true_rooms_of_a_data_set_are_taken_as_they_are(tmp_path: Path) -> None:
    truth = [
        {"id": "hall", "polygon": [[0, 0], [3, 0], [3, 4], [0, 4]]},
        {"id": "den", "polygon": [[3, 0], [8, 0], [8, 3], [3, 3]]},
        {"id": "bath", "polygon": [[3, 3], [8, 3], [8, 4], [3, 4]]},
    ]
    floor = read_plan(written(tmp_path, [{**PROBLEM, "truth": truth}])).floors[0]
    assert floor.outline == []
    assert floor.rooms[1].polygon[1] == (8.0, 0.0)
    assert (floor.rooms[1].name, floor.rooms[1].type) == ("Bedroom", "bedroom")


def test_a_room_graph_without_outline_gets_one_for_its_areas(tmp_path: Path) -> None:
    graph = {"nodes": [{**node, "area": 12.0} for node in PROBLEM["nodes"]], "edges": PROBLEM["edges"]}
    (x, y) = read_plan(written(tmp_path, graph)).floors[0].outline[2]
    assert x * y == pytest.approx(36.0)


@pytest.mark.parametrize(("name", "module"), [("a.ifc", "ifcopenshell"), ("a.dxf", "ezdxf")])
def test_without_its_library_a_file_is_refused_with_what_to_install(
    name: str, module: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    (tmp_path / name).touch()
    with pytest.raises(MansionError, match=rf"need the package {module}: pip install 'mansion\[") as refusal:
        read_plan(tmp_path / name)
    assert refusal.value.code == "UNAVAILABLE"
    assert extra_for(tmp_path / name) == name[2:]


def test_one_of_several_plans_is_named(tmp_path: Path) -> None:
    path = written(tmp_path, [PROBLEM, {**PROBLEM, "plan_id": 7}])
    assert isinstance(read_plan(path.with_name("plan.json#7")), BuildingPlan)
    assert isinstance(read_plan(path.with_name("plan.json#1")), BuildingPlan)
    with pytest.raises(MansionError, match=r"2 plans; name one as plan\.json#a"):
        read_plan(path)
    with pytest.raises(MansionError, match="there is no plan 'x' in it"):
        read_plan(path.with_name("plan.json#x"))
