"""Numbers that end a clause: ``until only two are left``, for how many people it is, that those there are counted."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import PERSONS, Word, next_mark, text_at
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.refinement import counting_those_there
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Clear,
    Ensure,
    Mention,
    Move,
    Place,
    Remove,
    Statement,
    Things,
)

__all__ = ["Counting", "EndingNumbers"]

_BEING_LEFT: Final = frozenset("until there are is only just left remain of them".split())
"""Words of ``until there are only two of them left``, besides the number."""


class EndingNumbers(Progress):
    """Reads a number after a clause that tells how many are meant in all."""

    def _end_of_limit(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``, no more``, ``, not four``, by which a number is meant exactly; 0 for others."""
        if self._denies_number(words, at):
            return at + 3
        start = at + (words[at].text in (",", "and"))
        said = tuple(word.text for word in words[start : start + 3])
        if said == ("not", "one", "more"):
            return start + 3
        return start + 2 if said[:1] in (("no",), ("not",)) and said[1:2] in (("more",), ("less",), ("fewer",)) else 0

    def _denies_number(self, words: Sequence[Word], at: int) -> bool:
        """Whether ``, not four`` ends a clause about another number that shall be there, which is meant exactly."""
        if [word.text for word in words[at : at + 2]] != [",", "not"] or at + 2 >= len(words):
            return False
        number = words[at + 2]
        ends = at + 3 >= len(words) or words[at + 3].kind == "mark"
        brought = [s for s in self.clause if isinstance(s, Add | Ensure)]
        counted = [s.things.amount for s in brought if s.things.amount.kind == "some"]
        other = len(counted) == len(self.clause) == 1 and counted[0].number not in (0, number.value)
        return number.kind == "number" and ends and other

    def _until_so_many_are_left(self, words: Sequence[Word], at: int) -> int:
        """Read ``until only two are left`` after things that go or move: all but so many of them do."""
        end = next_mark(words, at)
        numbers = [word for word in words[at:end] if word.kind == "number"]
        said = {word.text for word in words[at:end]} - {word.text for word in numbers}
        done = [s for s in self.clause if isinstance(s, Remove | Move)]
        all_of_them = len(done) == len(self.clause) == 1 and done[0].things.plural and done[0].things.definite
        if text_at(words, at) != "until" or len(numbers) != 1 or not said <= _BEING_LEFT or not all_of_them:
            return 0
        if not said & {"left", "remain", "there"} or done[0].things.amount.kind not in ("all", "some"):
            return 0
        left = Amount(kind="all_but", number=int(numbers[0].value))
        things = msgspec.structs.replace(done[0].things, amount=left)
        quote = done[0].quote + self.text[words[at - 1].end : words[end - 1].end]
        self.clause = [msgspec.structs.replace(done[0], things=things, quote=quote)]
        return end

    def _so_that_so_many_are_there(self, words: Sequence[Word], at: int) -> int:
        """Read ``so that there are three`` after what is brought, which then are three with those there."""
        start = at + (words[at].text == ",")
        said = [word.text for word in words[start : start + 5]]
        there = 1 + (said[1:2] == ["that"])
        if said[:1] != ["so"] or said[there : there + 2] not in (["there", "are"], ["we", "have"], ["it", "has"]):
            return 0
        number = start + there + 2
        brought = [s for s in self.clause if isinstance(s, Add | Ensure)]
        if len(brought) != 1 or len(self.clause) != 1 or number >= len(words) or words[number].kind != "number":
            return 0
        end = number + 1
        while text_at(words, end) in ("of", "them", "in", "all", "total", "altogether", "there"):
            end += 1
        if not (end >= len(words) or words[end].kind == "mark") or brought[0].each:
            return 0
        amount = Amount(kind="exactly", number=int(words[number].value))
        things = msgspec.structs.replace(brought[0].things, amount=amount)
        quote = brought[0].quote + self.text[words[at - 1].end : words[end - 1].end]
        self.clause = [Ensure(things=things, place=brought[0].place, quote=quote)]
        return end


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
