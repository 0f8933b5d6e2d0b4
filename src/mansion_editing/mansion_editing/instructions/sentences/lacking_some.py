"""Some of several that lack something and are each given one: ``Two of the desks have no lamp. Give them one``."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import COURTESIES, Word
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Amount, Ensure, Mention, Place, Relation, Things

__all__ = ["LackingSome"]

_GIVING: Final = frozenset("put add give place provide bring set supply install get equip stand lay".split())
_ONE: Final = frozenset("one a an".split())
_THOSE: Final = frozenset("each both them those these".split())
_OF_GIVING: Final = _GIVING | _ONE | _THOSE | frozenset("on to in at for with of the all too also there".split())
"""Words of ``put one on each of those``, besides the name of what is given."""
_STILL: Final = frozenset("still currently yet now".split())


@dataclass(frozen=True)
class _Lack:
    """What so many of several have not."""

    things: Things
    place: Place
    number: int


class LackingSome(Progress):
    """Reads what some of several lack, and that they get it."""

    def _gives_what_some_lack(self, words: Sequence[Word], later: Sequence[Word]) -> bool:
        """Read a sentence that tells what some lack, or that they are given it; or both."""
        if self.given_later:
            self.given_later = False
            return True
        cuts = [at for at, word in enumerate(words) if word.text in (",", "-", "so", "and")]
        for at in (*cuts, len(words)):
            rest = [word for word in words[at:] if _matters(word)]
            lack = self._told_lack(words[:at])
            giving = rest or [word for word in later if _matters(word)]
            if lack is None or not _gives_one_each(giving, lack):
                continue
            self.given_later = not rest
            self.statements.append(Mention(quote=self._quote(words, 0, at)))
            quote = self._quote(giving, 0, len(giving))
            each = Ensure(things=lack.things, place=lack.place, each=True, lacking=lack.number, quote=quote)
            self.statements.append(each)
            return True
        return False

    def _told_lack(self, words: Sequence[Word]) -> _Lack | None:
        """Read ``two of the desks in the office have no monitor`` to its end."""
        reader = ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))
        holders = reader.item(reader.skip(0)) if words else None
        if holders is None or holders.is_room or not holders.phrase.plural or holders.phrase.definite:
            return None
        place = self._after_verb(reader, holders.end)
        lacking = reader.item(place, places=False) if place else None
        ends = lacking is not None and all(word.text in _STILL for word in words[lacking.end :])
        if lacking is None or not ends or lacking.is_room or lacking.phrase.noun.kind != "object":
            return None
        things = Things(noun=lacking.phrase.things().noun, colour=lacking.phrase.noun.colour)
        relation: Relation = "beside" if self.lexicon.stands(lacking.phrase.noun.words) else "on"
        whole = msgspec.structs.replace(
            holders.phrase.things(), amount=Amount(kind="all", number=0), definite=True, plural=True, each=True
        )
        where, _ = joined_places(list(holders.places))
        if where.anchor is not None or holders.phrase.amount.kind != "some" or things.colour:
            return None
        return _Lack(things, Place(relation=relation, anchor=whole, rooms=where.rooms), holders.phrase.amount.number)

    def _after_verb(self, reader: ClauseReader, at: int) -> int:
        """Return the place after ``have no``, ``lack a``, ``are without a``; 0 for other verbs."""
        while reader.text(at) in _STILL:
            at += 1
        said = (reader.text(at), reader.text(at + 1))
        if reader.text(at) == "lack":
            return at + 1
        if said in (("is", "without"), ("are", "without"), ("is", "missing"), ("are", "missing")):
            return at + 2
        negated = said == ("have", "no") or said == ("have", "not") or said == ("do", "not")
        end = at + 2
        while negated and reader.text(end) in ("have", "got", "get", "any", "a", "an"):
            end += 1
        return end if negated else 0


def _matters(word: Word) -> bool:
    return word.kind != "mark" and word.text not in COURTESIES | {"so", "and"}


def _gives_one_each(words: Sequence[Word], lack: _Lack) -> bool:
    """Whether all the words only say that those get one each: ``put one on each of those``."""
    texts = [word.text for word in words]
    noun = lack.things.noun.split()
    rest = [text for text in texts if text not in _OF_GIVING and text not in noun]
    told = texts[:1] != [] and texts[0] in _GIVING and not rest
    return told and bool({*texts} & _ONE) and bool({*texts} & _THOSE)
