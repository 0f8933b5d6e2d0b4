"""A policy calls only the editor's tools, in number and kind as is allowed, and is stopped where it does not."""

from collections.abc import Callable

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.runs.policies import Action, Policy, Verdict
from mansion_editing.runs.run import MOST_REFUSED, run_policy

EditorFactory = Callable[..., SceneEditor]


def _calls(*actions: tuple[str, dict[str, object]]) -> Policy:
    for tool, arguments in actions:
        yield Action("", tool, arguments)
    return Verdict("done")


@pytest.mark.parametrize(
    ("tool", "arguments"),
    [
        ("Save", {}),
        ("Undo", {}),
        ("os.system", {"command": "ls"}),
        ("SetState", {"object_id": "F1/kitchen/fridge_1", "wall": True}),
        ("RemoveObject", {"object_id": "F1/kitchen/mug_1", "editor": "other"}),
        ("SearchAssets", {"query": "mug", "top_k": 10_000}),
    ],
)
def test_actions_outside_the_tools_are_refused(
    open_editor: EditorFactory, tool: str, arguments: dict[str, object]
) -> None:
    report = run_policy(open_editor(), _calls((tool, arguments)), "test")
    assert [step.refused for step in report.steps] == [True] and report.edits == 0


def test_a_policy_that_only_misbehaves_is_stopped(open_editor: EditorFactory) -> None:
    report = run_policy(open_editor(), _calls(*[("Nothing", {})] * 100), "test")
    assert not report.done and len(report.steps) == MOST_REFUSED
