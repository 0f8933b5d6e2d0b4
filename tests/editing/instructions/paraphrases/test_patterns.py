"""Set wordings are put in the plain words of what they ask for, and nothing else is."""

import pytest

from mansion_editing.instructions.paraphrases.patterns import in_plain_words, in_running_text, without_idioms


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("I was wondering if you could open the fridge?", "please open the fridge?"),
        ("Could somebody please open the fridge?", "please open the fridge?"),
        ("We'd be glad of another lamp in the hall.", "we want another lamp in the hall."),
        ("The hall could do with a lamp.", "The hall needs a lamp."),
        ("A plant by the door wouldn't go amiss.", "I want A plant by the door."),
        ("What we lack there is a trolley.", "I want a trolley there."),
        ("No need to keep the rug in the hall.", "remove the rug in the hall."),
        ("The rug has got to go.", "The rug must go."),
        ("Down to the cellar with the ladder!", "move the ladder to the cellar!"),
        ("That ladder upstairs: down to the cellar with it!", "move That ladder upstairs to the cellar!"),
        ("The clock doesn't belong in the hall but in the study.", "move The clock in the hall to the study."),
        ("Anna wants the plant swapped for a bookcase.", "replace the plant by a bookcase."),
        ("Get the lamp out of the hall and into the study.", "move the lamp from the hall to the study."),
        ("Lay the table in the hall with two plates.", "put two plates on the table in the hall."),
        ("A trolley must still fit through from the hall to the study.", "I can get from the hall to the study."),
        ("We must be able to push a cart from the hall to the study.", "I can get from the hall to the study."),
        ("Keep the way from the hall to the study open.", "I can get from the hall to the study."),
        ("Guests in the study must get down to the hall.", "I can get from the study to the hall."),
        ("People must still get in from the hall.", "I can get from the hall to there."),
        ("Make sure the door can still be used.", "do not block the door."),
        ("Have the rack stand next to the bench.", "the rack should stand next to the bench."),
        (
            "Get the globe - sorry, the chart - out of the hall and into the study.",
            "move the chart from the hall to the study.",
        ),
        (
            "Of the eight chairs in the hall, move two to the study.",
            "move two of the eight chairs in the hall to the study.",
        ),
        ("One will do nicely.", "One is enough."),
        ("Fewer stools in the bar, please - one will do.", "there should be exactly one stools in the bar."),
        ("Add a lamp in the hall if there's room.", "Add a lamp in the hall."),
        ("Put a mug on the desk, would you?", "Put a mug on the desk?"),
        ("Let the lamp stay where it is.", "leave the lamp where it is."),
    ],
)
def test_wordings_are_put_plainly(said: str, plain: str) -> None:
    assert in_plain_words(in_running_text(said)).lower() == plain.lower()


@pytest.mark.parametrize(
    "said",
    [
        "Do not remove the rug in the hall.",
        "Let us not move the sofa.",
        "I want the rug to stay in the hall.",
        "Put two mugs on the desk in the study.",
        "How many chairs are in the hall?",
        "If the lamp is on, switch it off.",
    ],
)
def test_plain_words_are_left_as_they_are(said: str) -> None:
    assert in_plain_words(said) == said


@pytest.mark.parametrize(
    "said",
    [
        "Nobody should be able to get from the hall to the study.",
        "Is it possible to bring the laptop from the hall to the study?",
        "The plant in the hall should go to the study.",
    ],
)
def test_what_is_no_free_way_is_not_read_as_one(said: str) -> None:
    assert "I can get" not in in_plain_words(said)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("The gym is short of mats, put in five more.", "add five more mats to the gym."),
        ("The kitchen could use more mugs. Three more please.", "add Three more mugs to the kitchen."),
        ("Gym: both screens on, one treadmill less.", "Gym: both screens on, remove one treadmill."),
        ("The board in the hall is not needed, replace it by a lamp.", "replace the board in the hall by a lamp."),
        ("Lunch break! Open the fridge.", "Open the fridge."),
        ("The cans should be gone and replaced by bottles.", "The cans should be replaced by bottles."),
        ("Movie night in the den! Lamp off.", "Movie night in the den: Lamp off."),
    ],
)
def test_set_phrases_that_would_be_misread_are_put_plainly(said: str, plain: str) -> None:
    assert without_idioms(said) == plain
