"""Read an instruction with a model, each statement verified against its words; the rules fill the gaps.

A quote that is not in the text, a statement that says other than its quote, and one that contradicts what the rules
read in the same words are asked for again once. What is still wrong then is left out. Its words are the rules' if these
understand them, else not understood. A contradiction that stays is refused with both readings.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final

from mansion_editing.instructions.by_model.accounted_words import AccountedWords
from mansion_editing.instructions.by_model.agreement import agree
from mansion_editing.instructions.by_model.answers import ReadingAnswer, StatementAnswer
from mansion_editing.instructions.by_model.conversion import OTHER, UnusableError, statement_of
from mansion_editing.instructions.by_model.leaves import Leaf, leaves_of
from mansion_editing.instructions.by_model.question import reading_question
from mansion_editing.instructions.by_model.said_words import SaidWords, Span
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Instruction, Mention, Statement
from mansion_editing.state import SceneState
from mansion_llm import Fault, LlmClient
from mansion_llm.quotes import find_quote
from mansion_msgs_py.editing.instructions import ReadStatement

__all__ = ["ModelReading", "read_with_model"]

REPAIRS: Final = 1
"""How often statements with faults are asked for again."""

MOST_STATEMENTS: Final = 60


@dataclass(frozen=True)
class ModelReading:
    """What an instruction says, and who read it.

    Attributes
    ----------
    read : list of ReadStatement
        The statements in words, with their reader.
    open_wishes : tuple of str
        Words that ask for something that no statement can say.
    refusal : str
        How the two readers contradict each other; empty where they do not.
    reason : str
        Why the model's answer was not taken whole; empty where it was.
    """

    instruction: Instruction
    read: list[ReadStatement]
    open_wishes: tuple[str, ...] = ()
    refusal: str = ""
    reason: str = ""


@dataclass(frozen=True)
class _Placed:
    """A statement and where its quote stands; without a statement, words that none can say."""

    statement: Statement | None
    span: Span


@dataclass(frozen=True)
class _Taken:
    """What of a model's answer can be used, and what is wrong with the rest."""

    good: list[_Placed] = field(default_factory=list)
    dropped: list[Span] = field(default_factory=list)
    contradictions: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def read_with_model(client: LlmClient, text: str, state: SceneState) -> ModelReading:
    """Return what an instruction says: the model's reading where it holds, with the rules' where that is silent.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where key, model or address are refused.
    """
    words = SaidWords(text, state)
    rules = read_instruction(text, state)
    known = _known(rules, text) if words.is_english else []
    if not client.wants("reading"):
        return _by_rules(rules, "the settings do not ask the model for readings")

    def check(answer: ReadingAnswer) -> list[Fault]:
        return _taken(answer, words, known).faults

    question = reading_question(text, state)
    answer = client.ask(question, ReadingAnswer, check, array_field="statements", repairs=REPAIRS)
    taken = _taken(answer.value, words, known) if answer.value is not None else _Taken()
    if not taken.good and not taken.contradictions:
        return _by_rules(rules, answer.reason or "the model made no statement")
    return _joined(taken, rules, known, words, answer.reason)


def _by_rules(rules: Instruction, reason: str) -> ModelReading:
    return ModelReading(rules, [_told(statement, "rules") for statement in rules.statements], reason=reason)


def _known(rules: Instruction, text: str) -> list[_Placed]:
    """Return the rules' statements with their places, without background that they did not understand whole."""
    found = [(statement, find_quote(text, statement.quote)) for statement in rules.statements]
    unread = [find_quote(text, piece) for piece in rules.not_understood]
    return [
        _Placed(statement, span)
        for statement, span in found
        if span is not None
        and not (isinstance(statement, Mention) and any(piece is None or _touch(span, piece) for piece in unread))
    ]


def _touch(one: Span, other: Span) -> bool:
    return one[0] < other[1] and other[0] < one[1]


def _taken(answer: ReadingAnswer, words: SaidWords, known: Sequence[_Placed]) -> _Taken:
    """Sort the statements of an answer into those that can be used and faults."""
    taken = _Taken()
    places: dict[str, set[Span]] = {}
    for number, entry in enumerate(answer.statements[:MOST_STATEMENTS], 1):
        try:
            placed = _placed(entry, words, places.setdefault(f"{entry.kind} {entry.quote}", set()))
        except UnusableError as error:
            shown = f"statement {number} ({entry.kind[:20]}, {entry.quote[:60]!r})"
            taken.faults.append(Fault(f"{shown}: {error}", str(number)))
            taken.dropped.extend(span for span in [find_quote(words.text, entry.quote)] if span is not None)
        else:
            taken.good.append(placed)
    accounted = AccountedWords(words, _with_statements(taken.good))
    for placed in list(taken.good):
        left = accounted.left(placed.span) if placed.statement is not None else []
        if left:
            quote = words.text[slice(*placed.span)]
            said = f"the statement does not say {', '.join(map(repr, left))} of its quote {quote[:60]!r}"
            taken.faults.append(Fault(said))
            taken.good.remove(placed)
            taken.dropped.append(placed.span)
    if len(answer.statements) > MOST_STATEMENTS:
        taken.faults.append(Fault(f"{len(answer.statements)} statements are too many; at most {MOST_STATEMENTS}"))
    for reason in _contradictions(taken.good, known, words):
        taken.contradictions.append(reason)
        taken.faults.append(Fault(reason))
    return taken


