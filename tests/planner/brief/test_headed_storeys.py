"""Lists of a brief on two storeys begin with where they are: "below bar and kitchen; above two bedrooms"."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    "text",
    [
        "A vet clinic over two floors: down reception and pharmacy; up an operating room and a laboratory.",
        "A vet clinic on 2 levels. Below reception and pharmacy. Above operating room and laboratory.",
    ],
)
def test_rooms_are_on_the_storey_that_their_list_begins_with(text: str) -> None:
    program = plan_building(BuildRequest(description=text)).program
    wished = {wish.value.name: wish.scope.floors for wish in program.wishes if wish.kind == "room"}
    assert wished == {"reception": [1], "pharmacy": [1], "operating_room": [2], "laboratory": [2]}


def test_the_first_floor_is_above_what_is_at_the_bottom() -> None:
    text = "A building of three floors. At the bottom a bakery. Above it on the first and second floor one flat each."
    program = plan_building(BuildRequest(description=text)).program
    assert [wish.scope.floors for wish in program.wishes if wish.value.name == "flat"] == [[2, 3]]


def test_what_is_in_the_middle_of_a_ward_is_on_every_floor() -> None:
    text = "A hospital ward: 2 floors, each floor 10 patient rooms, nurse station in the middle, one treatment room."
    program = plan_building(BuildRequest(description=text)).program
    assert [wish.scope.floors for wish in program.wishes if wish.value.name == "nurse_station"] == [[1, 2]]


def test_a_till_between_storeys_is_a_range_and_no_furniture() -> None:
    brief = "Office with five storeys. Storeys 2 till 4 are same: twelve offices, one archive. Open from 9 till 5."
    program = plan_building(BuildRequest(description=brief)).program
    wished = {wish.value.name: wish.scope.floors for wish in program.wishes if wish.kind == "room"}
    assert wished == {"office": [2, 3, 4], "archive": [2, 3, 4]}
    assert not [wish for wish in program.wishes if wish.kind == "object"]
