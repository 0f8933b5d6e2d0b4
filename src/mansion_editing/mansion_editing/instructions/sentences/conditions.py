"""Conditions, ``if there is no plant in the kitchen``, ``unless it is on``, and the statements that depend on them."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.phrases.words import BE, STATE_WORDS, Word
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ask,
    Ensure,
    Mention,
    Move,
    Place,
    Statement,
    Things,
    When,
)

__all__ = ["Condition", "Depending", "begins_condition", "else_at", "on_condition", "read_answer", "read_condition"]

_BEFORE: Final = frozenset("only but and just".split())
_BETWEEN: Final = frozenset("already still currently yet really now switched turned".split())
_AFTER: Final = frozenset("yet there already so far still , then at all right now in it inside".split())


class Condition(msgspec.Struct, frozen=True):
    """What must be so, or must not.

    Attributes
    ----------
    ask : Ask, optional
        The question; None where the condition is only that what a clause brings is not there yet.
    holds : bool
        The answer that lets the clause be carried out.
    """

    ask: Ask | None
    holds: bool


def begins_condition(words: Sequence[Word], at: int) -> int:
    """Return the place after ``if``, ``only if``, ``unless``, ``in case``; 0 where there is none."""
    place = at
    while place < len(words) and words[place].text in _BEFORE:
        place += 1
    if place < len(words) and words[place].text in ("if", "unless"):
        return place + 1
    pair = tuple(w.text for w in words[place : place + 2])
    return place + 2 if pair in (("in", "case"), ("provided", "that"), ("as", "long")) else 0


def else_at(words: Sequence[Word]) -> tuple[int, int] | None:
    """Return where a conditional sentence says what is to be done otherwise: the end before it, and its first word."""
    texts = [word.text for word in words]
    if not {"if", "unless"} & set(texts[:4]):
        return None
    for at in range(2, len(texts) - 1):
        said = texts[at] == "otherwise" or (texts[at] == "else" and texts[at - 1] in (",", "or"))
        if not said:
            continue
        end = at
        while texts[end - 1] in (",", "or", "and"):
            end -= 1
        return end, at + 1 + (texts[at + 1] == ",")
    return None


def read_answer(words: Sequence[Word], at: int) -> tuple[bool, int] | None:
    """Read ``if so``, ``if it is not``, ``if there is none`` after a question; None where the words say more.

    Returns
    -------
    holds : bool
        The answer to the question that lets the clause be carried out.
    end : int
    """
    if at >= len(words) or words[at].text != "if":
        return None
    end = at + 1
    while end < len(words) and words[end].text in _OF_ANSWERS:
        end += 1
    said = [w.text for w in words[at + 1 : end]]
    ends = end >= len(words) or words[end].text in (",", "then", "please")
    if not said or not (ends or said in (["not"], ["so"])):
        return None
    return not set(said) & _DENIALS, end + (end < len(words) and words[end].text in (",", "then"))


_DENIALS: Final = frozenset("not no none".split())
_OF_ANSWERS: Final = _DENIALS | frozenset(
    "so yes it they there that this is are do does has have one any the case true yet already left more anymore".split()
)


def read_condition(reader: ClauseReader, at: int, last: Things | None) -> tuple[Condition, int] | None:
    """Read the condition that begins at a place; None where it is not understood.

    Parameters
    ----------
    last : Things, optional
        What the clause before brought, which ``one`` and ``it`` mean.
    """
    place = begins_condition(reader.words, at)
    if not place:
        return None
    denied = any(w.text == "unless" for w in reader.words[at:place])
    found = _existing(reader, place, last) or _elliptic(reader, place) or _of_subject(reader, place, last)
    if found is None:
        return None
    condition, end = found
    while reader.text(end) in _AFTER and not (reader.text(end) == "," and reader.starts_clause(reader.skip(end))):
        end += 1
    end += reader.text(end) == ","
    return Condition(condition.ask, condition.holds != denied), end


def on_condition(statement: Statement, condition: Condition) -> Statement:
    """Return a statement that is carried out only where a condition holds."""
    same = condition.ask is not None and isinstance(statement, Add) and _is_about(condition.ask, statement)
    if condition.ask is None or (same and not condition.holds):
        if isinstance(statement, Add) and not (condition.ask is None and condition.holds):
            return Ensure(things=statement.things, place=statement.place, each=statement.each, quote=statement.quote)
        return statement
    return When(ask=condition.ask, holds=condition.holds, then=statement, quote=statement.quote)


def _is_about(ask: Ask, statement: Add) -> bool:
    things = ask.things
    if things is None or things.amount.kind != "all":
        return False
    return ask.about == "exists" and things.noun == statement.things.noun and ask.place is None


def _elliptic(reader: ClauseReader, at: int) -> tuple[Condition, int] | None:
    """Read ``if it hasn't``, ``if not already there``, ``if needed``, ``if missing``."""
    texts = [w.text for w in reader.words[at:]]
    for words, holds in _SHORT:
        if tuple(texts[: len(words)]) == words and (len(texts) == len(words) or not texts[len(words)].isalpha()):
            return Condition(None, holds), at + len(words)
    return None


