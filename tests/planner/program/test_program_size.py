"""Buildings as large as the rooms that a brief counts."""

import re

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.program_size import size_of_program

KNOWLEDGE = default_knowledge()


def storeys(brief: str, kind: str) -> int | None:
    size = size_of_program(read_brief(brief, KNOWLEDGE), KNOWLEDGE.buildings[kind], KNOWLEDGE)
    return size and size.storeys


@pytest.mark.parametrize(
    ("brief", "kind", "expected"),
    [
        ("An office with three offices and a meeting room.", "office", 1),
        ("A school with four classrooms.", "school", 1),
        ("A hotel with 12 rooms and a restaurant.", "hotel", 2),
    ],
)
def test_a_few_rooms_make_a_small_building(brief: str, kind: str, expected: int) -> None:
    assert storeys(brief, kind) == expected


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A hotel with 60 rooms.", "hotel"),
        ("A hotel with a restaurant.", "hotel"),
        ("A high-rise hotel with 12 rooms.", "hotel"),
        ("A hotel with 12 rooms, 2000 m2 in all.", "hotel"),
        ("A hotel with 12 rooms on the third floor.", "hotel"),
        ("A house with three bedrooms.", "house"),
    ],
)
def test_other_briefs_keep_the_usual_size(brief: str, kind: str) -> None:
    assert storeys(brief, kind) is None


def test_rooms_that_are_counted_on_a_storey_have_none_above_them() -> None:
    brief = "An inn with a taproom and a kitchen on the ground floor and six guest rooms on the floor above."
    assert len(plan_building(BuildRequest(description=brief, seed=5)).program.floors) == 2


def test_a_storey_is_as_large_as_its_share() -> None:
    few, many = (
        size_of_program(read_brief(f"A hotel with {n} rooms.", KNOWLEDGE), KNOWLEDGE.buildings["hotel"], KNOWLEDGE)
        for n in (4, 16)
    )
    assert few is not None and many is not None
    assert few.storeys * few.area < many.storeys * many.area


@pytest.mark.parametrize("given", [{"area": 1500.0}, {"floor_area": 300.0}])
def test_a_size_in_the_request_leaves_the_usual_number_of_storeys(given: dict[str, float]) -> None:
    program = plan_building(BuildRequest(description="A hotel with 12 rooms", **given)).program
    assert len(program.floors) >= KNOWLEDGE.buildings["hotel"].floors[0]


@pytest.mark.parametrize(
    ("brief", "storeys"),
    [
        ("an office of 200 m2", 1),
        ("a garden annexe of 55 m2 for one person", 1),
        ("a house of 90 m2", 1),
        ("a house of 120 m2", 2),
        ("an office of 600 m2", 2),
        ("a townhouse of 90 m2", 2),
        ("a house of 90 m2 on two floors", 2),
    ],
)
def test_a_stated_area_is_divided_over_storeys_that_have_room_beside_a_stair(brief: str, storeys: int) -> None:
    program = plan_building(BuildRequest(description=brief)).program
    assert len(program.floors) == storeys
    stated = float(re.search(r"(\d+) m2", brief).group(1))  # type: ignore[union-attr]
    assert sum(floor.gross_floor_area for floor in program.floors) == pytest.approx(stated, rel=0.1)
