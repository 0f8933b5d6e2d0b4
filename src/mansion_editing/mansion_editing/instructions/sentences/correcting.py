"""What somebody says instead of what was said just before: ``on the table, no wait, on the dresser``."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import Word
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Add, Ensure, Mention, Move, Place, Rooms, Statement

__all__ = ["Correcting"]

_TAKING_BACK: Final = frozenset("no nope wait sorry oops actually".split())
_AROUND: Final = _TAKING_BACK | frozenset("hm hmm rather , - please hang".split())
_INSTEAD: Final = (
    ("make", "that"), ("make", "it"), ("i", "mean"), ("i", "meant"), ("we", "meant"), ("i", "meant", "to", "say"),
)  # fmt: skip
_ENDS: Final = frozenset("please instead then".split())


class Correcting(Progress):
    """Puts another place for the one that was named just before."""

    def _corrected(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read a correction of the last place; return its end, 0 where the words are none."""
        end = at
        while end < len(words) and words[end].raw in _AROUND:
            end += 1
        if not _TAKING_BACK & {word.raw for word in words[at:end]}:
            return 0
        said = next((s for s in sorted(_INSTEAD, key=len, reverse=True) if _says(words, end, s)), ())
        end += len(said)
        start = end
        place, end = self._other_place(reader, end, named=bool(said))
        ends = end >= len(words) or words[end].kind == "mark" or reader.text(end) in _ENDS
        last = self.statements[-1] if self.statements else None
        if place is None or not ends or not isinstance(last, Add | Ensure | Move):
            return 0
        if isinstance(last, Add | Ensure) and last.each:
            return 0
        quote = self._quote(words, start, end)
        self.statements[-1:] = [Mention(quote=last.quote), _placed(last, place, quote)]
        return end

    def _other_place(self, reader: ClauseReader, at: int, *, named: bool) -> tuple[Place | None, int]:
        """Read ``on the dresser``, or ``the dresser`` where `named` words say that it comes instead."""
        places, end = reader.places(at)
        if places and not any(read.source or read.each for read in places):
            return joined_places(places)[0], end
        item = reader.item(at) if named else None
        if item is None or not (item.phrase.definite or item.is_room) or item.phrase.refers:
            return None, at
        if item.is_room:
            return Place(rooms=item.rooms()), item.end
        rooms = joined_places(list(item.places))[0].rooms
        return Place(anchor=item.phrase.things(), rooms=rooms), item.end


def _says(words: Sequence[Word], at: int, said: tuple[str, ...]) -> bool:
    return tuple(word.text for word in words[at : at + len(said)]) == said


def _placed(statement: Add | Ensure | Move, place: Place, quote: str) -> Statement:
    """Return a statement at another place, in the room of the first one where the other names none."""
    first = statement.place
    if place.anchor is None and not place.spot and first.anchor is not None:
        return msgspec.structs.replace(statement, place=msgspec.structs.replace(first, rooms=place.rooms), quote=quote)
    rooms = first.rooms if place.rooms in (None, Rooms(same=True)) else place.rooms
    relation = place.relation or first.relation
    return msgspec.structs.replace(
        statement, place=msgspec.structs.replace(place, relation=relation, rooms=rooms), quote=quote
    )
