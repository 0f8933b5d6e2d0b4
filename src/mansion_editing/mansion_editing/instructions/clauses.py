"""Clauses: a verb or a predicate with its noun phrases and places, read into statements."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final

import msgspec

from mansion_editing.instructions.lexicon import Lexicon
from mansion_editing.instructions.noun_phrases import MATERIALS, Noun, NounPhrase, noun_phrase
from mansion_editing.instructions.places import ReadPlace, merged, read_place, with_place
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Clear,
    Ensure,
    Finish,
    Forbid,
    Furnish,
    History,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Reach,
    Remove,
    Rename,
    Replace,
    Reshape,
    Rooms,
    SetState,
    Statement,
    Surface,
    Swap,
    Things,
    Turn,
)
from mansion_editing.instructions.verb_words import PARTICIPLES, Deed
from mansion_editing.instructions.verbs import verb_at
from mansion_editing.instructions.words import BE, COURTESIES, HAVE, MODALS, PARTICIPLES_OF_REST, STATE_WORDS, Word
from mansion_language.colours import COLOUR_WORDS

__all__ = ["ClauseReader", "Item", "NotUnderstood"]


class NotUnderstood(Exception):
    """Words that belong to no statement.

    Attributes
    ----------
    start, end : int
        Their places in the words of the sentence.
    """

    def __init__(self, start: int, end: int) -> None:
        super().__init__(start, end)
        self.start, self.end = start, end


@dataclass(frozen=True)
class Item:
    """A noun phrase with the places that follow it."""

    phrase: NounPhrase
    places: tuple[ReadPlace, ...]
    end: int

    @property
    def is_room(self) -> bool:
        """Whether the phrase names a room and no object."""
        return self.phrase.noun.kind == "room"

    def goal(self) -> tuple[Place, bool]:
        """Return where the thing goes: all its places but those that it comes from; and whether each is meant."""
        return _joined([p for p in self.places if not p.source])

    def things(self) -> Things:
        """Return the thing with the places where it is."""
        things = self.phrase.things()
        place, _ = _joined(list(self.places))
        return things if place == Place() else with_place(things, place)

    def rooms(self) -> Rooms:
        """Return the room that is named, with the storeys that follow."""
        rooms = self.phrase.rooms()
        for read in self.places:
            more = read.place.rooms
            if more is not None:
                whole = merged(Place(rooms=rooms), Place(rooms=more)).rooms
                rooms = rooms if whole is None else whole
            elif read.place.anchor is not None:
                rooms = msgspec.structs.replace(rooms, holding=read.place.anchor)
        return rooms


def _joined(places: Sequence[ReadPlace]) -> tuple[Place, bool]:
    place, each = Place(), False
    for read in places:
        place = read.place if place == Place() else merged(place, read.place)
        each = each or read.each
    return place, each


def _text(words: Sequence[Word], at: int) -> str:
    return words[at].text if 0 <= at < len(words) else ""


_SKIPPED: Final = COURTESIES | frozenset(["also", "now", "then", "just", "simply", "finally", "afterwards", "again",
                                          "too", "meanwhile", "next", "first", "and", "but", "so", ",", "-", "*", ":",
                                          "quickly", "immediately", "kindly", "maybe", "perhaps", "otherwise", ".",
                                          "once", "still", "already", "today", "asap", "else", "as", "well", "there",
                                          "here", "back", "together", "instead", "carefully", "neatly", "nicely",
                                          "thus", "therefore", "yet", "while", "plus", "for", "now", ")", "(", "!",
                                          '"', "\n", "?", ";"])  # fmt: skip
_PART: Final[dict[str, Surface]] = {"wall": "walls", "floor": "floor", "ceiling": "ceiling", "flooring": "floor"}


class ClauseReader:
    """Reads the clauses of one sentence.

    Parameters
    ----------
    words : sequence of Word
    lexicon : Lexicon
    floors : sequence of int
        Those of the building.
    quote : callable
        Returns the text between two places in the words.
    frame : Place
        A place that the sentence began with ("in the lobby, ...").
    """

    def __init__(
        self, words: Sequence[Word], lexicon: Lexicon, floors: Sequence[int], quote: Callable[[int, int], str]
    ) -> None:
        self.words, self.lexicon, self.floors, self.quote = words, lexicon, floors, quote
        self.frame = Place()
        self.last_noun: Noun | None = None
        self.topic: Things | None = None
        self.affirmed: Things | None = None
        self.follows = False

    # Pieces

    def text(self, at: int) -> str:
        """Return a word, empty beyond the end."""
        return _text(self.words, at)

    def phrase(self, at: int) -> NounPhrase | None:
        """Read a noun phrase."""
        return noun_phrase(self.words, at, self.lexicon, self.floors)

    def places(self, at: int) -> tuple[tuple[ReadPlace, ...], int]:
        """Read the places from a place in the words on."""
        found: list[ReadPlace] = []
        while True:
            start = at
            relative = self.text(at) in ("that", "which", "who")
            while (
                self.text(at) in PARTICIPLES_OF_REST
                and self.text(at) != "there"
                and not (self.text(at) == "left" and self.text(at + 1) in ("and", "of"))
            ):
                if (
                    self.text(at) == "that"
                    and self.text(at + 1) in ("can", "could", "may")
                    and self.text(at + 2) == "be"
                ):
                    at += 3
                    at += self.text(at + 1) in ("on", "off", "up")
                at += 1
            if self.text(at) in ("is", "are") and self.text(at - 1) in ("that", "which", "who"):
                at += 1
                while self.text(at) in PARTICIPLES_OF_REST:
                    at += 1
            read = read_place(self.words, at, self.lexicon, self.floors)
            if read is None and found and self.text(at) == ",":
                read = self._place_after_comma(at, found)
            if read is None:
                return tuple(found), start
            owned = not found and self.text(read.start) == "of" and read.place.rooms is not None
            found.append(replace(read, relative=True) if relative or owned else read)
            at = read.end

    def _place_after_comma(self, at: int, found: list[ReadPlace]) -> ReadPlace | None:
        """Read ``, ground floor`` and ``, in the kitchen`` where the place before lacks just that."""
        read = read_place(self.words, at + 1, self.lexicon, self.floors)
        place, _ = _joined(found)
        room = self.phrase(at + 1)
        bare = place.rooms is None or not place.rooms.words
        own = room is not None and room.noun.kind in ("room", "both") and self.lexicon.is_own_room(room.noun.words)
        if room is not None and own and bare and self.text(room.end) in ("", ",", ".", "please", ":", "-"):
            return ReadPlace(Place(rooms=room.rooms()), at + 1, room.end)
        nearer = read is not None and read.place.anchor is not None and place.anchor is None and place.rooms is not None
        if read is not None and nearer and (read.end >= len(self.words) or self.text(read.end) in (",", ".", "please")):
            return read
        if read is None or read.place.rooms is None or read.place.anchor is not None:
            return None
        if place.rooms is not None and (place.rooms.floors or read.place.rooms.words):
            return None
        ends = read.end >= len(self.words) or self.text(read.end) in (",", ".", "and", ")", "please", ";")
        return read if (ends and verb_at(self.words, read.end + 1, self.lexicon) is None) or ends else None

    def item(self, at: int, *, places: bool = True) -> Item | None:
        """Read a noun phrase with its places."""
        found = self.phrase(at)
        if found is None or found.noun.unknown:
            return None
        if not places:
            return Item(found, (), found.end)
        following, end = self.places(found.end)
        counted = self.text(found.end - 1) in ("them", "those") and self.text(found.end) == ","
        if counted and not following:
            following, end = self.places(found.end + 1)
            end = end if following else found.end
        return Item(found, following, end)

    def items(self, at: int) -> list[Item]:
        """Read noun phrases joined by commas and conjunctions.

        Raises
        ------
        NotUnderstood
            Where there is no noun phrase.
        """
        found: list[Item] = []
        while True:
            item = self.item(at)
            if item is None:
                if found:
                    return found
                raise NotUnderstood(at, self.boundary(at))
            placed = self._participle(item.phrase.end)
            new = placed is not None and placed[0] == "add" and not item.phrase.definite
            if found and (self.predicate_follows(item.end) or self._is_way(item.phrase) or new):
                return found
            found.append(self._beside_it(self._as_before(self._named(item, found), found), found))
            after = self.conjunction(item.end)
            if not after or self.starts_clause(after) or self.text(after) in ("only", "just"):
                return found
            at = after

    def _beside_it(self, item: Item, before: Sequence[Item]) -> Item:
        """Put the thing before for ``it``: the table or anything on it."""
        last = before[-1] if before else None
        if last is None or not last.phrase.definite or not item.places:
            return item
        anchor = item.places[0].place.anchor
        if anchor is None or anchor.refers != "last" or anchor.noun:
            return item
        place = msgspec.structs.replace(item.places[0].place, anchor=last.things())
        return Item(item.phrase, (replace(item.places[0], place=place), *item.places[1:]), item.end)

    def _as_before(self, item: Item, before: Sequence[Item]) -> Item:
        """Give a bare noun the quantifier before it: any bottle of wine or beer."""
        amount = item.phrase.amount
        bare = item.phrase.end - item.phrase.start == len(item.phrase.noun.words) and not item.phrase.definite
        if not before or not bare or before[-1].phrase.amount.kind not in ("all", "none") or amount.kind != "some":
            return item
        first = before[-1].phrase
        phrase = replace(item.phrase, amount=first.amount, definite=first.definite)
        return Item(phrase, item.places, item.end)

    def _named(self, item: Item, before: Sequence[Item]) -> Item:
        """Put the noun that came before for ``one``: two red mugs and a blue one."""
        last = next((i.phrase.noun for i in reversed(before) if i.phrase.noun.kind != "anything"), self.last_noun)
        if item.phrase.noun.words[-1:] != ("one",) or last is None:
            if item.phrase.noun.kind == "object":
                self.last_noun = item.phrase.noun
            return item
        told = item.phrase.noun.words[:-1]
        words = (*told, last.words[-1]) if told else last.words
        if told and not self.lexicon.is_object(words):
            raise NotUnderstood(item.phrase.start, item.end)
        noun = replace(item.phrase.noun, words=words, kind=last.kind)
        return Item(replace(item.phrase, noun=noun), item.places, item.end)

    def conjunction(self, at: int) -> int:
        """Return the place after a comma or a conjunction between noun phrases, 0 where there is none."""
        place = at
        if self.text(place) == ",":
            place += 1
        if self.text(place) in ("and", "plus", "&", "+", "or", "nor") or (
            self.text(place) == "as" and self.text(place + 1) == "well"
        ):
            place += 3 if self.text(place) == "as" else 1
        if self.text(place) == "also":
            place += 1
        return place if place > at else 0

    def starts_clause(self, at: int) -> bool:
        """Whether a clause with a verb of its own begins at a place."""
        while self.text(at) in ("please", "then", "also", "just", "not", "never", "do", "finally"):
            if self.text(at) == "do" and self.text(at + 1) != "not":
                break
            at += 1
        if verb_at(self.words, at, self.lexicon) is not None:
            return True
        if self.text(at) in ("there", "i", "we", "you", "nothing", "make", "let", "if", "because", "nobody"):
            return True
        return False

    def predicate_follows(self, at: int) -> bool:
        """Whether the words at a place make the noun phrase before them the subject of a clause."""
        word = self.text(at)
        if word in (",", "-", ":"):
            return False
        if word in MODALS or word in (
            "is",
            "are",
            "stay",
            "remain",
            "need",
            "has",
            "have",
            "go",
            "get",
            "belong",
            "lack",
            "want",
            "face",
        ):
            return True
        if word in STATE_WORDS:
            nominal = word in ("on", "off") and self.phrase(at + 1) is not None
            return not nominal
        if word in ("switched", "turned", "left", "kept", "powered") and self.text(at + 1) in STATE_WORDS:
            return True
        return self._participle(at) is not None

    def _participle(self, at: int) -> tuple[Deed, int] | None:
        for length in (2, 1):
            span = tuple(w.text for w in self.words[at : at + length])
            if len(span) == length and span in PARTICIPLES:
                return PARTICIPLES[span], at + length
        return None

    def boundary(self, at: int) -> int:
        """Return the end of the words that cannot be read, at the next comma or conjunction with a clause."""
        place = at + 1
        while place < len(self.words):
            word = self.words[place]
            if word.kind == "mark" and word.text in (",", ".", ";", "\n", "(", ")", ":", "!"):
                break
            if word.text in ("and", "but", "then") and self.starts_clause(place + 1):
                break
            place += 1
        return place

    def taken_affirmed(self) -> Things | None:
        """Return what the clause just read said to be there, and forget it."""
        affirmed, self.affirmed = self.affirmed, None
        return affirmed

    def skip(self, at: int) -> int:
        """Return the place after courtesies, adverbs and marks."""
        if self.text(at) == "," and self.text(at + 1) in ("would", "could", "will", "can") and at + 3 >= len(self.words):
            return len(self.words)
        while at < len(self.words) and self.text(at) in _SKIPPED:
            if self.text(at) in ("thank", "thanks"):
                while self.text(at + 1) in (
                    "you",
                    "very",
                    "so",
                    "much",
                    "a",
                    "lot",
                    "in",
                    "advance",
                    "for",
                    "your",
                    "help",
                ):
                    at += 1
            if self.text(at) == "there" and (self.text(at + 1) in BE or self.text(at + 1) in MODALS
                                             or self.text(at + 1) in ("need", "has", "have")):  # fmt: skip
                break
            if self.text(at) == "for" and self.text(at + 1) not in ("now", "me", "us"):
                break
            if self.text(at) == "next" and self.text(at + 1) == "to":
                break
            if self.text(at) == "for" and self.text(at + 1) in ("me", "us"):
                at += 1
            if self.text(at) == "as" and self.text(at + 1) not in ("well", "soon"):
                break
            at += 1
        return at

    # Clauses

    def read(self, at: int) -> tuple[list[Statement], int]:
        """Read the clause at a place.

        Raises
        ------
        NotUnderstood
            Where the words make no clause.
        """
        if self.words[at].kind == "ordinal" and verb_at(self.words, at + 1, self.lexicon) is not None:
            at += 1
        if self.words[at].kind == "ordinal" and self.text(at + 1) == "," and self.starts_clause(at + 2):
            at += 2
        if self.text(at) in ("only", "just", "to") and verb_at(self.words, at + 1, self.lexicon) is not None:
            at += 1
        if at >= len(self.words):
            raise NotUnderstood(len(self.words) - 1, len(self.words))
        for opening in (self._negated, self._existential, self._going, self._desired, self._of_persons, self._with_verb,
                        self._with_predicate):  # fmt: skip
            found = opening(at)
            if found is not None:
                return found
        return self._verbless(at)

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
        if self.text(place) in ("touch", "disturb", "alter", "bother", "affect", "move", "break", "mess"):
            items = self.items(place + 1 + (self.text(place + 1) == "with"))
            end = items[-1].end
            return [Keep(things=self._all(i.things()), quote=self.quote(at, end)) for i in items if not i.is_room], end
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
        items = self.items(place)
        end = items[-1].end
        while self.text(end) in ("on", "off", "any", "more", "either", "yet", "at", "all", "anymore", "there", "away"):
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
            own, _ = _joined(list(items[-1].places))
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
            return [_state(item.things(), state, quote, value=not value)], end + 1
        if item.phrase.amount.kind == "some" and not item.phrase.definite:
            things = msgspec.structs.replace(item.things(), amount=Amount(kind="all", number=0))
            return [Remove(things=things, quote=self.quote(at, end))], end
        raise NotUnderstood(at, self.boundary(at))

    def _existential(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``there should be four chairs in the break room``."""
        if self.text(at) != "there":
            return None
        place = at + 1
        contracted = self.words[at].raw in ("there's", "theres")
        while self.text(place) in MODALS or self.text(place) in (
            "be", "is", "are", "to", "need", "has", "have", "not", "also", "always", "ought", "supposed", "no", "longer",
        ):  # fmt: skip
            place += 1
        if place == at + 1 and not contracted:
            return None
        between = {w.text for w in self.words[at:place]}
        negated = "not" in between or "no" in between
        told = between <= {"there", "is", "are", "no", "not", "currently", "still"} and (
            negated or self.text(place) == "no"
        )
        items = self.items(place)
        if self._is_way(items[0].phrase):
            return self._way(at, items[0].phrase.end)
        end = items[-1].end
        if any(item.is_room for item in items):
            return [Mention(quote=self.quote(at, end))], end
        following = self._state_after(items[-1], end, at)
        if following is not None:
            return following
        affirmed = not negated and len(items) == 1 and (between or {"is"}) <= {"there", "is", "are", "already", "still", "currently"}
        if affirmed and items[0].phrase.amount.kind in ("some",):
            self.affirmed = items[0].things()
        if told or (items[0].phrase.amount.kind == "none" and between <= {"there", "is", "are"}):
            goal, _ = self._shared_goal(items, items[0])
            self.frame = Place(rooms=goal.rooms) if goal.rooms is not None else self.frame
            return [Mention(quote=self.quote(at, end))], end
        if len(items) == 1 and between <= {"there", "is", "are", "already", "still", "currently"}:
            self.topic = items[0].things()
        out: list[Statement] = []
        for item in items:
            out += self._there(item, self._shared_goal(items, item), self.quote(at, end), negated=negated)
        return out, end

    def _there(self, item: Item, shared: tuple[Place, bool], quote: str, *, negated: bool = False) -> list[Statement]:
        """Return that things are at a place, or are not."""
        amount = item.phrase.amount
        goal, each = self._framed(shared)
        things = item.phrase.things()
        if amount.kind == "fewer":
            fewer = msgspec.structs.replace(things, amount=Amount(number=amount.number), plural=False)
            return [Remove(things=with_place(fewer, goal) if goal != Place() else fewer, quote=quote)]
        if negated and amount.kind == "at_most":
            negated = False
        if amount.kind == "none" or negated:
            gone = with_place(things, goal) if goal != Place() else things
            return [Remove(things=msgspec.structs.replace(gone, amount=Amount(kind="all", number=0)), quote=quote)]
        if item.phrase.definite and not item.phrase.noun.kind == "anything":
            return [Move(things=things, place=goal, or_new=True, quote=quote)]
        return [Ensure(things=things, place=goal, each=each, quote=quote)]

    def _framed(self, goal: tuple[Place, bool]) -> tuple[Place, bool]:
        """Return a place with what the sentence began with."""
        place, each = goal
        each = each or (self.frame.rooms is not None and self.frame.rooms.every and bool(self.frame.rooms.words))
        return (place if self.frame == Place() else merged(place, self.frame) if place != Place() else self.frame), each

    def _shared_goal(self, items: Sequence[Item], item: Item) -> tuple[Place, bool]:
        """Return where a thing of several goes: its own place, else the next one's after it, else the last before it."""
        at = items.index(item)
        if items[at].places:
            return items[at].goal()
        for other in (*items[at:], *reversed(items[:at])):
            goal = other.goal()
            if goal[0].anchor is not None or goal[0].rooms is not None:
                return goal
        return Place(), False

    def _is_way(self, phrase: NounPhrase) -> bool:
        return bool(phrase.noun.words) and self.lexicon.is_way(phrase.noun.words[-1])

    def _desired(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``I want``, ``we need``, ``I would like``, ``can you``, ``make sure that`` and what follows."""
        place = at
        who = self.text(place)
        if who in ("i", "we", "you", "one", "they", "it") and who not in ("it",):
            place += 1
            while self.text(place) in MODALS or self.text(place) in (
                "really",
                "also",
                "just",
                "do",
                "still",
                "ve",
                "d",
                "ll",
            ):
                place += 1
            if self.text(place) in ("think", "believe", "guess", "feel", "suggest", "propose", "ask", "hope"):
                return self.read(place + 1 + (self.text(place + 1) in ("that", "you")) + (self.text(place + 2) == "to"))
            if self.text(place) == "not" and self.text(place + 1) in ("want", "like", "wish"):
                return self._unwanted(at, place + 2)
            longer = {"anymore", "longer"} & {w.text for w in self.words} or "any more" in self.quote(
                at, len(self.words)
            )
            if self.text(place) == "not" and self.text(place + 1) == "need" and longer:
                return self._unwanted(at, place + 2)
            if self.text(place) == "not":
                raise NotUnderstood(at, self.boundary(at))
            if self.text(place) == "rather" and self.text(place + 1) == "not":
                return self._unwanted(at, place + 2)
            pleased = self.text(place) == "be" and self.text(place + 1) in ("glad", "happy", "grateful", "pleased")
            if pleased and self.text(place + 2) in ("of", "with", "about", "for"):
                return self._wanted(at, place + 3)
            if self.text(place) in ("was", "am", "were", "are") and self.text(place + 1) in ("hoping", "looking"):
                return self._wanted(at, place + 2)
            if self.text(place) in (
                "like",
                "love",
                "want",
                "need",
                "prefer",
                "require",
                "have",
                "wish",
                "expect",
                "fancy",
                "appreciate",
            ):
                return self._wanted(at, place + 1)
            if who in ("you",) and place > at + 1:
                return self.read(self.skip(place))
            return None
        if who == "what" and self.text(place + 1) in ("i", "we") and self.text(place + 3) == "is":
            return self._wanted(at, place + 4)
        if who in MODALS and self.text(place + 1) == "it" and self.text(place + 3) == "possible":
            return self._wanted(at, place + 4 + (self.text(place + 4) == "for"))
        if who in MODALS and self.text(place + 1) in ("you", "we", "i", "somebody", "someone"):
            place += 2
            while self.text(place) in ("please", "maybe", "just", "also", "perhaps", "kindly", "possibly", "be", "so", "kind", "as",
                                       "to", "mind"):  # fmt: skip
                place += 1
            if self.text(place) in ("have", "get") and who in ("can", "could", "may", "might"):
                return self._wanted(at, place + 1)
            return self.read(place)
        if who in MODALS and self.text(place + 1) not in ("not", "it"):
            asked = self.item(place + 1)
            if asked is not None and self.text(asked.end) in (
                "be",
                "go",
                "get",
                "have",
                "stand",
                "move",
                "come",
                "face",
            ):
                found = self._predicate(asked, asked.end, at)
                if found is not None:
                    return found
        if self.words[at].raw == "let's":
            return self.read(place + 1)
        if who in ("let",) and self.text(place + 1) in ("us", "me", "there"):
            return self.read(place + 1 + (self.text(place + 1) != "there"))
        return None

    def _going(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the nurse must be able to walk from the lobby to the lab``."""
        if self.text(at) in ("there", "make", "check", "ensure", "verify"):
            return None
        subject = self.item(at)
        if subject is not None and subject.phrase.noun.kind == "object" and not self._is_way(subject.phrase):
            return None
        return self._reaching(at, at)

    def _of_persons(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the officer on duty wants a phone on the desk``: what persons want, who are no part of the scene."""
        for place in range(at + 1, min(at + 8, len(self.words))):
            word = self.words[place]
            before = self.words[at:place]
            if self.lexicon.is_way(word.text) and {"have", "has", "need"} & {w.text for w in before}:
                return self._way(at, place + 1)
            if word.raw in ("like", "love") and "would" in {w.text for w in before}:
                return self._wanted(at, place + 1)
            known = any(self.lexicon.is_own_room((w.text,)) or self.lexicon.is_object((w.text,)) for w in before)
            if known and not {"would", "have", "has"} & {w.text for w in self.words[at : place + 2]}:
                return None
            if word.raw == "asked" and self.text(place + 1) == "for":
                return self._wanted(at, place + 2)
            having = {"have", "has", "need"} & {w.text for w in before}
            if having:
                continue
            if word.kind == "mark" or word.text in BE:
                return None
            if (
                word.raw in ("wants", "want", "needs", "need", "likes", "requires", "expects", "lacks")
                and self.item(at) is None
            ):
                return self._wanted(at, place + 1)
        return None

    def _unwanted(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``we do not want any chairs in the lobby``: they are to go."""
        while self.text(place) in ("to", "see", "have", "find", "there", "be"):
            place += 1
        place += 2 * (self.text(place) == "you" and self.text(place + 1) == "to")
        verb = verb_at(self.words, place, self.lexicon)
        if verb is not None:
            return self._negated_verb(at, *verb)
        items = self.items(place)
        end = items[-1].end
        while self.text(end) in ("any", "more", "anymore", "at", "all", "there", "longer"):
            end += 1
        quote = self.quote(at, end)
        return [self._removed(items, item, (), (), quote) for item in items if not item.is_room], end

    def _wanted(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read what is wanted: a clause after ``to``, a thing with a predicate, or a thing."""
        place += self.text(place) in ("that", "for", "me", "us")
        if self.text(place) == "nothing":
            nothing = self._nothing(place)
            if nothing is not None:
                return nothing
        if self.text(place) == "to":
            place += 1
            if self.text(place) in ("have", "see", "get", "find"):
                place += 1
            elif verb_at(self.words, place, self.lexicon) is None and self.item(place + 1) is not None:
                item = self.item(place + 1)
                assert item is not None
                if self.text(item.end) not in (",", "so", "and", "but") or "so" not in (self.text(item.end), self.text(item.end + 1)):
                    raise NotUnderstood(at, self.boundary(at))
                self.topic = item.things()
                return [Mention(quote=self.quote(at, item.end))], item.end
            else:
                return self.read(place)
        if self.text(place) == "you" and self.text(place + 1) == "to":
            return self.read(place + 2)
        if self.text(place) == "there":
            found = self._existential(place)
            if found is not None:
                return found
        item = self.item(place)
        if item is None:
            raise NotUnderstood(place, self.boundary(place))
        if self._is_way(item.phrase):
            return self._way(at, item.phrase.end)
        if self.text(item.end) in ("to", "be") or self.predicate_follows(item.end):
            found = self._predicate(item, item.end, at)
            if found is not None:
                return found
        items = self.items(place)
        end = items[-1].end
        out: list[Statement] = []
        for each in items:
            kind = each.phrase.amount.kind
            if kind in ("exactly", "at_least", "at_most", "none", "all"):
                out += self._there(each, self._shared_goal(items, each), self.quote(at, end))
            elif each.is_room:
                raise NotUnderstood(place, end)
            else:
                out.append(self._added(items, each, self.quote(at, end)))
        return out, end

    # Clauses with a verb

    def _with_verb(self, at: int) -> tuple[list[Statement], int] | None:
        verb = verb_at(self.words, at, self.lexicon)
        if verb is None:
            return None
        deed, place = verb
        readers: dict[Deed, Callable[[int, int], tuple[list[Statement], int]]] = {
            "add": self._add, "bring": self._add, "remove": self._remove, "clear": self._clear, "move": self._move,
            "swap": self._swap, "replace": self._replace, "switch": self._switch, "open": self._open,
            "close": self._close, "start": self._start, "stop": self._stop, "paint": self._paint,
            "rename": self._rename, "furnish": self._furnish, "equip": self._equip, "enlarge": self._enlarge,
            "shrink": self._shrink, "make": self._make, "turn": self._rotate, "check": self._check, "undo": self._undo,
            "redo": self._undo, "restore": self._restore, "leave": self._leave, "tidy": self._tidy, "keep": self._keep, "let": self._let,
            "change": self._change, "give": self._give, "take": self._take, "go": self._go, "set": self._set, "want": self._want,
            "repeat": self._repeat, "connect": self._connect, "use": self._use,
        }  # fmt: skip
        reader = readers.get(deed)
        if reader is None:
            return None
        return reader(at, place)

    def _add(self, at: int, place: int) -> tuple[list[Statement], int]:
        if self.text(place) in ("on", "off") and self.text(at) == "put":
            return self._switch(at, place)
        door = self._door_between(at, place)
        if door is not None:
            return door
        place = self._fronted(place)
        for_whom = self.text(place) in ("me", "us") and self.text(place + 1) != "to"
        items = self.items(place + for_whom)
        end = items[-1].end
        back = self.text(end) == "back" or "back" in (w.text for w in self.words[at:place])
        if back and len(items) == 1 and not items[0].places and (items[0].phrase.refers or items[0].phrase.definite):
            end += self.text(end) == "back"
            while self.text(end) in ("where", "it", "they", "was", "were", "to", "its", "place", "there", "again"):
                end += 1
            return [History(what="restore", things=items[0].things(), quote=self.quote(at, end))], end
        verb = self.text(at)
        if len(items) == 1 and verb in ("put", "leave") and self.text(end) in ("on", "off"):
            state, value = STATE_WORDS[self.text(end)]
            return [_state(items[0].things(), state, self.quote(at, end + 1), value=value)], end + 1
        if items[0].is_room and self.text(end) == "with":
            return self._equip(at, place)
        source_only = bool(items[0].places) and all(p.source for p in items[0].places)
        if len(items) == 1 and self.text(at) in ("fetch", "bring", "get", "carry", "take") and items[0].phrase.definite and source_only:
            self.topic = items[0].things()
            return [Mention(quote=self.quote(at, end))], end
        structure = self._new_core(items, at, end)
        if structure is not None:
            return [structure], end
        if any(w.text in ("or", "either") for w in self.words[place:end]):
            raise NotUnderstood(place, end)
        items, further = self._places_after_places(items)
        if any(item.is_room for item in items):
            raise NotUnderstood(place, end)
        out = [self._added(items, item, self.quote(at, end)) for item in items]
        for extra in further:
            out += [self._elsewhere(statement, extra) for statement in out[: len(items)]]
        return self._with_companions(items[-1], out, at, end)

    def _places_after_places(self, items: list[Item]) -> tuple[list[Item], list[Item]]:
        """Tell further places from things: in ``a mug on the table and the desk`` the desk is a place."""
        at = next((k for k in range(1, len(items)) if items[k - 1].places and not items[k].places and not items[0].phrase.definite
                   and (items[k].is_room or items[k].phrase.definite)), len(items))  # fmt: skip
        return items[:at], items[at:]

    def _elsewhere(self, statement: Statement, where: Item) -> Statement:
        """Return the same at another place."""
        old = getattr(statement, "place", Place())
        if where.is_room or (where.phrase.noun.kind == "both" and old.anchor is None):
            place = msgspec.structs.replace(old, rooms=where.rooms())
        else:
            place = Place(relation=old.relation or "on", anchor=where.phrase.things())
        return msgspec.structs.replace(statement, place=place)

    def _with_companions(self, item: Item, said: list[Statement], at: int, end: int) -> tuple[list[Statement], int]:
        """Read what comes with new things: ``12 desks, each with a chair``, ``a tray with two mugs``."""
        place = end + (self.text(end) == ",")
        each = self.text(place) == "each"
        place += each
        main = said[-1]
        if self.text(place) != "with" or not isinstance(main, Add | Ensure):
            return said, end
        try:
            others = self.items(place + 1)
        except NotUnderstood:
            return said, end
        stop = others[-1].end + (self.text(others[-1].end) == "each")
        each = each or stop > others[-1].end
        quote = self.quote(at, stop)
        times = max(1, main.things.amount.number) if each else 1
        out = [*said]
        for other in others:
            things = other.phrase.things()
            number = max(1, things.amount.number) * times
            things = msgspec.structs.replace(things, amount=Amount(kind=things.amount.kind, number=number))
            where = other.goal()[0]
            if where == Place():
                on_it = not self.lexicon.stands(other.phrase.noun.words)
                last = Things(refers="last", definite=True, amount=Amount(number=0))
                where = Place(relation="on", anchor=last) if on_it else main.place
            out.append(Add(things=things, place=where, quote=quote))
        return out, stop

    def _take(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``take the mug to the kitchen``, ``take the mug off the desk``, and ``take the mug and put it ...``."""
        items = self.items(place)
        end = items[-1].end
        places = items[-1].places
        if any(p.goal and not p.source for p in places):
            return self._move(at, place)
        if (
            self.text(end) in ("and", ",", "then")
            and read_place(self.words, end + 1, self.lexicon, self.floors) is not None
        ):
            return self._move(at, place)
        away = self.text(end) in ("away", "out", "off")
        if self._goes_on_with_it(end + away):
            self.topic = items[0].things()
            return [Mention(quote=self.quote(at, end + away))], end + away
        if away or (any(p.source for p in places) and self.text(at) == "take"):
            return self._remove(at, place)
        if self.text(at) in ("grab", "pick") and not items[0].phrase.definite:
            return self._add(at, place)
        raise NotUnderstood(at, self.boundary(at))

    def _goes_on_with_it(self, at: int) -> bool:
        """Whether the next clause does something with what the one before took."""
        after = self.conjunction(at) or self.skip(at)
        later = {w.text for w in self.words[after : after + 8]}
        return self.starts_clause(after) and bool(later & {"it", "them", "that"})

    def _go(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``find the wardrobe and open it``: the thing is only what the next clause is about."""
        items = self.items(place)
        end = items[-1].end
        if not (self._goes_on_with_it(end) or end >= len(self.words) or self.text(end) in (":", ".")):
            raise NotUnderstood(at, self.boundary(at))
        self.topic = items[0].things()
        return [Mention(quote=self.quote(at, end))], end

    def _fronted(self, place: int) -> int:
        """Read a place before the object ("put on the desk two mugs") into the frame."""
        read = read_place(self.words, place, self.lexicon, self.floors)
        if read is None or self.text(place) in ("next", "back", "there", "here", "second", "first", "third"):
            return place
        following, end = self.places(place)
        end += self.text(end) == ","
        if self.phrase(end) is None:
            return place
        self.frame, _ = _joined(following)
        return end

    def _added(self, items: Sequence[Item], item: Item, quote: str) -> Statement:
        """Return the statement of ``put X at Y``: a move of what is there, else something new."""
        goal, each = self._framed(self._shared_goal(items, item))
        phrase = item.phrase
        shared = item.places or not any(other.places for other in items)
        source = _joined([p for p in item.places if p.source])[0] if shared else Place()
        if any(p.relative or p.goal for p in item.places) and (phrase.definite or phrase.refers):
            source, goal, each = self._source_and_goal(item.places)
            goal, each = self._framed((goal, each))
        moved = phrase.definite or (phrase.refers and phrase.amount.kind != "more") or source != Place() or phrase.amount.kind in ("all", "all_but")
        if not moved:
            if phrase.amount.kind in ("exactly", "at_least", "at_most"):
                return Ensure(things=phrase.things(), place=goal, each=each, quote=quote)
            return Add(things=phrase.things(), place=goal, each=each, quote=quote)
        things = phrase.things()
        if source != Place():
            things = with_place(things, self._framed((source, False))[0] if source.rooms is None else source)
        return Move(things=things, place=goal, or_new=source == Place() and not phrase.refers, quote=quote)

    def _new_core(self, items: Sequence[Item], at: int, end: int) -> Statement | None:
        """Read ``add a second stair``."""
        if (
            len(items) != 1
            or not items[0].phrase.noun.words
            or self.text(at) not in ("add", "build", "create", "install", "put")
        ):
            return None
        head = items[0].phrase.noun.words[-1]
        what = {"stair": "stair", "staircase": "stair", "stairwell": "stair", "elevator": "elevator"}.get(head)
        if what is None:
            return None
        where = items[0].goal()[0].rooms
        return Reshape(what="stair" if what == "stair" else "elevator", rooms=where, quote=self.quote(at, end))

    def _door_between(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``add a door between the kitchen and the dining room``."""
        start = place
        while self.text(place) in ("a", "an", "another", "the", "new", "connecting", "internal", "one", "extra"):
            place += 1
        if self.text(place) not in ("door", "doorway", "opening", "passage"):
            return None
        linking = self.text(place + 1)
        if linking not in ("between", "from", "connecting", "linking", "joining") and start == place:
            return None
        if linking not in ("between", "from", "connecting", "linking", "joining"):
            return None
        return self._connect(at, place + 2)

    def _connect(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read the two rooms that a door shall connect."""
        one = self.item(place, places=False)
        if one is None or one.phrase.noun.kind not in ("room", "both"):
            raise NotUnderstood(place, self.boundary(place))
        end = one.end
        if self.text(end) not in ("and", "to", "with"):
            raise NotUnderstood(place, self.boundary(place))
        other = self.item(end + 1)
        if other is None or other.phrase.noun.kind not in ("room", "both"):
            raise NotUnderstood(place, self.boundary(place))
        end = other.end
        if self.text(end) in ("with", "by") and self.text(end + 2) in ("door", "doorway", "opening"):
            end += 3
        floors = other.rooms().floors
        first = msgspec.structs.replace(one.rooms(), floors=floors)
        return [Reshape(what="door", rooms=first, other=other.rooms(), quote=self.quote(at, end))], end

    def _remove(self, at: int, place: int) -> tuple[list[Statement], int]:
        taking = self.text(at) in ("take", "pull", "move", "put")
        if self.text(place) in ("from", "out", "off") and not taking:
            place = self._fronted(place)
        items = self.items(place)
        end = items[-1].end
        if taking and any(p.goal and not p.source for p in items[-1].places):
            return self._move(at, place)
        while self.text(end) in ("away", "out", "off", "completely", "altogether", "entirely", "too"):
            end += 1
        more, end = self.places(end)
        end, besides = self.exceptions(end)
        late, end = self.places(end + 1) if besides and self.text(end) == "," else ((), end)
        more = (*more, *late)
        out: list[Statement] = []
        quote = self.quote(at, end)
        for item in items:
            if item.is_room:
                raise NotUnderstood(place, end)
            out.append(self._removed(items, item, more, besides, quote))
        return out, end

    def _removed(
        self, items: Sequence[Item], item: Item, more: Sequence[ReadPlace], besides: tuple[Things, ...], quote: str
    ) -> Statement:
        at = items.index(item)
        own = item.places or next((other.places for other in (*items[at:], *reversed(items[:at])) if other.places), ())
        place, _ = self._framed(_joined([*own, *more]))
        things = item.phrase.things()
        number = next((b.amount.number for b in besides if b.refers == "last" and b.amount.number), 0)
        if number and things.amount.kind == "all":
            things = msgspec.structs.replace(things, amount=Amount(kind="all_but", number=number))
            besides = ()
        told = next((b.place for b in besides if b.place is not None), None)
        if place == Place() and told is not None:
            place = told
        if things.noun == "" and not things.refers:
            return Clear(place=place, spare=besides, quote=quote)
        if item.phrase.amount.kind == "some" and item.phrase.amount.number == 0 and item.phrase.plural:
            things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
        things = msgspec.structs.replace(things, beside=tuple(_named_as(one, things.noun) for one in besides))
        return Remove(things=with_place(things, place) if place != Place() else things, quote=quote)

    def exceptions(self, at: int) -> tuple[int, tuple[Things, ...]]:
        """Read ``except the vase and the lamp``."""
        place = at + (self.text(at) == ",")
        for phrase in (("except", "for"), ("apart", "from"), ("other", "than"), ("aside", "from"), ("except",),
                       ("but", "not"), ("and", "not"), ("not",), ("besides",), ("but",), ("save", "for"), ("excluding",), ("without",)):  # fmt: skip
            span = tuple(w.text for w in self.words[place : place + len(phrase)])
            if span != phrase:
                continue
            if self.starts_clause(place + len(phrase)):
                return at, ()
            places, stop = self.places(place + len(phrase))
            if places:
                return stop, (Things(amount=Amount(kind="all", number=0), plural=True, place=_joined(places)[0]),)
            try:
                items = self.items(place + len(phrase))
            except NotUnderstood:
                return at, ()
            return items[-1].end, tuple(_kind_of_its_own(self._all(item.things())) for item in items)
        return at, ()

    def _all(self, things: Things) -> Things:
        """Return all that words describe, where they give no number."""
        if things.amount.number == 0 and things.amount.kind == "some":
            return msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
        return things

    def _clear(self, at: int, place: int) -> tuple[list[Statement], int]:
        place += self.text(place) in ("up", "out", "off", "away")
        items = self.items(place)
        end = items[-1].end
        item = items[0]
        comes_from = any(p.source or p.place.relation in ("on", "in") for p in item.places)
        if item.phrase.noun.kind == "anything" or (comes_from and not item.is_room and item.phrase.plural):
            return self._remove(at, place)
        if self.text(end) == "of" or (
            item.places and item.places[-1].start and self.words[item.places[-1].start].text == "of"
        ):
            return self._cleared_of(at, item)
        while self.text(end) in ("up", "out", "off", "completely", "totally", "entirely"):
            end += 1
        end, spare = self.exceptions(end)
        quote = self.quote(at, end)
        return [Clear(place=self._emptied(each), spare=spare, quote=quote) for each in items], end

    def _tidy(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``tidy the hall``, which by itself asks for nothing that can be checked."""
        items = self.items(place)
        if any(p.source for item in items for p in item.places):
            return self._remove(at, place)
        end = items[-1].end
        return [Mention(quote=self.quote(at, end))], end

    def _emptied(self, item: Item) -> Place:
        """Return a place that is to be empty: a room, or on and in furniture."""
        if item.is_room or (item.phrase.noun.kind == "both" and not item.places):
            return Place(rooms=item.rooms())
        where, _ = _joined(list(item.places))
        return Place(relation="on", anchor=item.phrase.things(), rooms=where.rooms)

    def _cleared_of(self, at: int, item: Item) -> tuple[list[Statement], int]:
        """Read ``clear the lobby of chairs``."""
        joint = next(k for k in range(item.phrase.end, len(self.words)) if self.text(k) == "of")
        where = Item(item.phrase, tuple(p for p in item.places if p.end <= joint), joint)
        gone = self.items(joint + 1)
        end = gone[-1].end
        return self._gone_from(where, gone, self.quote(at, end)), end

    def _gone_from(self, where: Item, gone: Sequence[Item], quote: str) -> list[Statement]:
        out: list[Statement] = []
        place = self._emptied(where)
        for item in gone:
            things = item.phrase.things()
            if not things.noun and not things.refers:
                out.append(Clear(place=place, quote=quote))
            else:
                whole = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
                out.append(Remove(things=with_place(whole, place), quote=quote))
        return out

    def _move(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items(place)
        end = items[-1].end
        if any(item.is_room for item in items):
            raise NotUnderstood(place, end)
        if (
            self.text(end) in ("and", ",", "then")
            and read_place(self.words, end + 1, self.lexicon, self.floors) is not None
        ):
            more, end = self.places(end + 1)
            items = [*items[:-1], Item(items[-1].phrase, (*items[-1].places, *more), end)]
        goal_of = [p for p in items[-1].places if not p.source]
        if not goal_of:
            raise NotUnderstood(at, self.boundary(at))
        out: list[Statement] = []
        quote = self.quote(at, end)
        for item in items:
            own = item.places or items[-1].places
            source, goal, each = self._source_and_goal(own)
            if goal == Place():
                raise NotUnderstood(at, end)
            things = item.phrase.things()
            if source != Place():
                things = with_place(things, source)
            out.append(Move(things=self._all_if_plural(things), place=goal, quote=quote))
        return out, end

    def _all_if_plural(self, things: Things) -> Things:
        return self._all(things) if things.plural else things

    def _source_and_goal(self, places: Sequence[ReadPlace]) -> tuple[Place, Place, bool]:
        """Return where things come from and where they go: the goal begins with ``to``, or is the last place."""
        explicit = next((k for k, p in enumerate(places) if p.goal), None)
        told = max((k for k, p in enumerate(places) if p.relative), default=-1)
        if explicit is None and 0 <= told < len(places) - 1:
            explicit = told + 1
        leaving = next((k for k, p in enumerate(places) if p.source), None)
        if explicit is None:
            related = [
                k for k, p in enumerate(places) if not p.source and (p.place.relation or p.place.spot or p.place.facing)
            ]
            anew = [
                k for k, p in enumerate(places) if not p.source and p.place.rooms is not None and p.place.rooms.words
            ]
            explicit = (
                related[-1]
                if related
                else anew[-1]
                if anew
                else max((k for k, p in enumerate(places) if not p.source), default=0)
            )
            if leaving is not None and leaving > explicit:
                explicit = min(k for k, p in enumerate(places) if not p.source)
        if leaving is not None and leaving > explicit:
            goal, each = _joined(places[explicit:leaving])
            source, _ = _joined([*places[:explicit], *places[leaving:]])
        else:
            goal, each = _joined(places[explicit:])
            source, _ = _joined(places[:explicit])
        return source, goal, each

    def _swap(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items(place)
        end = items[-1].end
        quote = self.quote(at, end)
        if len(items) == 2 and items[0].is_room and items[1].is_room:
            return [Swap(one=items[0].rooms(), other=items[1].rooms(), quote=quote)], end
        if len(items) == 1 and items[0].is_room and self.text(end) == ":":
            named = self.items(end + 1)
            if len(named) == 2:
                quote = self.quote(at, named[1].end)
                return [Swap(one=named[0].rooms(), other=named[1].rooms(), quote=quote)], named[1].end
        if len(items) == 1 and items[0].is_room and items[0].phrase.amount.number == 2:
            return [Swap(one=items[0].rooms(), other=Rooms(same=True), quote=quote)], end
        joint = next((k for k in range(place, len(self.words)) if self.text(k) in ("for", "with", "by", "to", "against")
                      and self.phrase(k + 1) is not None), None)  # fmt: skip
        if len(items) == 1 and joint is not None:
            return self._replaced_by(at, place, joint)
        if len(items) == 2:
            one, other = items
            shared = other.places and not one.places
            first = one.things() if not shared else with_place(one.phrase.things(), _joined(list(other.places))[0])
            return [Swap(one=first, other=other.things(), quote=quote)], end
        raise NotUnderstood(at, self.boundary(at))

    def _replaced_by(self, at: int, place: int, joint: int) -> tuple[list[Statement], int]:
        """Read ``X with Y``: an exchange of places where both are there, else something new for something old."""
        before = ClauseReader(self.words[:joint], self.lexicon, self.floors, self.quote)
        old = before.items(place)
        self.last_noun = old[-1].phrase.noun
        new = self.items(joint + 1)
        end = new[-1].end
        quote = self.quote(at, end)
        if len(old) == 1 and len(new) == 1 and old[0].is_room and new[0].is_room:
            return [Swap(one=old[0].rooms(), other=new[0].rooms(), quote=quote)], end
        swapped = self.text(at) in ("swap", "exchange", "trade", "interchange")
        if swapped and len(new) == 1 and new[0].phrase.definite and not new[0].phrase.refers:
            return [Swap(one=old[0].things(), other=new[0].things(), quote=quote)], end
        out: list[Statement] = []
        for item in old:
            things = item.things()
            for other in new:
                if other.places:
                    things = with_place(things, _joined(list(other.places))[0]) if not item.places else things
            place_, _ = self._framed((things.place or Place(), False))
            things = msgspec.structs.replace(things, place=place_ if place_ != Place() else None)
            out += [
                Replace(things=self._all_if_plural(things), by=other.phrase.things(), quote=quote) for other in new[:1]
            ]
            out += [Add(things=other.phrase.things(), place=things.place or Place(), quote=quote) for other in new[1:]]
        return out, end

    def _replace(self, at: int, place: int) -> tuple[list[Statement], int]:
        joint = next((k for k in range(place, len(self.words)) if self.text(k) in ("with", "by", "for")), None)
        if joint is None:
            raise NotUnderstood(at, self.boundary(at))
        if self.text(at) == "substitute" and self.text(joint) == "for":
            new = ClauseReader(self.words[:joint], self.lexicon, self.floors, self.quote).items(place)
            old = self.items(joint + 1)
            quote = self.quote(at, old[-1].end)
            return [Replace(things=old[0].things(), by=new[0].phrase.things(), quote=quote)], old[-1].end
        return self._replaced_by(at, place, joint)

    def _switch(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``turn on the lamp``, ``switch the lamp off``, ``turn the sofa by 90 degrees``."""
        place -= self.text(place - 1) in ("on", "off") and place - 1 > at
        misspelt = self.text(place) == "of" and self.text(place + 1) in ("the", "all", "every", "both")
        if self.text(place) in ("on", "off") or misspelt:
            value = self.text(place) == "on"
            items = self.items(place + 1)
            end, besides = self.exceptions(items[-1].end)
            quote = self.quote(at, end)
            return [self._state_of(items, i, "on", besides, quote, value=value) for i in items], end
        items = self.items(place)
        end = items[-1].end
        if self.text(end) in ("on", "off") or (self.text(end) in ("back",) and self.text(end + 1) in ("on", "off")):
            end += self.text(end) == "back"
            value = self.text(end) == "on"
            places, stop = self.places(end + 1)
            stop, besides = self.exceptions(stop)
            quote = self.quote(at, stop)
            out: list[Statement] = []
            for item in items:
                whole = Item(item.phrase, (*item.places, *places), stop)
                out.append(self._state_of([whole], whole, "on", besides, quote, value=value))
            return out, stop
        if (len(items) == 1 and items[0].is_room) or (
            items[0].places and items[0].places[-1].goal and items[0].phrase.noun.kind != "object"
        ):
            return self._furnish(at, place)
        return self._rotate(at, place)

    def _state_of(
        self, items: Sequence[Item], item: Item, state: str, besides: tuple[Things, ...], quote: str, *, value: bool
    ) -> Statement:
        own = item.places or next((other.places for other in items[items.index(item) :] if other.places), ())
        place, _ = self._framed(_joined(list(own)))
        things = item.phrase.things()
        if item.is_room:
            rooms = item.rooms()
            things, place = (
                Things(noun="light", definite=True, plural=True, amount=Amount(kind="all", number=0)),
                Place(rooms=rooms),
            )
        spared = tuple(_named_as(one, things.noun) for one in besides)
        things = msgspec.structs.replace(self._all_if_plural(things), beside=spared)
        return _state(with_place(things, place) if place != Place() else things, state, quote, value=value)

    def _open(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "open", value=True)

    def _close(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "open", value=False)

    def _start(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "on", value=True)

    def _stop(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "on", value=False)

    def _set_state(self, at: int, place: int, state: str, *, value: bool) -> tuple[list[Statement], int]:
        items = self.items(place)
        end, besides = self.exceptions(items[-1].end)
        quote = self.quote(at, end)
        return [self._state_of(items, item, state, besides, quote, value=value) for item in items], end

    def _colour_at(self, at: int) -> tuple[str, str, int] | None:
        """Read a colour or a material: ``dark red``, ``oak parquet``."""
        place = at
        while self.text(place) in (
            "a",
            "an",
            "the",
            "in",
            "light",
            "dark",
            "pale",
            "bright",
            "deep",
            "soft",
            "to",
            "of",
            "as",
            "made",
        ):
            place += 1
        colour = material = ""
        start = place
        while self.text(place) in COLOUR_WORDS or self.text(place) in MATERIALS:
            word = self.text(place)
            if word in COLOUR_WORDS:
                colour = COLOUR_WORDS[word]
            else:
                material = MATERIALS[word]
            place += 1
        if place == start:
            return None
        place += self.text(place) in ("colour", "color", "flooring", "floor", "wallpaper")
        return colour, material, place

    def _paint(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items_or_surfaces(place)
        if items is None:
            raise NotUnderstood(at, self.boundary(at))
        subject, end = items
        colour = self._colour_at(end)
        if colour is None:
            raise NotUnderstood(at, self.boundary(at))
        stop = colour[2]
        return self._painted(subject, colour[0], colour[1], self.quote(at, stop)), stop

    def items_or_surfaces(self, at: int) -> tuple[tuple[Surface, Rooms] | list[Item], int] | None:
        """Read ``the walls of the lobby``, ``the kitchen floor``, or objects."""
        surface = self._surface(at)
        if surface is not None:
            return surface
        try:
            items = self.items(at)
        except NotUnderstood:
            return None
        return items, items[-1].end

    def _surface(self, at: int) -> tuple[tuple[Surface, Rooms], int] | None:
        place = at
        while self.text(place) in ("the", "all", "its", "a", "whole", "all", "four", "every"):
            place += 1
        if self.text(place) in _PART:
            part, end = _PART[self.text(place)], place + 1
            end += self.text(end) in ("colour", "color", "finish", "material", "covering", "paint")
            places, end = self.places(end)
            rooms = _joined(places)[0].rooms if places else self.frame.rooms
            return None if rooms is None else ((part, rooms), end)
        for length in (4, 3, 2, 1):
            head = place + length
            if self.text(head) not in _PART or (self.text(head) == "floor" and self.words[head - 1].kind == "ordinal"):
                continue
            span = tuple(w.text for w in self.words[place:head])
            if self.lexicon.is_room(span) or (
                len(span) > 1 and span[-1].isdecimal() and self.lexicon.is_room(span[:-1])
            ):
                end = head + 1
                end += self.text(end) in ("colour", "color", "finish", "material", "covering")
                places, end = self.places(end)
                rooms = Rooms(words=" ".join(span))
                more = _joined(places)[0].rooms
                rooms = rooms if more is None else merged(Place(rooms=rooms), Place(rooms=more)).rooms or rooms
                return (_PART[self.text(head)], rooms), end
        return None

    def _painted(
        self, subject: "tuple[Surface, Rooms] | list[Item]", colour: str, material: str, quote: str
    ) -> list[Statement]:
        if isinstance(subject, tuple):
            part, rooms = subject
            return [Finish(rooms=rooms, part=part, colour=colour, material=material, quote=quote)]
        out: list[Statement] = []
        for item in subject:
            if item.phrase.noun.kind in ("room", "both") and self.lexicon.is_own_room(item.phrase.noun.words):
                out.append(Finish(rooms=item.rooms(), part="walls", colour=colour, material=material, quote=quote))
            else:
                out.append(
                    Paint(things=self._all_if_plural(item.things()), colour=colour, material=material, quote=quote)
                )
        return out

    def _rename(self, at: int, place: int) -> tuple[list[Statement], int]:
        place += self.text(place) == '"'
        item = self.item(place)
        if item is None or item.phrase.noun.kind not in ("room", "both", "object"):
            raise NotUnderstood(at, self.boundary(at))
        end = item.phrase.end + (self.text(item.phrase.end) == '"')
        rooms = item.phrase.rooms()
        places: list[ReadPlace] = []
        for read in item.places:
            if self.words[read.start].text == "to" or (read.goal and read.place.anchor is not None):
                break
            places.append(read)
            end = read.end
        rooms = Item(item.phrase, tuple(places), end).rooms()
        while self.text(end) in ("to", "as", "into", '"', "the", "be", "called", "named", ":"):
            end += 1
        name, stop = self._name(end)
        return [Rename(room=rooms, name=name, quote=self.quote(at, stop))], stop

    def _name(self, at: int) -> tuple[str, int]:
        """Read a name as it is written, up to a mark or the end."""
        stop = at
        while stop < len(self.words) and self.text(stop) not in (",", '"', ";", "please", "\n") and stop < at + 8:
            if self.text(stop) in ("and", "from") and (self.starts_clause(stop + 1) or self.text(stop) == "from"):
                break
            stop += 1
        if stop == at:
            raise NotUnderstood(at - 1, self.boundary(at - 1))
        name = self.quote(at, stop).strip("\"'“”‘’ ")
        stop += self.text(stop) == '"'
        return name, stop

    def _furnish(self, at: int, place: int) -> tuple[list[Statement], int]:
        item = self.item(place, places=False)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        if item.phrase.noun.kind == "object":
            raise NotUnderstood(at, self.boundary(at))
        places: list[ReadPlace] = []
        end = item.end
        while True:
            read = read_place(self.words, end, self.lexicon, self.floors)
            if read is None or self.text(end) in ("into", "to", "with"):
                break
            places.append(read)
            end = read.end
        rooms = Item(item.phrase, tuple(places), end).rooms()
        while self.text(end) in ("anew", "again", "afresh", "completely", "newly", "new"):
            end += 1
        if self.text(end) == "with":
            return self._equip(at, place)
        kind = ""
        if self.text(end) in ("into", "as", "to", "for", "like"):
            found = self.phrase(end + 1)
            if found is None or found.noun.kind not in ("room", "both"):
                raise NotUnderstood(end, self.boundary(end))
            kind, end = " ".join((*filter(None, [found.noun.owned]), *found.noun.words)), found.end
        return [Furnish(rooms=rooms, kind=kind, quote=self.quote(at, end))], end

    def _equip(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``equip the office with two desks``, ``fill the basket with apples``."""
        where = self.item(place)
        if where is not None and self.text(where.end) == "for":
            colon = next(
                (k for k in range(where.end, min(where.end + 6, len(self.words))) if self.text(k) in (":", "with")),
                None,
            )
            if colon is None:
                raise NotUnderstood(at, self.boundary(at))
            where = Item(where.phrase, where.places, colon)
        elif where is not None and self.text(where.end) == ":":
            more, start = self._skip_storey(where.end + 1)
            where = Item(where.phrase, (*where.places, *more), start - 1)
        elif where is None or self.text(where.end) not in ("with",):
            joint = next((k for k in range(place, len(self.words)) if self.text(k) == "with"), None)
            if joint is None:
                raise NotUnderstood(at, self.boundary(at))
            where = ClauseReader(self.words[:joint], self.lexicon, self.floors, self.quote).item(place)
            if where is None:
                raise NotUnderstood(at, self.boundary(at))
            where = Item(where.phrase, where.places, joint)
        items = self.items(where.end + 1)
        end = items[-1].end
        goal = self._receiver(where)
        each = where.phrase.each or where.phrase.amount.kind == "all" or (where.phrase.plural and where.phrase.definite)
        quote = self.quote(at, end)
        return [self._given(item, goal, quote, each=each) for item in items], end

    def _receiver(self, where: Item) -> Place:
        """Return the place of what is given to a room or to furniture."""
        if where.is_room or (where.phrase.noun.kind == "both" and self.lexicon.is_own_room(where.phrase.noun.words)):
            return Place(rooms=where.rooms())
        place, _ = _joined(list(where.places))
        return merged(Place(relation="on", anchor=where.phrase.things()), place)

    def _given(self, item: Item, goal: Place, quote: str, *, each: bool) -> Statement:
        own = item.goal()[0]
        place = goal if own == Place() else merged(own, goal)
        if place.relation == "on" and place.anchor is not None and self.lexicon.stands(item.phrase.noun.words):
            place = msgspec.structs.replace(place, relation="around" if item.phrase.plural else "beside")
        if item.phrase.amount.kind in ("exactly", "at_least", "at_most"):
            return Ensure(things=item.phrase.things(), place=place, each=each, quote=quote)
        return Add(things=item.phrase.things(), place=place, each=each, quote=quote)

    def _give(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``give the lobby two plants``; ``give me a chair`` asks for it."""
        if self.text(place) in ("me", "us"):
            return self._add(at, place + 1)
        where = self.item(place)
        if where is None:
            raise NotUnderstood(at, self.boundary(at))
        items = self.items(where.end)
        end = items[-1].end
        each = where.phrase.each or where.phrase.amount.kind == "all"
        goal = self._receiver(where)
        return [self._given(item, goal, self.quote(at, end), each=each) for item in items], end

    def _set(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``set the table with eight plates``; otherwise as ``put``."""
        where = self.item(place)
        if where is not None and self.text(where.end) in ("with", ":", "for"):
            return self._equip(at, place)
        return self._add(at, place)

    def _skip_storey(self, at: int) -> tuple[tuple[ReadPlace, ...], int]:
        """Read a storey that only tells where the thing before a colon is (``: 2nd floor, ...``)."""
        read = read_place(self.words, at, self.lexicon, self.floors)
        if read is None or read.place.rooms is None or read.place.rooms.words or self.text(read.end) != ",":
            return (), at
        return (read,), read.end + 1

    def _want(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._wanted(at, place)

    def _amount_of_area(self, at: int) -> tuple[float, bool, int] | None:
        """Read ``by 10 m2`` or ``to 40 m2``."""
        place = at
        while self.text(place) in (
            ",",
            "by",
            "to",
            "about",
            "of",
            "around",
            "up",
            "at",
            "an",
            "another",
            "extra",
            "roughly",
            "approximately",
        ):
            place += 1
        absolute = any(w.text == "to" for w in self.words[at:place])
        if place + 1 < len(self.words) and self.words[place].kind == "number" and self.words[place + 1].text == "m2":
            return self.words[place].value, absolute, place + 2
        number = place < len(self.words) and self.words[place].kind == "number"
        if number and self.text(place + 1) in ("square", "sqm", "sq"):
            return self.words[place].value, absolute, place + 2 + (self.text(place + 2) in ("metre", "meter", "m"))
        return None

    def _enlarge(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._resized(at, place, 1.0)

    def _shrink(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._resized(at, place, -1.0)

    def _resized(self, at: int, place: int, sign: float) -> tuple[list[Statement], int]:
        """Read ``enlarge the cafeteria by 10 m2``, and ``reduce the chairs in the lobby to two``."""
        start = place
        if self.text(place) == "the" and self.text(place + 1) in ("number", "amount", "count", "area", "size"):
            place += 3
        item = self.item(place)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        cut = next((p for p in item.places if self.words[p.start].text in ("to", "by", "down", "up")), None)
        end = cut.start if cut is not None else item.end
        end += self.text(end) in ("down", "up")
        kept = Item(item.phrase, tuple(p for p in item.places if p.end <= end), end)
        area = self._amount_of_area(end)
        room = item.phrase.noun.kind in ("room", "both") and self.text(start + 1) not in ("number", "amount", "count")
        if area is not None and room:
            value = area[0] if area[1] else sign * area[0]
            quote = self.quote(at, area[2])
            return [Reshape(what="area", rooms=kept.rooms(), area=value, absolute=area[1], quote=quote)], area[2]
        if self.text(end) in ("to", "by") and end + 1 < len(self.words):
            last = end + 1 + (self.text(end + 1) in ("only", "just", "exactly"))
            if self.words[last].kind == "number":
                return self._numbered(at, kept, int(self.words[last].value), last + 1, self.text(end), sign)
        raise NotUnderstood(at, self.boundary(at))

    def _numbered(
        self, at: int, item: Item, number: int, end: int, preposition: str, sign: float
    ) -> tuple[list[Statement], int]:
        """Return the statement of a number of things that rises or falls, by or to a number."""
        end += self.text(end) in ("piece", "unit")
        quote = self.quote(at, end)
        place, each = self._framed(_joined(list(item.places)))
        things = item.phrase.things()
        if preposition == "to":
            counted = msgspec.structs.replace(things, amount=Amount(kind="exactly", number=number), definite=False)
            return [Ensure(things=counted, place=place, each=each, quote=quote)], end
        if sign > 0:
            more = msgspec.structs.replace(things, amount=Amount(kind="more", number=number), definite=False)
            return [Add(things=more, place=place, each=each, quote=quote)], end
        fewer = msgspec.structs.replace(things, amount=Amount(number=number))
        return [Remove(things=with_place(fewer, place) if place != Place() else fewer, quote=quote)], end

    def _make(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``make the cafeteria 10 m2 larger``, ``make the sofa red``, ``make sure``, ``make it two``."""
        if self.text(place) in ("it", "this") and self.text(place + 1) in ("look", "so", "happen", "seem"):
            end = self.boundary(place)
            return [Mention(quote=self.quote(at, end))], end
        surface = self._surface(place)
        if surface is not None:
            colour = self._colour_at(surface[1])
            if colour is not None:
                return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        if self.text(place) == "it" and place + 1 < len(self.words) and self.words[place + 1].kind == "number":
            return self._wanted(at, place + 1)
        item = self.item(place)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        end = item.end
        area = self._amount_of_area(end)
        if area is not None:
            value, absolute, stop = area
            sign = 0.0
            if self.text(stop) in ("larger", "bigger", "wider", "more", "greater"):
                sign, stop = 1.0, stop + 1
            elif self.text(stop) in ("smaller", "less", "narrower"):
                sign, stop = -1.0, stop + 1
            elif self.text(stop) in ("large", "big"):
                stop += 1
            rooms = item.rooms()
            quote = self.quote(at, stop)
            return [
                Reshape(
                    what="area", rooms=rooms, area=value * (sign or 1.0), absolute=absolute or not sign, quote=quote
                )
            ], stop
        if self.text(end) in ("larger", "bigger", "smaller", "wider"):
            sign = -1.0 if self.text(end) == "smaller" else 1.0
            area = self._amount_of_area(end + 1)
            if area is not None:
                quote = self.quote(at, area[2])
                change = Reshape(what="area", rooms=item.rooms(), area=sign * area[0], absolute=area[1], quote=quote)
                return [change], area[2]
            raise NotUnderstood(at, self.boundary(at))
        colour = self._colour_at(end)
        if colour is not None:
            return self._painted([item], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        found = self._predicate(item, end, at)
        if found is not None:
            return found
        kind = self.phrase(end)
        if kind is not None and kind.noun.kind in ("room", "both") and item.phrase.noun.kind in ("room", "both"):
            words = " ".join((*filter(None, [kind.noun.owned]), *kind.noun.words))
            return [Furnish(rooms=item.rooms(), kind=words, quote=self.quote(at, kind.end))], kind.end
        raise NotUnderstood(at, self.boundary(at))

    def _rotate(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``rotate the sofa by 90 degrees``, ``turn the armchair to the window``, ``face the bed to the door``."""
        item = self.item(place, places=False)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        where, end = self._places_before_turn(item)
        things = Item(item.phrase, where, end).things()
        while self.text(end) in ("by", "around", "through", "about", "round"):
            if self.text(end) == "around" and not self._degrees(end + 1):
                return [Turn(things=things, degrees=180.0, quote=self.quote(at, end + 1))], end + 1
            end += 1
        degrees = self._degrees(end)
        if degrees is not None:
            value, stop = degrees
            places, last = self.places(stop)
            if places:
                things = with_place(things, _joined(places)[0])
            return [Turn(things=things, degrees=value, quote=self.quote(at, last))], last
        while self.text(end) in (
            "to",
            "towards",
            "toward",
            "so",
            "that",
            "it",
            "face",
            "at",
            "is",
            "they",
            "and",
            "facing",
            "them",
        ):
            end += 1
        goal = self.item(end)
        if goal is None or goal.is_room:
            raise NotUnderstood(at, self.boundary(at))
        return [Turn(things=things, facing=goal.things(), quote=self.quote(at, goal.end))], goal.end

    def _places_before_turn(self, item: Item) -> tuple[tuple[ReadPlace, ...], int]:
        found: list[ReadPlace] = []
        end = item.end
        while self.text(end) not in ("to", "towards", "toward", "around", "facing", "at"):
            read = read_place(self.words, end, self.lexicon, self.floors)
            if read is None or self._degrees(end + 1) is not None:
                break
            found.append(read)
            end = read.end
        return tuple(found), end

    def _degrees(self, at: int) -> tuple[float, int] | None:
        if at >= len(self.words):
            return None
        if self.text(at) in ("a", "one") and self.text(at + 1) in ("quarter", "half"):
            value = 90.0 if self.text(at + 1) == "quarter" else 180.0
            end = at + 2 + (self.text(at + 2) in ("turn", "circle"))
        elif self.words[at].kind == "number" and self.text(at + 1) in ("degree", "deg", "°"):
            value, end = self.words[at].value, at + 2
        else:
            return None
        if self.text(end) in ("clockwise", "right") or (self.text(end) == "to" and self.text(end + 2) == "right"):
            return -value, end + (3 if self.text(end) == "to" else 1)
        if self.text(end) in ("counterclockwise", "anticlockwise", "left", "counter-clockwise"):
            return value, end + 1
        if self.text(end) in ("counter", "anti") and self.text(end + 1) == "clockwise":
            return value, end + 2
        if self.text(end) == "to" and self.text(end + 2) == "left":
            return value, end + 3
        return value, end

    def _check(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``make sure that ...``: a way, or a clause that shall be true."""
        while self.text(place) in ("that", "whether", "if", "for", "to", ",", ":"):
            place += 1
        found_by = self._found_by_somebody(at, place)
        if found_by is not None:
            return found_by
        way = self._reaching(at, place)
        if way is not None:
            return way
        existential = self._existential(place)
        if existential is not None:
            return existential
        item = self.item(place)
        if item is not None:
            found = self._predicate(item, item.end, at)
            if found is not None:
                return found
        if verb_at(self.words, place, self.lexicon) is not None:
            return self.read(place)
        items = self.items(place)
        end = items[-1].end
        out: list[Statement] = []
        for each in items:
            if self._is_way(each.phrase):
                return self._way(at, each.phrase.end)
            out += self._there(each, self._shared_goal(items, each), self.quote(at, end))
        return out, end

    def _found_by_somebody(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``the robot will find a stapler on the desk``."""
        somebody = frozenset("robot agent i we one guest visitor people everyone whoever someone subject".split())
        for k in range(place + 1, min(place + 6, len(self.words))):
            if self.text(k) in ("find", "see", "grab", "pick") and self.phrase(k + 1) is not None:
                if somebody & {w.text for w in self.words[place:k]}:
                    return self._wanted(at, k + 1)
        return None

    # Ways

    def _reaching(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``I can get from the lobby to the kitchen``, ``nothing blocks the way to the lab``."""
        start = place
        if self.text(place) == "nothing":
            way = next((k for k in range(place, min(place + 6, len(self.words)))
                        if self.text(k) in ("way", "path", "route", "access", "door", "doorway", "passage")), None)  # fmt: skip
            return None if way is None else self._way(at, way + 1)
        if self.text(place) in ("the", "a", "delivery") and "robot" in (w.text for w in self.words[place : place + 4]):
            joint = next((k for k in range(place, len(self.words)) if self.text(k) == "from"), None)
            if joint is not None and joint < place + 9:
                return self._way(at, joint)
        while place < len(self.words) and place < start + 12:
            word = self.text(place)
            if self._is_going(place):
                break
            if self.words[place].kind == "mark" or word in ("to", "on", "in"):
                going = self.text(place + 1) in (
                    "be",
                    "get",
                    "go",
                    "walk",
                    "drive",
                    "reach",
                    "travel",
                    "come",
                    "move",
                    "enter",
                )
                if word != "to" or not going:
                    return None
            place += 1
        else:
            return None
        moving = any(
            w.text in ("can", "could", "able", "possible", "must", "should", "may", "has", "have", "need", "will")
            for w in self.words[start:place]
        )
        if not moving:
            return None
        if self.text(place) == "find" or self.text(place) == "make":
            place += 2
        return self._way(at, place + 1)

    def _is_going(self, at: int) -> bool:
        """Whether a word is a verb of going, with a direction where it has other meanings."""
        word, following = self.text(at), self.text(at + 1)
        if word in ("reach", "access", "enter"):
            return True
        if word in ("find", "make"):
            return following in ("a", "the", "his", "its", "their", "my") and self.text(at + 2) == "way"
        directions = ("to", "from", "into", "in", "inside", "through", "around", "up", "down", "over", "all", "out", "there",
                      "everywhere", "anywhere", "across", "freely", "back", "upstairs", "towards", "straight", "safely",
                      "easily", "between")  # fmt: skip
        going = ("get", "go", "walk", "drive", "travel", "come", "navigate", "move", "pass", "roll")
        return word in going and following in directions

    def _way(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read the ends of a way."""
        start: Things | Rooms | None = None
        ends: list[Things | Rooms] = []
        end = place
        while end < len(self.words):
            while self.text(end) in ("all", "the", "way", "leading", "down", "up", "over", "through", "straight", "that",
                                     "leads", "lead", "clear", "free", "open", "unobstructed", "around", "easily", "safely",
                                     "still", "always", "directly", "back") and self.text(end) != "the":  # fmt: skip
                end += 1
            if self.text(end) == "from":
                found = self._end_of_way(end + 1)
                if found is None:
                    break
                start, end = found
                continue
            joint = self.text(end) in ("to", "into", "towards", "inside", "and", ",", "in")
            if ends and self.text(end) in ("and", ",") and self.starts_clause(end + 1):
                break
            found = self._end_of_way(end + joint) if joint or not ends else None
            if found is None:
                break
            ends.append(found[0])
            end = found[1]
        while self.text(end) in ("be", "is", "are", "clear", "free", "open", "possible", "without", "being", "blocked", "stay",
                                 "there", "unobstructed", "should", "must", "obstacle", "any", "by", "robot", "on", "foot", "a"):  # fmt: skip
            end += 1
        if start is None and not ends:
            raise NotUnderstood(at, self.boundary(at))
        quote = self.quote(at, end)
        goals: list[Things | Rooms | None] = [*ends] or [None]
        return [Reach(start=start, end=goal, quote=quote) for goal in goals], end

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

    # History, leaving alone

    def _undo(self, at: int, place: int) -> tuple[list[Statement], int]:
        what = "undo" if self.text(at) in ("undo", "revert", "reverse", "roll", "cancel") else "redo"
        end = place
        while end < len(self.words) and self.text(end) in (
            "the", "that", "it", "this", "last", "latest", "previous", "my", "your", "edit", "change", "step", "one",
            "instruction", "thing", "what", "you", "did", "just", "again", "recent", "most", "action", "have", "done",
        ):  # fmt: skip
            end += 1
        return [History(what="undo" if what == "undo" else "redo", quote=self.quote(at, end))], end

    def _restore(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items(place)
        end = items[-1].end
        return [History(what="restore", things=item.things(), quote=self.quote(at, end)) for item in items], end

    def _repeat(self, at: int, place: int) -> tuple[list[Statement], int]:
        end = place
        while self.text(end) in ("thing", "for", "with", "again", "it", "that"):
            if self.text(end) in ("for", "with"):
                break
            end += 1
        if self.text(end) in ("for", "in", "on", "at", "to", "with"):
            item = self.item(end + 1)
            if item is not None and item.phrase.noun.kind in ("room", "both"):
                return [
                    History(what="repeat", place=Place(rooms=item.rooms()), quote=self.quote(at, item.end))
                ], item.end
            places, stop = self.places(end)
            if places:
                return [History(what="repeat", place=_joined(places)[0], quote=self.quote(at, stop))], stop
        return [History(what="repeat", quote=self.quote(at, end))], end

    def _leave(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``leave the sofa alone``, ``leave the door open``, ``leave two mugs on the desk``."""
        if self.text(place) == "nothing":
            nothing = self._nothing(place)
            if nothing is not None:
                return nothing
        rest = place
        while self.text(rest) in ("everything", "else", "all", "the", "other", "thing", "rest", "of", "it", "anything"):
            rest += 1
        if rest > place and self.text(rest) in ("as", "where", "alone", "unchanged", "untouched", "in", "like"):
            while self.text(rest) in ("as", "where", "alone", "unchanged", "untouched", "in", "place", "it", "is", "they", "are"):
                rest += 1
            return [Mention(quote=self.quote(at, rest))], rest
        items = self.items(place)
        end = items[-1].end
        item = items[0]
        end += self.text(end) in ("inside", "there", "here")
        if self.text(end) in STATE_WORDS or (
            self.text(end) in ("switched", "turned") and self.text(end + 1) in STATE_WORDS
        ):
            end += self.text(end) in ("switched", "turned")
            state, value = STATE_WORDS[self.text(end)]
            quote = self.quote(at, end + 1)
            return [self._state_of(items, i, state, (), quote, value=value) for i in items], end + 1
        alone = end
        while self.text(alone) in (
            "alone",
            "as",
            "where",
            "it",
            "they",
            "is",
            "are",
            "untouched",
            "in",
            "place",
            "be",
            "there",
            "unchanged",
            "exactly",
            "like",
            "that",
            "stand",
            "the",
            "way",
            "was",
        ):
            alone += 1
        if alone > end or (item.phrase.definite and not any(p.place.relation for p in item.places)):
            quote = self.quote(at, alone)
            return [Keep(things=self._all(i.things()), quote=quote) for i in items if not i.is_room], alone
        return self._add(at, place)

    def _keep(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``keep the door closed``, ``keep the sofa``, ``keep the desk free of mugs``."""
        item = self.item(place)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        if self._is_way(item.phrase):
            return self._way(at, item.phrase.end)
        found = (
            self._predicate(item, item.end, at)
            if self.text(item.end) in STATE_WORDS or self.predicate_follows(item.end)
            else None
        )
        if found is not None:
            return found
        if (item.phrase.definite or item.phrase.refers) and self.text(item.end) not in (
            "as",
            "where",
            "alone",
            "untouched",
        ):
            items = self.items(place)
            quote = self.quote(at, items[-1].end)
            return [Keep(things=self._all(i.things()), quote=quote) for i in items if not i.is_room], items[-1].end
        if item.phrase.definite or item.phrase.refers:
            return self._leave(at, place)
        if not item.phrase.definite:
            items = self.items(place)
            quote = self.quote(at, items[-1].end)
            return [s for i in items for s in self._there(i, self._shared_goal(items, i), quote)], items[-1].end
        raise NotUnderstood(at, self.boundary(at))

    def _let(self, at: int, place: int) -> tuple[list[Statement], int]:
        if self.text(place) in ("us", "me"):
            return self.read(place + 1)
        if self.text(place) == "there":
            found = self._existential(place)
            if found is not None:
                return found
        item = self.item(place)
        if item is not None:
            found = self._predicate(item, item.end, at)
            if found is not None:
                return found
            if self.text(item.end) in ("stay", "remain", "be"):
                return self._leave(at, place)
        raise NotUnderstood(at, self.boundary(at))

    def _change(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``change the colour of the sofa to red``, ``change the sofa for an armchair``."""
        start = place
        if self.text(place) == "the" and self.text(place + 1) in (
            "colour",
            "color",
            "name",
            "material",
            "type",
            "kind",
            "use",
        ):
            what = self.text(place + 1)
            place += 2 + (self.text(place + 2) == "of")
            if what == "name":
                return self._rename(at, place)
        found = self.items_or_surfaces(place)
        if found is not None:
            subject, end = found
            if isinstance(subject, list):
                goals = [p for p in subject[-1].places if self.words[p.start].text in ("to", "into", "for")]
                end = goals[0].start if goals else end
                subject = [Item(i.phrase, tuple(p for p in i.places if p.end <= end), end) for i in subject]
            if self.text(end) in ("to", "into", "for"):
                colour = self._colour_at(end + 1)
                if (colour is not None and self.phrase(end + 1) is None) or (
                    colour is not None and colour[2] >= len(self.words)
                ):
                    return self._painted(subject, colour[0], colour[1], self.quote(at, colour[2])), colour[2]
                if colour is not None and self.text(colour[2]) in (",", "and", "please", "."):
                    return self._painted(subject, colour[0], colour[1], self.quote(at, colour[2])), colour[2]
                if isinstance(subject, list):
                    new = self.phrase(end + 1)
                    if new is not None and subject[0].phrase.noun.kind == "room":
                        return self._furnish(at, place)
                    return self._replaced_by(at, start, end)
        joint = next((k for k in range(place, len(self.words)) if self.text(k) in ("with", "for", "to", "into")), None)
        if joint is None:
            raise NotUnderstood(at, self.boundary(at))
        return self._replaced_by(at, place, joint)

    def _use(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``use the storage as an office``."""
        item = self.item(place)
        if item is None or self.text(item.end) != "as":
            raise NotUnderstood(at, self.boundary(at))
        return self._furnish(at, place)

    # Clauses with a subject

    def _with_predicate(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the lamp should be on``, ``the lobby needs two chairs``, ``nothing should be on the table``."""
        if self.text(at) == "nothing":
            return self._nothing(at)
        number = self._number_should_be(at) or self._only_thing(at)
        if number is not None:
            return number
        surface = self._surface(at)
        if surface is not None:
            end = surface[1]
            while self.text(end) in MODALS or self.text(end) in ("be", "is", "are", "in", "get", "painted", "have"):
                end += 1
            colour = self._colour_at(end)
            if colour is not None and end > surface[1] - 1:
                return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        return self._of_subjects(at)

    def _of_subjects(self, at: int) -> tuple[list[Statement], int] | None:
        """Read one subject or several, and what is said of them."""
        subjects: list[Item] = []
        joined = self.text(at) in ("neither", "both", "either") and self.phrase(at + 1) is not None
        place = at + joined
        while True:
            item = self.item(place)
            if item is None:
                return None
            subjects.append(self._named(item, subjects))
            after = self.conjunction(item.end)
            if self.predicate_follows(item.end) or self.text(item.end) in BE or not after or self.starts_clause(after):
                break
            place = after
        shared = all(s.phrase.definite or s.phrase.noun.plural or s.is_room for s in subjects)
        if len(subjects) > 1 and not (self.predicate_follows(subjects[-1].end) and (shared or joined)):
            return None
        out: list[Statement] = []
        end = at
        for subject in subjects:
            if self.text(at) == "neither":
                none = Amount(kind="none", number=0)
                subject = Item(replace(subject.phrase, amount=none), subject.places, subject.end)
            found = self._predicate(subject, subjects[-1].end, at)
            if found is None:
                return None
            out += found[0]
            end = found[1]
        return out, end

    def _only_thing(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the only thing on the table should be a vase``."""
        if (
            self.text(at) != "the"
            or self.text(at + 1) != "only"
            or self.text(at + 2) not in ("thing", "object", "item")
        ):
            return None
        places, end = self.places(at + 3)
        while self.text(end) in MODALS or self.text(end) in BE:
            end += 1
        if not places or end == places[-1].end:
            return None
        kept = self.items(end)
        where, quote = _joined(places)[0], self.quote(at, kept[-1].end)
        out: list[Statement] = [Ensure(things=item.phrase.things(), place=where, quote=quote) for item in kept]
        spare = tuple(self._all(item.phrase.things()) for item in kept)
        return [*out, Clear(place=where, spare=spare, quote=quote)], kept[-1].end

    def _number_should_be(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the number of apples on the desk should be 2``."""
        place = at + (self.text(at) == "the")
        if self.text(place) != "number" or self.text(place + 1) != "of":
            return None
        item = self.item(place + 2)
        if item is None:
            return None
        end = item.end
        while self.text(end) in MODALS or self.text(end) in BE or self.text(end) in ("to", "exactly", "has"):
            end += 1
        if end >= len(self.words) or self.words[end].kind != "number":
            return None
        amount = Amount(kind="exactly", number=int(self.words[end].value))
        things = msgspec.structs.replace(item.phrase.things(), amount=amount, definite=False)
        return [Ensure(things=things, place=self._framed(item.goal())[0], quote=self.quote(at, end + 1))], end + 1

    def _nothing(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``nothing should be on the table except the vase``."""
        way = self._reaching(at, at)
        if way is not None:
            return way
        if self.text(at + 2) == "(":
            return [Mention(quote=self.quote(at, at + 2))], at + 2
        place = at + 1
        if self.text(place) in ("but", "except"):
            items = self.items(place + 1 + (self.text(place + 1) == "for"))
            goal, _ = self._framed(self._shared_goal(items, items[0]))
            if goal != Place():
                end = items[-1].end
                quote = self.quote(at, end)
                kept = tuple(self._all(item.phrase.things()) for item in items)
                there: list[Statement] = [
                    Ensure(things=item.phrase.things(), place=goal, quote=quote) for item in items
                ]
                return [*there, Clear(place=goal, spare=kept, quote=quote)], end
        spare: tuple[Things, ...] = ()
        place, spare = self.exceptions(place + (self.text(place) == "else"))
        while (
            self.text(place) in MODALS
            or self.text(place) in BE
            or self.text(place) in ("else", "left", "remain", "lie", "stand")
        ):
            place += 1
        places, end = self.places(place)
        if not places:
            return None
        if not spare:
            end, spare = self.exceptions(end)
        return [Clear(place=self._framed(_joined(places))[0], spare=spare, quote=self.quote(at, end))], end

    def _state_after(self, item: Item, end: int, at: int) -> tuple[list[Statement], int] | None:
        place = end
        while self.text(place) in (
            "switched",
            "turned",
            "left",
            "kept",
            "powered",
            "wide",
            "fully",
            "be",
            "always",
            ",",
        ):
            if self.text(place) == "," and self.text(place + 1) not in (
                "switched",
                "turned",
                "on",
                "off",
                "open",
                "closed",
            ):
                return None
            place += 1
        dark = self.text(place) == "out" and item.phrase.noun.words[-1:] == ("light",)
        if dark:
            quote = self.quote(at, place + 1)
            where, stop = self.places(place + 1)
            whole = Item(item.phrase, (*item.places, *where), stop)
            return [self._state_of([whole], whole, "on", (), quote, value=False)], stop
        if self.text(place) not in STATE_WORDS:
            return None
        if self.text(place) in ("on", "off") and self.phrase(place + 1) is not None:
            return None
        state, value = STATE_WORDS[self.text(place)]
        quote = self.quote(at, place + 1)
        switched = self._state_of([item], item, state, (), quote, value=value)
        brought = not item.phrase.definite and item.phrase.amount.kind == "some" and bool(item.places)
        if brought and not item.is_room:
            goal, each = self._framed(item.goal())
            return [Ensure(things=item.phrase.things(), place=goal, each=each, quote=quote), switched], place + 1
        return [switched], place + 1

    def _predicate(self, item: Item, end: int, at: int) -> tuple[list[Statement], int] | None:
        """Read what is said of a subject."""
        place = end
        negated = False
        modal = False
        while self.text(place) in MODALS or (self.text(place) in BE and self.text(place) not in ("stay", "remain")) or self.text(place) in (
            "to", "not", "also", "always", "never", "do", "does", "now", "all", "both", "still", "get", "longer", "each",
            "supposed",
            "itself",
            "themselves", "has", "have", "no", "just", "only",
        ):  # fmt: skip
            if self.text(place) in ("has", "have", "get") and self.text(place + 1) not in ("to", "be"):
                if self._participle(place + 1) is None:
                    break
            if self.text(place) in ("to", "only", "just", "no", "all", "both") and self.phrase(place + 1) is not None:
                if self.text(place) != "to" or self.text(place - 1) in BE or place == end:
                    break
            negated = negated or self.text(place) in ("not", "never", "no")
            modal = modal or self.text(place) in MODALS
            place += 1
        for reader in (self._said_state, self._said_participle, self._said_having, self._said_gone, self._said_where,
                       self._said_colour, self._said_good):  # fmt: skip
            found = reader(item, place, at, negated)
            if found is not None:
                return found
        return None

    def _said_state(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        found = self._state_after(item, place, at)
        if found is None:
            return None
        said, end = found
        if negated:
            turned = [s for s in said if isinstance(s, SetState)]
            said = [msgspec.structs.replace(s, value=not s.value) for s in turned]
        return said, end

    def _said_participle(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        found = self._participle(place)
        if found is None:
            return None
        deed, after = found
        if deed == "remove" and not negated:
            places, end = self.places(after)
            things = self._all_if_plural(Item(item.phrase, (*item.places, *places), end).things())
            return [Remove(things=things, quote=self.quote(at, end))], end
        if deed == "clear" and not negated:
            if self.text(after) in ("of", "from"):
                gone = self.items(after + 1)
                return self._gone_from(item, gone, self.quote(at, gone[-1].end)), gone[-1].end
            after += self.text(after) in ("up", "out", "off")
            after, spare = self.exceptions(after)
            return [Clear(place=self._emptied(item), spare=spare, quote=self.quote(at, after))], after
        if negated:
            return None
        if deed == "move" and self.text(after) == ":":
            self.topic = item.things()
            return [Mention(quote=self.quote(at, after))], after
        if deed in ("move", "add"):
            places, end = self.places(after)
            if places or self.text(after) in ("there", "instead"):
                whole = Item(item.phrase, (*item.places, *places), end)
                if deed == "move":
                    source, goal, _ = self._source_and_goal(whole.places)
                    things = item.phrase.things() if source == Place() else with_place(item.phrase.things(), source)
                    return [Move(things=self._all_if_plural(things), place=goal, quote=self.quote(at, end))], end
                return [self._added([whole], whole, self.quote(at, end))], end
            return [self._added([item], item, self.quote(at, after))], after
        if deed == "replace" and self.text(after) in ("with", "by"):
            new = self.items(after + 1)
            quote = self.quote(at, new[-1].end)
            return [Replace(things=self._all_if_plural(item.things()), by=new[0].phrase.things(), quote=quote)], new[
                -1
            ].end
        if deed == "paint":
            colour = self._colour_at(after)
            if colour is not None:
                return self._painted([item], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        if deed == "equip" and self.text(after) == "with":
            new = self.items(after + 1)
            quote = self.quote(at, new[-1].end)
            goal = self._receiver(item)
            return [self._given(n, goal, quote, each=item.phrase.each) for n in new], new[-1].end
        if deed == "rename":
            after += self.text(after) in ("to", "as")
            name, stop = self._name(after)
            return [Rename(room=item.rooms(), name=name, quote=self.quote(at, stop))], stop
        if deed == "furnish" and self.text(after) in ("as", "into", "like"):
            kind = self.phrase(after + 1)
            if kind is not None:
                words = " ".join((*filter(None, [kind.noun.owned]), *kind.noun.words))
                return [Furnish(rooms=item.rooms(), kind=words, quote=self.quote(at, kind.end))], kind.end
        return None

    def _said_having(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``needs two chairs``, ``should have a clock``, ``must not contain any knives``."""
        word = self.text(place)
        if word == "do" and self.text(place + 1) == "with":
            return self._said_having(item, place + 1, at, negated)
        if word in ("has", "have") and self.text(place + 1) == "no" and self.text(place + 2) in ("business", "place"):
            places, end = self.places(place + 3 + (self.text(place + 3) == "being"))
            gone = Item(item.phrase, (*item.places, *places), end).things()
            return [Remove(things=self._all_if_plural(gone), quote=self.quote(at, end))], end
        if (
            word not in HAVE
            and word not in ("carry", "bear", "store")
            and not (word == "with" and self.text(place - 1) == "do")
            and word not in ("need", "require", "lack", "get", "want", "deserve", "miss", "missing", "keep")
        ):
            return None
        if self.text(place + 1) == "to":
            return None
        new = self.items(place + 1)
        if self._is_way(new[0].phrase):
            return self._way(at, new[0].phrase.end)
        end = new[-1].end
        while self.text(end) in ("on", "in", "inside") and self.text(end + 1) in ("it", "them", "there"):
            end += 2
        goal = self._receiver(item)
        quote = self.quote(at, end)
        if negated:
            return self._gone_from(item, new, quote), end
        each = item.phrase.each or item.phrase.amount.kind == "all" or (item.phrase.plural and item.phrase.definite)
        out: list[Statement] = []
        for thing in new:
            own = thing.goal()[0]
            where = goal if own == Place() else merged(own, goal)
            if thing.phrase.amount.kind == "none":
                out += self._gone_from(item, [thing], quote)
            elif thing.phrase.amount.kind == "more" or word in ("need", "require", "get", "lack", "deserve", "miss"):
                out.append(self._given(thing, goal, quote, each=each))
            else:
                out.append(Ensure(things=thing.phrase.things(), place=where, each=each, quote=quote))
        return out, end

    def _said_gone(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``must go``, ``should disappear``, ``goes``."""
        word = self.text(place)
        if word in ("stay", "remain") or (word == "be" and self.text(place + 1) == "left"):
            end = place + 1
            places, after = self.places(end)
            end = after if places and not any(p.goal for p in places) else end
            while self.text(end) in ("put", "there", "here", "as", "it", "is", "where", "they", "are", "untouched", "alone", "in", "on", "place"):
                end += 1
            kept = Item(item.phrase, (*item.places, *(places if end == after else ())), end)
            return [Keep(things=self._all(kept.things()), quote=self.quote(at, end))], end
        if word in ("go", "disappear", "vanish", "leave") and not negated:
            places, end = self.places(place + 1)
            if not places:
                end += self.text(end) in ("away",)
                return [Remove(things=self._all_if_plural(item.things()), quote=self.quote(at, end))], end
            return [self._brought(item, places, self.quote(at, end))], end
        if word in ("belong", "come", "sit", "stand", "lie", "live", "rest", "hang") and not negated:
            places, end = self.places(place + 1)
            if places:
                return [self._brought(item, places, self.quote(at, end))], end
        return None

    def _said_where(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``should be on the desk``, ``should be reachable from the lobby``."""
        if self.text(place) in ("reachable", "accessible", "reached", "connected"):
            start: Things | Rooms | None = None
            end = place + 1
            if self.text(end) in ("from", "to"):
                found = self._end_of_way(end + 1)
                if found is not None:
                    start, end = found
            goal = item.rooms() if item.phrase.noun.kind in ("room", "both") else item.things()
            return [Reach(start=start, end=goal, quote=self.quote(at, end))], end
        if place == item.end:
            return None
        places, end = self.places(place)
        if not places:
            return None
        quote = self.quote(at, end)
        if negated:
            things = Item(item.phrase, places, end).things()
            if item.phrase.amount.kind in ("some",) and not item.phrase.definite:
                things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
            return [Remove(things=things, quote=quote)], end
        whole = Item(item.phrase, places, end)
        if item.phrase.definite or item.phrase.refers:
            return [self._brought(item, places, quote)], end
        return self._there(whole, whole.goal(), quote), end

    def _brought(self, item: Item, places: Sequence[ReadPlace], quote: str) -> Statement:
        """Return that a subject, with the place where it is, goes to other places."""
        whole = Item(item.phrase, tuple(places), item.end)
        if not item.places:
            return self._added([whole], whole, quote)
        source, _ = self._framed(_joined(list(item.places)))
        goal, _ = self._framed(_joined([p for p in places if not p.source]))
        things = with_place(item.phrase.things(), source)
        return Move(things=self._all_if_plural(things), place=goal, quote=quote)

    def _said_good(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``a mug on the desk would be nice``, and ``the desk is too bare``, which tells what comes next is about."""
        if self.text(place) in (
            "nice",
            "good",
            "great",
            "lovely",
            "fine",
            "helpful",
            "appreciated",
            "perfect",
            "ideal",
            "welcome",
        ):
            if negated or not any(w.text in MODALS for w in self.words[item.end : place]):
                return None
            return self._there(item, item.goal(), self.quote(at, place + 1)), place + 1
        if self.text(place) in ("face", "facing"):
            goal = self.item(place + 1)
            if goal is not None and not goal.is_room:
                quote = self.quote(at, goal.end)
                return [Turn(things=self._all_if_plural(item.things()), facing=goal.things(), quote=quote)], goal.end
        verb = self.words[item.end].raw if item.end < len(self.words) else ""
        if verb in ("died", "broke", "fell", "leaks", "squeaks", "smells", "wobbles", "cracked", "burst") and place == item.end:
            self.topic = item.things()
            return [Mention(quote=self.quote(at, place + 1))], place + 1
        if self.text(item.end) not in ("is", "are", "look", "seem", "feel") or any(
            w.text in MODALS for w in self.words[item.end : place]
        ):
            return None
        stop = item.end + 1
        while (
            stop < len(self.words)
            and self.words[stop].kind == "word"
            and self.text(stop) not in ("and", "but", "so")
            and stop < item.end + 6
        ):
            stop += 1
        told = self.words[item.end + 1 : stop]
        named = any(self.lexicon.is_object((w.text,)) or self.lexicon.is_own_room((w.text,)) for w in told)
        scarce = {"enough", "sufficient"} & {w.text for w in told}
        if not told or named or (negated and not scarce) or (stop < len(self.words) and self.words[stop].kind == "number"):
            return None
        if item.is_room:
            self.frame = Place(rooms=item.rooms())
        else:
            self.topic = item.things()
        return [Mention(quote=self.quote(at, stop))], stop

    def _said_colour(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        if negated or place == item.end:
            return None
        colour = self._colour_at(place)
        if colour is None:
            return None
        return self._painted([item], colour[0], colour[1], self.quote(at, colour[2])), colour[2]

    def _verbless(self, at: int) -> tuple[list[Statement], int]:
        """Read things with their places and no verb: ``three apples in a bowl on the table``."""
        items = self.items(at)
        if self._is_way(items[0].phrase):
            return self._way(at, items[0].phrase.end)
        end = items[-1].end
        out: list[Statement] = []
        found = self._state_after(items[-1], end, at) if len(items) == 1 else None
        if found is not None:
            return found
        if any(item.is_room for item in items):
            raise NotUnderstood(at, self.boundary(at))
        if items[0].phrase.definite and not self.follows and self.text(end) not in ("out", "away", "gone"):
            raise NotUnderstood(at, end)
        if self.text(end) in ("out", "away", "gone"):
            quote = self.quote(at, end + 1)
            return [self._removed(items, item, (), (), quote) for item in items], end + 1
        if not any(item.places for item in items) and self.frame == Place():
            kinds = {item.phrase.amount.kind for item in items}
            if not kinds & {"more", "fewer", "none", "exactly"}:
                raise NotUnderstood(at, end)
        quote = self.quote(at, end)
        out = []
        for item in items:
            if item.phrase.amount.kind == "more":
                out.append(self._added(items, item, quote))
            else:
                out += self._there(item, self._shared_goal(items, item), quote)
        return out, end


def _kind_of_its_own(things: Things) -> Things:
    """Return an exception that names no kind of its own ("not those in the lab") as one of any kind at its place."""
    if things.refers == "last" and things.place is not None:
        return msgspec.structs.replace(things, refers="", noun="")
    return things


def _named_as(spared: Things, noun: str) -> Things:
    """Return an exception without a noun as one of the kind that it is excepted from."""
    return msgspec.structs.replace(spared, noun=noun) if not spared.noun and not spared.refers else spared


def _state(things: Things, state: str, quote: str, *, value: bool) -> SetState:
    return SetState(things=things, state="open" if state == "open" else "on", value=value, quote=quote)
