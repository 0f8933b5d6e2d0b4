"""What is said to stay as it is: ``the treadmills are fine``, ``nothing on the third floor may change``."""

from typing import Final

from mansion_editing.instructions.clauses.coordination import is_for_one
from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.outcomes import everything_at
from mansion_editing.instructions.clauses.subjects import Subjects
from mansion_editing.instructions.phrases.lexicon import HYPERNYMS
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.word_sets import (
    AFTER_STAYING,
    ASSURING,
    CHANGED,
    DISTURBING,
    GOOD_AS_IT_IS,
    JOINING,
    KEPT_AS_IT_IS,
    LYING,
    NOT_MEANT,
    SO_DOING,
    STAYING,
)
from mansion_editing.instructions.phrases.words import BE, MODALS
from mansion_editing.instructions.statements import Amount, Keep, Mention, Place, Rooms, Statement, Things

__all__ = ["Staying"]


_LIES: Final = frozenset("is are lies stands sits hangs remains stays".split())


class Staying(Subjects):
    """Reads statements that something is to stay as it is."""

    def tells_what_stays(self, at: int) -> bool:
        """Whether words that begin like a question tell what stays: ``what's on the dresser is fine``."""
        return self.text(at) == "what" and self._subject_stays(at) is not None

    def says_what_stays(self) -> bool:
        """Whether all the words only say what stays as it is."""
        found = self._stays_so(self.skip(0)) if self.words else None
        return found is not None and self.skip(found[1]) >= len(self.words)

    def _stays_so(self, at: int) -> tuple[list[Statement], int] | None:
        """Read a clause that says of things, of a room or of a storey that they stay as they are."""
        return (
            self._so_does(at)
            or self._all_else(at)
            or self._nothing_changes(at)
            or self._keeps_its_own(at)
            or self._subject_stays(at)
        )

    def _so_does(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``so does the table in the mail room`` after what stays."""
        at_verb = at + (self.text(at) == "so")
        before = {word.text for word in self.words[:at]}
        if not before & STAYING or "so" not in (self.text(at), self.text(at - 1)) or self.text(at_verb) not in SO_DOING:
            return None
        item = self.item(at_verb + 1)
        if item is None or item.is_room or not item.phrase.definite or not self._clause_ends(item.end):
            return None
        return [Keep(things=self._all(item.things()), quote=self.quote(at, item.end))], item.end

    def _all_else(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``everything else in the hall stays the same``, which is checked of every instruction."""
        end = self._rest_there(at)
        if not end:
            return None
        if self.text(end - 1) == "rest" and self.text(end) in ("stay", "remain"):
            return None  # the others of a kind
        stop = self._as_it_is(self.places(end)[1])
        return ([Mention(quote=self.quote(at, stop))], stop) if stop else None

    def _rest_there(self, at: int) -> int:
        """Return the end of ``everything else``, ``whatever else is``, ``all the rest``; 0 for others."""
        if self.text(at) in ("everything", "all", "anything", "whatever", "what") and self.text(at + 1) == "else":
            end = at + 2 + (self.text(at + 2) in ("that", "which"))
            told = end < len(self.words) and self.words[end].raw in _LIES
            return end + told if told or self.text(at) not in ("whatever", "what") else 0
        start = at + (self.text(at) == "all")
        if (self.text(start), self.text(start + 1)) == ("the", "rest"):
            end = self._of_the_whole(start + 2)
            return end if end > start + 2 or start == at else start + 2
        return 0

    def _of_the_whole(self, at: int) -> int:
        """Return the end of ``of it``, ``of the furniture``, ``of the room`` after ``the rest``."""
        if self.text(at) != "of":
            return at
        whole = self.item(at + 1, places=False)
        if whole is None:
            return at
        general = whole.phrase.definite and " ".join(whole.phrase.noun.words) in HYPERNYMS
        return whole.end if whole.is_room or whole.phrase.refers or general else at

    def _nothing_changes(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``nothing in the kitchen may be moved`` and ``nothing may change on the third floor``."""
        if self.text(at) != "nothing":
            return None
        before, end = self.places(at + 1)
        while self.text(end) in MODALS or self.text(end) in BE or self.text(end) == "get":
            end += 1
        if self.text(end) not in CHANGED:
            return None
        after, end = self.places(end + 1)
        found = [self._framed(joined_places([*before, *after]))[0]]
        while (after or before) and self.text(end) in ("or", "nor", "and", ","):
            more, stop = self.places(end + 1 + (self.text(end + 1) in ("or", "nor", "and")))
            if not more:
                break
            found, end = [*found, joined_places(more)[0]], stop
        if any(place == Place() or place.outside for place in found) or not self._clause_ends(end):
            return None
        quote = self.quote(at, end)
        return [Keep(things=everything_at(place), quote=quote) for place in found], end

    def _keeps_its_own(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the dining room keeps its own`` and ``the bedroom keeps its lamps``."""
        room = self.item(at)
        if room is None or not room.is_room or self.text(room.end) != "keep":
            return None
        place = room.end + 1
        place += (1 + (self.text(place + 1) == "of")) if self.text(place) == "all" else 0
        own = place + 1 if self.text(place) in ("the", "their", "its") else place
        if self.text(own) == "own" and self._clause_ends(own + 1):
            if self.last_noun is None:
                return None
            noun, end = " ".join(self.last_noun.words), own + 1
            kept = Things(noun=noun, amount=Amount(kind="all", number=0), definite=True, plural=True)
        else:
            item = self.item(place)
            if item is None or item.is_room or item.places or not (item.phrase.definite or self.text(own) == "own"):
                return None
            kept, end = self._all(item.phrase.things()), item.end
        if not self._clause_ends(end):
            return None
        return [Keep(things=with_place(kept, Place(rooms=room.rooms())), quote=self.quote(at, end))], end

    def _stays_after(self, at: int) -> bool:
        return bool(self._as_it_is(at) or self._not_part_of_it(at))

    def _subject_stays(self, at: int) -> tuple[list[Statement], int] | None:
        """Read one subject or several that stay: ``the vase, the lamp and the phone are fine``."""
        kept: list[Things] = []
        place = at
        while (found := self._subject(place)) is not None:
            things, end = found
            if things.place is None and self.frame.rooms is not None:
                things = with_place(things, Place(rooms=self.frame.rooms))
            load = self.item(end + 1) if self.text(end) == "with" else None
            end = end if load is None else load.end
            kept += [things] if load is None else [things, self._all(load.things())]
            stop = self._as_it_is(end) or self._not_part_of_it(end)
            if stop and place > at and is_for_one(self.words[end]):
                return None
            if stop:
                return [Keep(things=one, quote=self.quote(at, stop)) for one in kept], stop
            place = self.conjunction(end)
            item = self.item(at)
            directed = item is not None and any(p.goal or p.source for p in item.places)
            if not place or directed or self.starts_clause(place):
                return None
        return None

    def _subject(self, at: int) -> tuple[Things, int] | None:
        """Read what stays: ``what is on the dresser``, ``the third floor``, ``the mug that is lying there``."""
        if self.text(at) == "what":
            places, end = self.places(at + 1 + (self.text(at + 1) in BE or self.text(at + 1) in LYING))
            return (everything_at(joined_places(places)[0]), end) if places else None
        own = self.text(at) in ("the", "its", "their")
        if own and self.text(at + 1) == "content" and self.text(at + 2) not in ("of", "in"):
            holder = Things(refers="last", definite=True)
            return everything_at(Place(relation="in", anchor=holder)), at + 2
        framed, stop = self.places(at)
        if framed and "everything" in (self.text(stop - 1), self.text(stop)):
            return everything_at(joined_places(framed)[0]), stop + (self.text(stop) == "everything")
        item = self.item(at)
        if item is not None and item.is_room:
            return everything_at(Place(rooms=item.rooms())), item.end
        if item is not None and (item.phrase.definite or item.phrase.refers or item.phrase.amount.kind == "all"):
            things = self._all(item.things())
            return (things, self._lying_there(item.end)) if things.noun or things.place else None
        storeys = read_storeys(self.words, at, self.floors)
        if item is None and storeys is not None:
            return everything_at(Place(rooms=Rooms(floors=storeys[0]))), storeys[2]
        return None

    def _lying_there(self, at: int) -> int:
        """Return the end of ``that is lying there`` at a place, the place itself where there is none."""
        end = at + (self.text(at) in ("that", "which"))
        end += end > at and self.text(end) in BE
        end += self.text(end) in ("already", "still")
        end += self.text(end) in LYING
        end += self.text(end) in ("already", "still")
        end += self.text(end) in ("up", "down", "in", "over") and self.text(end + 1) in ("there", "here")
        return end + 1 if self.text(end) in ("there", "here") else at

    def _as_it_is(self, at: int) -> int:
        """Return the end of ``may stay as they are``, ``is fine``, ``must not be moved``; 0 where it is not said."""
        if self.text(at) in ("untouched", "unchanged") and self._clause_ends(at + 1):
            return at + 1
        end = at
        if self.text(at) == "as" and self.text(at + 1) in ("it", "they", "is"):
            while self.text(end) in KEPT_AS_IT_IS:
                end += 1
            return end if self._clause_ends(end) else 0
        while self._is_before_staying(end):
            end += 1 + (self.text(end) == "of")
        said = [word.text for word in self.words[at:end]]
        denied = self.text(end) in ("not", "never")
        if denied:
            end += 1
            while self.text(end) in BE or self.text(end) in ("get", "to", "for"):
                end += 1
            must = bool(set(said) & MODALS) or bool({"to", "for"} & {self.text(k) for k in range(at, end)})
            return end + 1 if must and self.text(end) in CHANGED and self._clause_ends(end + 1) else 0
        wished = set(said) & MODALS
        good = bool(set(said) & BE) and not wished and self.text(end) in GOOD_AS_IT_IS
        left = bool(set(said) & BE) and self.text(end) in ("left", "kept")
        if not (good or left or set(said) & {"stay", "remain"}):
            return 0
        end += good or left
        start = end
        while self.text(end) in KEPT_AS_IT_IS or self.text(end) in AFTER_STAYING:
            end += 1
        if left and end == start:
            return 0
        return end if self._clause_ends(end) else 0

    def _is_before_staying(self, at: int) -> bool:
        """Whether a word only joins a subject with what is said of it: ``should``, ``of course``, ``can also``."""
        word = self.text(at)
        assured = word in ASSURING or (word == "of" and self.text(at + 1) == "course")
        return assured or word in MODALS or word in BE or word in ("all", "both", "just", "to")

    def _not_part_of_it(self, at: int) -> int:
        """Return the end of what says that something is not meant, or still needed: ``don't touch``, ``we do need``."""
        end = at + (self.text(at) in ("-", ",", ":"))
        end += self.text(end) in ("please", "you", "do")
        contracted = end < len(self.words) and self.words[end].raw in ("isn't", "aren't")
        if self.text(end) in ("not", "never") and not contracted:
            end += 1 + (self.text(end + 1) in ("to", "be"))
            return end + 1 if self.text(end) in DISTURBING and self._clause_ends(end + 1) else 0
        end = at
        if contracted or (self.text(end) in BE and self.text(end + 1) == "not"):
            end += 1 if contracted else 2
            if self.text(end) in NOT_MEANT and self._clause_ends(end + 1):
                return end + 1
            part = [self.text(k) for k in range(end, end + 3)]
            ours = part[:2] == ["part", "of"] and part[2] in ("it", "this", "that")
            return end + 3 if ours and self._clause_ends(end + 3) else 0
        if self.text(end) in ("we", "i", "they", "you"):
            end += 1 + (self.text(end + 1) in ("do", "still", "will"))
            end += self.text(end) == "still"
            return end + 1 if self.text(end) in ("need", "use", "keep") and self._clause_ends(end + 1) else 0
        if self.text(end) in ("should", "must", "shall", "will") and self.text(end + 1) == "still":
            end += 2
            there = self.text(end) in LYING or self.text(end) == "be"
            end += 1 + (self.text(end + 1) == "there") if there else 0
            end += self.text(end) in ("afterward", "after", "then", "later")
            return end if there and self._clause_ends(end) else 0
        return 0

    def _clause_ends(self, at: int) -> bool:
        """Whether a clause may end before a place."""
        if at >= len(self.words) or self.words[at].kind == "mark" or self.text(at) in JOINING:
            return True
        return self.text(at) in ("please", "though", "anyway", "too", "because", "since", "for")
