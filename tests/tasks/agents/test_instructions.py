"""Instructions are read as what, from where, to where."""

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_language import singular
from mansion_tasks.agents.instructions import NounPhrase, read_instruction
from mansion_tasks.language.matching import match_score

FLOORS, LABELS = (1, 2, 3, 4), ("G", "2", "3", "4")


@pytest.mark.parametrize(
    ("text", "target", "destination", "relation"),
    [
        (
            "Find a box on the bed and bring it to the bathroom.",
            NounPhrase("box", places=("bed",)),
            NounPhrase("bathroom"),
            "room",
        ),
        (
            "Find a cellphone on a blue couch on the first floor and bring it to the round table on the second floor.",
            NounPhrase("cellphone", places=("couch",), floor=1),
            NounPhrase("round table", floor=2),
            "room",
        ),
        (
            "Go to the third floor, find a laptop on the desk in the meeting room on the third floor, and take it to "
            "the restroom on the fourth floor.",
            NounPhrase("laptop", places=("desk", "meeting room"), floor=3),
            NounPhrase("restroom", floor=4),
            "room",
        ),
        (
            "I want to clean my sofa. Go get a cloth from the first floor and come back near the sofa.",
            NounPhrase("cloth", floor=1),
            NounPhrase("sofa"),
            "near",
        ),
        (
            "Get the orange toolbox from the third floor and bring it to the fourth floor.",
            NounPhrase("toolbox", color="orange", floor=3),
            NounPhrase("", floor=4),
            "room",
        ),
        (
            "Take the mug from the kitchen to the bedroom on floor 3.",
            NounPhrase("mug", places=("kitchen",)),
            NounPhrase("bedroom", floor=3),
            "room",
        ),
        ("Put the apples in the fridge.", NounPhrase("apple"), NounPhrase("fridge"), "in"),
        (
            "Open the cabinet in the office on the second floor and put a book from the library in it.",
            NounPhrase("book", places=("library",)),
            NounPhrase("cabinet", places=("office",), floor=2),
            "in",
        ),
        ("Find a laptop somewhere on the top floor.", NounPhrase("laptop", floor=4), None, "room"),
        ("Find the key on floor G.", NounPhrase("key", floor=1), None, "room"),
    ],
)
def test_the_papers_tasks_and_their_like_are_understood(
    text: str, target: NounPhrase, destination: NounPhrase | None, relation: str
) -> None:
    errand = read_instruction(text, FLOORS, LABELS)
    found = (plain(errand.target), plain(errand.destination), errand.relation)
    assert found == (target, destination, relation)


def plain(phrase: NounPhrase | None) -> NounPhrase | None:
    return None if phrase is None else replace(phrase, place_colors=())


def test_colours_of_places_asides_and_what_is_to_be_closed_are_kept_apart() -> None:
    errand = read_instruction(
        "Take a white mouse on a gray office desk on the first floor (button G) and put it into the storage cabinet "
        "in private office 9 on the second floor; make sure that it is closed afterwards.",
        FLOORS,
        LABELS,
    )
    assert errand.target == NounPhrase("mouse", "white", ("office desk",), ("grey",), 1)
    assert errand.destination == NounPhrase("storage cabinet", "", ("private office 9",), ("",), 2)
    assert (errand.relation, errand.close) == ("in", True)


@given(st.text(max_size=200))
@settings(max_examples=60, deadline=None)
def test_any_text_is_read_as_something(text: str) -> None:
    errand = read_instruction(text, FLOORS, LABELS)
    assert isinstance(errand.target.noun, str)


@pytest.mark.parametrize(
    ("noun", "name", "score"),
    [
        ("couch", "sofa", 3),
        ("restroom", "toilet", 3),
        ("cellphone", "cell_phone", 3),
        ("meeting room", "meeting_room_2", 3),
        ("table", "coffee_table", 2),
        ("round table", "table", 1),
        ("pen", "open_shelf", 0),
        ("couch", "leather_sofa", 2),
        ("leather couch", "sofa", 1),
        ("reception", "corridor", 0),
        ("mug", "desk", 0),
        ("", "desk", 0),
        ("private office 2", "private_office_2", 3),
        ("private office 2", "private_office_3", 0),
    ],
)
def test_nouns_match_categories_by_word(noun: str, name: str, score: int) -> None:
    assert match_score(noun, name) == score


def test_singulars_keep_words_that_only_look_like_plurals() -> None:
    assert [singular(w) for w in ("glass", "bus", "boxes", "knives")] == ["glass", "bus", "box", "knife"]


def test_a_word_for_a_colour_means_the_colour_that_materials_have() -> None:
    read = read_instruction("Bring the navy mug to the cream sofa.", FLOORS, LABELS)
    assert (read.target.color, read.destination.color) == ("blue", "beige")
