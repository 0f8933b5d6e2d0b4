"""Join what a model read in a brief with what the rules read where the model is silent."""

import re
from collections.abc import Iterable
from dataclasses import fields, replace
from typing import Any

from mansion_language import Token, tokenize
from mansion_llm.quotes import find_quote
from mansion_planner.brief.facts import BriefFacts, RoomFact, Span
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN
from mansion_planner.brief.reading import FLOOR_WORDS
from mansion_planner.llm.statement_facts import StatementFacts

__all__ = ["joined_facts", "without_rules"]

_UNSPOKEN = frozenset({"size", "setback", "protruding", "unheeded"})
"""What the rules read and no statement of a model can say; it stands wherever its words are."""

_APART = frozenset({"building_name", "building_like", "building_span", "rooms", "unread"})
"""What is joined in a way of its own."""

_RIVALS = {
    "adjacent": ("adjacent", "apart"),
    "apart": ("adjacent", "apart"),
    "building": ("building_type",),
    "outside": ("facade", "roof", "grounds", "room"),
}
"""What runs across words of other statements, and the kinds that say the same.

"kitchen next to the dining room" has the rooms in it, "modern art gallery" the style, "white villa" the walls.
"""

_MOST_TOKENS = 12
"""Tokens of a piece that is reported as not understood."""

_LEAST_WORDS, _LEAST_LETTERS = 3, 12
"""Words, or letters, from which on a piece in another language than English is reported as not understood."""


def _overlap(first: Span, second: Span) -> bool:
    """Whether two pieces of a brief have a character in common."""
    return first.start < second.end and second.start < first.end


def joined_facts(model: StatementFacts, rules: BriefFacts, text: str) -> BriefFacts:
    """Return the model's facts, and those of the rules whose words no statement of the model has.

    A relation between rooms is the rules' also where the model quotes the rooms alone and not what joins them, and the
    kind of the building where it quotes the style alone. Words that neither made a statement of are `unread`.

    Parameters
    ----------
    model : StatementFacts
    rules : BriefFacts
        What the rules' reader reads in the whole text, which must be English.
    """
    lists: dict[str, Any] = {}
    dropped: list[Span] = []
    for name in _names(without=_APART):
        theirs = list(getattr(rules, name))
        open_ = [entry for entry in theirs if name in _UNSPOKEN or _fills_in(name, _span_of(entry), model)]
        lists[name] = [*getattr(model.facts, name), *open_]
        dropped += [_span_of(entry) for entry in theirs if entry not in open_]
    rooms, lost = _joined_rooms(model, rules)
    dropped += lost
    joined = _with_building_name(BriefFacts(**lists, rooms=rooms), model, rules)
    kept = [_span_of(entry) for name in _names() for entry in getattr(joined, name)]
    kept += [child.span for room in joined.rooms for child in room.suite]
    unread = [span for span in model.facts.unread if not any(_overlap(span, other) for other in kept)]
    unread += _left_over(text, rules.unread, dropped, [*model.spans, *model.facts.unread, *kept])
    return _with_named_rooms(replace(joined, unread=unread))


def without_rules(model: StatementFacts, text: str) -> BriefFacts:
    """Return the model's facts of a brief that is not English; longer pieces that it says nothing of are unread."""
    facts = replace(model.facts, unread=list(model.facts.unread))
    held = [*model.spans, *model.facts.unread]
    run: list[re.Match[str]] = []
    for match in [*re.finditer(r"\w+|[.;:!?\n]", text), None]:
        free = match is not None and match[0][:1].isalnum() and not _touched(match.start(), match.end(), held)
        if match is not None and free:
            run.append(match)
        elif run:
            if len(run) >= _LEAST_WORDS or sum(len(word[0]) for word in run) >= _LEAST_LETTERS:
                last = run[:_MOST_TOKENS][-1]
                facts.unread.append(Span(text[run[0].start() : last.end()], run[0].start(), last.end()))
            run = []
    return _with_named_rooms(facts)


def _with_named_rooms(facts: BriefFacts) -> BriefFacts:
    """Return facts in which the rooms that relations and furniture name are wanted, as in a brief that names them."""
    rooms = list(facts.rooms)
    unwanted = {name for name, _ in facts.excluded}
    named = [
        pair for fact in facts.adjacent for pair in ((fact.first_name, fact.first), (fact.second_name, fact.second))
    ]
    spans = [fact.span for fact in facts.adjacent for _ in range(2)]
    named += [(fact.room, fact.room_type) for fact in facts.objects if fact.room and not fact.excluded]
    spans += [fact.span for fact in facts.objects if fact.room and not fact.excluded]
    for (name, kind), span in zip(named, spans):
        every = [part for room in rooms for part in (room, *room.suite)]
        if kind and kind not in unwanted and not any(name == r.name or kind == r.room_type for r in every):
            label = (name or kind).replace("_", " ")
            within = find_quote(span.words, label)
            if within is not None:
                span = Span(span.words[within[0] : within[1]], span.start + within[0], span.start + within[1])
            rooms.append(RoomFact(kind, name or kind, span, label=label))
    return replace(facts, rooms=rooms)


