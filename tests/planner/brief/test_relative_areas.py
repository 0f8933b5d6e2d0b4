"""Areas that a brief tells as a share or a multiple of the one said last."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("brief", "room", "area"),
    [
        ("A workshop of 80 m2 and a showroom half that size.", "showroom", 40.0),
        ("We need a gym of 90 m2, a cafe a third of that, and a kitchen.", "cafe", 30.0),
        ("A library of 60 m2; the reading room should be twice as large.", "reading_room", 120.0),
        ("Shop of 100 m2, its storage is half as large as that.", "storage", 50.0),
        ("Clinic with a waiting room of 20 m2 and a lab double that area.", "lab", 40.0),
    ],
)
def test_a_share_of_the_area_said_last_is_an_area(brief: str, room: str, area: float) -> None:
    rooms = {fact.name: fact.area for fact in read_brief(brief, default_knowledge()).rooms}
    assert rooms[room] == area


@pytest.mark.parametrize(
    "brief",
    [
        "A workshop with three benches and a showroom half that size.",
        "A workshop of 80 m2 and half that number of desks in a showroom.",
        "A workshop of 80 m2, a third meeting room and a showroom.",
        "An office of 80 m2 twice as bright as the showroom.",
    ],
)
def test_a_share_of_no_area_or_of_something_else_is_none(brief: str) -> None:
    areas = {fact.name: fact.area for fact in read_brief(brief, default_knowledge()).rooms}
    assert areas["showroom"] is None


def test_a_multiple_of_a_room_is_that_of_its_area() -> None:
    text = "A gallery with 5 exhibition rooms of 90 m2 and a sculpture room twice as large as an exhibition room."
    rooms = read_brief(text, default_knowledge()).rooms
    assert [(room.count, room.area) for room in rooms] == [(5, 90.0), (1, 180.0)]
