"""Noun phrases with the places that follow them: ``the mug on the desk in the study``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, joined_places
from mansion_editing.instructions.clauses.spans import Spans
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase
from mansion_editing.instructions.phrases.nouns import Noun
from mansion_editing.instructions.phrases.places import SUPERLATIVES, ReadPlace, merged, read_place, with_place
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import BESIDE_RELATIONS
from mansion_editing.instructions.phrases.words import PARTICIPLES_OF_REST
from mansion_editing.instructions.statements import Place, Rooms, Things

__all__ = ["PlacedItems"]

_LYING: Final = frozenset("lying standing sitting hanging resting leaning".split())
_RESTS: Final = frozenset("is are lie lies stand stands sit sits hang hangs rest rests".split())
"""Verbs of a relative clause that say where something is."""
_HOLDING: Final = frozenset(["on", "in", "under"])
"""Relations to furniture that carries or covers things."""


class PlacedItems(Spans):
    """Reads places, and things at them."""

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
            which = read.place.relation in SUPERLATIVES
            if which and found:  # "on the desk nearest the door", "the chair in the hall nearest the door"
                place = merged(found[-1].place, read.place)
                bare = found[-1].place.anchor is None
                found[-1] = replace(found[-1], place=place, end=read.end, relative=found[-1].relative or bare)
                at = read.end
                continue
            beside = self._beside_what_it_carries(found, read)
            if beside is not None:
                found = [*(p for p in found if p.source), beside]
            else:
                found.append(replace(read, relative=True) if relative or owned or which else read)
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
        carried = surface.relation in ("on", "in") and near.place.relation in BESIDE_RELATIONS | {"between"}
        small = not self.lexicon.stands(tuple(mark.noun.split())) and not mark.refers
        if not carried or not small or not self.lexicon.stands(tuple(holder.noun.split())):
            return None
        second = None if near.place.other is None else with_place(near.place.other, surface)
        inner = msgspec.structs.replace(near.place, anchor=with_place(mark, surface), other=second)
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
        if read is not None and nearer and following in ("", ",", ".", "please", "that", "which", "if"):
            return read
        apart = read is not None and (
            read.place.facing is not None or read.place.within > 0 or (bool(read.place.spot) and not place.spot)
        )
        if read is not None and apart and following in ("", ",", ".", "please", "if"):
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

    def _with_ones(self, places: tuple[ReadPlace, ...], phrase: NounPhrase) -> tuple[ReadPlace, ...]:
        """Put the noun for ``one`` in places: a second sofa opposite the first one."""
        noun = phrase.noun if phrase.noun.kind == "object" else self.last_noun
        if self.last_holder and noun is not None and not self.lexicon.stands(noun.words):
            places = tuple(replace(p, place=_with_holder(p.place, self.last_holder)) for p in places)
        anchors = [p.place.anchor.noun for p in places if p.place.anchor is not None and p.place.relation in _HOLDING]
        self.last_holder = next((noun for noun in reversed(anchors) if noun and noun != "one"), self.last_holder)
        return places if noun is None else tuple(replace(p, place=_with_noun(p.place, noun)) for p in places)


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
