"""Objects that stand before who shall do something with them: ``the mugs you can take away``."""

from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item
from mansion_editing.instructions.clauses.sentence import Sentence
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import ANY_LONGER, BEFORE_REQUESTS
from mansion_editing.instructions.phrases.words import MODALS, Word
from mansion_editing.instructions.statements import Keep, Remove, Statement, Things

__all__ = ["Fronting"]

_PEOPLE: Final = frozenset("i we you she he they".split())
_KEEPING: Final = frozenset("keep need use".split())
_BETWEEN: Final = frozenset("do still also just really definitely".split())


class Fronting(Sentence):
    """Reads an object before the subject of its clause."""

    def _fronted_object(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the blocks she may keep``, ``the board we don't need any more``, ``the rug you can roll up``."""
        item = self.item(at)
        if item is None or item.is_room or not item.phrase.definite or item.phrase.refers:
            return None
        if not (item.phrase.noun.words or item.places):
            return None
        verb = verb_at(self.words, item.end + 1, self.lexicon) if self.text(item.end) == "please" else None
        if verb is not None and self.phrase(verb[1]) is None:
            return self._done_with(item, at, item.end + 1)
        if self.text(item.end) not in _PEOPLE:
            return None
        place = item.end + 1
        said: set[str] = set()
        while self.text(place) in MODALS | BEFORE_REQUESTS | _BETWEEN | {"not"}:
            said.add(self.text(place))
            place += 1
        denied = "not" in said or self.words[item.end].raw.endswith("n't")
        if self.text(place) in _KEEPING:
            return self._kept_or_not(item, at, place, denied=denied)
        if self.text(item.end) != "you" or denied or not said & (MODALS | {"please"}):
            return None
        return self._done_with(item, at, place)

    def _kept_or_not(self, item: Item, at: int, verb: int, *, denied: bool) -> tuple[list[Statement], int] | None:
        end = verb + 1
        end += self.text(end) in ("it", "them")
        while self.text(end) in ANY_LONGER:
            end += 1
        if end < len(self.words) and self.words[end].kind != "mark" and self.text(end) not in ("and", "but", "so"):
            return None
        quote = self.quote(at, end)
        if not denied:
            return [Keep(things=self._all(item.things()), quote=quote)], end
        if self.text(verb) == "keep":
            return None
        return [Remove(things=self._all_if_plural(item.things()), quote=quote)], end

    def _done_with(self, item: Item, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read what is to be done with an object that stands before the verb as if a pronoun stood after it."""
        verb = verb_at(self.words, place, self.lexicon)
        if verb is None:
            return None
        joint = verb[1]
        where = self.words[joint - 1].end
        pronoun = Word("them" if item.phrase.plural else "it", "", "word", where, where)

        def quote(start: int, end: int) -> str:
            return self.quote(start - (start > joint), end - (end > joint))

        words = [*self.words[:joint], pronoun, *self.words[joint:]]
        inner = type(self)(words, self.lexicon, self.floors, quote)
        inner.frame = self.frame
        found, end = inner.read(place)
        things = self._all_if_plural(item.things())
        whole = self.quote(at, end - 1)
        out = [_about(statement, things, whole) for statement in found]
        return None if any(one is None for one in out) else ([one for one in out if one is not None], end - 1)


def _about(statement: Statement, things: Things, quote: str) -> Statement | None:
    """Return a statement about things where it is about what its pronoun means; None for others."""
    own = getattr(statement, "things", None)
    if not isinstance(own, Things) or own.refers != "last" or own.noun:
        return None
    return msgspec.structs.replace(statement, things=things, quote=quote)
