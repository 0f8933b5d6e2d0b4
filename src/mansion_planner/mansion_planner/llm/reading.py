"""Ask a model what a brief states, before anything is planned; the rules' reader fills the gaps.

Each statement comes with the words that it was read from. A quote that is not in the brief is asked for again once, and
its statement left out where it stays wrong.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import get_args

import msgspec

from mansion_llm import Fault, Prompt, quoted_data
from mansion_msgs_py.wishes import MOST_WORDS, Wish
from mansion_planner.brief import BriefFacts, read_brief
from mansion_planner.brief.facts import Shape, Span
from mansion_planner.brief_checks import check_understood, nothing_understood, states_something
from mansion_planner.llm.answers import ReadingAnswer
from mansion_planner.llm.context import ARCHITECT, CLOSING, Context
from mansion_planner.llm.joined_facts import joined_facts, without_rules
from mansion_planner.llm.statement_facts import StatementFacts, facts_of_statements
from mansion_planner.program.building import PlannedBuilding

__all__ = ["JointReading", "read_with_model", "signed"]

REPAIRS = 1
"""How often statements with faults are asked for again."""

_KINDS = """\
kind is one of:
building_type (value.type of the list, value.name as the client calls it), style (value.name of the list),
floors and basements (value.count), total_area and floor_area (value.area, gross),
outline (value.name: {shapes}), use (value.type: what the building's floors scope.floors are for),
copy (scope.floors are identical), stair and elevator (value.count, or value.unwanted),
room (value.name as the client calls it, value.type of the list, value.count, value.area of each; scope.floors;
 scope.each where the count is for each of these floors; scope.room where each such room has it for itself, the count
 then being for each),
no_room (value.name, value.type; scope.floors where it is unwanted there only),
adjacent and apart (value.name and value.other: the two rooms),
object and no_object (furniture: value.name, value.count; scope.room; scope.each where it is for each such room),
height (value.height of ceilings; scope.room),
material (value.type: floor or wall; value.name: the material; scope.room),
facade (value.name: what the outer walls are made of or their colour, as in red brick, white render, dark timber),
roof (value.name: flat, gable or hip; value.type: what covers it, as in slate, tile, thatch, grass),
grounds (value.name: garden, pool outdoors, parking outdoors with value.count places, playground, hedge or fence),
clutter (value.name: dense where many small things are to lie about, sparse where few; scope.room),
occupants (value.count of value.name),
only (nothing but what is named is wanted), unread (it asks for something that none of these kinds can say),
aside (it asks for nothing: greetings, reasons)."""

_RULES = f"""\
Rules:
1. One statement for each single thing that is asked for, in the order of the text; say nothing that the text does not.
   A room that stands in a relation or holds furniture has a statement of its own as well.
2. quote repeats the words that state it, letter by letter in the language of the brief: with its number, size and
   floor, and no more, at most {MOST_WORDS} words. Statements may share words, and together the quotes cover all that
   the text asks for.
3. Names are English, snake_case and singular, whatever the language of the brief; use the same name for the same room.
4. value.count is a number; null and value.several true for a plural without one. Fields that say nothing stay empty.
5. scope.floors has numbers (1 is the ground floor) or ground, top, roof, basement, every, upper, lower, middle, odd,
   even, not_top; it is empty where the text names no floor.
6. Areas are in square metres and heights in metres: convert other units.
7. language is the English name of the language of the brief."""

_SCHEMA = """\
{"language": "<name>", "statements": [{"kind": "<kind>", "quote": "<words of the brief>",
 "value": {"name": "", "type": "", "other": "", "other_type": "", "count": null, "several": false, "area": null,
           "height": null, "unwanted": false},
 "scope": {"floors": [], "room": "", "each": false}}]}"""


@dataclass(frozen=True)
class JointReading:
    """What a brief states, and the words of the model's statements; none where the rules read alone."""

    facts: BriefFacts
    by_model: tuple[Span, ...] = ()


def read_with_model(context: Context, refusal: Callable[[BriefFacts], str] = lambda facts: "") -> JointReading:
    """Return what the brief states: the model's reading, with the rules' where that is silent.

    Parameters
    ----------
    refusal : callable
        Returns why facts cannot be planned, or an empty string; a reading that cannot is asked for again.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` where model and rules together understand nothing of it.
    """
    text = context.description
    if not context.client.wants("reading"):
        context.from_rules("reading")
        return JointReading(read_brief(text, context.knowledge))

    def check(answer: ReadingAnswer) -> list[Fault]:
        model = facts_of_statements(answer, text, context.knowledge)
        why = "" if model.faults else refusal(_joined(context, model, answer.language))
        return [*model.faults, *([Fault(f"what you read cannot be planned: {why}")] if why else [])]

    answer = context.client.ask(_question(context), ReadingAnswer, check, array_field="statements", repairs=REPAIRS)
    model = facts_of_statements(answer.value or ReadingAnswer([]), text, context.knowledge)
    if answer.value is None or not (model.spans or model.facts.unread):
        context.from_rules("reading", answer.reason or "the model made no statement")
        facts = read_brief(text, context.knowledge)
        check_understood(facts, text)
        return JointReading(facts)
    facts = _joined(context, model, answer.value.language)
    if not states_something(facts):
        raise nothing_understood(facts, text)
    _name_source(context, model, len(answer.value.statements), answer.reason)
    return JointReading(facts, (*model.spans, *model.facts.unread))


def _joined(context: Context, model: StatementFacts, language: str) -> BriefFacts:
    """Return the model's facts, and in an English brief what the rules read besides."""
    if language.strip().lower()[:2] in ("", "en"):
        return joined_facts(model, read_brief(context.description, context.knowledge), context.description)
    return without_rules(model, context.description)


def signed(planned: PlannedBuilding, reading: JointReading) -> PlannedBuilding:
    """Return the plan with its wishes signed by their reader; numbers that nobody stated are no wishes."""
    wishes = [_signed(wish, reading.by_model) for wish in planned.program.wishes if wish.text]
    wishes = [msgspec.structs.replace(wish, id=f"wish_{n}") for n, wish in enumerate(wishes, 1)]
    return replace(planned, program=msgspec.structs.replace(planned.program, wishes=wishes))


def _signed(wish: Wish, by_model: tuple[Span, ...]) -> Wish:
    """Sign a wish: what the rules add lies outside the model's words, in part at least."""
    start, end = wish.span
    model = any(span.start <= start and end <= span.end for span in by_model)
    return msgspec.structs.replace(wish, read_by="model" if model else "rules")


def _name_source(context: Context, model: StatementFacts, count: int, reason: str) -> None:
    """Record how many statements are the model's."""
    if model.faults:
        good = max(count - len({fault.piece for fault in model.faults}), 0)
        context.partly_from_model("reading", f"{good} of {count} statements: {reason}")
    else:
        context.from_model("reading")


def _question(context: Context) -> Prompt:
    """Return the question for the statements of the brief."""
    knowledge = context.knowledge
    lines = [
        quoted_data("brief", context.description),
        "Read what the brief states: list its statements, each with the words that state it.",
        _KINDS.format(shapes=", ".join(get_args(Shape))),
        f"Building types: {', '.join(sorted(knowledge.buildings))}.",
        f"Styles: {', '.join(sorted(knowledge.styles))}.",
        f"Room types: {', '.join(sorted(knowledge.rooms))}.",
        _RULES,
        CLOSING,
        _SCHEMA,
    ]
    return Prompt("reading", ARCHITECT, "\n".join(lines))
