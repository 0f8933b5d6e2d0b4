"""What is taken from furniture: where it is, where it goes, and what stays behind."""

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Mention, Move, Paint, Place, Remove, Rooms, Statement, Things
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == []
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


def test_getting_things_off_furniture_takes_them_away_but_for_the_exceptions(furnished_state: SceneState) -> None:
    (clear,) = _asked(
        "get everything off the desk in the study apart from the lamp, the mug and the book", furnished_state
    )
    assert isinstance(clear, Clear) and [spared.noun for spared in clear.spare] == ["lamp", "mug", "book"]
    assert clear.place.rooms == Rooms(words="study")


def test_getting_things_from_a_room_still_brings_them(furnished_state: SceneState) -> None:
    (move,) = _asked("get two mugs from the kitchen to the study", furnished_state)
    assert isinstance(move, Move)


def test_collecting_things_from_furniture_takes_them_away(furnished_state: SceneState) -> None:
    (gone,) = _asked("collect the mugs from the desk", furnished_state)
    assert isinstance(gone, Remove) and gone.things.noun == "mug"


def test_what_is_thrown_out_of_furniture_goes(furnished_state: SceneState) -> None:
    (gone,) = _asked("throw both mugs out of the cabinet in the kitchen", furnished_state)
    assert isinstance(gone, Remove) and gone.things.noun == "mug"
    (moved,) = _asked("throw the mug out of the cabinet into the sink", furnished_state)
    assert isinstance(moved, Move)


def test_what_a_list_comes_from_is_nothing_of_the_list(furnished_state: SceneState) -> None:
    for text in ("remove all tables and all chairs from it", "remove the desk and the chairs from it"):
        for gone in _asked(text, furnished_state):
            assert isinstance(gone, Remove) and gone.things.place is not None
            anchor = gone.things.place.anchor
            assert anchor is not None and anchor.refers == "last" and not anchor.noun


def test_what_is_taken_out_is_put_without_being_named_again(furnished_state: SceneState) -> None:
    (move,) = _asked(
        "take 2 mugs out from the cabinet in the kitchen and put on the desk in the study", furnished_state
    )
    assert isinstance(move, Move) and move.things.amount.number == 2
    assert move.place.anchor is not None and move.place.anchor.noun == "desk"


def test_the_room_after_furniture_that_something_comes_from_is_where_that_stands(furnished_state: SceneState) -> None:
    (move,) = _asked("lay the mug from the desk in the study on the table in the kitchen", furnished_state)
    assert isinstance(move, Move) and move.things.place is not None
    assert move.things.place.rooms == Rooms(words="study") and move.place.rooms == Rooms(words="kitchen")


def test_one_stays_and_the_other_one_goes(furnished_state: SceneState) -> None:
    (move,) = _asked("leave one chair at the desk and put the other one in the kitchen", furnished_state)
    assert isinstance(move, Move)
    assert (move.things.noun, move.things.amount.kind, move.things.amount.number, move.things.amount.of) == (
        "chair",
        "all_but",
        1,
        2,
    )


def test_emptying_furniture_means_what_is_in_it_too(furnished_state: SceneState) -> None:
    (emptied,), (cleared,) = (_asked(f"{verb} the dresser", furnished_state) for verb in ("empty", "clear"))
    assert isinstance(emptied, Clear) and isinstance(cleared, Clear)
    assert (emptied.place.relation, cleared.place.relation) == ("", "on")


def test_only_one_of_several_is_one_of_them(furnished_state: SceneState) -> None:
    (gone,) = _asked("remove just one of the two chairs in the study", furnished_state)
    assert isinstance(gone, Remove) and (gone.things.amount.number, gone.things.amount.of) == (1, 2)


def test_upholstery_is_a_colour_and_a_material(furnished_state: SceneState) -> None:
    (paint,) = _asked("reupholster the sofa in dark green fabric", furnished_state)
    assert paint == Paint(
        things=paint.things if isinstance(paint, Paint) else Things(),
        colour="green",
        material="fabric",
        quote=paint.quote,
    )
    assert Place() != paint.things.place


def test_the_others_do_not_go_where_none_is(editor: SceneEditor) -> None:
    report = instruct(editor, "leave one book on the table in the kitchen and put the others in the study")
    assert not report.done and not report.object_ids
