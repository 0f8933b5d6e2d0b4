"""Ways from one place to another that shall be free."""

from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.sentence import Sentence
from mansion_editing.instructions.phrases.places import read_place
from mansion_editing.instructions.phrases.word_sets import (
    ABILITIES,
    ALONG_WAYS,
    BEFORE_ENDS_OF_WAYS,
    DIRECTIONS,
    FREE_WAYS,
    GOING,
    GOING_SOMEWHERE,
    JOINING,
    ROLLING,
    SOMEBODY,
    WAYS,
)
from mansion_editing.instructions.phrases.words import BE, MODALS
from mansion_editing.instructions.statements import Reach, Rooms, Statement, Things

__all__ = ["Ways"]

_FREE: Final = frozenset("free clear open unobstructed unblocked passable walkable".split())
_BLOCKED: Final = frozenset("blocked obstructed barred narrowed".split())
_BEING: Final = MODALS | BE | frozenset("to has have kept left keep always still completely".split())
_AIDS: Final = ROLLING - {"bed"} | frozenset("crutch walker rollator buggy aid".split())
"""What people who must get somewhere sit in, lean on or push."""
_BEFORE_AIDS: Final = frozenset("a an the his her their walking loaded full baby child's electric mobility".split())
_UNHINDERED: Final = frozenset("unhindered unimpeded unobstructed undisturbed".split())
_HINDERING: Final = frozenset(
    "in the a her his their our my its him them us it way path blocking obstructing hindering stopping standing lying "
    "being any thing obstacle obstruction furniture at all there".split()
)
"""Words of ``without anything standing in her way``."""
_COLLIDING: Final = frozenset("bumping running tripping stumbling squeezing crashing knocking having getting".split())
_OF_COLLIDING: Final = frozenset(
    "to into over past against through around any anything something anyone anybody thing furniture obstacle stuck "
    "move squeeze climb push step walk go be get".split()
)
"""Words of ``without having to squeeze past anything``, none of which names a thing that is there."""
_ON_WHEELS: Final = frozenset("rolled wheeled pushed driven".split())
"""What is done with carts: where that can be done, there is a way."""


