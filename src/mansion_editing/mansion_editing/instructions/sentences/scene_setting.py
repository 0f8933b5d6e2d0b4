"""Clauses that tell where things are before something is asked of them: ``A guest left a bag on the sofa``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged, with_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import PEOPLE, RELATIVES, TELLING_WHERE
from mansion_editing.instructions.phrases.words import ADVERBS, MODALS, PERSONS, STATE_WORDS, Word, text_at
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ensure,
    Mention,
    Move,
    Place,
    Remove,
    Rooms,
    Statement,
    Swap,
    Things,
)

__all__ = ["SceneSetting"]

_HAVING: Final = frozenset("has have holds contains works uses".split())
_LEFT: Final = frozenset(
    "left forgot forgotten lost dropped threw thrown put placed parked hid hidden laid hung stored stuck abandoned "
    "dumped deposited carried brought".split()
)
_AT_REST: Final = frozenset("lying standing sitting hanging kept stored parked resting left forgotten".split())
_SOMETIMES: Final = frozenset("usually normally always still currently now already right at present".split())
_NOW: Final = frozenset("now currently again there right".split())
_SOMEBODY: Final = PERSONS | PEOPLE | RELATIVES | {"child", "they", "he", "she"}
_PERSON: Final = _SOMEBODY - frozenset("they i we my our his her their one robot".split())
"""Words for somebody who is in a room of his own."""
_HIS: Final = frozenset("his her their".split())
_TAKING_UP: Final = frozenset("it them both they those these two that this one".split())
_TITLES: Final = frozenset("mr mrs ms miss dr prof".split())
_LIVING: Final = frozenset("lives sleeps sits works stays is".split())
_PAIRS: Final = frozenset("both them they these those two".split())
_WISHED: Final = frozenset("belong prefer rather want like go please swap".split())
_SLEEPING: Final = TELLING_WHERE - {"was", "were"} | frozenset("sleeps sleep goes go moves move".split())
"""Verbs of what becomes of something: ``tonight it sleeps on the sofa``."""

_FROM_NOW: Final = frozenset("tonight tomorrow today now from on then instead".split())
_MOST: Final = 6
"""Words of a subject before its verb."""


class SceneSetting(Progress):
    """Reads what sentences tell of where things are, which the next clause takes up."""

    def _sets_scene(self, reader: ClauseReader, at: int) -> int:
        """Read a clause that tells where things are, where the next one takes them up; return its end, else 0."""
        if self._tells_of_occupant(reader):
            self.statements.append(Mention(quote=self._quote(reader.words, at, len(reader.words))))
            return len(reader.words)
        for read in (self._left_by_somebody, self._listed_there, self._found_there, self._held_by):
            found = read(reader, at)
            if found is None:
                continue
            things, end = found
            joint = reader.text(end) if reader.text(end) in (",", "and", "but", "so", "-") else ""
            rest = reader.words[end:] if end < len(reader.words) else self.later
            if (end < len(reader.words) and not joint) or not self._takes_up(rest, things):
                continue
            self.scene = tuple(_those_there(one) for one in things)
            self.topic = self.scene[0] if len(self.scene) == 1 else None
            reader.last_noun = reader.phrase_of(things[0].noun) if len(things) == 1 else reader.last_noun
            self.statements.append(Mention(quote=self._quote(reader.words, at, end)))
            return end
        return 0

    def _at_their_owner(self, words: Sequence[Word]) -> list[Word]:
        """Return words with the room of whoever was told of after ``his bed`` and ``her desk``."""
        reader = ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))
        out: list[Word] = []
        at = 0
        while at < len(words):
            phrase = reader.phrase(at) if self.whose and words[at].text in _HIS else None
            if phrase is None or phrase.end <= at:
                out.append(words[at])
                at += 1
                continue
            room = phrase.noun.words == ("room",) and text_at(words, at - 1) == "in"
            thing = phrase.noun.kind == "object" and not reader.places(phrase.end)[0]
            said = list(words[at : phrase.end])
            if room:  # "in his room" is "in room 4"
                out[-1:] = _standing_for(said, self.whose)
            else:
                out += [*said, *(_standing_for(said[-1:], self.whose) if thing else [])]
            at = phrase.end
        self.whose = self._room_of_person(reader) or self.whose
        return out

    def _tells_of_occupant(self, reader: ClauseReader) -> bool:
        """Whether a sentence only says how somebody in a room is: ``Mr. Novak in room 4 is thirsty``."""
        told = [word.start for word in self._room_of_person(reader)]
        rest = [word for word in reader.words if told and word.start > told[-1]]
        plain = all(word.kind == "word" and word.text not in STATE_WORDS for word in rest)
        plain = plain and not {word.text for word in rest} & (MODALS | {"not", "no", "and"})
        named = any(self.lexicon.is_object((w.text,)) or self.lexicon.is_own_room((w.text,)) for w in rest)
        return bool(told) and not self.is_last and plain and not named

    def _room_of_person(self, reader: ClauseReader) -> list[Word]:
        """Return the words for the room that somebody is in: ``Mr. Novak in room 4``, ``Ann sleeps in room 2``."""
        words = reader.words
        if not words or verb_at(words, 0, self.lexicon) or len([w for w in words if w.text in _TITLES]) > 1:
            return []
        for at in range(1, min(len(words), _MOST)):
            place = at + (words[at].raw in _LIVING)
            titled = words[0].text in _TITLES or {word.text for word in words[:at]} & _PERSON
            if text_at(words, place) != "in" or not titled or words[at].raw in _LEFT:
                continue
            if any(word.raw in _LEFT for word in words[1:at]):
                return []  # what somebody left is in the room, not he
            places, end = reader.places(place)
            rooms = joined_places(list(places))[0] if places else Place()
            if rooms.rooms is not None and rooms.rooms.words and rooms.anchor is None and not rooms.rooms.every:
                return list(words[place:end])
        return []

    def _left_by_somebody(self, reader: ClauseReader, at: int) -> tuple[list[Things], int] | None:
        """Read ``Somebody threw an apple into the bin``, ``One of the kids has put a doll on the sofa``."""
        words = reader.words
        verb = next((k for k in range(at + 1, min(at + _MOST, len(words))) if words[k].raw in _LEFT), 0)
        subject = {word.text for word in words[at:verb]}
        if not verb or not subject & _SOMEBODY or subject & MODALS or subject & {"not", "please", "if", "you", "never"}:
            return None
        while reader.text(verb + 1) in ("behind", "again"):
            verb += 1
        return self._listed_at(reader, verb + 1)

    def _listed_there(self, reader: ClauseReader, at: int) -> tuple[list[Things], int] | None:
        """Read ``there is a cup and a bowl on the table``, ``on the table there are a cup and a bowl``."""
        places, start = reader.places(at) if reader.text(at) != "there" else ((), at)
        start += reader.text(start) == ","
        verb = reader.text(start + 1) in ("is", "are")
        short = start < len(reader.words) and reader.words[start].raw in ("there's", "theres")
        if reader.text(start) != "there" or not (verb or short):
            return None
        start += 1 + verb
        while text_at(reader.words, start) in _SOMETIMES:
            start += 1
        items = _items(reader, start)
        new = all(item.phrase.amount.kind == "some" and not item.phrase.definite for item in items)
        if not items or not new or any(item.is_room or item.phrase.refers for item in items):
            return None
        place = joined_places([*(items[-1].places or places)])[0]
        if place == Place() or (len(items) == 1 and not self._says_that(items[0])):
            return None
        things = [item.things() if item.places else with_place(item.phrase.things(), place) for item in items]
        return things, _past_adverbs(reader.words, items[-1].end)

    def _says_that(self, item: Item) -> bool:
        """Whether the next sentence means a thing by ``that``."""
        head = item.phrase.noun.words[-1:]
        return any(w.text == "that" and head == (text_at(self.later, k + 1),) for k, w in enumerate(self.later))

    def _found_there(self, reader: ClauseReader, at: int) -> tuple[list[Things], int] | None:
        """Read ``The teddy lives in the chest``, ``A laptop and a mouse are standing on the desk``."""
        first = self._at_rest(reader, at, asked=True)
        if first is None:
            return None
        things, end = first
        joint = reader.conjunction(end)
        more = self._at_rest(reader, joint, asked=False) if joint and len(things) == 1 else None
        return first if more is None else ([*things, *more[0]], more[1])

    def _at_rest(self, reader: ClauseReader, at: int, *, asked: bool) -> tuple[list[Things], int] | None:
        """Read subjects, a verb of rest, which may be left out where it is not `asked` for, and their place."""
        words = reader.words
        verb = next((k for k in range(at + 1, min(at + 2 * _MOST, len(words))) if words[k].raw in TELLING_WHERE), 0)
        if not verb and not asked:
            item = reader.item(at)
            plain = item is not None and item.places and item.phrase.definite and not item.is_room
            return ([item.things()], item.end) if item is not None and plain else None
        if not verb or any(word.kind == "mark" or word.text in MODALS for word in words[at:verb]):
            return None
        stop = verb
        while stop > at and words[stop - 1].raw in _SOMETIMES:
            stop -= 1
        items = _items(reader.until(stop), at)
        if not items or items[-1].end != stop or any(item.is_room or item.phrase.refers for item in items):
            return None
        end = verb + 1
        while text_at(words, end) in _SOMETIMES or (end < len(words) and words[end].raw in _AT_REST):
            end += 1
        places, end = reader.places(end) if not reader.bothers(end) else ((), end)
        if not places or any(read.source or read.each for read in places):
            return None
        plain = len(items) == 1 and items[0].phrase.definite and words[verb].text in ("is", "are")
        if plain and reader.skip(places[-1].end) >= len(words) and asked:
            return None  # which of several is meant, wherever it is named
        place, _ = joined_places(list(places))
        return [self._at(reader, item.things(), place) for item in items], _past_adverbs(words, end)

    def _held_by(self, reader: ClauseReader, at: int) -> tuple[list[Things], int] | None:
        """Read ``the bed has a pillow on it``, ``Room 1 works with a laptop and room 2 with a monitor``."""
        places, start = reader.places(at)
        start = reader.skip(start) if places else at
        first = self._holding(reader, start, joined_places(list(places))[0])
        if first is None:
            return None
        things, end = first
        joint = reader.conjunction(end)
        more = self._holding(reader, joint, Place(), again=True) if joint and len(things) == 1 else None
        return first if more is None else ([*things, *more[0]], more[1])

    def _holding(
        self, reader: ClauseReader, start: int, frame: Place, *, again: bool = False
    ) -> tuple[list[Things], int] | None:
        """Read a room or furniture, a verb of having, and what it has; `again` without the verb."""
        words = reader.words
        verb = next((k for k in range(start + 1, min(start + 2 * _MOST, len(words))) if words[k].raw in _HAVING), 0)
        if not verb and again:
            bare = reader.item(start, places=False)
            verb = bare.end if bare is not None and text_at(words, bare.end) == "with" else 0
        whose = text_at(words, start) in ("somebody", "someone") and words[start].genitive
        holder = reader.until(verb).item(start + whose) if verb else None
        if holder is None or holder.end != verb or holder.phrase.refers:
            return None
        room = holder.is_room
        owner = holder.things() if frame == Place() else with_place(holder.things(), frame)
        if whose:  # any of them, whoever sleeps in it
            owner = msgspec.structs.replace(owner, definite=True, plural=True, amount=Amount(kind="all", number=0))
        after = verb + 1 + (words[verb].raw == "works" and text_at(words, verb + 1) == "with")
        items = _items(reader, after, places=False)
        new = all(item.phrase.amount.kind == "some" and not item.phrase.definite for item in items)
        if not items or not (owner.definite or room) or not new:
            return None
        end = items[-1].end
        relation = text_at(words, end) if text_at(words, end) in ("on", "in") else ""
        if not room and (not relation or text_at(words, end + 1) not in ("it", "them")):
            return None
        if relation and text_at(words, end + 1) == "it":
            end += 2
        place = (
            Place(rooms=holder.rooms()) if room else Place(relation="in" if relation == "in" else "on", anchor=owner)
        )
        return [with_place(item.phrase.things(), place) for item in items], _past_adverbs(words, end)

    def _goes_to_rest(self, reader: ClauseReader, at: int) -> int:
        """Read ``tonight it sleeps on the sofa`` of what was just told to be elsewhere; return its end, else 0."""
        words = reader.words
        first = at
        while text_at(words, at) in _FROM_NOW:
            at += 1
        told = self.topic if len(self.scene) == 1 else None
        verb = words[at + 1].raw if at + 1 < len(words) else ""
        if told is None or text_at(words, at) not in ("it", "they", "he", "she") or verb not in _SLEEPING:
            return 0
        if verb in TELLING_WHERE and at == first:
            return 0
        places, end = reader.places(at + 2)
        place, each = joined_places(list(places))
        if not places or each or any(read.source for read in places) or place.outside:
            return 0
        quote = self._quote(words, first, end)
        self.statements.append(Move(things=told, place=place, quote=quote))
        self.scene, self.topic = (), None
        return end

    def _listed_at(self, reader: ClauseReader, at: int) -> tuple[list[Things], int] | None:
        """Read a list of things with the place that all of them are at."""
        items = _items(reader, at)
        if not items or any(item.is_room or item.phrase.refers for item in items):
            return None
        place, _ = joined_places([read for read in items[-1].places if not read.source])
        if place == Place():
            return None
        things = [item.things() if item.places else with_place(item.phrase.things(), place) for item in items]
        return [self._at(reader, one, Place()) for one in things], _past_adverbs(reader.words, items[-1].end)

    def _at(self, reader: ClauseReader, things: Things, place: Place) -> Things:
        whole = things if place == Place() else with_place(things, place)
        return whole if reader.frame == Place() else with_place(whole, reader.frame)

    def _takes_up(self, later: Sequence[Word], things: Sequence[Things]) -> bool:
        """Whether the words that follow ask for something of the things that were told of."""
        texts = [word.text for word in later]
        nouns = {one.noun.split()[-1] for one in things if one.noun}
        named = any(text in nouns and texts[k - 1] in ("that", "this", "the", "those") for k, text in enumerate(texts))
        one = len(things) == 1 and bool({*texts} & _TAKING_UP)
        several = len(things) > 1 and bool({*texts} & _PAIRS)
        asked = any(verb_at(later, k, self.lexicon) is not None for k in range(min(4, len(later))))
        asked = asked or bool({*texts} & (MODALS | _WISHED)) or any(word.raw in _SLEEPING for word in later[:7])
        return (named or one or several) and asked

    def _of_scene(self, statement: Statement) -> list[Statement]:
        """Return a statement about what the clause before told of: ``both``, ``that apple``, ``these two``."""
        scene = self.scene
        told = isinstance(statement, Swap) and isinstance(statement.one, Things) and bool(statement.one.refers)
        if isinstance(statement, Swap) and told and statement.one == statement.other:
            if len(scene) != 2:
                self.unknown.append(statement.quote)  # it is not told which two
                return []
            return [Swap(one=scene[0], other=scene[1], quote=statement.quote)]
        if not scene:
            return [statement]
        if isinstance(statement, Move) and statement.or_new and _pinned(statement.things, scene) in scene:
            statement = msgspec.structs.replace(statement, or_new=False)
        statement = _pinned(statement, scene)
        things = getattr(statement, "things", None)
        statement = self._on_it_there(statement)
        if isinstance(statement, Ensure) and things in scene:
            statement = Move(things=statement.things, place=statement.place, quote=statement.quote)
        if len(scene) < 2 or not isinstance(things, Things) or not _means_all(things):
            return [statement]
        if things.amount.number not in (0, 1, len(scene)):
            return [statement]
        first = self.statements[-len(scene) :]
        again = [s.things for s in first if isinstance(s, Move) and s.place.anchor is None] == list(scene)
        if isinstance(statement, Move) and isinstance(first[0], Move) and again:
            self.statements[-len(scene) :] = [Mention(quote=first[0].quote)]
            place = merged(statement.place, msgspec.structs.replace(first[0].place, spot=""))
            statement = msgspec.structs.replace(statement, place=place)
        return [msgspec.structs.replace(statement, things=one) for one in scene]

    def _on_it_there(self, statement: Statement) -> Statement:
        """Return what small things are added ``there`` as added on the furniture that things were told to be on."""
        place = self.scene[0].place
        if not isinstance(statement, Add | Ensure) or statement.place != Place(rooms=Rooms(same=True)):
            return statement
        if place is None or place.anchor is None or self.lexicon.stands(tuple(statement.things.noun.split())):
            return statement
        return msgspec.structs.replace(statement, place=msgspec.structs.replace(place, relation="on"))

    def _in_scene(self, statement: Statement) -> Statement:
        """Return a statement with the place of what was told of; once that has moved or gone, it is told no longer."""
        if not self.scene or isinstance(statement, Mention):
            return statement
        pinned: Statement = _pinned(statement, self.scene)
        self.scene = () if isinstance(pinned, Move | Remove | Swap) and len(self.scene) == 1 else self.scene
        return pinned


def _standing_for(said: Sequence[Word], told: Sequence[Word]) -> list[Word]:
    """Return words that were told before at the end of those which they explain."""
    return [replace(word, start=said[-1].end, end=said[-1].end) for word in told]


def _items(reader: ClauseReader, at: int, *, places: bool = True) -> list[Item]:
    """Return things joined by conjunctions, the places of which are read or left."""
    if places:
        try:
            return reader.items(at)
        except NotUnderstood:
            return []
    found: list[Item] = []
    while (item := reader.item(at, places=False)) is not None and not item.is_room:
        found.append(item)
        at = reader.conjunction(item.end)
        if not at:
            break
    return found


def _past_adverbs(words: Sequence[Word], at: int) -> int:
    while text_at(words, at) in _NOW or text_at(words, at) in ADVERBS - {"too", "also"}:
        at += 1
    return at


def _those_there(things: Things) -> Things:
    """Return things as those that are there, on or in furniture: one where one is told of."""
    if things.place is not None and things.place.relation in ("on", "in"):
        things = msgspec.structs.replace(things, place=msgspec.structs.replace(things.place, relation=""))
    counted = things.amount.number if things.amount.kind == "some" and things.amount.number > 1 else 0
    return msgspec.structs.replace(things, definite=True, amount=Amount(number=counted))


def _means_all(things: Things) -> bool:
    """Whether words only say ``both``, ``them``, ``the two``."""
    several = things.plural or things.amount.number > 1
    return things.refers == "last" and not things.noun and several and things.place is None


def _pinned(value: Any, scene: Sequence[Things]) -> Any:
    """Return a statement in which definite words for a thing mean the one that was told of, at its place."""
    if isinstance(value, Things) and value.definite and not value.refers and not value.owned:
        told = [one for one in scene if one.noun == value.noun and value.colour in ("", one.colour)]
        if len(told) == 1 and value.place in (None, Place(rooms=Rooms(same=True))):
            return told[0]
    if not isinstance(value, msgspec.Struct):
        return tuple(_pinned(part, scene) for part in value) if isinstance(value, tuple) else value
    return msgspec.structs.replace(value, **{f: _pinned(getattr(value, f), scene) for f in value.__struct_fields__})
