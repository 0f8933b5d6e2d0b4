"""Rooms without a name of their own are what the building is for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A hotel with 40 rooms.", "hotel_room"),
        ("A hospital with 12 rooms.", "patient_room"),
        ("A flat with one chamber and a kitchen.", "bedroom"),
        ("An office with one chamber and a kitchen.", "meeting_room"),
    ],
)
def test_rooms_are_of_the_kind_that_the_building_has(brief: str, kind: str) -> None:
    assert read_brief(brief, default_knowledge()).rooms[0].room_type == kind
