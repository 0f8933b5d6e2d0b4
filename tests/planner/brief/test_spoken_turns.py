"""Questions that the writer answers, and words between a noun and its area, are read as they are meant."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def test_a_question_that_is_denied_asks_for_what_is_named_instead() -> None:
    facts = read("A house. Ground floor: hall, kitchen-diner? No - kitchen and dining room as two rooms side by side.")
    assert [(room.name, room.floors[0].first) for room in facts.rooms] == [
        ("hall", 1), ("kitchen", 1), ("dining_room", 1),
    ]  # fmt: skip
    assert [(fact.first, fact.second) for fact in facts.adjacent] == [("kitchen", "dining_room")]
    assert (facts.excluded, facts.unread) == ([], [])


@pytest.mark.parametrize("answer", ["No", "Rather not", "Not needed", "No, thank you", "Nope"])
def test_a_question_that_is_only_denied_excludes(answer: str) -> None:
    facts = read(f"A bungalow with three bedrooms. A games room? {answer}. A garage? Yes.")
    assert [name for name, _ in facts.excluded] == ["game_room"]
    assert [room.name for room in facts.rooms] == ["bedroom", "garage"]


def test_a_cellar_and_a_lift_are_denied_so_too() -> None:
    facts = read("A two-storey house. Cellar? No. A lift? No, stairs only.")
    assert [name for name, _ in facts.excluded] == ["basement"]
    assert {name for name, _ in facts.vertical} >= {"no_elevator", "stair"}


@pytest.mark.parametrize(
    ("words", "name", "area"),
    [
        ("a living room of, let's say, 45 m2", "living_room", 45.0),
        ("a kitchen separate, 9 m2", "kitchen", 9.0),
        ("one bedroom too, 12 m2", "bedroom", 12.0),
        ("a reading corner as a separate room of 18 m2", "reading_corner", 18.0),
    ],
)
def test_words_before_an_area_do_not_part_it_from_its_room(words: str, name: str, area: float) -> None:
    facts = read(f"A house of 120 m2. It has {words} and a study.")
    assert [(room.name, room.area) for room in facts.rooms] == [(name, area), ("study", None)]
    assert facts.unread == []


def test_an_ellipsis_goes_on_with_the_sentence() -> None:
    facts = read("A house with a study with a desk... next to the kitchen.")
    assert [(fact.first_name, fact.second_name) for fact in facts.adjacent] == [("study", "kitchen")]


def test_some_of_a_number_of_rooms_are_up_and_some_down() -> None:
    facts = read_brief("A school of two storeys with nine classrooms (four down, five up).", default_knowledge())
    assert [(room.count, room.floors[0].kind) for room in facts.rooms] == [(4, "number"), (5, "upper")]
