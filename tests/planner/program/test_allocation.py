"""Rooms shared out over storeys: what a brief counts or refuses leaves no place for its like."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def types(brief: str) -> list[str]:
    program = plan_building(BuildRequest(description=brief)).program
    return [room.room_type for floor in program.floors for room in floor.rooms]


def test_who_wants_no_cafeteria_gets_no_cafe_either() -> None:
    assert "cafe" in types("A museum of two floors")
    assert not {"cafe", "cafeteria", "restaurant"} & set(types("A museum of two floors. We do not want cafeteria."))


def test_counted_bathrooms_leave_no_room_for_other_toilets() -> None:
    found = types("A language school on one floor of 290 m2 with 4 classrooms and 2 bathrooms")
    assert (found.count("bathroom"), {"restroom", "toilet"} & set(found)) == (2, set())


def test_rooms_that_others_have_for_themselves_are_not_added_again() -> None:
    found = types("A courthouse of two storeys with two courtrooms, each with its own judge's chamber")
    assert found.count("judges_chamber") == 2


@pytest.mark.parametrize(
    ("brief", "kind", "count"),
    [
        ("A kindergarten with three group rooms, each with a nap room.", "nap_room", 3),
        ("A one-storey hotel with four guest rooms, each with a bathroom, and a sauna.", "sauna", 1),
    ],
)
def test_rooms_that_each_of_a_group_has_are_not_added_to(brief: str, kind: str, count: int) -> None:
    assert types(brief).count(kind) == count
