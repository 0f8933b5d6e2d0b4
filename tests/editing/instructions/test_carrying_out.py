"""Statements change the building just so far as they say, and the reply says what was there and what changed."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.run import carry_out
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ask,
    Clear,
    Ensure,
    Forbid,
    Instruction,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Reach,
    Remove,
    Rename,
    Replace,
    Rooms,
    SetState,
    Statement,
    Swap,
    Things,
    Turn,
)
from mansion_msgs_py.editing.instructions import AgentReport

KITCHEN, HALL, OFFICE = (Rooms(words=words) for words in ("kitchen", "hall", "private office"))
TABLE = Place(relation="on", anchor=Things(noun="dining table", definite=True), rooms=KITCHEN)


def the(noun: str, **more: object) -> Things:
    return Things(noun=noun, definite=True, **more)  # type: ignore[arg-type]


def some(noun: str, number: int, **more: object) -> Things:
    return Things(noun=noun, plural=number != 1, amount=Amount(number=number), **more)  # type: ignore[arg-type]


def do(editor: SceneEditor, *statements: Statement) -> AgentReport:
    return carry_out(editor, Instruction(statements=list(statements)), "by hand")


def number_of(editor: SceneEditor, category: str, room: str = "") -> int:
    return sum(item.category == category and room in ("", item.room) for _, item in editor.state.objects())


def test_more_means_new_ones_besides_those_that_are_there(editor: SceneEditor) -> None:
    report = do(editor, Add(things=some("mug", 2), place=TABLE))
    assert report.done and number_of(editor, "mug", "F1/kitchen") == 3
    assert report.message.startswith("there was 1 mug on the dining table in the Kitchen; 2 added (F1/kitchen/mug_2")
    assert report.message.endswith("now 3")


def test_what_is_there_counts_for_a_number_that_shall_be_there(editor: SceneEditor) -> None:
    report = do(editor, Ensure(things=some("chair", 5), place=Place(rooms=HALL)))
    assert report.done and number_of(editor, "chair", "F1/hall") == 5 and "now 5" in report.message
    again = do(editor, Ensure(things=some("chair", 4), place=Place(rooms=HALL)))
    assert again.done and not again.edits and "nothing had to change" in again.message


@pytest.mark.parametrize(("kind", "left"), [("exactly", 1), ("at_most", 1), ("at_least", 3), ("none", 0)])
def test_what_is_more_goes_only_where_words_say_so(editor: SceneEditor, kind: str, left: int) -> None:
    amount = Amount(kind=kind, number=1)  # type: ignore[arg-type]
    report = do(editor, Ensure(things=Things(noun="chair", amount=amount), place=Place(rooms=HALL)))
    assert report.done and number_of(editor, "chair", "F1/hall") == left


def test_each_of_several_places_gets_its_own(editor: SceneEditor) -> None:
    tables = Things(noun="dining table", amount=Amount(kind="all", number=0))
    report = do(editor, Add(things=some("plate", 1), place=Place(relation="on", anchor=tables), each=True))
    assert report.done and len(report.object_ids) == 2
    assert {name.rsplit("/", 1)[0] for name in report.object_ids} == {"F1/kitchen", "F2/private_office_1"}


def test_just_the_number_meant_is_removed(editor: SceneEditor) -> None:
    report = do(editor, Remove(things=some("chair", 2)))
    assert report.done and number_of(editor, "chair") == 1 and "1 of 3 left" in report.message


def test_what_stood_on_removed_furniture_goes_with_it_and_is_named(editor: SceneEditor) -> None:
    report = do(editor, Remove(things=the("dining table", place=Place(rooms=KITCHEN))))
    assert report.done and "with what stood on it: F1/kitchen/mug_1, F1/kitchen/plate_1" in report.message


@pytest.mark.parametrize(
    "things", [Things(noun="piano", plural=True, amount=Amount(kind="all", number=0)), the("piano")]
)
def test_nothing_to_remove_is_said(editor: SceneEditor, things: Things) -> None:
    report = do(editor, Remove(things=things))
    assert report.done and not report.edits and report.message.startswith("there was nothing to remove")


@pytest.mark.parametrize("things", [some("chair", 4), the("chair"), some("chair", 2, definite=True), the("mug")])
def test_what_cannot_be_told_apart_or_is_not_there_changes_nothing(editor: SceneEditor, things: Things) -> None:
    report = do(editor, Add(things=some("mug", 1), place=TABLE), Remove(things=things, quote="the words"))
    known = number_of(editor, "mug"), number_of(editor, "chair")
    if things.noun == "mug":
        assert report.done and known == (3, 3)  # the mug is the one that was just brought
    else:
        assert not report.done and known == (3, 3) and report.message.startswith("the words: ")


def test_candidates_are_reported(editor: SceneEditor) -> None:
    report = do(editor, Remove(things=the("mug")))
    assert not report.done and len(report.candidates) == 3 and "say which" in report.message


def test_a_table_is_cleared_but_for_what_is_spared(editor: SceneEditor) -> None:
    report = do(editor, Clear(place=TABLE, spare=(the("plate"),)))
    assert report.done and editor.state.find("F1/kitchen/plate_1") and not editor.state.find("F1/kitchen/mug_1")


def test_a_room_is_cleared_of_what_is_loose_alone(editor: SceneEditor) -> None:
    before = number_of(editor, "fridge") + number_of(editor, "dining_table")
    report = do(editor, Clear(place=Place(rooms=KITCHEN)))
    assert report.done and sorted(report.object_ids) == ["F1/kitchen/mug_1", "F1/kitchen/plate_1"]
    assert number_of(editor, "fridge") + number_of(editor, "dining_table") == before


def test_a_thing_moves_to_furniture_and_to_another_storey(editor: SceneEditor) -> None:
    desk = Place(relation="on", anchor=the("office desk"))
    report = do(editor, Move(things=the("plate"), place=desk))
    assert report.done and number_of(editor, "plate") == 1 and number_of(editor, "plate", "F2/private_office_1") == 1
    assert "F1/kitchen/plate_1" in report.message
    again = do(editor, Move(things=the("plate"), place=desk))
    assert again.done and not again.edits and "there already" in again.message


def test_a_new_one_is_brought_only_where_none_is_in_the_building(editor: SceneEditor) -> None:
    fridge = Place(relation="in", anchor=the("fridge"))
    assert do(editor, Move(things=the("milk"), place=fridge, or_new=True)).object_ids == ["F1/kitchen/milk_carton_1"]
    assert do(editor, Move(things=the("plate"), place=fridge, or_new=True)).done
    assert number_of(editor, "plate") == 1


def test_of_several_mugs_the_one_in_the_room_goes_into_the_fridge(editor: SceneEditor) -> None:
    report = do(editor, Move(things=the("mug"), place=Place(relation="in", anchor=the("fridge")), or_new=True))
    assert report.done and report.object_ids == ["F1/kitchen/mug_1"]


def test_what_was_mentioned_is_meant_by_a_pronoun(editor: SceneEditor) -> None:
    them = Things(refers="last", plural=True, amount=Amount(kind="all", number=0))
    add = Add(things=some("chair", 2), place=Place(rooms=HALL))
    report = do(editor, add, Move(things=them, place=Place(rooms=KITCHEN)))
    assert report.done and number_of(editor, "chair", "F1/kitchen") == 2 and number_of(editor, "chair", "F1/hall") == 3


def test_things_are_opened_switched_painted_turned_and_swapped(editor: SceneEditor) -> None:
    report = do(
        editor,
        SetState(things=the("fridge"), state="open", value=True),
        SetState(things=the("light", place=Place(rooms=KITCHEN)), state="on", value=False),
        Paint(things=the("sofa"), colour="red"),
        Turn(things=the("floor lamp"), degrees=90.0),
    )
    assert report.done and report.edits == 5
    assert do(editor, Swap(one=the("plate"), other=Things(noun="F2/private_office_1/mug_1"))).done
    found = editor.state.find("F1/kitchen/fridge_1")
    assert found is not None and found[1].states["open"] is True


def test_a_state_that_holds_already_is_said(editor: SceneEditor) -> None:
    report = do(editor, SetState(things=the("fridge"), state="open", value=False))
    assert report.done and not report.edits
    assert report.message == "there was nothing to do: F1/kitchen/fridge_1 is closed already"


def test_things_are_replaced_where_they_stood(editor: SceneEditor) -> None:
    old = editor.state.get("F1/hall/sofa_1")[1]
    report = do(editor, Replace(things=the("sofa"), by=Things(noun="armchair")))
    new = editor.state.get("F1/hall/armchair_1")[1]
    assert report.done and not number_of(editor, "sofa") and new.position[:2] == old.position[:2]


def test_new_things_stand_where_relations_have_them(editor: SceneEditor) -> None:
    place = Place(relation="left", anchor=the("sofa"))
    report = do(editor, Add(things=Things(noun="plant"), place=place))
    plant, sofa = (editor.state.get(name)[1] for name in (report.object_ids[0], "F1/hall/sofa_1"))
    assert report.done and plant.position[0] < sofa.position[0]


def test_a_way_that_is_there_needs_nothing(editor: SceneEditor) -> None:
    report = do(editor, Reach(end=OFFICE))
    assert report.done and not report.edits and "F2/private_office_1" in report.message


def test_background_asks_for_nothing_and_words_that_belong_to_nothing_stop_the_edit(editor: SceneEditor) -> None:
    assert not do(editor, Mention()).done
    assert do(editor, Mention(), Add(things=some("mug", 1), place=TABLE)).done
    read = Instruction(statements=[Remove(things=the("sofa"))], not_understood=["and make it pop"])
    report = carry_out(editor, read, "by hand")
    assert not report.done and "make it pop" in report.message and editor.state.find("F1/hall/sofa_1")


def test_what_shall_stay_or_not_come_stops_what_would_break_it(editor: SceneEditor) -> None:
    chairs = Things(noun="chair", plural=True)
    hall = Place(rooms=HALL)
    broken = do(editor, Forbid(things=chairs, place=hall), Add(things=some("chair", 1), place=hall))
    assert not broken.done and number_of(editor, "chair") == 3
    kept = do(editor, Remove(things=the("sofa")), Keep(things=Things(noun="sofa", definite=True)))
    assert not kept.done and number_of(editor, "sofa") == 1


def test_what_shall_stay_is_not_among_all_that_go(editor: SceneEditor) -> None:
    report = do(editor, Remove(things=the("seat", place=Place(rooms=HALL), plural=True)), Keep(things=the("sofa")))
    assert report.done and number_of(editor, "sofa") == 1 and not number_of(editor, "chair")


def test_a_room_takes_a_name_or_the_tool_is_said_to_be_missing(editor: SceneEditor) -> None:
    report = do(editor, Rename(room=HALL, name="Atrium"))
    assert report.done or "RenameRoom" in report.message


@pytest.mark.parametrize(
    ("question", "answer"),
    [
        (Ask(about="count", things=Things(noun="mug", plural=True)), "There are 3 mugs in the building: "),
        (Ask(about="exists", things=Things(noun="piano")), "No, there is no piano in the building."),
        (Ask(about="where", things=the("plate")), "F1/kitchen/plate_1 is on F1/kitchen/dining_table_1 in the Kitchen"),
        (Ask(about="what", place=TABLE), "1 mug, 1 plate"),
        (Ask(about="state", things=the("fridge"), state="open"), "No: F1/kitchen/fridge_1 is closed."),
        (Ask(about="rooms", rooms=Rooms(floors=(2,), every=True)), "2 rooms: "),
        (Ask(about="area", rooms=KITCHEN), "36.0 m2"),
        (Ask(about="reach", rooms=OFFICE), "Yes: F1/hall > "),
        (Ask(about="colour", things=the("sofa")), "F1/hall/sofa_1 is grey"),
    ],
)  # fmt: skip
def test_questions_are_answered_from_the_scene(editor: SceneEditor, question: Ask, answer: str) -> None:
    report = do(editor, question)
    assert report.done and report.question and answer in report.message
    assert not report.edits and not report.object_ids


def test_a_thing_is_replaced_by_one_of_its_kind(editor: SceneEditor) -> None:
    report = do(editor, Replace(things=the("sofa"), by=Things(noun="sofa", colour="green")))
    (sofa,) = [item for _, item in editor.state.objects() if item.category == "sofa"]
    assert report.done and sofa.material.endswith("green")


def test_a_vessel_that_is_not_there_is_brought_where_words_have_it(editor: SceneEditor) -> None:
    bowl = Place(relation="in", anchor=Things(noun="bowl", place=TABLE))
    report = do(editor, Add(things=Things(noun="apple"), place=bowl))
    apple = next(item for _, item in editor.state.objects() if item.category == "apple")
    assert report.done and apple.parent == "F1/kitchen/bowl_1" and len(report.object_ids) == 2


def test_what_is_too_high_for_a_chest_is_refused_with_its_size(editor: SceneEditor) -> None:
    assert instruct(editor, "Put a storage chest in the hall.").done
    assert instruct(editor, "Put a teddy bear on the dining table in the kitchen.").done
    report = instruct(editor, "Put the teddy bear in the storage chest.")
    assert not report.done
    assert "teddy bear" in report.message and "does not fit in F1/hall/storage_chest_1" in report.message


def test_what_is_brought_can_do_what_most_of_its_kind_do(editor: SceneEditor) -> None:
    report = instruct(editor, "Put a television on the dining table in the kitchen and switch it on.")
    assert report.done, report.message
