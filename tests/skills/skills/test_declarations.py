"""A skill is declared once: whatever lists skills has what its module says, in the published order."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from decoding import check_decoding
from mansion_msgs_py.codec import convert
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.registry import SKILL_PAYLOADS, SKILLS, skill_named

ZIGZAG = '''
"""Zigzag: a skill in a module of its own."""

from typing import Annotated, Any

from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import SkillStatus
from mansion_skills.skills.declaration import Action, Argument, Card, skill
from mansion_skills.skills.results import Step, done, invalid


class ZigzagArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How often to turn."""

    times: Annotated[Any, Argument("number", "how often")] = 1


@skill(
    "Zigzag",
    "Go in a zigzag.",
    arguments=ZigzagArgs,
    example=\'{"times": 2}\',
    failures=(SkillStatus.INVALID_ACTION,),
    card=Card("go in a zigzag", ("times",), optional=("times",)),
    actions=(Action(fixed={"times": 2}),),
)
def zigzag(world, robot, arguments, *, realtime):
    if arguments.times != 2:
        return invalid(world, robot, "Zigzag", "it takes two turns", "2")
    yield Step(1.0, 0.5, "zigzagging")
    return done(world, robot, "Zigzag", "zigzagged")
'''

LISTS = """
import json, sys
import mansion_skills.skills
mansion_skills.skills.__path__.append(sys.argv[1])
from mansion_bringup.interfaces import PAYLOADS, SERVICES, markdown_table, skill_commands, skill_table
from mansion_skills import Robot
from mansion_tasks.agents.skill_cards import card_lines, faulty_arguments
from mansion_tasks.env.skill_level import SKILL_ACTIONS, skill_call
robot = Robot(sys.argv[2])
last = len(SKILL_ACTIONS) - 1
print(json.dumps({
    "services": [entry.name for entry in SERVICES],
    "payloads": list(PAYLOADS),
    "table": markdown_table(),
    "skills": skill_table(),
    "commands": skill_commands(),
    "cards": card_lines(),
    "fault": faulty_arguments("Zigzag", {"times": "often"}),
    "actions": SKILL_ACTIONS,
    "call": skill_call([last, 0, 0, 0], [], [], [1]).arguments,
    "done": robot.skill("Zigzag", times=2).message,
    "refused": robot.skill("zigzag").status,
}))
"""


def test_a_new_module_with_a_skill_is_in_every_list(tmp_path: Path, building: Path) -> None:
    (tmp_path / "zigzagging.py").write_text(ZIGZAG)
    command = [sys.executable, "-c", LISTS, str(tmp_path), str(building)]
    found = json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=120).stdout)
    assert "skills/zigzag" in found["services"] and "ZigzagArgs" in found["payloads"]
    assert "| `skills/zigzag` | `diagnostic_msgs/srv/AddDiagnostics` | ZigzagArgs | SkillResult |" in found["table"]
    assert "| Zigzag | `times`: how often | `INVALID_ACTION` |" in found["skills"]
    assert "mansion call skills/zigzag '{\"times\": 2}'" in found["commands"]
    assert found["cards"].endswith("\n- Zigzag(times): go in a zigzag")
    assert found["fault"] == "times of Zigzag must be a number, not 'often'"
    assert found["actions"][-1] == "Zigzag 2" and found["call"] == {"times": 2}
    assert (found["done"], found["refused"]) == ("zigzagged", "INVALID_ACTION")


def test_both_names_of_a_skill_find_it() -> None:
    for service, skill in SKILLS.items():
        assert skill_named(service) is skill_named(skill.name) is skill
    assert skill_named("Fly") is None


@pytest.mark.parametrize("skill", SKILLS.values(), ids=SKILLS)
def test_what_a_skill_declares_fits_its_arguments(skill: Skill) -> None:
    known = set(skill.parameters)
    convert(skill.arguments, json.loads(skill.example or "{}"))
    if skill.card is not None:
        assert set(skill.card.optional) <= set(skill.card.arguments) <= known
    for action in skill.actions:
        assert {*action.fixed, action.indexed} - {""} <= known
        assert not action.indexed or skill.parameters[action.indexed].kind in ("landmark", "object", "floor")


@pytest.mark.parametrize("name", sorted(SKILL_PAYLOADS))
@given(data=st.data())
@settings(max_examples=25, deadline=None)
def test_any_bytes_give_arguments_or_the_documented_error(name: str, data: st.DataObject) -> None:
    check_decoding(SKILL_PAYLOADS[name], data)
