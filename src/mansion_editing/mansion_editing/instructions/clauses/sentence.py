"""The words of a sentence, and the pieces that its clauses are made of."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final, Self

import msgspec

from mansion_editing.instructions.clauses.coordination import first_subject
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, TwoReadings, joined_places
from mansion_editing.instructions.phrases.lexicon import HYPERNYMS, Lexicon
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase, noun_phrase
from mansion_editing.instructions.phrases.nouns import Noun
from mansion_editing.instructions.phrases.places import ReadPlace, merged, read_place, with_place
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verb_words import PARTICIPLES, Deed
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import (
    AFTER_THANKS,
    BEFORE_VERBS,
    BEGIN_CLAUSES,
    BESIDE_RELATIONS,
    BETWEEN_CLAUSES,
    PREDICATE_VERBS,
)
from mansion_editing.instructions.phrases.words import (
    BE,
    COURTESIES,
    DETERMINERS,
    MODALS,
    PARTICIPLES_OF_REST,
    STATE_WORDS,
    Word,
    text_at,
)
from mansion_editing.instructions.statements import JOINED, Amount, Place, Relation, Rooms, Statement, Things

__all__ = ["Sentence"]

_SKIPPED: Final = COURTESIES | BETWEEN_CLAUSES

_LYING: Final = frozenset("lying standing sitting hanging resting leaning".split())

_RESTS: Final = frozenset("is are lie lies stand stands sit sits hang hangs rest rests".split())
"""Verbs of a relative clause that say where something is."""

"""Relations of small things to others on the same surface."""

_HOLDING: Final = frozenset(["on", "in", "under"])
"""Relations to furniture that carries or covers things."""

_THOSE: Final = frozenset("the these those my our your them".split())

_EXCEPTIONS: Final = (
    ("except", "for"), ("apart", "from"), ("other", "than"), ("aside", "from"), ("except",), ("but", "not"),
    ("and", "not"), ("not",), ("besides",), ("but",), ("save", "for"), ("excluding",), ("without",),
)  # fmt: skip
"""Words that begin an exception."""


class Sentence(ABC):
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
        self.last_holder = ""

    def until(self, end: int) -> Self:
        """Return a reader of the words before a place."""
        return type(self)(self.words[:end], self.lexicon, self.floors, self.quote)

    @abstractmethod
    def read(self, at: int) -> tuple[list[Statement], int]:
        """Read the clause at a place.

        Raises
        ------
        NotUnderstood
            Where the words make no clause.
        """

    def text(self, at: int) -> str:
        """Return a word, empty beyond the end."""
        return text_at(self.words, at)

    def phrase(self, at: int) -> NounPhrase | None:
        """Read a noun phrase."""
        return noun_phrase(self.words, at, self.lexicon, self.floors)

    def phrase_of(self, noun: str) -> Noun | None:
        """Return a noun of the sentence by its words, which ``one`` may mean later."""
        for at in range(len(self.words)):
            found = self.phrase(at)
            if found is not None and " ".join(found.noun.words) == noun:
                return found.noun
        return None

    def places(self, at: int) -> tuple[tuple[ReadPlace, ...], int]:
        """Read the places from a place in the words on."""
        found: list[ReadPlace] = []
        while True:
            start = at
            relative = self.text(at) in ("that", "which", "who") or (
                self.words[at : at + 1] and self.words[at].raw in _LYING
            )
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
            if self.text(at) in _RESTS and self.text(at - 1) in ("that", "which", "who"):
                at += 1
                while self.text(at) in PARTICIPLES_OF_REST and self.text(at) != "there":
                    at += 1
            read = read_place(self.words, at, self.lexicon, self.floors)
            if read is None and self.text(at) == ",":
                read = self._place_after_comma(at, found) if found else self._mark_after_comma(at)
            if read is None:
                return tuple(found), start
            owned = not found and self.text(read.start) == "of" and read.place.rooms is not None
            if relative and found and read.place == Place(rooms=Rooms(same=True)):
                at = read.end  # "next to the one that is already there"
                found[-1] = replace(found[-1], place=_those_there(found[-1].place))
                continue
            beside = self._beside_what_it_carries(found, read)
            if beside is not None:
                found = [*(p for p in found if p.source), beside]
            else:
                found.append(replace(read, relative=True) if relative or owned else read)
            at = read.end

    def _beside_what_it_carries(self, found: Sequence[ReadPlace], near: ReadPlace) -> ReadPlace | None:
        """Read ``on the desk next to the laptop`` as a place beside the laptop, which is on the desk."""
        there = [p for p in found if not p.source]
        if not there or near.source or any(p.relative or p.each for p in there):
            return None
        surface, _ = joined_places(there)
        mark, holder = near.place.anchor, surface.anchor
        if mark is None or holder is None or mark.place is not None or holder.refers:
            return None
        carried = surface.relation in ("on", "in") and near.place.relation in BESIDE_RELATIONS
        small = not self.lexicon.stands(tuple(mark.noun.split())) and not mark.refers
        if not carried or not small or not self.lexicon.stands(tuple(holder.noun.split())):
            return None
        inner = msgspec.structs.replace(near.place, anchor=with_place(mark, surface))
        return replace(there[0], place=inner, end=near.end)

    def _mark_after_comma(self, at: int) -> ReadPlace | None:
        """Read ``, opposite the two which are there`` right after a thing, where the sentence ends with it."""
        read = read_place(self.words, at + 1, self.lexicon, self.floors)
        if read is None or read.source or self.frame == Place():
            return None
        near = read.place.relation in BESIDE_RELATIONS | {"between"} and read.place.anchor is not None
        end = read.end
        while self.text(end) in ("which", "that", "are", "is", "stand", "already", "there"):
            end += 1
        return read if (near or read.place.facing is not None) and end >= len(self.words) else None

    def _place_after_comma(self, at: int, found: list[ReadPlace]) -> ReadPlace | None:
        """Read ``, ground floor`` and ``, in the kitchen`` where the place before lacks just that."""
        after = at + 1 + (self.text(at + 1) == "also" and self.text(at + 2) in ("on", "in"))
        read = read_place(self.words, after, self.lexicon, self.floors)
        place, _ = joined_places(found)
        room = self.phrase(at + 1)
        bare = place.rooms is None or not place.rooms.words
        own = room is not None and room.noun.kind in ("room", "both") and self.lexicon.is_own_room(room.noun.words)
        if room is not None and own and bare and self.text(room.end) in ("", ",", ".", "please", ":", "-"):
            return ReadPlace(Place(rooms=room.rooms()), at + 1, room.end)
        nearer = read is not None and read.place.anchor is not None and place.anchor is None and place.rooms is not None
        nearer = nearer or (read is not None and self._beside_what_it_carries(found, read) is not None)
        following = "" if read is None else self.text(read.end)
        if read is not None and nearer and following in ("", ",", ".", "please", "that", "which"):
            return read
        apart = read is not None and (
            read.place.facing is not None or read.place.within > 0 or (bool(read.place.spot) and not place.spot)
        )
        if read is not None and apart and (read.end >= len(self.words) or self.text(read.end) in (",", ".", "please")):
            return read
        if read is None or read.place.rooms is None or read.place.anchor is not None:
            return None
        unnamed = place.rooms is not None and not place.rooms.words and not place.rooms.same
        if place.rooms is not None and not unnamed and (place.rooms.floors or read.place.rooms.words):
            return None
        ends = read.end >= len(self.words) or self.text(read.end) in (",", ".", "and", ")", "please", ";", "there")
        ends = ends or (self.text(read.end) == "on" and read_storeys(self.words, read.end + 1, self.floors) is not None)
        return read if (ends and verb_at(self.words, read.end + 1, self.lexicon) is None) or ends else None

    def item(self, at: int, *, places: bool = True) -> Item | None:
        """Read a noun phrase with its places."""
        found = self.phrase(at)
        if found is None or found.noun.unknown:
            return None
        if not places:
            return Item(found, (), found.end)
        following, end = self.places(found.end)
        if not following and self.text(end) == "there" and found.definite and found.noun.kind == "object":
            following, end = (ReadPlace(Place(rooms=Rooms(same=True)), end, end + 1),), end + 1
        following = self._with_ones(_with_room_ones(following), found)
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
            Where there is no noun phrase, or where it is not told which of several go where.
        """
        return self._distributed(self._joined(at))

    def _distributed(self, items: list[Item]) -> list[Item]:
        """Return the shares of ``two lamps for the study, one on the desk and one on the shelf`` alone."""
        shares = items[1:]
        bare = [self.words[i.phrase.start].kind == "number" and i.phrase.end == i.phrase.start + 1 for i in shares]
        whole = items[0].phrase.amount.number
        if len(shares) < 2 or not all(bare) or sum(i.phrase.amount.number for i in shares) != whole:
            return items
        if items[0].phrase.definite:
            raise NotUnderstood(items[0].phrase.start, items[-1].end)
        rooms = tuple(p for p in items[0].places if p.place.anchor is None and p.place.rooms is not None)
        return [Item(i.phrase, (*i.places, *rooms), i.end) for i in shares]

    def _joined(self, at: int) -> list[Item]:
        found: list[Item] = []
        while True:
            item = self.item(at)
            if item is None:
                if found:
                    return found
                raise NotUnderstood(at, self.boundary(at))
            instead = (self.text(item.end), self.text(item.end + 2)) == ("in", "place") and not item.phrase.definite
            if found and instead and self.words[item.end + 1].raw in ("its", "their"):
                return found
            placed = self._participle(item.phrase.end)
            new = placed is not None and placed[0] == "add" and not item.phrase.definite
            if found and (self._is_way(item.phrase) or new):
                return found
            if found and self.is_subject(item):
                return self._objects(found, item)
            if found and self._tells_number_of(found[-1], item):
                found[-1] = Item(replace(found[-1].phrase, amount=item.phrase.amount), found[-1].places, item.end)
                return found
            shares = self._shared_out(found[-1], item) if found else None
            if shares is not None:
                found[-1] = shares
                return found
            if found and self._tells_where_holder_is(found[-1], item):
                last = found[-1].places[-1]
                whole = replace(last, place=merged(last.place, item.goal()[0]), end=item.end)
                found[-1] = Item(found[-1].phrase, (*found[-1].places[:-1], whole), item.end)
                at = self.conjunction(item.end)
                if not at or self.starts_clause(at):
                    return found
                continue
            found.append(self._beside_it(self._as_before(self._named(item, found), found), found))
            after = self.conjunction(item.end)
            if not after or self.starts_clause(after) or self.text(after) in ("only", "just", "now"):
                return found
            at = after

    def _tells_number_of(self, before: Item, item: Item) -> bool:
        """Whether an item is the number of the one before: ``chairs in the hall, at least three of them``."""
        phrase, open_number = item.phrase, before.phrase.plural and not before.phrase.definite
        bare = phrase.refers == "last" and not phrase.noun.words and not item.places and phrase.amount.number > 1
        open_number = open_number and before.phrase.amount.kind == "some" and not before.phrase.amount.number
        counted = phrase.amount.kind in ("some", "at_least") and not phrase.amount.of
        ends = item.end >= len(self.words) or self.words[item.end].kind == "mark"
        return bare and open_number and counted and ends and self.text(phrase.start - 1) == ","

    def _shared_out(self, before: Item, item: Item) -> Item | None:
        """Read ``two plants in the offices, one each``: one in each of the two; None for others.

        Raises
        ------
        NotUnderstood
            Where the numbers do not fit each other.
        """
        phrase, whole = item.phrase, before.phrase.amount
        bare = phrase.refers == "last" and not phrase.noun.words and not item.places and phrase.amount.kind == "some"
        if not bare or self.text(item.end) != "each" or self.text(phrase.start - 1) != "," or not before.places:
            return None
        share = phrase.amount.number
        at = next((k for k, read in enumerate(before.places) if _names_several(read.place)), -1)
        if at < 0 or not share or whole.kind != "some" or whole.number % share:
            raise NotUnderstood(before.phrase.start, item.end + 1)
        there = before.places[at]
        counted = replace(there, place=_so_many(there.place, whole.number // share), each=True)
        places = (*before.places[:at], counted, *before.places[at + 1 :])
        return Item(replace(before.phrase, amount=phrase.amount), places, item.end + 1)

    def _tells_where_holder_is(self, before: Item, item: Item) -> bool:
        """Whether an item is what the one before goes into, with its place: ``keys in a bowl, bowl on the shelf``."""
        holder = before.places[-1].place.anchor if before.places else None
        again = self._is_bare(item.phrase) or (item.phrase.definite and not item.phrase.refers)
        if holder is None or holder.definite or holder.place is not None or not item.places or not again:
            return False
        return holder.noun == " ".join(item.phrase.noun.words) and not any(p.source for p in item.places)

    def is_subject(self, item: Item) -> bool:
        """Whether a clause follows of which an item is the subject: ``the others as they are`` is one too."""
        as_it_is = self.text(item.end) == "as" and self.text(item.end + 1) in ("it", "they")
        return as_it_is or self.predicate_follows(item.end) or self._stays_after(item.end)

    def _stays_after(self, at: int) -> bool:
        """Whether the words at a place say that what is before them stays as it is."""
        return False

    def _objects(self, found: list[Item], subject: Item) -> list[Item]:
        """Return those of a list that are no subjects of the clause after it."""
        first = first_subject(self.words, [*found, subject])
        if first is None:
            raise TwoReadings(found[0].phrase.start, self.boundary(subject.end))
        return found[:first]

    def subjects(self, at: int) -> list[Item]:
        """Read the list of things that a clause begins with; empty where no clause follows it."""
        found: list[Item] = []
        while (item := self.item(at)) is not None:
            found.append(item)
            if self.is_subject(item):
                return found
            at = self.conjunction(item.end)
            if not at or self.starts_clause(at):
                break
        return []

    def _beside_it(self, item: Item, before: Sequence[Item]) -> Item:
        """Put the thing before for ``it``: the table or anything on it."""
        last = before[-1] if before else None
        if last is not None and self._belongs_to(item, last):
            relation: Relation = "around" if self.lexicon.stands(item.phrase.noun.words) else "on"
            there = ReadPlace(Place(relation=relation, anchor=last.phrase.things()), item.phrase.end, item.phrase.end)
            return Item(item.phrase, (replace(there, relative=True), *item.places), item.end)
        if last is None or not item.places:
            return item
        if not last.phrase.definite:
            return self._at_their_holder(item, last)
        anchor = item.places[0].place.anchor
        if anchor is None or anchor.refers != "last" or anchor.noun:
            return item
        if self.text(item.places[0].start) == "from" or (last.phrase.noun.plural and not anchor.plural):
            return item  # "all desks and all chairs from it"
        words = last.phrase.noun.words
        general = " ".join(words) in HYPERNYMS and not self.lexicon.stands(words)
        holds = not (general or self.lexicon.lies_beside_others(words))
        if (item.places[0].source or item.places[0].place.relation in _HOLDING) and not holds:
            return item  # "the laptop and the pen on it" are on what was named before
        place = msgspec.structs.replace(item.places[0].place, anchor=last.things())
        return Item(item.phrase, (replace(item.places[0], place=place), *item.places[1:]), item.end)

    def _belongs_to(self, item: Item, before: Item) -> bool:
        """Whether a thing is that of the furniture named before it: ``the table and its four chairs``."""
        own = self.words[item.phrase.start].raw == ("their" if before.phrase.noun.plural else "its")
        named = item.phrase.noun.kind == "object" and before.phrase.noun.kind == "object" and before.phrase.definite
        return own and named and not before.is_room and self.lexicon.stands(before.phrase.noun.words)

    def _at_their_holder(self, item: Item, before: Item) -> Item:
        """Put what several new things are at for ``it``: ``two chairs at the table and a candle on it``."""
        it, (there, _) = item.places[0].place.anchor, before.goal()
        told = it is not None and it.refers == "last" and not it.noun and not it.plural
        holder = there.anchor
        if not told or not before.phrase.plural or holder is None or holder.plural or not holder.definite:
            return item
        centre = self.text(item.places[0].start + 2) in ("middle", "centre", "center")
        relation: Relation = "on" if centre else item.places[0].place.relation
        place = msgspec.structs.replace(item.places[0].place, relation=relation, anchor=holder, rooms=there.rooms)
        return Item(item.phrase, (replace(item.places[0], place=place), *item.places[1:]), item.end)

    def _as_before(self, item: Item, before: Sequence[Item]) -> Item:
        """Give a bare noun the quantifier before it: any bottle of wine or beer."""
        amount = item.phrase.amount
        plain = amount.kind == "some" and amount.number > 0 and not item.phrase.definite and not item.phrase.refers
        if before and before[-1].phrase.amount.kind == "exactly" and plain:
            exactly = Amount(kind="exactly", number=amount.number)  # "exactly four plates, four forks and a jug"
            return Item(replace(item.phrase, amount=exactly), item.places, item.end)
        bare = item.phrase.end - item.phrase.start == len(item.phrase.noun.words) and not item.phrase.definite
        if not before or not bare or before[-1].phrase.amount.kind not in ("all", "none") or amount.kind != "some":
            return item
        first = before[-1].phrase
        phrase = replace(item.phrase, amount=first.amount, definite=first.definite)
        return Item(phrase, item.places, item.end)

    def _with_ones(self, places: tuple[ReadPlace, ...], phrase: NounPhrase) -> tuple[ReadPlace, ...]:
        """Put the noun for ``one`` in places: a second sofa opposite the first one."""
        noun = phrase.noun if phrase.noun.kind == "object" else self.last_noun
        if self.last_holder and noun is not None and not self.lexicon.stands(noun.words):
            places = tuple(replace(p, place=_with_holder(p.place, self.last_holder)) for p in places)
        anchors = [p.place.anchor.noun for p in places if p.place.anchor is not None and p.place.relation in _HOLDING]
        self.last_holder = next((noun for noun in reversed(anchors) if noun and noun != "one"), self.last_holder)
        return places if noun is None else tuple(replace(p, place=_with_noun(p.place, noun)) for p in places)

    def _named(self, item: Item, before: Sequence[Item]) -> Item:
        """Put the noun that came before for ``one``: two red mugs and a blue one."""
        if before and self._is_bare_number(item.phrase):
            return self._of_the_same_kind(item, before[-1])
        last = next((i.phrase.noun for i in reversed(before) if i.phrase.noun.kind != "anything"), self.last_noun)
        if item.phrase.noun.words[-1:] != ("one",) or last is None:
            if item.phrase.noun.kind == "object":
                self.last_noun = item.phrase.noun
            return item
        if not last.words:  # "replace it by a bigger one"
            raise NotUnderstood(item.phrase.start, item.end)
        told = item.phrase.noun.words[:-1]
        words = (*told, last.words[-1]) if told else last.words
        if told and not self.lexicon.is_object(words):
            raise NotUnderstood(item.phrase.start, item.end)
        noun = replace(item.phrase.noun, words=words, kind=last.kind)
        return Item(replace(item.phrase, noun=noun), item.places, item.end)

    def _is_bare_number(self, phrase: NounPhrase) -> bool:
        """Whether a phrase is only a number of what was named before: ``one``, ``two more``; not ``two of them``."""
        counted = phrase.amount.number > 0 and phrase.amount.kind in ("some", "more")
        pronoun = self.text(phrase.end - 1) in ("it", "them", "they", "those", "these", "both")
        return phrase.refers == "last" and not phrase.noun.words and counted and not pronoun

    def _of_the_same_kind(self, item: Item, before: Item) -> Item:
        """Return so many others of a kind, from where those before come: ``two chairs from the hall ... and one``."""
        noun = replace(before.phrase.noun, plural=item.phrase.amount.number > 1, ordinal=0, size="", number="")
        phrase = replace(item.phrase, noun=noun, refers="", definite=False)
        whence = () if any(p.source for p in item.places) else tuple(p for p in before.places if p.source)
        return Item(phrase, (*whence, *item.places), item.end)

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
        if place > at and self.text(place) == "of" and {"rid", "dispose"} & {word.text for word in self.words[:at]}:
            place += 1  # "get rid of the apple and of the pears"
        return place if place > at else 0

    def starts_clause(self, at: int) -> bool:
        """Whether a clause with a verb of its own begins at a place."""
        while self.text(at) in BEFORE_VERBS:
            if self.text(at) == "do" and self.text(at + 1) != "not":
                break
            at += 1
        if verb_at(self.words, at, self.lexicon) is not None:
            return True
        return self.text(at) in BEGIN_CLAUSES

    def predicate_follows(self, at: int) -> bool:
        """Whether the words at a place make the noun phrase before them the subject of a clause."""
        word = self.text(at)
        if word in (",", "-", ":"):
            return False
        following = self.text(at + 1)
        turns = (word, following) == ("turn", "into") or (word == "keep" and following in STATE_WORDS)
        if word in MODALS or word in PREDICATE_VERBS or turns:
            return True
        if word in STATE_WORDS:
            return not self.is_preposition(at)
        if word in ("switched", "turned", "left", "kept", "powered") and self.text(at + 1) in STATE_WORDS:
            return True
        return self._participle(at) is not None

    def is_preposition(self, at: int) -> bool:
        """Whether ``on`` or ``off`` begins a place, and is no state: ``on the desk``, ``on the upper floor``."""
        if self.text(at) not in ("on", "off"):
            return False
        place = read_place(self.words, at, self.lexicon, self.floors)
        return self.phrase(at + 1) is not None or (place is not None and place.end > at + 1)

    def bothers(self, at: int) -> bool:
        """Whether ``in the way`` stands at a place, which only says that something bothers."""
        return (self.text(at), self.text(at + 1), self.text(at + 2)) == ("in", "the", "way")

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
            joint = word.text in ("and", "but", "then", "so") and self.text(place + 1) != "that"
            if joint and self.begins_request(place + 1):
                break
            place += 1
        return place

    def begins_request(self, at: int) -> bool:
        """Whether a clause begins with a verb that asks for something, or with things of which something is said."""
        return self.starts_clause(at) or any(self._is_known_thing(item) for item in self.subjects(at))

    def _is_known_thing(self, item: Item) -> bool:
        return item.phrase.definite and bool(item.phrase.noun.words) and item.phrase.noun.kind == "object"

    def taken_affirmed(self) -> Things | None:
        """Return what the clause just read said to be there, and forget it."""
        affirmed, self.affirmed = self.affirmed, None
        return affirmed

    def skip(self, at: int) -> int:
        """Return the place after courtesies, adverbs and marks."""
        asking = self.text(at) == "," and self.text(at + 1) in ("would", "could", "will", "can")
        if asking and at + 3 >= len(self.words):
            return len(self.words)
        while at < len(self.words) and self.text(at) in _SKIPPED:
            if self.text(at) in ("thank", "thanks"):
                while self.text(at + 1) in AFTER_THANKS:
                    at += 1
            if self.words[at].raw in ("there's", "theres"):
                break
            if self.text(at) == "there" and (self.text(at + 1) in BE or self.text(at + 1) in MODALS
                                             or self.text(at + 1) in ("need", "has", "have", "not")):  # fmt: skip
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

    def exceptions(self, at: int) -> tuple[int, tuple[Things, ...]]:
        """Read ``except the vase and the lamp``."""
        place = at + (self.text(at) == ",")
        for phrase in _EXCEPTIONS:
            span = tuple(w.text for w in self.words[place : place + len(phrase)])
            if span != phrase:
                continue
            if self.starts_clause(place + len(phrase)):
                return at, ()
            rooms = self._excepted_rooms(place + len(phrase))
            if rooms is not None:
                return rooms
            places, stop = self.places(place + len(phrase))
            if places:
                return stop, (Things(amount=Amount(kind="all", number=0), plural=True, place=joined_places(places)[0]),)
            try:
                items = self.items(place + len(phrase))
            except NotUnderstood:
                return at, ()
            spared = tuple(_kind_of_its_own(self._all(item.things())) for item in items)
            return self._also_spared(items, spared)
        return at, ()

    def _also_spared(self, items: Sequence[Item], spared: tuple[Things, ...]) -> tuple[int, tuple[Things, ...]]:
        """Read further rooms of ``those in the office and in the hall``, ``those in the office and the hall``."""
        named = next((k for k in range(1, len(items)) if items[k].is_room), len(items))
        last, own = items[named - 1], spared[named - 1]
        if own.place is None or own.place.rooms is None or own.place.anchor is not None:
            return items[-1].end, spared
        rooms = [msgspec.structs.replace(own, place=Place(rooms=item.rooms())) for item in items[named:]]
        if not all(item.is_room for item in items[named:]):
            return items[-1].end, spared
        end = last.end if named == len(items) else items[-1].end
        while (at := self.conjunction(end)) and self.text(at) == "in":
            read = read_place(self.words, at, self.lexicon, self.floors)
            if read is None or read.place.rooms is None or read.place.anchor is not None:
                break
            rooms.append(msgspec.structs.replace(own, place=read.place))
            end = read.end
        return end, (*spared[:named], *rooms)

    def _excepted_rooms(self, at: int) -> tuple[int, tuple[Things, ...]] | None:
        """Read ``the office``, ``in room 3`` and ``rooms 1 and 2`` of an exception: all that is there."""
        at += self.text(at) == "in"
        found: list[Things] = []
        while (item := self.item(at)) is not None and self._is_own_room(item):
            end = item.end
            found.append(Things(amount=Amount(kind="all", number=0), plural=True, place=Place(rooms=item.rooms())))
            at = self.conjunction(end)
            if not at:
                break
        ends = not at or self.starts_clause(at) or self.item(at) is None
        return (end, tuple(found)) if found and ends else None

    def _is_own_room(self, item: Item) -> bool:
        """Whether an item names a room of the building, which a thing may be called like: the study, the bar."""
        both = item.phrase.noun.kind == "both" and self.lexicon.is_own_room(item.phrase.noun.words)
        return item.is_room or (both and not self.lexicon.is_here(item.phrase.noun.words[-1]))

    def _is_partitive(self, phrase: NounPhrase) -> bool:
        """Whether a phrase takes some of those that are there: ``two of the hammers``."""
        inner = self.words[phrase.start : phrase.end]
        return any(w.text == "of" and self.text(phrase.start + k + 1) in _THOSE for k, w in enumerate(inner))

    def _is_bare(self, phrase: NounPhrase) -> bool:
        """Whether a thing is named without an article, an owner or a number, as in notes: ``monitor stays``."""
        first = self.words[phrase.start]
        counted = first.kind == "number" or first.text in DETERMINERS
        plain = phrase.amount.kind == "some" and phrase.amount.number <= 1 and not phrase.definite
        return plain and not counted and not phrase.refers and phrase.noun.kind == "object"

    def _are_those_there(self, phrase: NounPhrase) -> bool:
        """Whether a phrase means things that are there: named with ``the``, or in the way of notes."""
        return phrase.definite or self._is_bare(phrase)

    def _as_those_there(self, phrase: NounPhrase) -> Things:
        """Return the things that are there, where they are named without an article too."""
        things = phrase.things()
        if not self._is_bare(phrase):
            return things
        return msgspec.structs.replace(things, amount=Amount(number=0), definite=True)

    def _in_each_room(self, phrase: NounPhrase) -> Things:
        """Return things; in notes for several rooms a bare noun means those of each: ``rooms 4+5: minibar open``."""
        rooms = self.frame.rooms
        several = rooms is not None and JOINED in rooms.words
        return self._as_those_there(phrase) if several else phrase.things()

    def _bare_kept(self, item: Item) -> Things:
        """Return all that is named without an article, in the room that the sentence began with."""
        things = self._all(Item(item.phrase, item.places, item.end).things())
        things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0), definite=True)
        rooms = self.frame.rooms
        own = things.place is not None and (things.place.rooms is not None or things.place.anchor is not None)
        return things if rooms is None or own else with_place(things, Place(rooms=rooms))

    def _is_way(self, phrase: NounPhrase) -> bool:
        return bool(phrase.noun.words) and self.lexicon.is_way(phrase.noun.words[-1])

    def _all(self, things: Things) -> Things:
        """Return all that words describe, where they give no number."""
        if things.amount.number == 0 and things.amount.kind == "some":
            return msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
        return things

    def _all_if_plural(self, things: Things) -> Things:
        return self._all(things) if things.plural else things

    def _within_frame(self, things: Things) -> Things:
        """Return things that are in the room that the sentence began with, where they are in no other.

        A room of their own is on the storey that the sentence began with.
        """
        rooms = self.frame.rooms
        own = things.place is not None and things.place.rooms is not None
        return things if rooms is None or (own and rooms.words) else with_place(things, Place(rooms=rooms))

    def _framed(self, goal: tuple[Place, bool]) -> tuple[Place, bool]:
        """Return a place with what the sentence began with."""
        place, each = goal
        each = each or (self.frame.rooms is not None and self.frame.rooms.every and bool(self.frame.rooms.words))
        if self.frame != Place():
            place = self.frame if place == Place() else merged(place, self.frame)
        return _with_holder_at(place), each


