"""Several single rooms have one bed each."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def beds(text: str) -> list[tuple[str, int, bool]]:
    program = plan_building(BuildRequest(description=text)).program
    return [
        (entry.category, entry.count, entry.exact)
        for floor in program.floors
        for room in floor.rooms
        for entry in room.objects
        if entry.category.endswith("bed")
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Hospice with four single rooms", [("hospital_bed", 1, True)] * 4),
        ("Hotel with two single rooms and two double rooms", [("single_bed", 1, True)] * 2),
        ("A flat with a single bedroom", []),
    ],
)
def test_single_rooms_have_one_bed(text: str, expected: list[tuple[str, int, bool]]) -> None:
    assert beds(text) == expected