class Ways(Sentence):
    """Reads who must get from where to where."""

    def _way_stays_free(self, at: int, place: int, *, kept: bool = False) -> tuple[list[Statement], int] | None:
        """Read ``the way from the hall to the desk must stay free``, ``the route to the lab may not be blocked``.

        Parameters
        ----------
        kept : bool
            After ``keep``, so that no other verb need say what shall be.
        """
        way = self.phrase(place)
        own = way is not None and self.lexicon.is_own_room(way.noun.words)
        if way is None or own or not way.definite or not self.lexicon.is_way("".join(way.noun.words[-1:])):
            return None
        told = next((k for k in range(way.end, len(self.words)) if self.text(k) in _FREE | _BLOCKED), 0)
        start = told
        while self.text(start - 1) in _BEING | {"not", "never"}:
            start -= 1
        said = {word.text for word in self.words[start:told]}
        blocked = self.text(told) in _BLOCKED
        if not (kept or said & _BEING) or blocked != bool(said & {"not", "never"}) or self.text(told + 1) == "of":
            return None
        try:
            found, end = self.until(start)._way(place, way.end)
        except NotUnderstood:
            return None
        quote = self.quote(at, told + 1)
        return ([msgspec.structs.replace(s, quote=quote) for s in found], told + 1) if end == start else None

    def _reaching(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``I can get from the lobby to the kitchen``, ``nothing blocks the way to the lab``."""
        start = place
        if self.text(place) == "nothing":
            way = next((k for k in range(place, min(place + 6, len(self.words)))
                        if self.text(k) in WAYS), None)  # fmt: skip
            return None if way is None else self._way(at, way + 1)
        if self.text(place) in ("the", "a", "delivery") and "robot" in (w.text for w in self.words[place : place + 4]):
            joint = next((k for k in range(place, len(self.words)) if self.text(k) == "from"), None)
            if joint is not None and joint < place + 9:
                self._refuse_denied(at, place, joint)
                return self._way(at, joint)
        while place < len(self.words) and place < start + 12:
            word = self.text(place)
            if self._is_going(place):
                break
            aided = self._with_aid(place)
            if aided:
                place = aided
                continue
            if self.words[place].kind == "mark" or word in ("to", "on", "in"):
                going = self.text(place + 1) in GOING_SOMEWHERE
                if word != "to" or not going:
                    return None
            place += 1
        else:
            return None
        able = any(w.text in ABILITIES for w in self.words[start:place])
        gets = place > start and self.words[place - 1].text in SOMEBODY | {"she", "he", "they"}
        if not able and not (gets and self.words[place].raw.endswith("s") and self.text(place + 1) in ("from", "to")):
            return None
        self._refuse_denied(at, start, place)
        if self.text(place) == "find" or self.text(place) == "make":
            place += 2
        return self._way(at, place + 1)

    def _with_aid(self, at: int) -> int:
        """Return the end of ``in a wheelchair``, ``with a pram`` after somebody; 0 for other words."""
        if self.text(at) not in ("in", "on", "with"):
            return 0
        end = next((k for k in range(at + 1, at + 4) if self.text(k) in _AIDS), 0)
        between = {self.text(k) for k in range(at + 1, end)} - _BEFORE_AIDS
        return end + 1 if end and not between else 0

    def _refuse_denied(self, at: int, start: int, end: int) -> None:
        """Refuse words by which somebody shall not get somewhere: no way is closed.

        Raises
        ------
        NotUnderstood
        """
        if {word.text for word in self.words[start:end]} & {"not", "never", "nobody", "no", "cannot"}:
            raise NotUnderstood(at, self.boundary(at))

    def _is_going(self, at: int) -> bool:
        """Whether a word is a verb of going, with a direction where it has other meanings."""
        word, following = self.text(at), self.text(at + 1)
        if word in ("reach", "access", "enter"):
            return True
        if word in ("find", "make"):
            return following in ("a", "the", "his", "its", "their", "my") and self.text(at + 2) == "way"
        if word in _ON_WHEELS:
            able = {w.text for w in self.words[max(0, at - 4) : at]} & {"can", "could", "able", "possible"}
            return self.text(at - 1) == "be" and bool(able) and following in DIRECTIONS
        return word in GOING and following in DIRECTIONS

    def _way(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read the ends of a way."""
        start: Things | Rooms | None = None
        ends: list[Things | Rooms] = []
        end = place
        both = self._end_of_way(end + 1) if self.text(end) == "between" else None
        if both is not None and self.text(both[1]) == "and":
            start, end = both[0], both[1]
        while end < len(self.words):
            while self.text(end) in ALONG_WAYS and self.text(end) != "the":
                end += 1
            if self.text(end) == "from":
                found = self._end_of_way(end + 1)
                if found is None:
                    break
                start, end = found
                continue
            joint = self.text(end) in BEFORE_ENDS_OF_WAYS
            if ends and self.text(end) in ("and", ",") and self.starts_clause(end + 1):
                break
            found = self._end_of_way(end + joint) if joint or not ends else None
            if found is None:
                break
            ends.append(found[0])
            end = found[1]
        free = self._end_of_unhindered(end)
        while not free and self.text(end) in FREE_WAYS:
            end += 1
        end = free or end
        if start is None and not ends:
            raise NotUnderstood(at, self.boundary(at))
        quote = self.quote(at, end)
        goals: list[Things | Rooms | None] = [*ends] or [None]
        return [Reach(start=start, end=goal, quote=quote) for goal in goals], end

    def _end_of_unhindered(self, at: int) -> int:
        """Return the end of ``without anything in the way``, ``without bumping into things``; 0 for others."""
        if self.text(at) in _UNHINDERED:
            return at + 1
        said = (self.text(at), self.text(at + 1))
        raw = self.words[at + 1].raw if at + 1 < len(self.words) else ""
        nothing = said == ("with", "nothing") or (said[0] == "without" and said[1] in ("anything", "something", "any"))
        if not nothing and not (said[0] == "without" and raw in _COLLIDING):
            return 0
        end = at + 2
        while end < len(self.words) and (
            self.words[end].raw in _HINDERING or self.text(end) in (_HINDERING if nothing else _OF_COLLIDING)
        ):
            end += 1
        ends = end >= len(self.words) or self.words[end].kind == "mark" or self.text(end) in JOINING
        return end if ends and end > at + 2 else 0

    def _end_of_way(self, at: int) -> tuple[Things | Rooms, int] | None:
        place = at
        if self.text(place) in ("there", "here"):
            return Rooms(same=True), place + 1
        read = read_place(self.words, at, self.lexicon, self.floors)
        if (
            read is not None
            and read.place.rooms is not None
            and read.place.anchor is None
            and self.text(at) in ("upstairs", "downstairs")
        ):
            return read.place.rooms, read.end
        while self.text(place) in ("the", "main", "front", "building", "building's"):
            place += 1
        if self.text(place) in ("door", "doorway") and self.text(place + 1) != "of":
            return Rooms(same=True), place + 1
        if self.text(place) in ("entrance", "exit", "outside", "street") and self.text(place + 1) != "hall":
            end = place + 1 + (self.text(place + 1) in ("door",))
            return Rooms(words="entrance"), end
        item = self.item(at)
        if item is None:
            return None
        until = next((p.start for p in item.places if p.goal or p.source or self.words[p.start].text == "to"), None)
        if until is not None:
            item = Item(item.phrase, tuple(p for p in item.places if p.end <= until), until)
        if item.phrase.noun.kind in ("room", "both"):
            return item.rooms(), item.end
        return item.things(), item.end
