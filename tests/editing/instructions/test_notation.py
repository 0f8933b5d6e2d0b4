"""Instructions in the way of notes: headings that name rooms, arrows, abbreviations, nouns without articles."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Add,
    Clear,
    Ensure,
    Furnish,
    Keep,
    Mention,
    Paint,
    Remove,
    Replace,
    Reshape,
    SetState,
    Statement,
    Swap,
    Turn,
)
from mansion_editing.state import SceneState


def _statements(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [s for s in instruction.statements if not isinstance(s, Mention)]


@pytest.mark.parametrize("only", ["keep just plate", "keep only the plate", "keep just plate on it"])
def test_what_is_kept_of_a_cleared_table_stays(furnished_state: SceneState, only: str) -> None:
    (cleared,) = _statements(f"Clear the dining table in the kitchen, {only}.", furnished_state)
    assert isinstance(cleared, Clear) and [things.noun for things in cleared.spare] == ["plate"]


def test_to_keep_only_one_thing_on_furniture_clears_it(furnished_state: SceneState) -> None:
    (cleared,) = _statements("Keep only the plate on the dining table in the kitchen.", furnished_state)
    assert isinstance(cleared, Clear) and cleared.place.anchor is not None
    assert cleared.place.anchor.noun == "dining table"


@pytest.mark.parametrize("text", ["plate + mug stay on it", "plate stays on it", "plate must remain there"])
def test_what_stays_is_never_added(furnished_state: SceneState, text: str) -> None:
    told = _statements(f"Kitchen: turn dining table by 180 deg. {text}.", furnished_state)
    assert isinstance(told[0], Turn) and all(isinstance(s, Keep) for s in told[1:])
    assert len(told) == 1 + 1 + text.count("+")


def test_a_heading_is_where_things_turn_and_take_colours(furnished_state: SceneState) -> None:
    told = _statements("Kitchen: turn dining table by 90 degrees, paint the dining table red.", furnished_state)
    assert isinstance(told[0], Turn) and isinstance(told[1], Paint)
    places = [s.things.place for s in told if isinstance(s, Turn | Paint)]
    assert [place.rooms.words for place in places if place is not None and place.rooms is not None] == ["kitchen"] * 2


def test_a_heading_of_several_words_is_a_room(furnished_state: SceneState) -> None:
    (opened,) = _statements("Private office 1: mug out", furnished_state)
    assert isinstance(opened, Remove) and opened.things.place is not None and opened.things.place.rooms is not None
    assert opened.things.place.rooms.words == "private office 1"


def test_what_stands_on_furniture_turns_with_it_and_stays_there(editor: SceneEditor) -> None:
    report = instruct(editor, "Kitchen: turn dining table by 180 deg. plate stays on it.")
    assert report.done
    _, plate = editor.state.get("F1/kitchen/plate_1")
    assert plate.parent == "F1/kitchen/dining_table_1"


@pytest.mark.parametrize("text", ["hall: chairs 3 -> 2", "hall: 3 chairs → 2", "hall: chairs 3 => 2"])
def test_an_arrow_between_numbers_tells_how_many_are_meant(furnished_state: SceneState, text: str) -> None:
    (there,) = _statements(text, furnished_state)
    assert isinstance(there, Ensure)
    assert (there.things.noun, there.things.amount.kind, there.things.amount.number) == ("chair", "exactly", 2)


@pytest.mark.parametrize("text", ["Sofa from the hall -> kitchen", "Move the sofa from the hall → the kitchen."])
def test_an_arrow_after_where_a_thing_is_tells_where_it_goes(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, text).done
    assert [item.room for _, item in editor.state.objects() if item.category == "sofa"] == ["F1/kitchen"]


def test_an_arrow_before_a_state_or_a_colour_is_what_shall_be(furnished_state: SceneState) -> None:
    off, red = _statements("kitchen: ceiling lights -> off, fridge -> red", furnished_state)
    assert isinstance(off, SetState) and not off.value and isinstance(red, Paint) and red.colour == "red"


def test_another_arrow_is_not_understood(furnished_state: SceneState) -> None:
    assert read_instruction("dining table -> wardrobe", furnished_state).not_understood


@pytest.mark.parametrize("verb", ["swap: ", "", "swap "])
def test_a_double_arrow_exchanges(furnished_state: SceneState, verb: str) -> None:
    text = f"{verb}plate (kitchen dining table) <-> mug (private office 1)"
    (swapped,) = _statements(text, furnished_state)
    assert isinstance(swapped, Swap)


def test_a_colon_after_a_verb_begins_what_it_asks_for(furnished_state: SceneState) -> None:
    told = _statements("In the kitchen please delete: the plate, the fridge.", furnished_state)
    assert [s.things.noun for s in told if isinstance(s, Remove)] == ["plate", "fridge"]


def test_a_door_stands_between_rooms_with_a_stroke(furnished_state: SceneState) -> None:
    (door,) = _statements("add door hall / kitchen", furnished_state)
    assert isinstance(door, Reshape) and door.rooms is not None and door.other is not None
    assert (door.what, door.rooms.words, door.other.words) == ("door", "hall", "kitchen")


def test_a_heading_is_the_room_that_becomes_another(furnished_state: SceneState) -> None:
    (furnished,) = _statements("Kitchen: convert to storage room.", furnished_state)
    assert isinstance(furnished, Furnish) and (furnished.rooms.words, furnished.kind) == ("kitchen", "storage room")


def test_what_takes_a_place_is_no_part_of_the_list_before_it(furnished_state: SceneState) -> None:
    (found,) = _statements("Kitchen: remove fridge, 2 house plants in its place", furnished_state)
    assert isinstance(found, Replace)
    assert (found.things.noun, found.by.noun, found.by.amount.number) == ("fridge", "house plant", 2)


@pytest.mark.parametrize("near", ["beside of", "next of", "in front from", "behind of", "near from"])
def test_prepositions_of_other_languages(furnished_state: SceneState, near: str) -> None:
    (added,) = _statements(f"Put a plant {near} the fridge in the kitchen.", furnished_state)
    assert isinstance(added, Add) and added.place.anchor is not None and added.place.anchor.noun == "fridge"


def test_a_heading_goes_for_the_sentences_after_it(furnished_state: SceneState) -> None:
    told = _statements(
        "Hall: chairs 3 -> 2. Paint the chairs red. Open the fridge in the kitchen. Mugs out.", furnished_state
    )
    rooms = [s.place.rooms for s in told if isinstance(s, Ensure)]
    rooms += [s.things.place.rooms for s in told if isinstance(s, Paint | SetState) and s.things.place is not None]
    assert [found.words for found in rooms if found is not None] == ["hall", "hall", "kitchen"]
    assert isinstance(told[-1], Remove) and told[-1].things.place is None


def test_what_alone_is_kept_needs_a_place(furnished_state: SceneState) -> None:
    assert read_instruction("Open the fridge. Keep only the plate.", furnished_state).not_understood


@pytest.mark.parametrize("joint", [" + ", " and "])
def test_names_that_begin_like_verbs_are_nouns_in_notes(state: SceneState, joint: str) -> None:
    read = read_instruction(f"glove box{joint}hand sanitizer on the dining table", state)
    assert read.not_understood == []
    assert [s.things.noun for s in read.statements if isinstance(s, Ensure)] == ["glove box", "hand sanitizer"]


def test_a_filing_cabinet_is_no_verb(state: SceneState) -> None:
    read = read_instruction("Office: bookshelf and filing cabinet out.", state)
    assert read.not_understood == []
    assert [s.things.noun for s in read.statements if isinstance(s, Remove)] == ["bookshelf", "filing cabinet"]