_LACKING = (
    "not|missing|needed|necessary|required|not there|not already there|it is missing|it has not|it have not|it not|"
    "they not|it is not there|it is not already there|they are not there|not there yet|it do not|it does not|"
    "not already present|not yet there"
)
_PRESENT = "it has|it is already there"
_SHORT: Final = tuple(
    (tuple(words.split()), holds)
    for group, holds in ((_LACKING, False), (_PRESENT, True))
    for words in group.split("|")
)
"""Conditions without a noun, and whether what is meant is there then."""


def _existing(reader: ClauseReader, at: int, last: Things | None) -> tuple[Condition, int] | None:
    """Read ``there is no plant in the kitchen``, ``there is not one yet``."""
    if reader.text(at) != "there" and reader.words[at : at + 1] and reader.words[at].raw not in ("there's", "theres"):
        return None
    place = at + 1
    denied = False
    while reader.text(place) in BE or reader.text(place) in (*_BETWEEN, "not"):
        denied = denied or reader.text(place) == "not"
        place += 1
    quantified = reader.item(place, places=False) if reader.text(place) in ("any", "some") else None
    bare = quantified is None or not quantified.phrase.noun.words
    if bare and reader.text(place) in ("one", "none", "any", "some"):
        holds = reader.text(place) != "none" and not denied
        where, end = reader.places(_past(reader, place + 1))
        if where and last is not None:
            ask = Ask(about="exists", things=_any(last), place=joined_places(where)[0])
            return Condition(ask, holds), end
        return Condition(None, holds), end
    item = reader.item(place)
    if item is None:
        return None
    denied = denied or item.phrase.amount.kind == "none"
    return Condition(_exists(item, item.things().place), not denied), item.end


def _of_subject(reader: ClauseReader, at: int, last: Things | None) -> tuple[Condition, int] | None:
    """Read ``the microwave is off``, ``the kitchen has no plant``, ``it already has one``."""
    item = reader.item(at)
    if item is None:
        return None
    place = item.end
    denied = False
    verb = ""
    while reader.text(place) in BE or reader.text(place) in (
        *_BETWEEN,
        "not",
        "do",
        "does",
        "has",
        "have",
        "contain",
        "got",
        "hold",
    ):
        denied = denied or reader.text(place) == "not"
        verb = "have" if reader.text(place) in ("has", "have", "contain", "got", "hold") else verb or "be"
        place += 1
    if place == item.end:
        return None
    things = last if item.phrase.refers == "last" and last is not None else item.things()
    if verb == "have":
        return _having(reader, item, place, last, denied=denied)
    lies = reader.text(place) in ("on", "off") and reader.phrase(place + 1) is not None
    if reader.text(place) in STATE_WORDS and not lies:
        name, value = STATE_WORDS[reader.text(place)]
        plain = msgspec.structs.replace(things, amount=Amount(kind="all", number=0), place=None)
        ask = Ask(
            about="state", things=plain, place=things.place, state="open" if name == "open" else "on", value=value
        )
        return Condition(ask, not denied), place + 1
    where, end = reader.places(place)
    if not where:
        return None
    own = things.place
    goal = joined_places(where)[0]
    ask = Ask(about="exists", things=_any(things), place=goal if own is None else merged(goal, own))
    return Condition(ask, not denied), end


def _having(
    reader: ClauseReader, item: Item, at: int, last: Things | None, *, denied: bool
) -> tuple[Condition, int] | None:
    if reader.text(at) in ("one", "none", "any", "some"):
        holds = reader.text(at) != "none" and not denied
        if item.phrase.refers == "last" or last is None:
            return Condition(None, holds), at + 1
        holder = Place(rooms=item.rooms()) if item.is_room else Place(relation="on", anchor=item.phrase.things())
        return Condition(Ask(about="exists", things=_any(last), place=holder), holds), at + 1
    thing = reader.item(at)
    if thing is None or item.phrase.refers == "last":
        return None
    holder = Place(rooms=item.rooms()) if item.is_room else Place(relation="on", anchor=item.phrase.things())
    denied = denied or thing.phrase.amount.kind == "none"
    own = thing.things().place
    return Condition(_exists(thing, holder if own is None else merged(own, holder)), not denied), thing.end


