"""A corner of a room is what stands there; a corner that is told alone, or with a size, is a room."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "category", "room"),
    [
        ("A house with a living room with a TV corner.", "television", "living_room"),
        ("A house. The bedroom has a sleeping alcove.", "bed", "bedroom"),
        ("A house with a kitchen with breakfast nook.", "dining_table", "kitchen"),
        ("A house with a piano corner in the living room.", "piano", "living_room"),
        ("A studio flat with a sleeping alcove.", "bed", "studio_flat"),
    ],
)
def test_a_corner_of_a_room_is_what_stands_there(text: str, category: str, room: str) -> None:
    facts = read(text)
    assert [(thing.category, thing.room) for thing in facts.objects] == [(category, room)]
    assert [fact.name for fact in facts.rooms if fact.name != room] == []


@pytest.mark.parametrize(
    "text",
    [
        "A library with a reading corner and a coffee corner.",
        "A bookshop with a sales room; a reading corner as a room of its own.",
        "A bookshop with a sales room with a reading corner of 18 m2.",
    ],
)
def test_a_corner_that_stands_alone_is_a_room(text: str) -> None:
    assert "reading_corner" in [room.name for room in read(text).rooms]


def test_each_of_several_rooms_has_its_corner() -> None:
    facts = read("A kindergarten with two group rooms, each with a play corner.")
    assert [(thing.category, thing.room, thing.each) for thing in facts.objects] == [("toy_shelf", "group_room", True)]
