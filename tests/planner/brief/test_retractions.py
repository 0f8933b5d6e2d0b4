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


@pytest.mark.parametrize(
    "words",
    [
        "a sauna. Scrap that, a gym instead",
        "a sauna (forget that), a gym",
        "a sauna, on second thought, a gym",
        "a sauna... hmm, no, a gym",
    ],
)
def test_what_is_named_instead_in_spoken_words_holds(words: str) -> None:
    facts = read(f"A house with {words}. Three bedrooms.")
    assert [room.name for room in facts.rooms] == ["gym", "bedroom"]
    assert facts.unread == []


def test_what_is_taken_back_with_nothing_instead_is_left_out() -> None:
    assert [room.name for room in read("A house with a sauna (scrap that) and a study.").rooms] == ["study"]


@pytest.mark.parametrize(
    "words",
    [
        "a cafe (scrap the cafe)",
        "a cafe; forget the cafe",
        "a cafe - never mind the cafe -",
        "a cafe. Actually, no cafe",
    ],
)
def test_a_room_that_is_withdrawn_by_name_is_not_wanted(words: str) -> None:
    facts = read(f"An office with {words}. Two meeting rooms.")
    assert [room.name for room in facts.rooms] == ["meeting_room"]
    assert [name for name, _ in facts.excluded] == ["cafe"]
    assert facts.unread == []


def test_a_thing_that_is_withdrawn_by_name_asks_for_nothing() -> None:
    facts = read("An office with a study with a piano... (never mind the piano) next to the kitchen.")
    assert facts.objects == []
    assert [(fact.first_name, fact.second_name) for fact in facts.adjacent] == [("study", "kitchen")]


def test_what_must_not_be_forgotten_is_wanted() -> None:
    facts = read("A house. Do not forget the pantry.")
    assert ([room.name for room in facts.rooms], facts.excluded, facts.unread) == (["pantry"], [], [])


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("A U-shaped school - no, L-shaped - with six classrooms.", "L"),
        ("A clinic, H-shaped if possible... hmm, no, keep it a plain rectangle.", "rectangle"),
    ],
)
def test_the_outline_that_is_told_last_holds(text: str, shape: str) -> None:
    facts = read(text)
    assert ([name for name, _ in facts.shapes], facts.unread) == ([shape], [])


def test_the_style_that_is_told_last_holds() -> None:
    assert [name for name, _ in read("A modern house - no, rustic - with two bedrooms.").styles] == ["rustic"]


@pytest.mark.parametrize(
    "words",
    [
        "a study next to the bedroom - on second thought next to the kitchen",
        "a study next to the bedroom, sorry, next to the kitchen",
    ],
)
def test_the_neighbour_that_is_told_last_holds(words: str) -> None:
    facts = read(f"A house with {words}.")
    assert [(fact.first_name, fact.second_name) for fact in facts.adjacent] == [("study", "kitchen")]
    assert [room.name for room in facts.rooms] == ["study", "bedroom", "kitchen"]


@pytest.mark.parametrize(
    "later",
    ["Remove the showroom again.", "Delete the showroom.", "We take out the showroom.", "No showroom after all."],
)
def test_what_is_removed_again_is_not_wanted(later: str) -> None:
    facts = read_brief(f"Office with a reception and a showroom. {later}", default_knowledge())
    assert [fact.name for fact in facts.rooms] == ["reception"]
    assert [name for name, _ in facts.excluded] == ["showroom"]


def test_what_is_replaced_goes() -> None:
    facts = read_brief("Clinic with a pharmacy. Replace the pharmacy with a laboratory.", default_knowledge())
    assert [fact.name for fact in facts.rooms] == ["laboratory"]
