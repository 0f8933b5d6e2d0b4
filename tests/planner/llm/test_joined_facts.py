"""What the rules read, stated by a model, becomes the same ledger; what only the rules read is joined to it."""

import json
from pathlib import Path
from types import ModuleType

import msgspec
import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wishes import Wish
from mansion_planner.brief import BriefFacts, read_brief
from mansion_planner.llm.answers import ReadingAnswer
from mansion_planner.llm.joined_facts import joined_facts, without_rules
from mansion_planner.llm.statement_facts import StatementFacts, facts_of_statements
from mansion_planner.program.building import plan_program

KNOWLEDGE = default_knowledge()
BRIEFS = Path(__file__).parents[2] / "briefs" / "briefs.json"
FEASIBLE = [entry["brief"] for entry in json.loads(BRIEFS.read_text()) if "error=INFEASIBLE" not in entry["facts"]]


def ledger(brief: str, facts: BriefFacts) -> list[Wish]:
    generator = item_generator(0, "program")
    return plan_program(BuildRequest(description=brief), facts, KNOWLEDGE, "b", generator).program.wishes


def stated(architect: ModuleType, brief: str, wishes: list[Wish]) -> StatementFacts:
    """Return the facts of an answer that states some wishes."""
    answer = {"language": "English", "statements": [architect.statement(wish) for wish in wishes]}
    return facts_of_statements(msgspec.convert(answer, ReadingAnswer), brief, KNOWLEDGE)


OUTSIDE = "A white villa with a slate hip roof, a garden with a pool and parking for 4 cars"


@pytest.mark.parametrize("brief", [*FEASIBLE[::3], OUTSIDE])
def test_a_model_that_states_what_the_rules_read_fills_the_same_ledger(architect: ModuleType, brief: str) -> None:
    rules = read_brief(brief, KNOWLEDGE)
    wishes = ledger(brief, rules)
    model = stated(architect, brief, wishes)
    assert model.faults == ()
    assert ledger(brief, joined_facts(model, rules, brief)) == wishes
    alone = [wish for wish in ledger(brief, without_rules(model, brief)) if wish.kind != "unread"]
    assert [(w.kind, w.text, w.value, w.scope) for w in alone] == [
        (w.kind, w.text, w.value, w.scope) for w in wishes if w.kind != "unread"
    ]


@pytest.mark.parametrize("brief", FEASIBLE[::5])
def test_of_a_model_that_states_nothing_the_rules_reading_is_left(architect: ModuleType, brief: str) -> None:
    rules = read_brief(brief, KNOWLEDGE)
    assert ledger(brief, joined_facts(stated(architect, brief, []), rules, brief)) == ledger(brief, rules)


@pytest.mark.parametrize("brief", FEASIBLE[::5])
def test_of_a_model_that_states_every_other_wish_none_is_lost(architect: ModuleType, brief: str) -> None:
    rules = read_brief(brief, KNOWLEDGE)
    wishes = ledger(brief, rules)
    joined = joined_facts(stated(architect, brief, wishes[::2]), rules, brief)
    assert {(wish.kind, wish.text) for wish in ledger(brief, joined)} >= {(wish.kind, wish.text) for wish in wishes}
