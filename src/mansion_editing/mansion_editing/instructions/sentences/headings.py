"""Headings: the room, the thing or the occasion that comes before a colon."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.noun_phrases import noun_phrase
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import EVENTS, HEADINGS
from mansion_editing.instructions.phrases.words import DETERMINERS, STATE_WORDS, Word
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Mention, Place

__all__ = ["Headings"]

_ASKED_OF_ALL: Final = frozenset(
    "everything all anything nothing none no not out away gone empty clear bare tidy".split()
) | set(STATE_WORDS)
"""Words by which a heading asks for something itself: ``All off: ...``."""

_ELSEWHERE: Final = frozenset("building house everywhere anywhere room".split())
"""Words of sentences that go on with something else than the room of a heading."""
_REFERRING: Final = frozenset("it its them they there here".split())
"""Words that mean what was mentioned last, wherever it is by now."""
_MOODS: Final = frozenset(
    "cosy cozy comfortable romantic festive quiet calm peaceful relaxed homely welcoming intimate atmospheric".split()
)
_MOST_OF_OCCASION: Final = 4
"""Words of a heading before its room."""


class Headings(Progress):
    """Reads what a sentence, or several, begin with before a colon."""

    def _tells_of_use(self, reader: ClauseReader, at: int) -> bool:
        """Read ``We want to use the storage as a reading corner.`` before requests: what comes next is about it."""
        words = reader.words
        said = [word.text for word in words[at : at + 5] if word.text not in ("would", "d")]
        if self.is_last or said[:1] not in (["we"], ["i"]) or said[2:4] != ["to", "use"]:
            return False
        if said[1] not in ("want", "like", "plan", "wish"):
            return False
        room = reader.item(next(k for k in range(at, len(words)) if words[k].text == "use") + 1)
        if room is None or not room.is_room or reader.text(room.end) != "as":
            return False
        use = words[room.end + 1 :]
        if not use or any(word.kind != "word" or word.text in ("and", "but", "not") for word in use):
            return False
        self.heading = Place(rooms=room.rooms())
        quote = self._quote(words, 0, len(words))
        self.statements.append(Mention(rooms=room.rooms(), passed_over=True, quote=quote))
        return True

    def _read_label(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read ``Preparing the workshop:``, a heading that names nothing of the building but the room of it all."""
        stop = next((k for k in range(at, len(words)) if words[k].text == ":"), len(words))
        verb = verb_at(words, at, self.lexicon)
        if (
            reader.begins_group(at)
            or stop == at
            or stop + 1 >= len(words)
            or (verb is not None and not words[at].raw.endswith("ing"))
        ):
            return at
        start = next((k for k in range(at + 1, stop) if reader.places(k)[1] == stop), stop)
        place, _ = joined_places(reader.places(start)[0])
        label = not _asks(words[at:stop]) and self._is_label(words, at, stop)
        told = None if label and _names_rooms(place) else self._place_of_occasion(reader, at, stop)
        if not label and told is None:
            return at
        if told is not None or _names_rooms(place):
            reader.frame = place if told is None else told
        self.statements.append(Mention(quote=self._quote(words, at, stop)))
        return stop + 1

    def _place_of_occasion(self, reader: ClauseReader, at: int, stop: int) -> Place | None:
        """Read ``Client visit tomorrow, conference room``, in any order; None where the words say something else."""
        place, parts, occasions = Place(), 0, 0
        start = at
        while start < stop:
            end = next((k for k in range(start, stop) if reader.text(k) == ","), stop)
            told = self._part_of_occasion(reader.until(end), start)
            if told is None:
                return None
            parts, occasions = parts + 1, occasions + told[1]
            place = told[0] if place == Place() else merged(place, told[0])
            start = end + 1
        return place if (occasions or parts > 1) and _names_rooms(place) else None

    def _part_of_occasion(self, part: ClauseReader, at: int) -> tuple[Place, bool] | None:
        """Read a room or a storey, or an occasion with its room; return the place, and whether an occasion is told."""
        end = len(part.words)
        room = part.item(at)
        bare = room is not None and not any(p.place.rooms is None or p.place.rooms.words for p in room.places)
        if room is not None and bare and room.is_room and room.end == end and not room.phrase.refers:
            return Place(rooms=room.rooms()), False
        start = next((k for k in range(at, end) if part.places(k)[1] == end), end)
        place, _ = joined_places(part.places(start)[0])
        if not (start == end or _names_rooms(place)):
            return None
        if start == at:
            return place, False
        return (place, True) if self._is_occasion(part.words[at:start]) else None

    def _is_label(self, words: Sequence[Word], at: int, stop: int) -> bool:
        """Whether words before a colon are a heading: ``Initial state:``."""
        if stop >= len(words) or words[stop].text != ":" or stop - at > 9:
            return False
        usual = HEADINGS
        nouns = [w.text for w in words[at:stop] if w.text not in usual]
        named = any(self.lexicon.is_object((noun,)) or self.lexicon.is_own_room((noun,)) for noun in nouns)
        named = named or self._begins_with_own_room(words, at)
        return not named or words[at].text in ("we", "i")

    def _read_heading(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read what a sentence is about: ``The lamp: ...``, ``Too many chairs ...``."""
        heading = reader.item(at)
        told = heading is not None and (heading.phrase.definite or bool(heading.places))
        if heading is not None and told and not heading.is_room and reader.text(heading.end) == ":":
            self.topic = msgspec.structs.replace(heading.things(), definite=True)
            self.statements.append(Mention(quote=self._quote(words, at, heading.end)))
            at = heading.end + 1
        if heading is not None and told and not heading.is_room and reader.text(heading.end) == ",":
            verb = verb_at(words, reader.skip(heading.end), self.lexicon)
            goes = any(place.goal and not place.source for place in heading.places)
            if verb is not None and reader.text(verb[1]) in ("it", "them") and heading.phrase.definite and not goes:
                self.topic = heading.things()  # "the bin from the hall, bring it to the study"
                self.statements.append(Mention(quote=self._quote(words, at, heading.end)))
                at = heading.end + 1
        if reader.text(at) == "many" and at > 0 and words[at - 1].text == "too":
            much = reader.item(at + 1)
            if much is not None:
                self.statements.append(Mention(quote=self._quote(words, at - 1, much.end)))
                at = reader.skip(much.end)
        return at

    def _end_of_occasion(self, reader: ClauseReader, at: int) -> int:
        """Return the colon after ``, evening mode`` of a room; the place itself where no such words follow."""
        stop = next((k for k in range(at, min(at + 5, len(reader.words))) if reader.text(k) == ":"), at)
        occasion = reader.words[at + 1 : stop]
        plain = reader.text(at) == "," and bool(occasion) and all(word.kind == "word" for word in occasion)
        plain = plain and not _ASKED_OF_ALL & {word.text for word in occasion}
        return at if not plain or self._names_anything(occasion) or verb_at(occasion, 0, self.lexicon) else stop

    def _keep_heading(self, reader: ClauseReader, words: Sequence[Word], at: int) -> None:
        """Put the room of a heading before later sentences that name no room: ``Study: lamp off. Chairs out.``"""
        if reader.frame != Place():
            self.heading = reader.frame if at and words[at - 1].text == ":" else Place()
        elif any(word.text in _ELSEWHERE for word in words) or self._names_place(reader, words):
            self.heading = Place()
        elif not any(word.text in _REFERRING for word in words):
            reader.frame = self.heading

    def _names_place(self, reader: ClauseReader, words: Sequence[Word]) -> bool:
        """Whether words name a room or a storey."""
        for at in range(len(words)):
            room = reader.item(at, places=False)
            if (room is not None and room.is_room) or read_storeys(words, at, self.floors) is not None:
                return True
        return False

    def _begins_with_own_room(self, words: Sequence[Word], at: int) -> bool:
        """Whether words begin with a room's name of several words: ``head teacher's office``, ``guest rooms 4``."""
        room = noun_phrase(words, at, self.lexicon, self.floors)
        return room is not None and room.noun.kind in ("room", "both") and self.lexicon.is_own_room(room.noun.words)

    def _names_room_alone(self, words: Sequence[Word]) -> bool:
        """Whether words are nothing but a room's name: ``Copy room``."""
        room = noun_phrase(words, 0, self.lexicon, self.floors)
        return room is not None and room.end == len(words) and room.noun.kind == "room"

    def _is_occasion(self, words: Sequence[Word]) -> bool:
        """Whether words before a place and a colon name what happens there: ``Movie night``."""
        if _is_mood(words):
            return True
        plain = len(words) <= _MOST_OF_OCCASION and all(word.kind == "word" for word in words) and not _asks(words)
        plain = plain and words[0].text not in DETERMINERS - {"a", "an", "the", "our"}
        if plain and words[-1].text in EVENTS:
            return True
        named = self._names_anything(words[-1:]) or self._names_room_alone(words)
        return plain and not (named or words[-1].text in ("more", "less", "fewer"))


def _names_rooms(place: Place) -> bool:
    """Whether a place only says which room or storey."""
    return place.rooms is not None and place == Place(rooms=place.rooms) and not place.rooms.same


def _is_mood(words: Sequence[Word]) -> bool:
    """Whether words only say what a room shall feel like: ``for the evening we want it cosy``."""
    texts = [word.text for word in words]
    who = next((k for k, text in enumerate(texts) if text in ("i", "we")), len(texts))
    before, wish = texts[:who], texts[who + 1 :]
    told = not before or (before[0] in ("for", "tonight", "today") and len(before) <= _MOST_OF_OCCASION)
    wish = wish[1:] if wish[:1] == ["would"] else wish
    liked = wish[:1] in (["want"], ["like"], ["need"]) and wish[1:2] == ["it"]
    rest = [text for text in wish[2:] if text not in ("and", "really", "very", "a", "bit", "nice", ",", "little")]
    return told and liked and bool(rest) and all(text in _MOODS for text in rest)


def _asks(words: Sequence[Word]) -> bool:
    """Whether words before a colon ask for something themselves."""
    return bool(_ASKED_OF_ALL & {word.text for word in words})
