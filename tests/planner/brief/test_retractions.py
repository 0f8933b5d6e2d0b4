"""What a brief names and takes back is not wanted; what it names instead is."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("words", "rooms"),
    [
        ("a library, no, a bookshop", [("bookshop", 1)]),
        ("a gym, sorry, a sauna", [("sauna", 1)]),
        ("a lab, I mean a library", [("library", 1)]),
        ("a study - or rather a music room - and a kitchen", [("music_room", 1), ("kitchen", 1)]),
        ("a canteen (scratch that, a cafe) and a kitchen", [("cafe", 1), ("kitchen", 1)]),
        ("four offices, pardon, meeting rooms", [("meeting_room", 4)]),
        ("a bar, no wait, two saunas", [("sauna", 2)]),
        ("a bar, sorry, a gym, no, a sauna", [("sauna", 1)]),
        ("a library, no gym, and a sauna", [("library", 1), ("sauna", 1)]),
        ("a library, well equipped, and a sauna", [("library", 1), ("sauna", 1)]),
    ],
)
def test_the_room_that_is_named_last_holds(words: str, rooms: list[tuple[str, int]]) -> None:
    facts = read(f"A house with {words}.")
    assert [(room.name, room.count) for room in facts.rooms] == rooms
    assert facts.unread == []


def test_a_building_is_taken_back() -> None:
    facts = read("A school, no wait, a museum with three galleries.")
    assert facts.building[0][0] == "museum"


def test_furniture_is_taken_back_and_the_place_after_it_holds() -> None:
    facts = read("A flat with a bedroom and a sofa, make that an armchair, in the living room.")
    assert [(thing.category, thing.room) for thing in facts.objects] == [("armchair", "living_room")]
