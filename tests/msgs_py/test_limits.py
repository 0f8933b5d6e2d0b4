"""What is larger than the stated limits is refused with the limit named, before any work on it."""

from typing import Any

import msgspec
import pytest

from mansion_msgs_py.codec import convert, decode, encode_bytes, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.placement import PlacementRoom
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene

SQUARE = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)]


def problem(**fields: Any) -> dict[str, Any]:
    nodes = [ProblemNode(id="hall", type="main", area=81.0)]
    return {**to_builtins(FloorProblem(boundary=SQUARE, nodes=nodes)), **fields}


def refused(kind: type[msgspec.Struct], payload: object) -> MansionError:
    with pytest.raises(MansionError) as caught:
        decode(kind, encode_bytes(payload))
    assert caught.value.code == ErrorCode.INVALID_PAYLOAD
    return caught.value


@pytest.mark.parametrize("far", [1e9, -1e18, 10_000.5])
def test_coordinates_are_near_the_origin(far: float) -> None:
    ring = [[0, 0], [far, 0], [far, 9]]
    for kind, payload in (
        (FloorProblem, problem(boundary=ring)),
        (FloorProblem, problem(structural_walls=[ring[:2]])),
        (PlacementRoom, {"room_id": "r", "polygon": ring}),
        (BuildRequest, {"description": "a house", "footprint": {"boundary": ring}}),
    ):
        assert "10000.0" in refused(kind, payload).info.message


def test_a_brief_is_no_book() -> None:
    assert "200000" in refused(BuildRequest, {"description": "a house " * 25_001}).info.message


@pytest.mark.parametrize("field", ["area", "floor_area"])
@pytest.mark.parametrize("area", [float(2**63), 1e300, 0.0, -1.0])
def test_areas_are_those_of_buildings(field: str, area: float) -> None:
    error = refused(BuildRequest, {"description": "a house", field: area})
    assert error.info.path == f"$.{field}"


@pytest.mark.parametrize("area", [1e-300, 0.0, 0.05])
def test_no_room_is_smaller_than_walls_can_be_moved(area: float) -> None:
    nodes = [{"id": "hall", "type": "main", "area": 40.0}, {"id": "den", "type": "Entities", "area": area}]
    error = refused(FloorProblem, problem(nodes=nodes))
    assert error.info.path == "$.nodes[1].area" and "0.1" in error.info.message


@pytest.mark.parametrize("area", [float("inf"), float("nan"), 1e7])
def test_an_area_from_a_command_line_is_a_number_within_the_limits(area: float) -> None:
    with pytest.raises(MansionError):
        convert(BuildRequest, {"description": "a house", "area": area})


def test_rings_rooms_and_objects_are_counted() -> None:
    ring = [[0.0, 0.001 * k] for k in range(20_001)]
    assert "20000" in refused(FloorProblem, problem(boundary=ring)).info.message
    nodes = [to_builtins(ProblemNode(id=f"room_{k}", type="Entities")) for k in range(1_001)]
    assert "1000" in refused(FloorProblem, problem(nodes=nodes)).info.message
    scene = {
        "building_id": "b", "floor": 1, "floors": 1, "label": "1", "elevation": 0.0, "height": 3.0, "outline": SQUARE,
        "rooms": [], "walls": [], "doors": [], "lights": [{"id": "l", "kind": "point", "position": [0, 0, 0]}] * 20_001,
    }  # fmt: skip
    assert "20000" in refused(FloorScene, scene).info.message
