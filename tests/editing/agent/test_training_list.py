"""A training list of the instruction parser: the same facts from many words, and no guesses.

The parser was mended until it read these sentences; they guard what it reads and measure nothing.
"""

import pytest

from mansion_assets.catalogue.vocabulary import vocabulary_of
from mansion_editing.agent.discourse import parse_instruction, plain_sentences
from mansion_editing.agent.facts import ObjectFact
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import MansionError


def _facts(state: SceneState, text: str) -> list[str]:
    return [str(fact) for fact in parse_instruction(state, text)]


@pytest.mark.parametrize(
    "text",
    [
        "There ought to be a laptop on the dining table in the kitchen.",
        "A laptop should be on the dining table in the kitchen",
        "Could you please put a laptop on top of the dining table in the kitchen?",
        "The dining table in the kitchen needs a laptop.",
        "In the kitchen, there must be a laptop on the dining table.",
        "We're missing a laptop on the kitchen's dining table!",
        "Check whether there is a laptop on the dining table in the kitchen, and if not, add one.",
        "I'd like the dining table of the kitchen to have a laptop on it.",
        "Set a laptop down on the dining table that is in the kitchen because the guests arrive soon.",
        "place a lap-top on the dining table in the kitchen".replace("-", ""),
        "equip the dining table in the kitchen with a labtop",
        "It is a lovely day. Make sure that a laptop can be found on the dining table in the kitchen.",
    ],
)
def test_one_wish_in_many_words(state: SceneState, text: str) -> None:
    (fact,) = parse_instruction(state, text)
    assert isinstance(fact, ObjectFact) and vocabulary_of(state.catalogue).nouns(fact.object.noun) == ["laptop"]
    assert (fact.object.count, fact.where.receptacle) == (1, "dining table")
    assert fact.where.rooms == ("F1/kitchen",)


@pytest.mark.parametrize(
    "text",
    [
        "There shouldn't be any mugs on the dining table.",
        "Get rid of every mug on the dining table",
        "The dining table must not have any mugs on it",
        "No mugs should be left on the dining table.",
        "Keep the dining table free of mugs",
        "Take all the mugs off the dining table",
        "All mugs on the dining table must go",
        "don't leave any mugs on the dining table",
    ],
)
def test_what_is_to_be_gone(state: SceneState, text: str) -> None:
    (fact,) = _facts(state, text)
    assert fact.startswith("gone: every mug") and fact.endswith("on the dining table")


@pytest.mark.parametrize(
    ("text", "facts"),
    [
        ("the dining table has to be empty", ["gone: everything on the dining table"]),
        (
            "neither pens nor books should be on the desk",
            ["gone: every pens on the desk", "gone: every books on the desk"],
        ),
        ("put exactly two apples on the desk", ["exactly 2 apples on the desk"]),
        ("no more than one mug on the desk", ["at most 1 mug on the desk"]),
        ("add another mug to the desk", ["another 1 mug on the desk"]),
        ("I want two mugs on the desk, and they must be red", ["2 red mugs on the desk"]),
        (
            "put a red book and a green one on the desk upstairs",
            ["1 red book on the desk on floor 2", "1 green book on the desk on floor 2"],
        ),
        (
            "set two pens next to the mug on the dining table",
            ["2 pens on the dining table next to the mug"],
        ),
        (
            "there should be a blue couch in the hall with a cellphone on it",
            ["1 blue couch in F1/hall", "1 cellphone on the blue couch in F1/hall"],
        ),
        (
            "three apples in a bowl on the dining table",
            ["1 bowl on the dining table", "3 apples in the bowl on the dining table"],
        ),
        ("clear the desk and put a vase on it", ["gone: everything on the desk", "1 vase on the desk"]),
        (
            "replace the mug on the dining table with an apple",
            ["gone: the mug on the dining table", "1 apple on the dining table"],
        ),
        ("the fridge should be left open", ["the fridge in the building open"]),
        ("switch the floor lamp upstairs on", ["the floor lamp on floor 2 on"]),
        ("turn off all lamps", ["every lamps in the building off"]),
        (
            "the kitchen must be reachable from the private office",
            ["a path from F2/private_office_1 to F1/kitchen"],
        ),
        (
            "keep the path between the hall and the kitchen clear",
            ["a path from F1/hall to F1/kitchen"],
        ),
        ("one can walk to the fridge from here", ["a path from the entrance to F1/kitchen"]),
        (
            "bring the mug on the dining table over to the office",
            ["1 mug on the dining table moved to in F2/private_office_1"],
        ),
    ],
)  # fmt: skip
def test_forms_of_wishes(state: SceneState, text: str, facts: list[str]) -> None:
    assert _facts(state, text) == facts


