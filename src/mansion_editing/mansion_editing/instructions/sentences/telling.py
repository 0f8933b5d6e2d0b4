"""Sentences that ask for nothing themselves, but tell where something is or what the next one is about."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, joined_places
from mansion_editing.instructions.clauses.outcomes import everything_at
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged, read_place, with_place
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import ANY_LONGER
from mansion_editing.instructions.phrases.words import (
    ADVERBS,
    BE,
    HAVE,
    MODALS,
    NEED,
    PERSONS,
    PREPOSITIONS,
    STATE_WORDS,
    Word,
    next_mark,
)
from mansion_editing.instructions.sentences.background import end_of_background
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.refinement import is_open, narrowed, with_noun_at
from mansion_editing.instructions.statements import Amount, Ensure, Mention, Place, Things

__all__ = ["Telling"]

_WISHING: Final = frozenset(
    "please not like love wish prefer expect fancy require appreciate ask insist demand recommend suggest propose "
    "think believe order hope if when".split()
)
"""Words of sentences that ask for something."""

_BEFORE_OCCASIONS: Final = frozenset("for after before during given despite until".split())

_I: Final = frozenset(["i", "we", "i'd", "we'd"])
_ABLE: Final = frozenset("i we he she you it they everyone everybody people anyone".split())
_COUNTING: Final = frozenset("it there is are a we have has got still about they that just only single".split())
_TAKING_UP: Final = frozenset("it one ones them that this those these".split())
_BECOMING: Final = frozenset("go stay remain disappear vanish".split())
"""Verbs that say what shall become of their subject."""


class Telling(Progress):
    """Reads what sentences tell of things, rooms and persons."""

    def _reads_scope(self, reader: ClauseReader, at: int) -> bool:
        """Read a sentence that only tells where something mentioned is: ``The desk is in the lobby.``."""
        if self._tells_storeys(reader, at):
            return True
        item = reader.item(at)
        if item is None:
            return False
        end = item.end
        indicative = reader.text(end) in ("is", "are")
        contracted = reader.words[item.phrase.end - 1].genitive and item.end > item.phrase.end
        pronoun = item.phrase.refers == "last" and reader.words[at].raw in ("it's", "they're")
        if not (indicative or contracted or pronoun) or reader.bothers(end + indicative):
            return False
        places, stop = reader.places(end + indicative) if indicative or not item.places else (item.places, item.end)
        if not places or reader.skip(stop) < len(reader.words):
            return False
        place = Place()
        for read in places:
            place = read.place if place == Place() else merged(place, read.place)
        noun = " ".join(item.phrase.noun.words)
        number = item.phrase.noun.number
        refined = [with_noun_at(s, f"{noun} {number}".strip(), place) for s in self.statements]
        if item.phrase.refers == "last" and self.statements:
            refined = [*self.statements[:-1], narrowed(self.statements[-1], place)]
        if refined == self.statements and item.is_room and place.rooms is not None and self.statements:
            rooms = merged(Place(rooms=item.phrase.rooms()), place)
            refined = [narrowed(s, rooms) if is_open(s) else s for s in self.statements]
        if (
            refined == self.statements
            and not (self.is_last or item.is_room or item.phrase.refers)
            and item.phrase.definite
        ):
            self.told.append((f"{noun} {number}".strip(), place))
            self.topic = with_place(item.phrase.things(), place)
            self.statements.append(Mention(quote=self._quote(reader.words, at, stop)))
            return True
        if refined == self.statements:
            return False
        self.statements = refined
        return True

    def _tells_of_person(self, reader: ClauseReader, at: int) -> bool:
        """Read ``She sleeps in the children's room``, which tells where the bed is; and why something is not right."""
        words = reader.words
        first = reader.text(at)
        whole = self._quote(words, 0, len(words))
        if first in ("he", "she") and at + 1 < len(words):
            places, end = reader.places(at + 2)
            if places and reader.skip(end) >= len(words) and self.statements and places[0].place.rooms is not None:
                place = places[0].place
                self.statements = [narrowed(s, place) if is_open(s) else s for s in self.statements]
                self.statements.append(Mention(quote=whole))
                return True
        if first in ("why",):
            there = next((k for k in range(at, len(words)) if words[k].text == "there"), -1)
            item = reader.item(there + 1) if there >= 0 else None
            self.topic = None if item is None else item.things()
            if self.topic is not None and not self.topic.definite:
                whole_of_it = Amount(kind="all", number=0)
                self.topic = msgspec.structs.replace(self.topic, amount=whole_of_it, plural=True, definite=True)
            self.statements.append(Mention(quote=whole))
            return True
        told = words[at].raw in ("is", "are", "looks") and len(words) - at <= 7
        if told and not reader.item(at + 1) and reader.text(at + 1) != "there":
            self.statements.append(Mention(quote=whole))
            return True
        return self._tells_what_was_left(reader, at)

    def _tells_what_was_left(self, reader: ClauseReader, at: int) -> bool:
        """Read ``A guest left a suitcase in room 4``, which says what the next sentence is about."""
        words = reader.words
        if self._tells_what_people_do(reader, at):
            return True
        verbs = (
            "left",
            "forgot",
            "lost",
            "dropped",
            "has",
            "have",
            "uses",
            "needs",
            "put",
            "see",
            "saw",
            "found",
            "notice",
        )
        left = next((k for k in range(at, min(at + 8, len(words))) if words[k].raw in verbs), -1)
        if self.is_last:
            return False
        if left < 0 or not {w.text for w in words[at:left]} & PERSONS:
            return False
        item = reader.item(left + 1)
        end = len(words) if item is None else item.end
        end += 2 if tuple(w.text for w in words[end : end + 2]) == ("any", "more") else 0
        if item is None or reader.skip(end) < len(words):
            return False
        taken_up = {word.text for word in self.later} & (_TAKING_UP | {*item.phrase.noun.words})
        if words[left].raw == "needs" and not taken_up:
            return False
        self.topic = _whatever_it_is(item)
        if words[left].raw in ("has", "have", "uses", "needs"):
            self.topic = msgspec.structs.replace(self.topic, definite=True)
        self.statements.append(Mention(quote=self._quote(words, 0, len(words))))
        return True

    def _tells_what_people_do(self, reader: ClauseReader, at: int) -> bool:
        """Read ``Nobody reads the newspaper any more``, ``We eat at the table``: what the next sentence is about."""
        words = reader.words
        end = 0 if self.is_last else self._told_of_thing(reader, at)
        if end < len(words):
            return False
        self.statements.append(Mention(quote=self._quote(words, 0, len(words))))
        return True

    def _end_of_reason(self, reader: ClauseReader, at: int) -> int:
        """Return the end of a reason or a purpose at a place, which a request after it is no part of."""
        words = reader.words
        end = max(end_of_background(words, at), self._end_of_adverbial(words, at))
        purpose = words[at].text in ("so", "in")
        for joint in range(at + 1, end if at else at):
            if words[joint].text not in ("and", "but") or not self._asks_at(reader, joint + 1):
                continue
            if purpose:  # "so that they come and open the window": what they do, or a request
                self.unknown.append(self._quote(words, at, end))
                return end
            return joint
        return end

    def _end_of_present_number(self, words: Sequence[Word], at: int) -> int:
        """Read ``, at the moment it is a dozen`` after a wished number; return its end, 0 for others."""
        last = self.statements[-1] if self.statements else None
        if not isinstance(last, Ensure) or last.things.amount.kind not in ("exactly", "at_most"):
            return 0
        said = [word.text for word in words[at:]]
        start = next((k for k, text in enumerate(said) if text not in (",", "-", "and", "but", "right")), len(said))
        end = start + 1
        while said[end : end + 1] and said[end] in _COUNTING:
            end += 1
        counted = end < len(said) and (words[at + end].kind == "number" or said[end] == "dozen") and end > start + 1
        ends = at + end + 1 >= len(words) or words[at + end + 1].kind == "mark"
        if said[start : start + 1] not in (["now"], ["currently"], ["presently"]) or not counted or not ends:
            return 0
        self.statements.append(Mention(quote=self._quote(words, at + start, at + end + 1)))
        return at + end + 1

    def _end_of_ability(self, words: Sequence[Word], at: int) -> int:
        """Read ``so I can find it``, what somebody can do then; return its end, 0 for others."""
        said = [word.text for word in words[at : at + 4]]
        end = next_mark(words, at)
        able = said[:1] == ["so"] and said[1:2] and said[1] in _ABLE and said[2:3] in (["can"], ["could"])
        plain = all(word.kind == "word" for word in words[at:end])
        plain = plain and not {"not", "and", *STATE_WORDS} & {w.text for w in words[at:end]}
        if not able or not plain or self._names_anything(words[at + 3 : end]):
            return 0
        self.statements.append(Mention(quote=self._quote(words, at, end)))
        return end

    def _end_of_adverbial(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``for safety's sake`` or ``after the break`` before a verb; the place itself for others."""
        if words[at].text not in _BEFORE_OCCASIONS:
            return at
        for end in range(at + 2, min(at + 10, len(words))):
            if words[end].raw in _I and not self._is_named(words[end - 1]):
                return end
            hyphen = "-" in (self.text[words[end].start - 1], self.text[words[end].end : words[end].end + 1])
            if hyphen:
                continue
            if words[end].kind == "mark" or words[end].text in PREPOSITIONS - {"of"} or self._is_named(words[end - 1]):
                return at
            if words[end].kind == "number" or words[end - 1].text in ("it", "them", "us", "me"):
                return at
            subject = end + 1 < len(words) and words[end + 1].raw in _I
            if verb_at(words, end, self.lexicon) is not None and not subject:
                return end
        return at

    def _asks_at(self, reader: ClauseReader, at: int) -> bool:
        """Whether words ask for something: a verb with its object, or things that must go or stay."""
        verb = verb_at(reader.words, at, self.lexicon)
        if verb is not None:
            item = reader.item(verb[1] + (reader.text(verb[1]) in ("on", "off", "up", "down", "out")))
            return item is not None and item.phrase.noun.kind != "anything"
        subjects = reader.subjects(at)
        if not subjects or not subjects[-1].phrase.definite:
            return False
        said = reader.text(subjects[-1].end)
        return said in MODALS - {"can", "could", "may", "might"} or said in _BECOMING

    def _told_of_thing(self, reader: ClauseReader, at: int) -> int:
        """Return the end of a clause that tells what somebody does with a thing, which is then the topic; else 0."""
        words = reader.words
        if verb_at(words, at, self.lexicon) is not None:
            return 0
        for verb in range(at + 1, min(at + 4, len(words) - 1)):
            if self._is_named_within(words[at:verb]) or not self._is_told_by(words, at, verb):
                continue
            place = read_place(words, verb + 1, self.lexicon, self.floors)
            item = reader.item(verb + 1)
            about = (
                item.things()
                if item is not None and not item.is_room
                else None
                if place is None
                else place.place.anchor
            )
            end = item.end if item is not None else len(words) if place is None else place.end
            while reader.text(end) in ANY_LONGER or reader.text(end) in ADVERBS:
                end += 1
            asking = {w.text for w in words[at:end]} & (MODALS | NEED | BE | HAVE | _WISHING)
            if about is None or asking or (end < len(words) and reader.text(end) not in (",", "so", "and", "but")):
                continue
            self.topic = about
            return end
        return 0

    def _is_told_by(self, words: Sequence[Word], at: int, verb: int) -> bool:
        """Whether a word is the verb of a clause that tells what somebody does or did."""
        person = verb == at + 1 and words[at].text in PERSONS | {"nobody"}
        past = words[verb].raw.endswith("ed") and words[verb].kind == "word"
        third = words[verb].plural and not self._is_named_within(words[verb : verb + 1])
        told = past or third or words[at].text in ("i", "we", "they", "people", "you", "guest", "visitor")
        return words[verb].text not in PREPOSITIONS and (past or person or third) and told

    def _is_named(self, word: Word) -> bool:
        """Whether a word names things, rooms or storeys."""
        text = (word.text,)
        return self.lexicon.is_object(text) or self.lexicon.is_room(text) or word.text in ("floor", *STATE_WORDS)

    def _is_named_within(self, words: Sequence[Word]) -> bool:
        return any(self.lexicon.is_object((w.text,)) or self.lexicon.is_own_room((w.text,)) for w in words)

    def _tells_storeys(self, reader: ClauseReader, at: int) -> bool:
        """Read ``the top floor is 8``, which asks for nothing."""
        storeys = read_storeys(reader.words, at, self.floors)
        if storeys is None or reader.text(storeys[2]) not in ("is", "are"):
            return False
        end = storeys[2] + 1
        if end + 1 != len(reader.words) or reader.words[end].kind not in ("number", "ordinal"):
            return False
        self.statements.append(Mention(quote=self._quote(reader.words, at, end + 1)))
        return True


def _whatever_it_is(item: Item) -> Things:
    """Return what was left somewhere; ``half the kitchen`` and ``a mess`` are whatever is there."""
    thing = item.phrase.noun.kind == "object" and item.phrase.amount.kind != "half"
    where, _ = joined_places(list(item.places))
    return item.things() if thing or where.anchor is None else everything_at(where)
