"""A storey that is excepted has what is said of it, and not what the others have."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def storeys(text: str) -> list[tuple[str, int | None, str]]:
    rooms = read_brief(text, default_knowledge()).rooms
    return [(room.room_type, room.count, room.floors[0].kind) for room in rooms]


@pytest.mark.parametrize(
    "text",
    [
        "An office block with two offices on each floor except the ground floor, where there is a bike room.",
        "An office block. Each floor has two offices, except the ground floor, which has a bike room.",
        "An office block. Each floor has two offices, apart from the ground floor, where there is a bike room.",
    ],
)
def test_the_clause_is_about_the_excepted_storey(text: str) -> None:
    assert storeys(text) == [("private_office", 2, "upper"), ("bike_storage", 1, "number")]


def test_an_exception_may_stand_behind_what_the_others_have() -> None:
    assert storeys("An office block. Each floor has a kitchenette, except for the top one.")[0][2] == "not_top"