def _with_statements(placed: Sequence[_Placed]) -> list[tuple[Statement, Span]]:
    return [(one.statement, one.span) for one in placed if one.statement is not None]


def _placed(entry: StatementAnswer, words: SaidWords, places: set[Span]) -> _Placed:
    span = find_quote(words.text, entry.quote, places)
    if span is None:
        raise UnusableError("the quote is not in the instruction; repeat its words letter by letter")
    places.add(span)
    if entry.kind == OTHER:
        return _Placed(None, span)
    statement = statement_of(entry, words.text[slice(*span)])
    fault = words.fault(statement, span)
    if fault:
        raise UnusableError(fault)
    return _Placed(statement, span)


def _contradictions(model: Sequence[_Placed], rules: Sequence[_Placed], words: SaidWords) -> list[str]:
    """Return where the two readers differ on the same words, in sentences."""
    out = []
    for ours in rules:
        if isinstance(ours.statement, Mention) or ours.statement is None:
            continue
        there = [one for one in model if _touch(one.span, ours.span) and one.statement is not None]
        if there and not any(agree(ours.statement, one.statement, words.same_kind) for one in there if one.statement):
            out.append(_difference(ours, there[0]))
    for theirs in model:
        there = [one for one in rules if _touch(one.span, theirs.span) and not isinstance(one.statement, Mention)]
        if theirs.statement is None or isinstance(theirs.statement, Mention) or not there:
            continue
        if not any(agree(one.statement, theirs.statement, words.same_kind) for one in there if one.statement):
            out.append(_difference(there[0], theirs))
    return list(dict.fromkeys(out))


def _difference(ours: _Placed, theirs: _Placed) -> str:
    quote = "" if ours.statement is None else ours.statement.quote
    return f"{quote!r} can be read in two ways: {_name(ours)} by the rules, {_name(theirs)} by the model"


def _name(placed: _Placed) -> str:
    statement = placed.statement
    if statement is None or isinstance(statement, Mention):
        return "nothing to be done"
    parts = [_shown(leaf) for leaf in leaves_of(statement)[:8]]
    return f"{_KINDS.get(type(statement).__name__, type(statement).__name__.lower())} ({', '.join(parts)})"


_KINDS: Final = {"SetState": "open or switch", "Ensure": "have", "Reach": "get to"}


def _shown(leaf: Leaf) -> str:
    if isinstance(leaf.value, bool):
        return f"{leaf.part}: {'yes' if leaf.value else 'no'}"
    return f"{leaf.value:g}" if isinstance(leaf.value, float) else leaf.value


def _joined(taken: _Taken, rules: Instruction, known: Sequence[_Placed], words: SaidWords, reason: str) -> ModelReading:
    """Join the model's statements with those of the rules on other words, in the order of the text."""
    held = [one.span for one in taken.good if one.statement is not None]
    filled = [one for one in known if not any(_touch(one.span, span) for span in held)]
    open_wishes = [
        one.span
        for one in taken.good
        if one.statement is None and not any(_touch(one.span, other.span) for other in filled)
    ]
    mine = [(one.span, one.statement, "model") for one in taken.good if one.statement is not None]
    theirs = [(one.span, one.statement, "rules") for one in filled if one.statement is not None]
    ordered = sorted([*mine, *theirs], key=lambda entry: entry[0])
    accounted = AccountedWords(words, [(statement, span) for span, statement, _ in ordered])
    instruction = Instruction(
        statements=[statement for _, statement, _ in ordered],
        not_understood=list(dict.fromkeys([*_lost(taken, ordered, words), *accounted.uncovered(open_wishes)])),
        ignored=rules.ignored,
    )
    return ModelReading(
        instruction,
        [_told(statement, reader) for _, statement, reader in ordered],
        tuple(words.text[slice(*span)] for span in open_wishes),
        "; ".join(taken.contradictions),
        reason,
    )


def _lost(taken: _Taken, ordered: Sequence[tuple[Span, Statement, str]], words: SaidWords) -> list[str]:
    """Return the words of statements that were left out and that no other one is about: an aside may cover them."""
    told = [span for span, statement, _ in ordered if not isinstance(statement, Mention)]
    return [words.text[slice(*lost)] for lost in taken.dropped if not any(_touch(lost, span) for span in told)]


def _told(statement: Statement, reader: str) -> ReadStatement:
    return ReadStatement(
        kind=type(statement).__name__, quote=statement.quote, read_by="model" if reader == "model" else "rules"
    )
