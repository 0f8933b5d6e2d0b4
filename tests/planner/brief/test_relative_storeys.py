"""Storeys that are told from another one lie above that one, and what each of them has is counted on each."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("text", "floors"),
    [
        ("A hotel with five floors. Each of the four floors above the ground floor has eight bedrooms", [2, 3, 4, 5]),
        ("A hostel with 4 storeys. Lobby at street level, on each of the three storeys above it a bedroom", [2, 3, 4]),
        ("A shop at ground level and on each of the three levels overhead two bedrooms", [2, 3, 4]),
        ("Clinic on 3 floors. Entrance level: lobby. Each of the two levels over it: six bedrooms", [2, 3]),
        ("School, three storeys. Every one of the two upper storeys has five bedrooms", [2, 3]),
        ("Hotel, three storeys, the two storeys above the lobby floor have 6 bedrooms each", [2, 3]),
        (
            "A hotel of five storeys. The second floor has a gym. Each of the three storeys above it: a bedroom",
            [3, 4, 5],
        ),
        ("A house with 3 floors. First floor: lobby. On all floors above the first: a bedroom", [2, 3]),
        ("A hospital with a basement; each of the three floors above ground has a bedroom", [1, 2, 3]),
        ("A 4-storey house: a cafe on the ground floor, a bedroom on each of the three further floors", [2, 3, 4]),
        ("A car park of 6 storeys; each level over the entrance level has a bedroom", [2, 3, 4, 5, 6]),
    ],
)
def test_what_each_storey_above_has_is_on_those(text: str, floors: list[int]) -> None:
    program = plan_building(BuildRequest(description=text)).program
    wish = next(wish for wish in program.wishes if wish.value.type == "bedroom")
    assert (wish.scope.floors, wish.scope.each) == (floors, True)


def test_the_words_that_tell_the_storeys_are_read() -> None:
    text = "A hotel with five floors. Each of the four floors above has eight guest rooms"
    assert read_brief(text, default_knowledge()).unread == []


def test_an_area_after_above_is_no_storey() -> None:
    facts = read_brief("A house. All floors above 30 m2 have a bedroom", default_knowledge())
    assert [ref.kind for room in facts.rooms for ref in room.floors] == ["every"]
