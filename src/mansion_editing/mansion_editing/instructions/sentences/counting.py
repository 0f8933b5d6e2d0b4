"""Numbers after a clause: for how many people it is, and that those there are counted."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import PERSONS, Word, next_mark
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.refinement import counting_those_there
from mansion_editing.instructions.statements import Add, Amount, Clear, Ensure, Mention, Place, Statement, Things

__all__ = ["Counting"]

_SEATED: Final = frozenset(
    "who that which are is be sit sits seated sitting eat eats work works meet meets stay stays live lives come comes "
    "usually will always round around at on in it there them here table".split()
)
"""Words that tell where people are whom something is for."""

_ROUND_IT: Final = frozenset("around round at".split())


class Counting(Progress):
    """Reads numbers that follow a clause."""

    def _in_number(self, reader: ClauseReader, at: int) -> int:
        """Read a number after a clause; return its end, 0 for others."""
        counted = self._counts_those_there(reader.words, at)
        if counted:
            self.clause = [counting_those_there(statement) for statement in self.clause]
        return counted or self._for_each_person(reader, at)

    def _counts_those_there(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``, counting the ones already there``; 0 where it is not said."""
        at += words[at].text == ","
        if at >= len(words) or words[at].raw not in ("counting", "including"):
            return 0
        end = next_mark(words, at)
        said = [word.text for word in words[at + 1 : end]]
        those = said[:1] in (["what"], ["those"]) or said[:2] in (["the", "one"], ["the", "existing"])
        return end if those and len(said) <= 6 and {"already", "there", "existing"} & set(said) else 0

    def _for_each_person(self, reader: ClauseReader, at: int) -> int:
        """Read ``for each of the four people who sit around it``: so many of what the clause brings."""
        start = at + (reader.text(at) == ",")
        place = start + 2 + (reader.text(start + 2) == "of")
        place += reader.text(place) in ("the", "our", "my", "these", "those")
        number = reader.words[place] if place < len(reader.words) else None
        if (reader.text(start), reader.text(start + 1)) != ("for", "each") or number is None or number.kind != "number":
            return 0
        if reader.text(place + 1) not in PEOPLE | PERSONS | {"us", "them"} - {"we", "i", "he", "she"}:
            return 0
        end = place + 2
        places, stop = reader.places(end)
        seated = end
        while reader.text(seated) in _SEATED:
            seated += 1
        told = {word.text for word in reader.words[end:seated]}
        where = Place()
        if seated > end and (seated >= len(reader.words) or reader.words[seated].kind == "mark"):
            end = seated
        elif places:
            where, end = joined_places(places)[0], stop
        if not all(isinstance(s, Add | Ensure) and s.things.amount.kind == "some" for s in self.clause):
            return 0
        last = self.statements[-1] if self.statements else None
        if where == Place() and (told & _ROUND_IT or isinstance(last, Clear)):
            it = Things(amount=Amount(number=0), definite=True, refers="last")
            where = last.place if isinstance(last, Clear) else Place(relation="on", anchor=it)
        if not self.clause or any(s.place == Place() and where == Place() for s in self.clause if isinstance(s, Add)):
            return 0
        self.clause = [_times(s, int(number.value), where) for s in self.clause]
        self.statements.append(Mention(quote=self._quote(reader.words, start, end)))
        return end


def _times(statement: Statement, number: int, where: Place) -> Statement:
    """Return a statement that brings so many times as much, to a place where it has none."""
    if not isinstance(statement, Add | Ensure):
        return statement
    amount = Amount(number=max(1, statement.things.amount.number) * number)
    things = msgspec.structs.replace(statement.things, amount=amount, plural=amount.number > 1)
    place = where if statement.place == Place() else statement.place
    return msgspec.structs.replace(statement, things=things, place=place)
