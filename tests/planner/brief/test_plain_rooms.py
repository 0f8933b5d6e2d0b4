"""Rooms without a name of their own are what the building is for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A hotel with 40 rooms.", "hotel_room"),
        ("A hospital with 12 rooms.", "patient_room"),
        ("A shared flat with 6 rooms.", "bedroom"),
        ("A hostel with 2 double rooms.", "hotel_room"),
        ("A flat with one chamber and a kitchen.", "bedroom"),
        ("An office with one chamber and a kitchen.", "meeting_room"),
    ],
)
def test_rooms_are_of_the_kind_that_the_building_has(brief: str, kind: str) -> None:
    assert read_brief(brief, default_knowledge()).rooms[0].room_type == kind


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A rowing club with a club room.", "common_room"),
        ("A house with three western rooms.", "bedroom"),
        ("A villa with a men majlis.", "lounge"),
        ("A school with a chemistry cabinet.", "science_lab"),
        ("A school with a computer class.", "computer_lab"),
        ("A hospital with urgencies.", "emergency_room"),
        ("A market with the room of the manager.", "private_office"),
        ("A market with a deposit of 40 m2.", "storage"),
        ("A care home with a program room.", "activity_hall"),
        ("A nursing home with a bathing room.", "shower_area"),
        ("A community hall with a kitchen and a crèche.", "nursery_room"),
    ],
)
def test_rooms_have_names_in_other_tongues_too(brief: str, kind: str) -> None:
    assert kind in {room.room_type for room in read_brief(brief, default_knowledge()).rooms}


def test_the_day_centre_of_old_people_is_a_building() -> None:
    facts = read_brief("An old-people's day centre with a living room and a kitchen.", default_knowledge())
    assert facts.building[0][0] == "community_center"


@pytest.mark.parametrize("verb", ["can all go down in", "could be kept in", "may all lie in", "go down in"])
def test_rooms_that_may_go_to_a_storey_are_put_there(verb: str) -> None:
    brief = f"A practice with a basement. The staff changing room, a plant room and the archive {verb} the basement."
    facts = read_brief(brief, default_knowledge())
    places = {room.name: [ref.kind for ref in room.floors] for room in facts.rooms}
    assert places["staff_changing_room"] == places["archive"] == ["basement"]
