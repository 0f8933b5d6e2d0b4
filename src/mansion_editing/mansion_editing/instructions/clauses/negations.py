"""What is not to be done."""

import msgspec

from mansion_editing.instructions.clauses.items import NotUnderstood, joined_places
from mansion_editing.instructions.clauses.states import States, state_set
from mansion_editing.instructions.phrases.places import read_place, with_place
from mansion_editing.instructions.phrases.verb_words import Deed
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import AFTER_NEGATED, DISTURBING
from mansion_editing.instructions.phrases.words import STATE_WORDS
from mansion_editing.instructions.statements import (
    Amount,
    Ensure,
    Forbid,
    Keep,
    Mention,
    Place,
    Remove,
    Statement,
    Things,
)

__all__ = ["Negations"]


class Negations(States):
    """Reads ``do not`` and ``never``."""

    def _negated(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``do not ...``, ``never ...``, ``no need to ...``."""
        place = at
        if self.text(place) in ("do", "does", "must", "should", "please", "you") and self.text(place + 1) in (
            "not",
            "never",
        ):
            place += 2
        elif self.text(place) in ("not", "never"):
            place += 1
        else:
            return None
        place += self.text(place) in ("ever", "just", "even", "to", "be", "you")
        if self.text(place) in ("forget", "hesitate") and self.text(place + 1) in ("to", "about"):
            return self.read(place + 2)
        verb = verb_at(self.words, place, self.lexicon)
        if self.text(place) in DISTURBING and self.text(place + 1) in ("anything", "any"):
            end = self.places(place + 2 + (self.text(place + 2) in ("else", "other")))[1]
            return [Mention(quote=self.quote(at, end))], end
        if self.text(place) in DISTURBING:
            items = self.items(place + 1 + (self.text(place + 1) == "with"))
            end = items[-1].end
            return [Keep(things=self._kept(i), quote=self.quote(at, end)) for i in items], end
        if verb is None:
            item = self.item(place) if self.words[place - 1].text == "not" else None
            read = read_place(self.words, place, self.lexicon, self.floors)
            if read is not None:
                return [
                    Forbid(things=Things(refers="last"), place=read.place, quote=self.quote(at, read.end))
                ], read.end
            if item is not None:
                return [Keep(things=self._all(item.things()), quote=self.quote(at, item.end))], item.end
            raise NotUnderstood(at, self.boundary(at))
        return self._negated_verb(at, *verb)

    def _negated_verb(self, at: int, deed: Deed, place: int) -> tuple[list[Statement], int]:
        if deed in ("leave", "keep", "let", "want"):
            return self._not_left(at, place)
        if deed == "switch":
            place += self.text(place) in ("on", "off")
        read = read_place(self.words, place + 1, self.lexicon, self.floors)
        if deed in ("add", "bring") and self.text(place) in ("any", "more") and read is not None:
            quote = self.quote(at, read.end)  # "don't add any on the ground floor"
            return [Forbid(things=Things(refers="last"), place=read.place, quote=quote)], read.end
        items = self.items(place)
        end = items[-1].end
        while self.text(end) in AFTER_NEGATED:
            end += 1
        quote = self.quote(at, end)
        out: list[Statement] = []
        for item in items:
            if deed in ("add", "bring", "set", "give", "equip"):
                if item.phrase.definite and not item.phrase.refers:
                    out.append(Keep(things=self._all(item.phrase.things()), quote=quote))
                else:
                    goal, _ = self._framed(self._shared_goal(items, item))
                    out.append(Forbid(things=item.phrase.things(), place=goal, quote=quote))
            else:
                out.append(Keep(things=self._all(item.things()), quote=quote))
        contrast = end + (self.text(end) == ",")
        if deed == "remove" and self.text(contrast) in ("only", "just", "but") and contrast > end:
            meant = self.items(contrast + 1)
            own, _ = joined_places(list(items[-1].places))
            stop = meant[-1].end
            for item in meant:
                things = self._all_if_plural(item.things())
                placed = things if item.places or own == Place() else with_place(things, own)
                out.append(Remove(things=placed, quote=self.quote(at, stop)))
            return out, stop
        return out, end

    def _not_left(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``do not leave the lamp on`` and ``do not keep any knives in the kitchen``."""
        most = self.text(place) == "more" and self.text(place + 1) == "than"
        item = self.item(place + 2 * most)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        end = item.end
        if most and item.phrase.amount.number:
            things = msgspec.structs.replace(
                item.phrase.things(), amount=Amount(kind="at_most", number=item.phrase.amount.number)
            )
            return [Ensure(things=things, place=self._framed(item.goal())[0], quote=self.quote(at, end))], end
        while self.text(end) in ("switched", "turned", "be"):
            end += 1
        if self.text(end) in STATE_WORDS:
            state, value = STATE_WORDS[self.text(end)]
            quote = self.quote(at, end + 1)
            return [state_set(item.things(), state, quote, value=not value)], end + 1
        if item.phrase.amount.kind == "some" and not item.phrase.definite:
            things = msgspec.structs.replace(item.things(), amount=Amount(kind="all", number=0))
            return [Remove(things=things, quote=self.quote(at, end))], end
        raise NotUnderstood(at, self.boundary(at))
