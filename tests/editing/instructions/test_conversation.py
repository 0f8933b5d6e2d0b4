"""A later instruction goes on from earlier ones of the same user."""

from collections.abc import Callable

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct

EditorFactory = Callable[..., SceneEditor]


def _apples(editor: SceneEditor) -> int:
    return sum(item.category == "apple" for _, item in editor.state.objects())


def test_one_more_repeats_what_was_brought(open_editor: EditorFactory) -> None:
    editor = open_editor()
    assert instruct(editor, "put an apple on the dining table").done
    assert instruct(editor, "One more, please.").done and _apples(editor) == 2
    assert instruct(editor, "one more").done and _apples(editor) == 3


def test_it_is_what_the_last_edit_was_about(open_editor: EditorFactory) -> None:
    editor = open_editor()
    assert instruct(editor, "put an apple on the dining table").done
    assert instruct(editor, "remove it").done and _apples(editor) == 0


def test_putting_it_back_takes_the_last_edit_back(open_editor: EditorFactory) -> None:
    editor = open_editor()
    before = editor.state.scenes[1].objects
    assert instruct(editor, "remove the mug from the dining table").done
    assert instruct(editor, "put it back").done and editor.state.scenes[1].objects == before


def test_nothing_is_repeated_before_the_first_edit(open_editor: EditorFactory) -> None:
    editor = open_editor()
    report = instruct(editor, "the same for the kitchen")
    assert not report.done and "no earlier instruction" in report.message


def test_something_else_is_not_put_back(open_editor: EditorFactory) -> None:
    editor = open_editor()
    assert instruct(editor, "put an apple on the dining table").done
    assert not instruct(editor, "put the fridge back").done and _apples(editor) == 1


def test_what_was_meant_is_done_instead(open_editor: EditorFactory) -> None:
    editor = open_editor()
    assert instruct(editor, "put a plant in the hall").done
    assert instruct(editor, "I meant the kitchen").done
    plants = [item.room for _, item in editor.state.objects() if item.category.endswith("plant")]
    assert plants == ["F1/kitchen"]


def test_several_edits_are_undone_together(open_editor: EditorFactory) -> None:
    editor = open_editor()
    before = editor.state.scenes[1].objects
    assert instruct(editor, "put an apple on the dining table").done
    assert instruct(editor, "put an apple on the dining table").done and _apples(editor) == 2
    assert instruct(editor, "undo both steps").done and editor.state.scenes[1].objects == before
    assert not instruct(editor, "undo the last two changes").done


def test_a_question_tells_what_them_means(editor: SceneEditor) -> None:
    assert "3 chairs" in instruct(editor, "How many chairs are in the hall?").message
    assert instruct(editor, "Take two of them away.").done
    assert "1 chair" in instruct(editor, "How many are left?").message


def test_no_at_the_beginning_says_nothing(open_editor: EditorFactory) -> None:
    editor = open_editor()
    before = editor.state.scenes[1].objects
    assert instruct(editor, "remove the mug from the dining table").done
    assert instruct(editor, "Hmm no, put it back.").done and editor.state.scenes[1].objects == before