def _span_of(entry: Any) -> Span:
    """Return the words of an entry of a list of `BriefFacts`."""
    if isinstance(entry, Span):
        return entry
    found = entry[-1] if isinstance(entry, tuple) else entry.span
    assert isinstance(found, Span)
    return found


def _names(*, without: Iterable[str] = ("building_name", "unread")) -> list[str]:
    """Return the names of the lists of facts."""
    words = {"building_name", "building_like"}
    return [entry.name for entry in fields(BriefFacts) if entry.name not in without and entry.name not in words]


def _fills_in(name: str, span: Span, model: StatementFacts) -> bool:
    """Whether a statement of the rules stands beside the model's."""
    rivals = _RIVALS.get(name)
    if rivals is None:
        return not any(_overlap(span, other) for other in model.spans)
    if any(kind in rivals and _overlap(span, other) for kind, other in zip(model.kinds, model.spans)):
        return False
    words = [token for token in tokenize(span.words) if token.kind == "word"]
    words = words if "adjacent" in rivals else [token for token in words if _content(token)]
    return not all(_touched(span.start + w.start, span.start + w.end, model.spans) for w in words)


def _joined_rooms(model: StatementFacts, rules: BriefFacts) -> tuple[list[RoomFact], list[Span]]:
    """Return the rooms of both, and the words of the rules' rooms that the model has statements of.

    Private rooms that only the rules read ("each with a bathroom") hang on the model's room of the same words.
    """
    rooms, dropped = list(model.facts.rooms), []
    for fact in rules.rooms:
        suite = tuple(child for child in fact.suite if _fills_in("rooms", child.span, model))
        dropped += [child.span for child in fact.suite if child not in suite]
        if _fills_in("rooms", fact.span, model):
            rooms.append(replace(fact, suite=suite))
            continue
        dropped.append(fact.span)
        owner = next((n for n, room in enumerate(model.facts.rooms) if _overlap(room.span, fact.span)), None)
        if owner is None:
            rooms += suite
        else:
            rooms[owner] = replace(rooms[owner], suite=(*rooms[owner].suite, *suite))
    return rooms, dropped


def _with_building_name(joined: BriefFacts, model: StatementFacts, rules: BriefFacts) -> BriefFacts:
    """Return the facts with the name of an unknown kind of building: the model's, or the rules' where it names none."""
    if not model.facts.building and all(_fills_in("building_span", span, model) for span in rules.building_span):
        return replace(
            joined,
            building_name=rules.building_name,
            building_span=list(rules.building_span),
            building_like=rules.building_like,
        )
    return replace(joined, building_name=model.facts.building_name, building_span=list(model.facts.building_span))


def _left_over(text: str, unread: list[Span], dropped: list[Span], held: list[Span]) -> list[Span]:
    """Return the runs of content words that neither reader made a statement of.

    Parameters
    ----------
    unread : list of Span
        What the rules read nothing from.
    dropped : list of Span
        Words of the rules' statements that the model's took the place of; numbers among them belong to these.
    """
    runs: list[list[Token]] = [[]]
    for token in tokenize(text):
        start, end = token.start, token.end
        said = _touched(start, end, held)
        open_word = _touched(start, end, unread) and not said
        open_word = open_word or (
            _touched(start, end, dropped) and not said and token.kind == "word" and _content(token)
        )
        if open_word:
            runs[-1].append(token)
        elif runs[-1]:
            runs.append([])
    spans = []
    for run in runs:
        if any(_content(token) for token in run):
            last = run[:_MOST_TOKENS][-1]
            spans.append(Span(text[run[0].start : last.end], run[0].start, last.end))
    return spans


def _content(token: Token) -> bool:
    if token.kind == "number":
        return True
    plain = token.text in FUNCTION_WORDS or token.text in PLAIN or token.text in FLOOR_WORDS
    return token.kind == "word" and not plain and len(token.text) > 1


def _touched(start: int, end: int, spans: Iterable[Span]) -> bool:
    return any(span.start < end and start < span.end for span in spans)
