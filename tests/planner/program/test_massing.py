"""How storeys connect, and what stands on which of several named storeys."""

from collections import Counter
from typing import Any

import pytest
from shapely.geometry import Polygon

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("description", "options", "stairs", "lifts"),
    [
        ("a flat", {}, 0, 0),
        ("a two-storey house", {}, 1, 0),
        ("a five-storey house", {}, 1, 1),
        ("a two-storey office with an elevator", {"floor_area": 200.0}, 1, 1),
        ("a two-storey office", {"floor_area": 320.0}, 2, 0),
        ("a two-storey office with one stair", {"floor_area": 320.0}, 1, 0),
        ("a two-storey gym", {}, 2, 1),
        ("a four-storey office without an elevator", {"floor_area": 300.0}, 2, 0),
        ("a seven-storey office", {"floor_area": 400.0}, 2, 1),
        ("an eight-storey office", {"floor_area": 400.0}, 2, 2),
        ("an eight-storey office", {"floor_area": 250.0}, 2, 1),
        ("an eight-storey office", {"floor_area": 120.0}, 1, 1),
    ],
)
def test_stairs_and_lifts_follow_height_use_and_area(
    description: str, options: dict[str, Any], stairs: int, lifts: int
) -> None:
    reply = plan_building(BuildRequest(description=description, **options))
    for problem in reply.problems:
        kinds = Counter(core.type for core in problem.cores)
        assert (kinds["stair"], kinds["elevator"]) == (stairs, lifts)


def test_rooms_for_two_storeys_are_shared_out_without_losing_the_odd_one() -> None:
    brief = "a three-storey house with five bedrooms on the upper two floors"
    program = plan_building(BuildRequest(description=brief)).program
    bedrooms = [
        sum("bedroom" in room.id for room in floor.rooms)
        for floor in sorted(program.floors, key=lambda floor: floor.index)
    ]
    assert bedrooms == [0, 3, 2]


@pytest.mark.parametrize("area", [200, 230, 320])
def test_a_single_storey_bends_into_a_small_u(area: int) -> None:
    floor = plan_building(BuildRequest(description=f"A U-shaped house, one storey, {area} m2")).program.floors[0]
    assert len(floor.outline) == 8
    assert floor.gross_floor_area == pytest.approx(area, rel=0.1)


def test_a_lobby_that_rooms_are_to_be_apart_from_is_not_what_all_are_reached_through() -> None:
    brief = "A police station on one floor: lobby, 4 holding cells, interview room. Cells must not touch the lobby."
    reply = plan_building(BuildRequest(description=brief))
    beside = {edge.source if edge.target == "lobby" else edge.target for edge in reply.topologies[0].edges
              if "lobby" in (edge.source, edge.target)}  # fmt: skip
    assert beside and not any(name.startswith("holding_cell") for name in beside)


@pytest.mark.parametrize(
    "brief", ["a square museum building of one floor, 320 m2", "a square office building, 3 floors of 400 m2"]
)
def test_a_square_building_is_as_long_as_it_is_deep(brief: str) -> None:
    ground = plan_building(BuildRequest(description=brief)).program.floors[0]
    xs, ys = [x for x, _ in ground.outline], [y for _, y in ground.outline]
    assert len(ground.outline) == 4
    assert max(xs) - min(xs) == pytest.approx(max(ys) - min(ys))


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_no_other_depth_gives_up_a_stated_area(seed: int) -> None:
    reply = plan_building(BuildRequest(description="A T-shaped house of 360 m2 on two floors.", seed=seed))
    for floor in reply.program.floors:
        assert Polygon(floor.outline).area <= 1.15 * 180.0