def _names_several(place: Place) -> bool:
    """Whether a place names several things or rooms without their number: ``on the desks``, ``in the offices``."""
    if place.anchor is not None:
        return place.anchor.plural and not place.anchor.amount.number
    return place.rooms is not None and place.rooms.every and not place.rooms.number


def _so_many(place: Place, number: int) -> Place:
    """Return several things or rooms with their number, where it is told."""
    if not number:
        return place
    if place.anchor is not None:
        return msgspec.structs.replace(
            place, anchor=msgspec.structs.replace(place.anchor, amount=Amount(number=number))
        )
    return (
        place
        if place.rooms is None
        else msgspec.structs.replace(place, rooms=msgspec.structs.replace(place.rooms, number=number))
    )


def _with_holder_at(place: Place) -> Place:
    """Return ``on the high table by the wall`` as on the table that is by the wall."""
    holder = place.anchor
    if not place.spot or holder is None or place.relation not in ("on", "in") or holder.refers or not holder.definite:
        return place
    return msgspec.structs.replace(place, spot="", anchor=with_place(holder, Place(spot=place.spot)))


def _with_room_ones(places: tuple[ReadPlace, ...]) -> tuple[ReadPlace, ...]:
    """Put the room that comes before for ``one``: from the third-floor kitchen to the second-floor one."""
    out: list[ReadPlace] = []
    for read in places:
        before = next((p.place.rooms for p in reversed(out) if p.place.rooms is not None and p.place.rooms.words), None)
        anchor, last = read.place.anchor, out[-1].place if out else Place()
        one = anchor is not None and anchor.noun == "one" and anchor.place is not None and read.goal
        if anchor is not None and anchor.place is not None and one and before is not None and last.anchor is None:
            where = anchor.place.rooms
            rooms = Rooms(words=before.words, floors=() if where is None else where.floors)
            read = replace(read, place=Place(rooms=rooms))
        out.append(read)
    return tuple(out)