def test_each_room_and_each_receptacle_counts_for_itself(state: SceneState) -> None:
    assert len(_facts(state, "there should be a mug on the floor of each floor")) == 2
    assert _facts(state, "every desk needs a pen") == [
        "1 pen on the F2/private_office_1/office_desk_1 in F2/private_office_1"
    ]


@pytest.mark.parametrize(
    "text",
    [
        "the walls should be painted red",
        "two hundred mugs on the desk",
        "put a gizmotron on the desk",
        "put a mug on the desk in the ballroom",
        "demolish the stairs and leave",
        "mug",
        "nothing",
    ],
)
def test_what_is_not_understood_is_refused(state: SceneState, text: str) -> None:
    with pytest.raises(MansionError):
        parse_instruction(state, text)


def test_courtesies_and_contractions_fall_away() -> None:
    text = "Hi robot, could you please see that there's a mug on the desk? Thanks!"
    assert plain_sentences(text) == ["see that there is a mug on the desk"]


TABLE = "the dining table in the kitchen"


@pytest.mark.parametrize(
    "text",
    [
        f"For the next experiment we require a laptop on {TABLE}.",
        f"My episode starts with a laptop on {TABLE}, so please provide one if it is not there.",
        f"Would it be possible to have a laptop on {TABLE}?",
        f"What I want is a laptop on {TABLE}.",
        f"I was hoping to find a laptop on {TABLE}.",
        f"Can we get a laptop onto {TABLE}?",
        f"Somebody forgot to put a laptop on {TABLE}. Do it for them.",
        f"The robot has to pick a laptop up from {TABLE}. Make sure that there is one.",
        "The dining table in the kitchen could do with a laptop.",
    ],
)
def test_a_wish_in_a_researchers_words(state: SceneState, text: str) -> None:
    assert _facts(state, text) == ["1 laptop on the dining table in F1/kitchen"]


@pytest.mark.parametrize(
    "text",
    [
        f"Nothing but a book on {TABLE}, please.",
        f"I want nothing except a book on {TABLE}.",
        "The dining table in the kitchen should hold only a book.",
        f"The only thing on {TABLE} should be a book.",
        f"There must be a book and nothing else on {TABLE}.",
        "Apart from a book, the dining table in the kitchen must be empty.",
        f"Swap what is on {TABLE} for a book.",
    ],
)
def test_nothing_but_a_thing(state: SceneState, text: str) -> None:
    assert _facts(state, text) == [
        "gone: everything but book on the dining table in F1/kitchen",
        "exactly 1 book on the dining table in F1/kitchen",
    ]


@pytest.mark.parametrize(
    "text",
    [
        f"Remove everything from {TABLE} except the mug.",
        f"Clear {TABLE} but leave the mug where it is.",
        f"Take everything off {TABLE} apart from the mug.",
        f"Keep the mug on {TABLE}, but take all the rest away.",
    ],
)
def test_everything_but_a_thing_goes(state: SceneState, text: str) -> None:
    assert _facts(state, text) == [
        "gone: everything but mug on the dining table in F1/kitchen",
        "1 mug on the dining table in F1/kitchen",
    ]


