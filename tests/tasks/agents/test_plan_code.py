"""Plans as code are read, and nothing of them runs."""

import builtins

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_skills.skills.registry import skill_named
from mansion_tasks.agents.plan_code import MAX_CALLS, PlanError, read_plan
from mansion_tasks.agents.skill_cards import CARDS


def test_a_plan_is_a_list_of_calls_under_either_name() -> None:
    plan = read_plan('go_to_landmark("elevator")  # first\nCallElevator()\nUseElevator(target_floor=3)')
    assert [(c.skill, c.arguments) for c in plan] == [
        ("GoToLandmark", {"landmark": "elevator"}),
        ("CallElevator", {}),
        ("UseElevator", {"target_floor": 3}),
    ]


@pytest.mark.parametrize(
    "code",
    [
        "import os",
        '__import__("os").system("touch /tmp/x")',
        'open("/etc/passwd").read()',
        'exec("1")',
        'PickUp(open("/etc/passwd").read())',
        'PickUp("a" + "b")',
        'PickUp(f"{1}")',
        'x = PickUp("a")',
        "while True: CallElevator()",
        '[PickUp(o) for o in "ab"]',
        '(lambda: PickUp("a"))()',
        'robot.PickUp("a")',
        'PickUp(**{"object": "a"})',
        'PickUp(*["a"])',
        'PickUp("a", session="default")',
        'PickUp("a", object="b")',
        'FlyAway("up")',
        'PickUp(b"a")',
        "PickUp(None)",
        "UseElevator(True)",
        'UseElevator("3")',
        "MoveAhead(1e999)",
        "MoveAhead(2j)",
        'MoveAhead(-"a")',
        'PickUp("")',
        'PickUp("' + "a" * 300 + '")',
        "CallElevator()\n" * (MAX_CALLS + 1),
        "(" * 5000,
        "-" * 5900 + "1",
        "PickUp('a'",
        "\0",
        "# " + "x" * 7000,
    ],
)
def test_what_is_more_than_calls_with_literals_is_refused(code: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def ran(*arguments: object) -> None:
        raise AssertionError("the plan ran")

    with monkeypatch.context() as patch:
        patch.setattr(builtins, "exec", ran)
        patch.setattr(builtins, "eval", ran)
        with pytest.raises(PlanError):
            read_plan(code)


@given(st.text(alphabet="PickUpMoveAhead()\"'#\n-1.5,=*[]{}:; ", max_size=120))
@settings(max_examples=100, deadline=None)
def test_any_text_is_calls_of_known_skills_or_refused(code: str) -> None:
    try:
        calls = read_plan(code)
    except PlanError:
        return
    assert all(call.skill in CARDS for call in calls)


def test_cards_are_those_of_skills_that_exist() -> None:
    for name, card in CARDS.items():
        skill = skill_named(name)
        assert skill is not None and not skill.query
        assert set(card.arguments) <= set(skill.arguments.__struct_fields__) - {"session", "token"}
