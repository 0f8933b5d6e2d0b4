"""Statements that depend on a condition, and what ``it`` and ``one`` mean in them."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import BE, Word
from mansion_editing.instructions.sentences.conditions import Condition, on_condition, read_answer, read_condition
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Amount, Ask, Mention, Move, Things, When

__all__ = ["Depending"]


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
