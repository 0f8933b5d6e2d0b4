"""Numbers that end a clause: ``, no more``, ``until only two are left``, ``so that there are six``."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.phrases.words import Word, next_mark, text_at
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Add, Amount, Ensure, Move, Remove

__all__ = ["EndingNumbers"]

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
