"""How storeys connect, and what stands on which of several named storeys."""

from collections import Counter
from typing import Any

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("description", "options", "stairs", "lifts"),
    [
        ("a flat", {}, 0, 0),
        ("a two-storey house", {}, 1, 0),
        ("a five-storey house", {}, 1, 1),
        ("a two-storey office with an elevator", {}, 1, 1),
        ("a four-storey office without an elevator", {"floor_area": 300.0}, 1, 0),
        ("a seven-storey office", {"floor_area": 400.0}, 2, 1),
        ("an eight-storey office", {"floor_area": 400.0}, 2, 2),
        ("an eight-storey office", {"floor_area": 250.0}, 1, 1),
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
