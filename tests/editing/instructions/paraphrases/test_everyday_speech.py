"""What everyday speech says around an order is put as that order, and what may mean two things is not."""

import pytest

from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.statements import Add, Keep, Mention, Move, Remove, SetState, Statement, When
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_in_other_words(text, state)
    assert read.not_understood == []
    asked = [s for s in read.statements if not isinstance(s, Mention)]
    return [type(s)(**{f: getattr(s, f) for f in s.__struct_fields__ if f != "quote"}) for s in asked]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "Everything off the dining table in the kitchen except for the plate.",
            "Remove everything from the dining table in the kitchen except for the plate.",
        ),
        ("Two chairs are not enough in the hall, add three.", "Add three more chairs in the hall."),
        (
            "One chair is enough for the hall. Carry the surplus ones to the kitchen.",
            "One of the chairs in the hall is enough; move the others to the kitchen.",
        ),
        (
            "There's nothing wrong with the chairs in the hall, but three are too many. Two will do; put the others in "
            "the kitchen.",
            "Two of the chairs in the hall are enough; put the others in the kitchen.",
        ),
        (
            "There must not be a single table in the kitchen without a candle.",
            "Each table in the kitchen should have a candle.",
        ),
        ("The hall gets a plant and loses the sofa.", "The hall gets a plant and remove the sofa from the hall."),
        (
            "The courier starts at the hall. He has to reach the kitchen; should something block his way, move it.",
            "I can get from the hall to the kitchen.",
        ),
        ("The dog is gone, so is the need for the sofa. Out with it!", "Remove the sofa."),
        ("The sofa in the hall is wanted in the kitchen.", "Move the sofa in the hall to in the kitchen."),
        ("The sofa can go, hall.", "In the hall, the sofa can go."),
        ("Mind that the fridge is shut afterwards.", "Make sure that the fridge is shut."),
        ("Make it five chairs instead of three in the hall.", "There should be exactly five chairs in the hall."),
        (
            "Every room on the first floor except the hall should have a plant.",
            "Every room on the first floor should have a plant except the hall.",
        ),
        (
            "Clear the dining table in the kitchen completely, only the plate stays where it is.",
            "Clear the dining table in the kitchen except the plate.",
        ),
    ],
)
def test_everyday_wording_is_read_like_the_plain_one(said: str, meant: str, furnished_state: SceneState) -> None:
    assert _asked(said, furnished_state) == _asked(meant, furnished_state)


def test_condition_after_and_is_one_of_what_follows(furnished_state: SceneState) -> None:
    plain, depending = _asked(
        "Remove the plate, and if the lights in the kitchen are off, turn them on.", furnished_state
    )
    assert isinstance(plain, Remove)
    assert isinstance(depending, When)
    assert isinstance(depending.then, SetState)


def test_clearing_a_thing_away_removes_the_thing(furnished_state: SceneState) -> None:
    (gone,) = _asked("Clear the sofa in the hall away.", furnished_state)
    assert isinstance(gone, Remove)
    assert gone.things.noun == "sofa"


def test_one_more_rolled_out_is_a_new_one(furnished_state: SceneState) -> None:
    (new,) = _asked("Roll out one more rug next to the sofa in the hall.", furnished_state)
    assert isinstance(new, Add)
    assert new.things.amount.number == 1


def test_things_left_where_they_are_stay(furnished_state: SceneState) -> None:
    gone, kept = _asked(
        "Take the sofa out of the hall but leave the mugs on the table where they are.", furnished_state
    )
    assert isinstance(gone, Remove)
    assert isinstance(kept, Keep)


def test_mass_in_furniture_is_all_of_it(furnished_state: SceneState) -> None:
    (gone,) = _asked("Take the beer out of the fridge in the kitchen.", furnished_state)
    assert isinstance(gone, Remove)
    assert gone.things.amount.kind == "all"


def test_what_goes_out_of_a_leading_room_is_of_that_room(furnished_state: SceneState) -> None:
    (moved,) = _asked("In the hall, the two chairs go to the kitchen.", furnished_state)
    assert isinstance(moved, Move)
    assert moved.place.rooms is not None
    assert (moved.place.rooms.words, moved.place.rooms.next_to) == ("kitchen", "")
    assert moved.things.place is not None
    assert moved.things.place.rooms is not None
    assert moved.things.place.rooms.words == "hall"


@pytest.mark.parametrize(
    "said",
    [
        "Leave two of the three chairs in the hall.",
        "Make sure that a plant is in the hall and that the fan hums along.",
        "Move the sofa to the kitchen, and a table comes in.",
        "The chairs lying about in the hall are needed somehow.",
        "The guest complained that the fridge is empty. Give him two colas.",
    ],
)
def test_what_may_mean_two_things_is_not_understood(said: str, furnished_state: SceneState) -> None:
    assert read_in_other_words(said, furnished_state).not_understood


@pytest.mark.parametrize(
    "said",
    [
        "We have decided against the sofa in the hall. It goes; what is on the table there moves over to wherever.",
        "Remove the plate. The chairs in the hall are the ones to be dealt with somehow.",
    ],
)
def test_clause_that_asks_is_not_passed_over(said: str, furnished_state: SceneState) -> None:
    assert read_in_other_words(said, furnished_state).not_understood