@pytest.mark.parametrize(
    ("text", "facts"),
    [
        ("Close everything in the kitchen.", ["every  in F1/kitchen closed"]),
        ("Shut whatever stands open in the kitchen.", ["every  in F1/kitchen closed"]),
        ("Turn everything off in the kitchen.", ["every  in F1/kitchen off"]),
        ("The fridge should not be open.", ["the fridge in the building closed"]),
        ("Don't leave the fridge open.", ["the fridge in the building closed"]),
        ("Put a yogurt in the fridge; then close it.",
         ["1 yogurt in the fridge", "1 fridge in the building closed"]),
        (f"I need the fridge open and a book on {TABLE}.",
         ["the fridge in the building open", "1 book on the dining table in F1/kitchen"]),
        (f"Don't allow more than one mug on {TABLE}.",
         ["at most 1 mug on the dining table in F1/kitchen"]),
        (f"Increase the number of pens on {TABLE} to three.",
         ["3 pens on the dining table in F1/kitchen"]),
        ("Make sure the fridge is shut and contains two yogurts.",
         ["the fridge in the building closed", "2 yogurts in the fridge"]),
        ("Open the fridge door.", ["the fridge in the building open"]),
        ("Is the kitchen accessible from the main entrance? Make sure it is.",
         ["a path from the entrance to F1/kitchen"]),
        (f"{TABLE} is too messy, tidy it up by removing everything but the mug.".replace("the", "The", 1),
         ["gone: everything but mug on the dining table in F1/kitchen",
          "1 mug on the dining table in F1/kitchen"]),
        (f"Free {TABLE} from clutter; only the mug may remain.",
         ["gone: everything but mug on the dining table in F1/kitchen",
          "1 mug on the dining table in F1/kitchen"]),
        (f"Ensure that whoever walks up to {TABLE} sees a stapler on it.",
         ["1 stapler on the dining table in F1/kitchen"]),
        (f"{TABLE} is too bare. Put a book on it.".replace("the", "The", 1),
         ["1 book on the dining table in F1/kitchen"]),
    ],
)  # fmt: skip
def test_states_and_numbers(state: SceneState, text: str, facts: list[str]) -> None:
    assert _facts(state, text) == facts


@pytest.mark.parametrize(
    "text",
    [
        "Swap the mug on the dining table and the pen on the office desk.",
        "The mug on the dining table and the pen on the office desk should trade places.",
    ],
)
def test_two_things_change_places(state: SceneState, text: str) -> None:
    one, other = _facts(state, text)
    assert one.endswith("moved to on the office desk") and "mug" in one
    assert other.endswith("moved to on the dining table") and "pen" in other


@pytest.mark.parametrize(
    "text",
    [
        "Grab the mug on the dining table and put it on the office desk.",
        "There is a mug on the dining table. Take it to the office desk.",
        "The mug on the dining table belongs on the office desk.",
    ],
)
def test_taken_and_put_is_one_move(state: SceneState, text: str) -> None:
    (fact,) = _facts(state, text)
    assert "mug on the dining table moved to on the office desk" in fact


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("Put a mug to the left of the sofa.", "to the left of"),
        ("If the mug is red, put a pen on the dining table.", "If"),
        ("Put either a mug or a book on the dining table.", "either a mug or"),
        ("Stack three books on the dining table.", "Stack"),
        ("Break the mug on the dining table.", "Break"),
        ("Make a copy of the kitchen.", "copy"),
        ("Put a mug on the table closest to the kitchen.", "closest"),
        ("Remove half of the mugs.", "half of"),
        ("Rotate the sofa by ninety degrees.", "Rotate"),
        ("Put a flurbostat on the dining table.", "flurbostat"),
        ("Put a slightly dented mug on the dining table.", "slightly dented"),
        ("Put a mug on the wobbly dining table.", "wobbly"),
        ("Put a mug on {}.", "{}"),
    ],
)
def test_what_no_tool_does_is_refused_by_its_words(state: SceneState, text: str, named: str) -> None:
    with pytest.raises(MansionError) as error:
        parse_instruction(state, text)
    assert f"not understood: {named!r}" in str(error.value)
    assert "what can be asked for" in str(error.value)