def _exists(item: Item, place: Place | None) -> Ask:
    return Ask(about="exists", things=_any(item.phrase.things()), place=place)


def _any(things: Things) -> Things:
    counted = things.amount.kind in ("at_most", "exactly")
    number = things.amount.number if things.amount.kind in ("some", "at_least") else 0
    amount = Amount(kind="all", number=0) if number < 2 and not counted else things.amount
    return msgspec.structs.replace(things, amount=amount, definite=False, place=None)


def _past(reader: ClauseReader, at: int) -> int:
    while reader.text(at) in ("yet", "already", "of", "them"):
        at += 1
    return at


class Depending(Progress):
    """Reads conditions before clauses, and lets the clauses depend on them."""

    def _topic_where(self, condition: Condition) -> Things | None:
        """Return what ``it`` and ``one`` mean where a condition holds: what is missing is a new thing."""
        topic = None if condition.ask is None else self._asked_for(condition.ask)
        missing = condition.ask is not None and condition.ask.about == "exists" and not condition.holds
        return msgspec.structs.replace(topic, definite=False) if topic is not None and missing else topic

    def _read_condition(self, reader: ClauseReader, words: Sequence[Word], at: int) -> tuple[int, Condition | None]:
        """Read ``if the lamp is off,`` before a clause; of a question before it, ``if not,``."""
        asked = self.statements[-1] if self.statements else None
        start = at - 1 if at and words[at - 1].text in ("only", "but", "so") else at
        answer = read_answer(words, at) if isinstance(asked, Ask) and asked.about in ("exists", "state") else None
        if isinstance(asked, Ask) and answer is not None:
            self.statements[-1] = Mention(quote=asked.quote)
            self.topic = self._topic_where(Condition(asked, answer[0]))
            return answer[1], Condition(asked, answer[0])
        answer = read_answer(words, at) if isinstance(asked, When) else None
        if isinstance(asked, When) and answer is not None:
            condition = Condition(asked.ask, asked.holds == answer[0])
            self.topic = self._topic_where(condition)
            if self.topic is not None and isinstance(asked.then, Move):  # "there" is where it would have gone
                self.topic = msgspec.structs.replace(self.topic, place=asked.then.place)
            return answer[1], condition
        found = read_condition(reader, start, None)
        if found is None or found[0].ask is None or found[1] >= len(words):
            return at, None
        condition, end = found
        things = condition.ask.things if condition.ask is not None else None
        if things is not None and condition.ask is not None:
            noun = reader.phrase_of(things.noun)
            reader.last_noun = noun or reader.last_noun
            whole = condition.ask.about == "exists" and condition.holds and _is_mass(words[start:end], things.noun)
            self.topic = msgspec.structs.replace(
                things,
                place=condition.ask.place or things.place,
                amount=Amount(kind="all", number=0) if whole else Amount(number=1),
                definite=condition.holds,
                plural=things.plural or whole,
            )
        return end, condition

    def _depend(self, condition: Condition, first: int, quote: str) -> None:
        """Let the statements from a place on depend on a condition."""
        for at in range(first, len(self.statements)):
            statement = self.statements[at]
            if not isinstance(statement, Mention):
                told = statement if quote == "" else msgspec.structs.replace(statement, quote=quote)
                self.statements[at] = on_condition(told, condition)

    def _asked_for(self, ask: Ask) -> Things | None:
        """Return what a question was about, which ``it`` means in what comes next."""
        if ask.things is None:
            return None
        number = max(1, ask.things.amount.number)
        one = ask.things.amount.kind != "all" or not ask.things.plural
        amount = Amount(number=number) if one else Amount(kind="all", number=0)
        return msgspec.structs.replace(
            ask.things, place=ask.place or ask.things.place, amount=amount, definite=True, plural=not one
        )


def _is_mass(words: Sequence[Word], noun: str) -> bool:
    """Whether a noun stands without an article or a number: ``if there is cheese, throw it away`` means all of it."""
    texts = [word.text for word in words]
    first = noun.split()
    at = next((k for k in range(1, len(texts)) if texts[k : k + len(first)] == first), 0)
    before = words[at - 1] if at else None
    plain = before is not None and (before.text in BE | {"any", "some", "still"} or before.raw in ("there's", "theres"))
    return plain and not words[at + len(first) - 1].plural
