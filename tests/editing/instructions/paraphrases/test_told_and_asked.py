"""What people tell beside a request, and the request as they put it, are understood as one plain request."""

import pytest

from mansion_editing.instructions.paraphrases.patterns import in_plain_words, in_running_text, without_idioms
from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.statements import Ensure, Keep, Mention, Remove, SetState, Statement, Swap, Things
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_in_other_words(text, state)
    assert read.not_understood == [], read.not_understood
    asked = [s for s in read.statements if not isinstance(s, Mention)]
    return [type(s)(**{f: getattr(s, f) for f in s.__struct_fields__ if f != "quote"}) for s in asked]


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("Lights out in the hall!", "switch the lights off in the hall!"),
        ("Remove the rug in the hall, but only the hall.", "Remove the rug in the hall."),
        ("Dump the chairs in the hall, all 3.", "Dump all 3 chairs in the hall."),
        ("The fridge is open, isn't it? If so, close it.", "is The fridge open? If so, close it."),
        ("Change the carpet in the hall to oak parquet.", "change the floor in the hall to oak parquet."),
        ("Put out the cups... sorry, mugs on the table.", "Put out mugs on the table."),
    ],
)
def test_idioms_are_read_before_their_words(said: str, plain: str) -> None:
    assert without_idioms(said).lower() == plain.lower()


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("The sofa in the hall - move it to the kitchen.", "move The sofa in the hall to the kitchen."),
        ("Someone put the bin in a silly spot, move it to the hall.", "move the bin to the hall."),
        ("The bin in the hall keeps tripping me up, take it away.", "take The bin in the hall away."),
        ("I'd like a mug waiting for me on the desk.", "I would like a mug on the desk."),
        ("Make the hall a bit cosier: a rug and a plant.", "in the hall: a rug and a plant."),
        ("It's far too dark in the hall. Add two plants.", "in the hall, Add two plants."),
        ("Put a bowl on the desk to keep my keys in.", "Put a bowl on the desk."),
        ("New floor in the kitchen - tiles please", "change the floor in the kitchen to tiles"),
        ("The cook would prefer a red sofa to that loveseat.", "replace that loveseat by a red sofa."),
        ("At the hall: 6 chairs max, prams need the space", "At the hall: at most 6 chairs"),
        ("Two mugs and a bowl have to go on the desk.", "put Two mugs and a bowl on the desk."),
        ("Give the sofa in the hall a quarter turn.", "turn the sofa in the hall by 90 degrees."),
        ("Every fridge in the kitchen has to stand open.", "open Every fridge in the kitchen."),
        ("The lamps in the hall need to be off.", "turn The lamps in the hall off."),
        ("Lock the cup away in the cupboard.", "put the cup in the cupboard."),
        ("The two chairs should join the others in the hall.", "move The two chairs to the hall."),
        (
            "Of the two sofas in the hall, the taller one goes to the study.",
            "the tallest sofa in the hall should go to the study.",
        ),
        (
            "Put a plant on either side of the sofa.",
            "Put one plant to the left of the sofa and one plant to the right of the sofa.",
        ),
        (
            "The rug in the hall is far too small, I want a bigger one in its place.",
            "replace The rug in the hall with a bigger one.",
        ),
        ("Take the sofa to the hall, books and all.", "Take the sofa to the hall."),
    ],
)
def test_what_is_told_beside_a_request_is_taken_off(said: str, plain: str) -> None:
    assert in_plain_words(in_running_text(said)).lower() == plain.lower()


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Nobody uses the sofa in the hall. Take it away.", "Take the sofa in the hall away."),
        ("One of the chairs in the hall has a broken leg. Throw it out.", "Throw one of the chairs in the hall out."),
        ("Who needs three chairs? Remove one of them.", "Remove one of the three chairs."),
        ("The sofa and the bench should swap positions.", "Swap the sofa and the bench."),
    ],
)
def test_a_pronoun_stands_for_what_was_told_of(furnished_state: SceneState, said: str, meant: str) -> None:
    assert _asked(said, furnished_state) == _asked(meant, furnished_state)


def test_what_is_not_wanted_any_more_goes(furnished_state: SceneState) -> None:
    (gone,) = _asked("I don't want the chairs in the hall any more since one of them broke.", furnished_state)
    assert isinstance(gone, Remove)
    assert gone.things.noun == "chair"


def test_one_that_goes_is_the_one_too_many(furnished_state: SceneState) -> None:
    (gone,) = _asked("Two of the three chairs in the hall are enough. Take one away.", furnished_state)
    assert isinstance(gone, Remove)
    assert (gone.things.amount.kind, gone.things.amount.number, gone.things.amount.of) == ("all_but", 2, 3)


def test_what_is_enough_is_no_remark(furnished_state: SceneState) -> None:
    (most,) = _asked("The hall has three chairs?? One is plenty.", furnished_state)
    assert isinstance(most, Ensure)
    assert most.things.amount.number == 1


def test_each_of_several_that_has_one_needs_no_more(furnished_state: SceneState) -> None:
    (wanted,) = _asked("Every table in the kitchen needs a mug on it.", furnished_state)
    assert isinstance(wanted, Ensure)
    assert wanted.each


def test_an_order_after_a_colon_says_what_was_announced(furnished_state: SceneState) -> None:
    announced = _asked("The hall gets new chairs: replace the three chairs with armchairs.", furnished_state)
    assert len(announced) == 1
    told = _asked("The hall gets a chair: remove the sofa.", furnished_state)
    assert len(told) == 2


def test_what_is_taken_back_is_never_done(furnished_state: SceneState) -> None:
    read = read_in_other_words("Put a lamp in the hall... no wait, whatever you like.", furnished_state)
    assert read.not_understood


def test_two_of_a_kind_change_places_with_each_other(furnished_state: SceneState) -> None:
    (swap,) = _asked("Swap the two dining tables.", furnished_state)
    assert isinstance(swap, Swap) and isinstance(swap.one, Things)
    assert swap.one == swap.other


@pytest.mark.parametrize(
    ("text", "noun", "number"),
    [
        ("Add two floor lamps to the hall.", "floor lamp", 2),
        ("Put three door mats in the hall.", "door mat", 3),
        ("Put a small round table in the hall.", "round table", 1),
        ("Put a first aid kit in the kitchen.", "first aid kit", 1),
        ("Put a comfy armchair in the hall.", "armchair", 1),
    ],
)
def test_names_keep_the_words_that_they_begin_with(
    furnished_state: SceneState, text: str, noun: str, number: int
) -> None:
    (added,) = _asked(text, furnished_state)
    things = getattr(added, "things", None)
    assert isinstance(things, Things)
    assert things.noun.endswith(noun)
    assert things.amount.number == number


def test_lights_out_switches_off(furnished_state: SceneState) -> None:
    (off,) = _asked("Lights out in the kitchen.", furnished_state)
    assert isinstance(off, SetState)
    assert not off.value


def test_what_stays_is_left_alone(furnished_state: SceneState) -> None:
    asked = _asked("The sofa in the hall stays, please take the chairs in the hall away.", furnished_state)
    assert any(isinstance(one, Keep) for one in asked)
