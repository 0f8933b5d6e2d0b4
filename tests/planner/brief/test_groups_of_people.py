"""Groups of people who have a room each."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def test_each_resident_of_a_group_has_a_room() -> None:
    brief = "Care home. Three groups of eight residents, each with its own kitchen and lounge."
    (group,) = read_brief(brief, default_knowledge()).rooms
    held = {room.room_type: room.count for room in group.suite}
    assert (group.count, held) == (3, {"resident_room": 8, "kitchen": 1, "living_room": 1})


def test_rooms_that_a_list_names_are_not_added_to() -> None:
    brief = "Care home. Three groups of eight residents, each with eight bedrooms and a kitchen."
    (group,) = read_brief(brief, default_knowledge()).rooms
    assert sorted(room.room_type for room in group.suite) == ["bedroom", "kitchen"]
