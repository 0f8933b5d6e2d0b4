"""Of several things or rooms that words fit, those that the building's brief asked for."""

from dataclasses import replace

import msgspec
import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.meaning.brief import Asked
from mansion_editing.instructions.meaning.choices import one_room_each, things_meant
from mansion_editing.instructions.meaning.context import Ambiguous, Context
from mansion_editing.instructions.meaning.targets import places_of
from mansion_editing.instructions.statements import Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.program import RequestedObject

TABLE = RequestedObject(category="dining_table", count=1, words="table")
KITCHEN, OFFICE = "F1/kitchen", "F2/private_office_1"


def _asked(*rooms: str) -> Context:
    return replace(Context(), brief=Asked(dict.fromkeys(rooms, (TABLE,))))


def test_the_table_is_the_one_that_the_brief_asked_for(furnished_state: SceneState) -> None:
    (table,) = things_meant(furnished_state, Things(noun="table", definite=True), _asked(OFFICE))
    assert table.id == f"{OFFICE}/dining_table_1"


@pytest.mark.parametrize("rooms", [(), (KITCHEN, OFFICE)])
def test_it_is_asked_about_where_the_brief_does_not_tell(furnished_state: SceneState, rooms: tuple[str, ...]) -> None:
    with pytest.raises(Ambiguous):
        things_meant(furnished_state, Things(noun="table", definite=True), _asked(*rooms))


def test_a_place_is_at_the_one_that_the_brief_asked_for(furnished_state: SceneState) -> None:
    place = Place(relation="beside", anchor=Things(noun="table", definite=True))
    (target,) = places_of(furnished_state, place, _asked(KITCHEN))
    assert target.room == KITCHEN


def test_any_of_several_alike_in_a_room_is_beside_enough(furnished_state: SceneState) -> None:
    place = Place(relation="beside", anchor=Things(noun="chair", definite=True))
    assert {target.room for target in places_of(furnished_state, place, Context())} == {"F1/hall"}


def test_the_chair_that_shall_go_is_asked_about(furnished_state: SceneState) -> None:
    with pytest.raises(Ambiguous):
        things_meant(furnished_state, Things(noun="chair", definite=True), Context())


def test_of_more_than_the_brief_asked_for_one_serves(furnished_state: SceneState) -> None:
    words = Things(noun="mug", definite=True, place=Place(rooms=Rooms(words=OFFICE)))
    mug = RequestedObject(category="mug", count=1, words="mug")
    one, two = (
        replace(Context(), brief=Asked({OFFICE: (msgspec.structs.replace(mug, count=count),)})) for count in (1, 2)
    )
    assert [item.id for item in things_meant(furnished_state, words, one)] == [f"{OFFICE}/mug_1"]
    with pytest.raises(Ambiguous):
        things_meant(furnished_state, words, two)


def test_the_room_is_the_one_that_the_brief_names(furnished_state: SceneState) -> None:
    several = Rooms(words="room")
    assert one_room_each(furnished_state, several, _asked(KITCHEN)) == [KITCHEN]
    with pytest.raises(Ambiguous):
        one_room_each(furnished_state, several, _asked(KITCHEN, OFFICE))


def test_the_answer_says_which_of_several_was_taken(editor: SceneEditor) -> None:
    report = instruct(editor, "Put a plant next to the chair.")
    assert report.done and "at F1/hall/chair_" in report.message and "one of 3" in report.message