def _those_there(place: Place) -> Place:
    """Return ``opposite the two which are there`` as at the two of the kind that is being placed."""
    anchor = None if place.anchor is None else _ones(place.anchor)
    return msgspec.structs.replace(place, anchor=anchor, facing=None if place.facing is None else _ones(place.facing))


def _ones(mark: Things) -> Things:
    """Return a bare number of things as so many ``ones``."""
    if mark.noun or mark.refers != "last" or not mark.amount.number or mark.plural:
        return mark
    return msgspec.structs.replace(mark, noun="one", refers="", definite=True, plural=mark.amount.number > 1)


def _with_noun(place: Place, noun: Noun) -> Place:
    def named(mark: Things | None) -> Things | None:
        if mark is None or mark.noun.split()[-1:] != ["one"]:
            return mark
        return msgspec.structs.replace(mark, noun=" ".join((*mark.noun.split()[:-1], *noun.words)))

    return msgspec.structs.replace(place, anchor=named(place.anchor), facing=named(place.facing))


def _with_holder(place: Place, holder: str) -> Place:
    """Put the furniture that came before for ``one`` that something is on or in: on the downstairs one."""
    if place.anchor is None or place.anchor.noun != "one" or place.relation not in _HOLDING:
        return place
    return msgspec.structs.replace(place, anchor=msgspec.structs.replace(place.anchor, noun=holder))


def _kind_of_its_own(things: Things) -> Things:
    """Return an exception that names no kind of its own ("not those in the lab") as one of any kind at its place."""
    if things.refers == "last" and things.place is not None:
        return msgspec.structs.replace(things, refers="", noun="")
    return things
