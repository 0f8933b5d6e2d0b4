"""Sentences that only repeat an earlier instruction: elsewhere, or with more."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.phrases.words import BE, MODALS, Word
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import History, Mention, Place, Reach, Rooms

__all__ = ["Repeating"]

_BLOCKING: Final = frozenset("block blocks blocking obstruct obstructs obstructing hinder hinders".split())
_BLOCKED: Final = (("it",), ("that",), ("the", "way"), ("the", "path"), ("the", "route"), ("its", "way"),
                   ("the", "robot"), ("this", "way"), ("that", "way"))  # fmt: skip
_IN_THE_WAY: Final = (("in", "the", "way"), ("in", "its", "way"), ("stand", "in", "the", "way"))


class Repeating(Progress):
    """Reads ``and in the bedroom too`` and ``one more``."""

    def _repeats(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        """Read what only repeats an earlier instruction: ``and in the bedroom too``, ``the same upstairs``."""
        if self.statements:
            return self._frees_way(reader, words, at)
        if reader.text(at) in ("same", "likewise", "ditto") or (
            reader.text(at) == "the" and reader.text(at + 1) == "same"
        ):
            at += 1 + (reader.text(at) == "the")
            at += reader.text(at) in ("thing", "again")
            if reader.text(at) == "for":
                return self._repeats_for(reader, words, at + 1)
        elif not (
            words[0].text in ("and", "also", "now", "then") or "too" in (words[-1].text, reader.text(len(words) - 2))
        ):
            return self._one_more(reader, words, at)
        places, end = reader.places(at)
        if not places or reader.skip(end) < len(words):
            return self._one_more(reader, words, at)
        place = places[0].place
        for read in places[1:]:
            place = merged(place, read.place)
        self.statements.append(History(what="repeat", place=place, quote=self._quote(words, 0, len(words))))
        return True

    def _repeats_for(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        quote = self._quote(words, 0, len(words))
        if tuple(w.text for w in words[at : at + 3]) in (("the", "next", "room"), ("the", "next", "one")):
            place = Place(rooms=Rooms(next_to="room", same=True))
            self.statements.append(History(what="repeat", place=place, quote=quote))
            return True
        item = reader.item(at)
        if item is None or reader.skip(item.end) < len(words):
            return False
        if item.phrase.noun.kind in ("room", "both"):
            self.statements.append(History(what="repeat", place=Place(rooms=item.rooms()), quote=quote))
        else:
            self.statements.append(History(what="repeat", things=item.things(), quote=quote))
        return True

    def _one_more(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        phrase = reader.phrase(at)
        bare = phrase is not None and phrase.refers == "last" and phrase.amount.kind == "more"
        if phrase is None or not bare or reader.skip(phrase.end) < len(words):
            return False
        quote = self._quote(words, 0, len(words))
        self.statements.append(History(what="repeat", things=phrase.things(), quote=quote))
        return True

    def _frees_way(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        """Read ``make sure nothing blocks it`` after a way was asked for, which is then checked again."""
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        texts = [word.text for word in words[at:]]
        if texts[:1] in (["make"], ["be"]) and texts[1:2] == ["sure"]:
            texts = texts[2:]
        elif texts[:1] == ["ensure"]:
            texts = texts[1:]
        texts = texts[1:] if texts[:1] == ["that"] else texts
        if not isinstance(last, Reach) or texts[:1] != ["nothing"]:
            return False
        rest = [word for word in texts[1:] if word not in MODALS and word not in BE]
        verb = len(rest) > 1 and rest[0] in _BLOCKING and tuple(rest[1:]) in _BLOCKED
        if not verb and tuple(rest) not in _IN_THE_WAY:
            return False
        self.statements.append(msgspec.structs.replace(last, quote=self._quote(words, at, len(words))))
        return True
