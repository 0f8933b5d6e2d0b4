"""A brief that asks for one room and names no building gets that room and nothing else."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def storeys(brief: str) -> list[tuple[float, list[str]]]:
    """Return of each storey its gross area and the types of its rooms."""
    floors = plan_building(BuildRequest(description=brief)).program.floors
    return [(floor.gross_floor_area, [room.room_type for room in floor.rooms]) for floor in floors]


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("a kitchen", "kitchen"),
        ("A single classroom with 24 desks, a whiteboard and a teacher's desk.", "classroom"),
        ("I need one single room for testing a robot: a kitchen with a fridge. No other rooms.", "kitchen"),
        ("one bedroom with a bed and a wardrobe", "bedroom"),
    ],
)
def test_one_room_is_a_building(brief: str, kind: str) -> None:
    assert [rooms for _, rooms in storeys(brief)] == [[kind]]


@pytest.mark.parametrize(
    ("brief", "area"),
    [
        ("a kitchen of 20 square metres", 20.0),
        ("A classroom, 60 m2", 60.0),
        ("Just a bathroom. 6 m2, with bathtub, toilet, sink and washing machine.", 6.0),
    ],
)
def test_the_building_is_as_large_as_its_room(brief: str, area: float) -> None:
    ((gross, rooms),) = storeys(brief)
    assert len(rooms) == 1
    assert gross == pytest.approx(area, rel=0.03)


def test_furniture_makes_the_room_larger() -> None:
    ((few, _),), ((many, _),) = storeys("a classroom with 10 desks"), storeys("a classroom with 50 desks")
    assert many > few


@pytest.mark.parametrize(
    "brief",
    [
        "a house with a kitchen",
        "a kitchen upstairs",
        "two classrooms",
        "a kitchen next to a bathroom",
        "a storage room in the basement",
    ],
)
def test_what_asks_for_more_than_a_room_is_a_building_with_others(brief: str) -> None:
    assert sum(len(rooms) for _, rooms in storeys(brief)) > 1
