"""Groups of furniture told part by part: ``a reading corner in the hall: an armchair and a lamp beside it``."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.adding import Adding
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.phrases.places import merged, with_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import BEFORE_WISHES, WISHES
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, MODALS, STATE_WORDS
from mansion_editing.instructions.statements import Add, Amount, Mention, Move, Place, SetState, Statement, Things

__all__ = ["Arranging"]

_GROUPS: Final = frozenset("corner nook area place spot station workplace workstation zone setup group niche".split())
"""Last words of names for what is made up of several pieces of furniture."""
_MAKING: Final = frozenset(["add", "make", "want", "bring", "give"])
"""What verbs before such a name ask for."""
_ONE: Final = frozenset("a an one another".split())
_FURTHER: Final = frozenset("more additional extra further second third new".split())
_BEFORE_LISTS: Final = (("consisting", "of"), ("made", "up", "of"), ("with",), (":",), ("-",))
_FOR_WHOM: Final = 4
"""Words of ``for the visitors`` at most."""
_ADJECTIVES: Final = 3


class Arranging(Adding):
    """Reads a group of furniture with the list of its parts, all of which are new unless they are told to be there."""

    def _arranged(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``make us a reading corner in the hall: a rug, an armchair and a lamp beside the armchair``."""
        end = self._group_at(at)
        places, end = self.places(end) if end else ((), 0)
        place = self._framed(joined_places(places))[0] if end else Place()
        joint = next((len(said) for said in _BEFORE_LISTS if self._says(end, said)), 0) if end else 0
        if not joint or place.rooms is None or place.anchor is not None or any(p.source for p in places):
            return None
        told = Mention(rooms=place.rooms, quote=self.quote(at, end))
        parts, stop = self._parts(end + joint, place)
        return ([told, *parts], stop) if parts else None

    def begins_group(self, at: int) -> bool:
        """Whether a group of furniture is asked for at a place."""
        try:
            return bool(self._group_at(at))
        except NotUnderstood:
            return True

    def _says(self, at: int, said: Sequence[str]) -> bool:
        return all(self.text(at + k) == word for k, word in enumerate(said))

    def _group_at(self, at: int) -> int:
        """Return the end of ``we need one more workplace for Ann``; 0 where no group is asked for.

        Raises
        ------
        NotUnderstood
            Where several are: the list may be of one of them, or of all.
        """
        wished = self.text(at) in ("we", "i")
        place = at + wished
        while wished and (self.text(place) in MODALS or self.text(place) in BEFORE_WISHES):
            place += 1
        verb = verb_at(self.words, place, self.lexicon)
        if wished and self.text(place) in WISHES:
            place += 1
        elif verb is not None and verb[0] in _MAKING and not wished:
            place = verb[1]
        place += self.text(place) in ("us", "me")
        number = self.words[place] if place < len(self.words) else None
        several = number is not None and number.kind == "number" and number.value > 1
        if not several and self.text(place) not in _ONE:
            return 0
        start = place + 1
        while self.text(start) in _FURTHER:
            start += 1
        head = next((k for k in range(start, start + _ADJECTIVES + 1) if self.text(k) in _GROUPS), 0)
        span = [word.text for word in self.words[start : head + 1]]
        if not head or set(span[:-1]) & FUNCTION_WORDS or self.lexicon.is_own_room(tuple(span)):
            return 0
        if several:
            raise NotUnderstood(at, self.boundary(head))
        return self._past_purpose(head + 1)

    def _past_purpose(self, at: int) -> int:
        """Return the place after ``for the visitors``."""
        if self.text(at) != "for":
            return at
        ends = ("in", "on", "at", "by", ":", "with")
        return next((k for k in range(at + 2, at + 2 + _FOR_WHOM) if self.text(k) in ends), at)

    def _parts(self, at: int, place: Place) -> tuple[list[Statement], int]:
        """Read the parts of a group, and states of them."""
        out: list[Statement] = []
        end = at
        while True:
            state = self._state_of_part(at, out, place)
            item = None if state else self.item(at)
            if state:
                out.append(state[0])
                end = state[1]
            elif item is not None and item.phrase.noun.kind == "object" and not item.phrase.refers:
                out.append(self._part(item, out, place))
                end = item.end
                if self.text(end) == "with":
                    carried, end = self._carried_by_part(end + 1)
                    out += carried
            else:
                break
            at = self.conjunction(end)
            if not at or self.starts_clause(at):
                break
        return self._together(out, place), end

    def _part(self, item: Item, before: Sequence[Statement], place: Place) -> Statement:
        """Return that a part comes to the group's place, or to its own there."""
        quote = self.quote(item.phrase.start, item.end)
        things, goal = item.phrase.things(), item.goal()[0]
        source = joined_places([p for p in item.places if p.source])[0]
        it = goal.anchor is not None and goal.anchor.refers == "last" and not goal.anchor.noun
        main = next((s.things for s in reversed(before) if isinstance(s, Add) and self._stands(s.things)), None)
        if it and goal.relation in ("", "on", "beside") and main is not None and self._stands(things):
            newest = Things(noun=main.noun, definite=True, ordinal=-1, amount=Amount(number=0))
            goal = Place(relation="beside", anchor=newest, rooms=place.rooms)
        whole = goal if it else merged(goal, place) if goal != Place() else place
        if not item.phrase.definite and source == Place():
            return Add(things=things, place=whole, quote=quote)
        things = things if source == Place() else with_place(things, source)
        return Move(things=self._all_if_plural(things), place=whole, quote=quote)

    def _stands(self, things: Things) -> bool:
        return self.lexicon.stands(tuple(things.noun.split()))

    def _carried_by_part(self, at: int) -> tuple[list[Statement], int]:
        """Read ``with a monitor, a keyboard and a mouse on it``; what stands on the floor is a part of its own."""
        items = self.items(at)
        last = next((k for k, item in enumerate(items) if _is_on_it(item)), None)
        if last is None:
            last = next((k for k, item in enumerate(items) if self._stands(item.phrase.things())), len(items)) - 1
        mine = items[: last + 1]
        if not mine or any(item.is_room or item.phrase.definite for item in mine):
            raise NotUnderstood(at, items[-1].end)
        relation = mine[-1].goal()[0].relation or "on"
        on_it = Place(relation=relation, anchor=Things(refers="last", definite=True, amount=Amount(number=0)))
        out: list[Statement] = [
            Add(things=item.phrase.things(), place=on_it, quote=self.quote(item.phrase.start, item.end))
            for item in mine
        ]
        return out, mine[-1].end

    def _together(self, parts: Sequence[Statement], place: Place) -> list[Statement]:
        """Return parts with the place of ``a kettle and four mugs on the counter`` for all of these."""
        out: list[Statement] = []
        for part in reversed(parts):
            after = out[0] if out else None
            shared = after.place if isinstance(after, Add) else Place()
            held = shared.relation in ("on", "in") and shared.anchor is not None and not shared.anchor.refers
            bare = isinstance(part, Add) and part.place == place and not self._stands(part.things)
            both = held and bare and isinstance(after, Add) and not self._stands(after.things)
            out.insert(0, msgspec.structs.replace(part, place=shared) if both else part)
        return out

    def _state_of_part(self, at: int, parts: Sequence[Statement], place: Place) -> tuple[SetState, int] | None:
        """Read ``lamp on`` after the list that has a floor lamp."""
        item = self.item(at, places=False)
        said = STATE_WORDS.get(self.text(item.end)) if item is not None else None
        if item is None or said is None or self.phrase(item.end + 1) is not None:
            return None
        named = [part.things for part in parts if isinstance(part, Add)]
        meant = [one for one in named if one.noun.split()[-1:] == list(item.phrase.noun.words[-1:])]
        if len(meant) != 1:
            return None
        newest = 0 if meant[0].plural else -1
        things = msgspec.structs.replace(meant[0], definite=True, amount=Amount(number=0), ordinal=newest, place=place)
        quote = self.quote(at, item.end + 1)
        return SetState(things=things, state="open" if said[0] == "open" else "on", value=said[1], quote=quote), (
            item.end + 1
        )


def _is_on_it(item: Item) -> bool:
    anchor = item.goal()[0].anchor
    return anchor is not None and anchor.refers == "last" and item.goal()[0].relation in ("on", "in")
