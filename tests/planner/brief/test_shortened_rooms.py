"""A room in full and in short is one room."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        (
            "A data centre with a network operations centre (NOC) with 6 desks and a battery room. "
            "The battery room shall not adjoin the NOC.",
            ["network_operation_centre", "battery_room"],
        ),
        (
            "An animation studio with a motion-capture stage and a screening room. "
            "The screening room shouldn't be next to the mocap stage.",
            ["motion_capture_stage", "screening_room"],
        ),
        (
            "A clinic with an intensive care unit and a lab. The ICU lies beside the lab.",
            ["intensive_care_unit", "lab"],
        ),
        ("A school with a computer lab and a chemistry lab", ["computer_lab", "chemistry_lab"]),
    ],
)
def test_names_in_short_are_the_same_room(text: str, rooms: list[str]) -> None:
    assert [room.name for room in read_brief(text, default_knowledge()).rooms] == rooms
