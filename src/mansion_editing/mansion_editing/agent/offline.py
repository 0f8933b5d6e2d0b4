"""The offline policy: parse an instruction into facts, check each, provision what is missing and no more."""

from collections.abc import Generator
from dataclasses import replace

from mansion_editing.agent.facts import AbsentFact, Fact, MoveFact, ObjectFact, PathFact, StateFact
from mansion_editing.agent.looking import find_things, named_so
from mansion_editing.agent.parse import parse_instruction
from mansion_editing.agent.protocol import Action, Outcome, Policy, Verdict
from mansion_editing.agent.providing import provide
from mansion_editing.agent.shifting import take_away, transfer
from mansion_editing.agent.wording import passed_over
from mansion_editing.editor import SceneEditor
from mansion_editing.state import SceneState
from mansion_editing.vocabulary import stems
from mansion_msgs_py.editing import PathReport

__all__ = ["offline_policy", "satisfy"]

Work = Generator[Action, Outcome, str]
"""Ends with the reason why a fact does not hold, empty when it does."""


def offline_policy(editor: SceneEditor, instruction: str) -> Policy:
    """Work through the facts of an instruction.

    Parameters
    ----------
    editor : SceneEditor
        Its state names rooms and things; it is only read.

    Raises
    ------
    MansionError
        See `parse_instruction`.
    """
    state = editor.state
    verdict = yield from satisfy(parse_instruction(state, instruction), state)
    untold = passed_over(instruction)
    if untold:
        verdict = replace(
            verdict, summary=f"{verdict.summary} (passed over, for nothing tells it: {', '.join(untold)})"
        )
    return verdict


def satisfy(facts: list[Fact], state: SceneState) -> Policy:
    """Check facts in order and provision what is missing."""
    failed = []
    for fact in facts:
        reason = yield from _satisfy(fact, state)
        if reason:
            failed.append(f"{fact}: {reason}")
    words = [str(fact) for fact in facts]
    summary = f"{len(facts) - len(failed)} of {len(facts)} facts hold" + (f"; {'; '.join(failed)}" if failed else "")
    return Verdict(summary, words, failed)


def _satisfy(fact: Fact, state: SceneState) -> Work:
    if isinstance(fact, ObjectFact):
        return (yield from provide(fact, state))
    if isinstance(fact, PathFact):
        return (yield from _path(fact))
    if isinstance(fact, AbsentFact):
        return (yield from take_away(fact, state))
    if isinstance(fact, MoveFact):
        return (yield from transfer(fact, state))
    return (yield from _switch(fact, state))


def _path(fact: PathFact) -> Work:
    answer = yield Action(f"Is there {fact}?", "CheckPath", {"start": fact.start, "end": fact.end})
    if answer.error is not None:
        return str(answer.error)
    report: PathReport = answer.value
    return "" if report.reachable else report.message


def _switch(fact: StateFact, state: SceneState) -> Work:
    found = yield from find_things(fact.thing, fact.where, state)
    if isinstance(found, str):
        return found
    if not fact.thing.noun and not (fact.where.rooms or fact.where.floor is not None):
        return "say in which room, or on which floor"
    if not found:
        return f"there is no {fact.thing.noun} {fact.where}"
    able = [i for i in found if ("openable" if fact.state == "open" else "toggleable") in i.properties]
    if not able:
        what = "opens" if fact.state == "open" else "switches"
        return f"no {fact.thing.noun} {fact.where} {what}"
    several = fact.thing.count == 0 and fact.thing.every
    own = set(stems(fact.thing.noun))
    named = [i for i in able if own <= set(stems(i.category.replace("_", " ")))]
    able = ([] if several else named_so(fact.thing.noun, able)) or named or able
    wanted = able if several else able[: max(1, fact.thing.count)]
    as_wished = [i for i in able if bool(i.states.get(fact.state, False)) == fact.value]
    if not several and len(as_wished) >= max(1, fact.thing.count):
        return ""
    for item in wanted:
        if bool(item.states.get(fact.state, False)) == fact.value:
            continue
        answer = yield Action(f"{item.id} is not as asked.", "SetState", {"object_id": item.id, fact.state: fact.value})
        if answer.error is not None:
            return str(answer.error)
    return ""
