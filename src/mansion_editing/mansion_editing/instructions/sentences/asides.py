"""Sentences with a clause that asks for nothing: it is passed over, and what it names must be as it was afterwards."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any, Final

import msgspec

from mansion_editing.instructions.clauses.items import Item
from mansion_editing.instructions.clauses.outcomes import everything_at
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import BEFORE_VERBS, PEOPLE, RELATIVES, TELLING_WHERE
from mansion_editing.instructions.phrases.words import BE, MODALS, PERSONS, Word, text_at
from mansion_editing.instructions.sentences.antecedents import listed_in, with_list_for_pronoun
from mansion_editing.instructions.sentences.bystanding import (
    asks_for_nothing,
    begins_with_state,
    fills_gaps,
    gives_up_room,
    is_exclamation,
    is_habit,
    is_purpose,
    is_regret,
    is_rhetorical,
    keeps_doors_free,
    lacks_a_place,
    needs_doing,
    needs_the_space,
    notes_deed,
    stands_wrong,
    tells_whose,
)
from mansion_editing.instructions.sentences.circumstances import is_circumstance
from mansion_editing.instructions.sentences.judgements import cannot_do, end_of_judged_predicate, is_judgement
from mansion_editing.instructions.sentences.lacking import given_where_none_is, spares_those_with_one
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ensure,
    Mention,
    Place,
    Remove,
    Rooms,
    Statement,
    Things,
)

__all__ = ["Asides"]

_CUTS: Final = frozenset([",", "(", ")", "-", ":"])
_JOINTS: Final = frozenset("and but so as since".split())
_RELATIVE: Final = frozenset("where which whose".split())
"""Words of clauses that may tell which of several is meant, and are therefore no asides."""

_EXCEPTING: Final = frozenset("apart except excluding save besides without but not unless".split())
"""Words that begin an exception, which is no remark whatever follows."""

_OTHERS: Final = frozenset("rest other remainder".split())
"""What is left of the things that were mentioned, of which words say what becomes."""

_ALIKE: Final = frozenset("neither nor likewise same ditto".split())
"""Words that ask the same of something else: ``neither is the notebook``."""

_MOST_CUTS: Final = 8
"""In longer sentences only beginnings and ends are tried."""

_MOST_ASIDES: Final = 3
"""In one sentence."""

_TAKING_UP: Final = frozenset("it its them they one there that this those these another ones both".split())
"""Words by which a sentence goes on with what the one before it told of."""


_WITHOUT_SUBJECT: Final = frozenset("stay remain should must needs belongs".split())
"""Verbs of a clause whose subject the one before it names: ``the cup is on the desk, should be on the shelf``."""

_TELLING_OF_ONE: Final = frozenset("one another second theirs own".split())
"""Words without which nothing is said of what has one already."""


class Asides(Progress):
    """Reads a sentence again without what asks for nothing, where it was not understood as a whole."""

    @abstractmethod
    def _read_sentence(self, words: Sequence[Word], *, marked: bool) -> None:
        """Read one sentence into statements."""

    def _read_rest(self, words: Sequence[Word], later: Sequence[Word], *, marked: bool, depth: int) -> None:
        """Read a sentence of which an aside was left out; it may have another one."""
        if depth < _MOST_ASIDES:
            self._read_beside_asides(words, later, marked=marked, depth=depth + 1)
        else:
            self._read_sentence(words, marked=marked)

    def _read_beside_asides(
        self, words: Sequence[Word], later: Sequence[Word], *, marked: bool, depth: int = 1
    ) -> None:
        """Read a sentence; a clause of it that is not understood and asks for nothing is passed over.

        Parameters
        ----------
        later : sequence of Word
            The sentence after it, which may go on with what this one tells of.
        """
        first = self._so_far()
        if self._gives_up_what_becomes_another(words, later):
            self._pass_over(words, later)
            return
        self._read_sentence(words, marked=marked)
        if len(self.unknown) == len(first["unknown"]) or self.undecided:
            return
        if self._fills_gaps(words, first):
            return
        whole = self._so_far()
        if self._reads_beside_judgement(words, later, first, marked=marked, depth=depth):
            return
        listed = listed_in(self._reader(words))
        for start, end in _parts(words):
            if listed and start == 0 and listed[0].start < words[end - 1].end < listed[-1].start:
                continue
            last = start > 0 and end == len(words)
            if last and self._reads_before_end(words, start, later, first, marked=marked, depth=depth):
                return
            if self._reads_beside(words, (start, end), later, first, marked=marked, depth=depth):
                return
        self._go_back(whole)

    def _reads_beside_judgement(
        self, words: Sequence[Word], later: Sequence[Word], first: dict[str, Any], *, marked: bool, depth: int
    ) -> bool:
        """Read a sentence without the first of two predicates, which only judges; return whether that is understood."""
        start, end = end_of_judged_predicate(words, self.lexicon)
        if not end:
            return False
        self._go_back(first)
        self._read_rest([*words[:start], *words[end:]], later, marked=marked, depth=depth)
        if len(self.unknown) > len(first["unknown"]):
            return False
        self.statements.append(Mention(quote=self._quote(words, start, end - 1), passed_over=True))
        return True

    def _reads_before_end(
        self, words: Sequence[Word], at: int, later: Sequence[Word], first: dict[str, Any], *, marked: bool, depth: int
    ) -> bool:
        """Read a sentence whose end only says what stays, or that gaps are filled; return whether it is understood."""
        rest, part = _trimmed(words[:at]), _trimmed(words[at:])
        if fills_gaps(part):
            self._go_back(first)
            self._read_rest(rest, later, marked=marked, depth=depth)
            if len(self.unknown) == len(first["unknown"]) and self._fills_gaps(part, self._so_far()):
                return True
        if not rest or not self._reader(part).says_what_stays():
            return False
        self._go_back(first)
        self._read_sentence(rest, marked=marked)
        self._read_sentence(part, marked=False)
        return len(self.unknown) == len(first["unknown"])

    def _reads_beside(
        self,
        words: Sequence[Word],
        part_at: tuple[int, int],
        later: Sequence[Word],
        first: dict[str, Any],
        *,
        marked: bool,
        depth: int,
    ) -> bool:
        """Read a sentence without a part that asks for nothing; return whether it is understood then."""
        start, end = part_at
        part, rest = words[start:end], [*words[:start], *words[end:]]
        before = start == 0
        wrong = self._stands_wrong(part, (rest or later) if before else [])
        if not (wrong or self._is_aside(part, followed=before and bool(rest or later), marked=marked)):
            return False
        self._go_back(first)
        if before and self._is_unclear(part, rest or later):
            return False
        if before:
            self._pass_over(part, rest or later)
            rest = list(self._with_listed(rest))
        if rest:
            again = self._with_subject(part, _trimmed(rest)) if before else _trimmed(rest)
            self._read_rest(again, later, marked=marked and before, depth=depth)
        if len(self.unknown) > len(first["unknown"]):
            return False
        if not before:
            self._pass_over(part, later if end == len(words) else [])
        return True

    def _gives_up_what_becomes_another(self, words: Sequence[Word], later: Sequence[Word]) -> bool:
        """Whether a room is told to be needed no longer before ``turn it into an office``."""
        verb = verb_at(later, 0, self.lexicon)
        if verb is None or verb[0] not in ("furnish", "switch", "make", "change"):
            return False
        return text_at(later, verb[1]) in ("it", "that", "this") and gives_up_room(_trimmed(words), self.lexicon)

    def _stands_wrong(self, words: Sequence[Word], later: Sequence[Word]) -> bool:
        """Whether words only tell why something shall be turned or moved: ``it is the wrong way round``."""
        subject = stands_wrong(_trimmed(words))
        taken_up = any(word.text in ("it", "them") for word in later)
        return bool(subject) and (taken_up or not (later or self._names_anything(subject[-1:])))

    def _with_subject(self, told: Sequence[Word], rest: Sequence[Word]) -> Sequence[Word]:
        """Return ``stays off`` after ``The shredder is broken`` with its subject."""
        if not rest or rest[0].text not in _WITHOUT_SUBJECT:
            return rest
        item = self._reader(told).item(0)
        return rest if item is None else [*told[: item.end], *rest]

    def _is_aside(self, words: Sequence[Word], *, followed: bool, marked: bool) -> bool:
        words = _trimmed(words)
        if text_at(words, 0) == "the" and text_at(words, 1) in _OTHERS:
            return False
        if words and (words[0].text in _RELATIVE | _EXCEPTING or begins_with_state(words) or _corrects(words)):
            return False
        if _go_elsewhere(words):
            return False
        if words and (words[0].text in _ALIKE or (words[0].text == "so" and text_at(words, 1) in BE | MODALS | {"do"})):
            return False
        joints = [at for at, word in enumerate(words) if word.text in _CUTS | _JOINTS | BEFORE_VERBS | {"or"}]
        if followed and not marked and cannot_do(words):
            return True
        orders = (at for at in joints if verb_at(words, at + 1, self.lexicon) is not None)
        if any(words[at].text != "so" or at + 2 < len(words) for at in orders):
            return False
        if marked or is_rhetorical(words):
            return is_rhetorical(words)
        if notes_deed(words, self.lexicon):
            return False
        last = words[-1].end if words else 0
        called = self.text[last : last + 1] == "!" and is_exclamation(words, self.lexicon)
        if is_habit(words) or needs_the_space(words) or (followed and is_regret(words)):
            return True
        if needs_doing(words) or keeps_doors_free(words):
            return True
        if followed and gives_up_room(words, self.lexicon):
            return True
        if tells_whose(words) or lacks_a_place(words, self.lexicon) or is_judgement(words, self.lexicon):
            return True
        if called or is_purpose(words, self.lexicon) or asks_for_nothing(words, self.lexicon, followed=followed):
            return True
        return is_circumstance(words, self.lexicon, followed=followed)

    def _pass_over(self, words: Sequence[Word], later: Sequence[Word]) -> None:
        """Note a clause that asks for nothing, with what it names unless the next one goes on with that."""
        words = _trimmed(words)
        named = _named(self._reader(words))
        nouns = {text for things in named for text in things.noun.split()}
        taken_up = any(word.text in _TAKING_UP or word.text in nouns for word in later)
        self.listed = list(listed_in(self._reader(words))) if taken_up else []
        rooms = None
        if taken_up and named:
            first = _other_than_holder(named, later)
            self.topic = self._told_of(words, first) if first.noun else self._lacking(words)
            rooms = None if named[0].noun or named[0].place is None else named[0].place.rooms
        own = _own_rooms(self._reader(words)) if taken_up and not nouns else []
        rooms = own[0] if len(own) == 1 else rooms
        quote = self._quote(words, 0, len(words))
        untouched = () if taken_up else named
        where = [things for things in named if not things.noun and things.place is not None]
        told_where = is_judgement(words, self.lexicon) or is_circumstance(words, self.lexicon, followed=True)
        if len(where) == 1 and told_where:
            rooms = where[0].place.rooms if where[0].place is not None else None
            rooms = rooms if rooms != Rooms() else None
            untouched = tuple(things for things in untouched if things is not where[0])
        elif told_where and rooms is None:
            within = _rooms_within(self._reader(words))
            rooms = within[0] if len(within) == 1 else None
        self.statements.append(Mention(quote=quote, rooms=rooms, passed_over=True, untouched=untouched))

    def _take_up_what_is_told(self, words: Sequence[Word]) -> Rooms | None:
        """Make the one thing that a remark names what ``it`` means next, where nothing was asked for before.

        Return the one room that it names where it names no thing.
        """
        named = [things for things in _named(self._reader(words)) if things.noun]
        if len(named) == 1 and all(isinstance(statement, Mention) for statement in self.statements):
            self.topic = self._told_of(words, named[0])
        rooms = _own_rooms(self._reader(words))
        return rooms[0] if len(rooms) == 1 and not named else None

    def _told_of(self, words: Sequence[Word], named: Things) -> Things:
        """Return what a clause names first as it says it: one thing, and not all of its kind."""
        reader = self._reader(words)
        items = ((at, reader.item(at)) for at in range(len(words)))
        known = (item for at, item in items if item is not None and (item.phrase.definite or _is_bare(item, at)))
        said = (msgspec.structs.replace(item.things(), definite=True) for item in known if not item.is_room)
        whole = Amount(number=0)
        one = next((things for things in said if things.noun == named.noun and not things.plural), named)
        return one if one is named or one.amount.number != 1 else msgspec.structs.replace(one, amount=whole)

    def _with_listed(self, words: Sequence[Word]) -> Sequence[Word]:
        """Return words in which the list that the clause before told of stands for its pronoun."""
        if not self.listed or not words:
            return words
        told, self.listed = self.listed, []
        return with_list_for_pronoun(words, told, self._reader(words))

    def _is_unclear(self, told: Sequence[Word], later: Sequence[Word]) -> bool:
        """Whether ``it`` may mean one or the other of several things that were told of, or one of no known name."""
        texts = [word.text for word in later]
        if {"it", "that", "them"} & {*texts} and self._has_unknown_subject(_trimmed(told)):
            return True
        return "it" in texts and len(listed_in(self._reader(_trimmed(told)))) > 0

    def _has_unknown_subject(self, words: Sequence[Word]) -> bool:
        """Whether a clause begins with a thing of no known name: ``the gizmo lives in the chest``."""
        if len(words) < 2 or words[0].text not in ("the", "our", "my", "a", "an", "this", "that"):
            return False
        reader = self._reader(words)
        known = reader.item(0) is not None or words[1].text in PERSONS | PEOPLE | RELATIVES
        resting = next((k for k in range(2, min(4, len(words))) if words[k].raw in TELLING_WHERE), 0)
        return not known and bool(resting) and any(things.noun for things in _named(reader))

    def _lacking(self, words: Sequence[Word]) -> Things | None:
        """Return what was mentioned last where words say of a room that it has none."""
        last = next((s.things for s in reversed(self.statements) if isinstance(s, Remove | Add | Ensure)), None)
        if last is None or not last.noun or not any(word.text == "none" for word in words):
            return self.topic
        return msgspec.structs.replace(last, place=None, amount=Amount(), definite=False, plural=False, refers="")

    def _spares_those_with_one(self, words: Sequence[Word], *, marked: bool) -> bool:
        """Read ``where there is one already leave it`` after what is brought, which then counts what is there."""
        first = self._so_far()
        for at in (0, *(at for at, word in enumerate(words) if word.text in _CUTS | _JOINTS)):
            part = _trimmed(words[at:])
            if not any(word.text in _TELLING_OF_ONE for word in part):
                break
            if at:
                self._go_back(first)
                self._read_sentence(_trimmed(words[:at]), marked=marked)
            together = self._asked_last()
            given = given_where_none_is(together, alone=True)
            if given is None or len(self.unknown) > len(first["unknown"]):
                continue
            if all(spares_those_with_one(part, _nouns_of(s.place), s.things.noun, several=s.each) for s in given):
                kept = [s for s in self.statements if s not in together]
                self.statements[:] = [*kept, *given, Mention(quote=self._quote(part, 0, len(part)))]
                return True
        self._go_back(first)
        return False

    def _asked_last(self) -> list[Statement]:
        """Return the statements of the last request."""
        asked = [statement for statement in self.statements if not isinstance(statement, Mention)]
        return [statement for statement in asked if statement.quote == asked[-1].quote]

    def _fills_gaps(self, words: Sequence[Word], first: dict[str, Any]) -> bool:
        """Count what is there already in the request before: ``add one only where it is missing``."""
        last = next((s for s in reversed(first["statements"]) if not isinstance(s, Mention)), None)
        if not fills_gaps(words) or not isinstance(last, Add | Ensure):
            return False
        together = [s for s in first["statements"] if isinstance(s, Add | Ensure) and s.quote == last.quote]
        one = "one" in {word.text for word in words}
        for said in together:
            counted = said.things.amount.kind == "some" and (said.each or isinstance(said, Ensure))
            if not counted or (one and (said.things.amount.number != 1 or len(together) > 1)):
                return False
        self._go_back(first)
        ensured = [Ensure(things=s.things, place=s.place, each=s.each, quote=s.quote) for s in together]
        kept = [s for s in self.statements if s not in together]
        self.statements[:] = [*kept, *ensured, Mention(quote=self._quote(words, 0, len(words)))]
        return True

    def _reader(self, words: Sequence[Word]) -> ClauseReader:
        return ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))

    def _so_far(self) -> dict[str, Any]:
        """Return how far the instruction is read, to come back to it."""
        return {name: list(value) if isinstance(value, list) else value for name, value in vars(self).items()}

    def _go_back(self, so_far: dict[str, Any]) -> None:
        for name, value in so_far.items():
            setattr(self, name, list(value) if isinstance(value, list) else value)


def _nouns_of(place: Place) -> frozenset[str]:
    """Return the words for what a place is at, and for its rooms."""
    told = [place.anchor.noun if place.anchor is not None else "", place.rooms.words if place.rooms is not None else ""]
    return frozenset(word for said in told for word in (said, *said.split()) if word)


def _is_thing(item: Item) -> bool:
    return item.phrase.noun.kind == "object"


def _is_bare(item: Item, at: int) -> bool:
    """Whether notes name one thing that is there, at the beginning and with its room: ``laptop in room 2 was lost``."""
    phrase = item.phrase
    rooms = any(place.place.rooms is not None for place in item.places)
    return at == 0 and rooms and len(phrase.noun.words) == phrase.end - phrase.start and not phrase.noun.plural


def _corrects(words: Sequence[Word]) -> bool:
    """Whether words put something else for what was said: ``I meant the kitchen``."""
    return any(word.raw in ("mean", "meant", "mistake", "correction") for word in words)


def _parts(words: Sequence[Word]) -> list[tuple[int, int]]:
    """Return the stretches of a sentence that may be asides, the longest first: all of it, its beginnings and ends."""
    count = len(words)
    cuts = [at for at in range(1, count) if words[at].text in _CUTS | _JOINTS]
    ends = [(at, count) for at in cuts]
    beginnings = [(0, at) for at in reversed(cuts)]
    inner = [] if len(cuts) > _MOST_CUTS else [(one, other) for one in cuts for other in reversed(cuts) if one < other]
    return [(0, count), *ends, *beginnings, *inner]


def _trimmed(words: Sequence[Word]) -> Sequence[Word]:
    """Return words without marks and joints around them."""
    start, end = 0, len(words)
    while start < end and words[start].text in _CUTS | (_JOINTS - {"as", "so"}):
        start += 1
    while end > start and words[end - 1].text in _CUTS | (_JOINTS - {"as"}):
        end -= 1
    return words[start:end]


def _own_rooms(reader: ClauseReader) -> list[Rooms]:
    """Return the rooms of the building that words name, whether or not a thing may be called so too."""
    found: list[Rooms] = []
    at = 0
    while at < len(reader.words):
        item = reader.item(at)
        if item is not None and item.end > at and reader.lexicon.is_own_room(item.phrase.noun.words):
            rooms = item.rooms()
            found += [rooms] if item.phrase.definite or rooms.words.rpartition(" ")[2].isdecimal() else []
        at = at + 1 if item is None or item.end <= at else item.end
    return found


def _rooms_within(reader: ClauseReader) -> list[Rooms]:
    """Return the rooms in which something is or happens, as words tell it: ``anything in the pantry``."""
    items = (reader.item(at) for at in range(1, len(reader.words)) if reader.text(at - 1) in ("in", "into"))
    rooms = [item.rooms() for item in items if item is not None and item.is_room and item.phrase.definite]
    return [one for at, one in enumerate(rooms) if one.words and one not in rooms[:at]]


def _go_elsewhere(words: Sequence[Word]) -> bool:
    """Whether things go somewhere: ``the two others leave for the hall``, ``the office loses the sofa``."""
    for at, word in enumerate(words[1:], start=1):
        thing = not {before.text for before in words[:at]} & (PERSONS | PEOPLE)
        if thing and word.raw in ("leave", "leaves", "lose", "loses"):
            return True
        if words[0].text in ("what", "whatever") and word.raw in ("moves", "goes", "comes", "belongs", "move", "go"):
            return True  # "what is on it moves to the hall"
    return False


def _other_than_holder(named: Sequence[Things], later: Sequence[Word]) -> Things:
    """Return the thing that ``one on each table`` is one of, after words about the tables and the candles."""
    holders = {word.text for at, word in enumerate(later) if text_at(later, at - 1) in ("each", "every", "the")}
    counted = any(word.text == "one" for word in later)
    others = [things for things in named if things.noun and not holders & {*things.noun.split()[-1:]}]
    return others[0] if counted and others and named[0].noun else named[0]


def _named(reader: ClauseReader) -> tuple[Things, ...]:
    """Return the things and rooms that words name as those that are there."""
    found: list[Things] = []
    at = 0
    while at < len(reader.words):
        item = reader.item(at)
        if item is None or item.end <= at:
            noun = reader.text(at + 1)
            if reader.text(at) == "the" and reader.lexicon.is_object((noun,)):
                found.append(Things(noun=noun, amount=Amount(kind="all", number=0), definite=True, plural=True))
            at += 1
            continue
        if item.is_room:
            found.append(everything_at(Place(rooms=item.rooms())))
        elif (item.phrase.definite or _is_bare(item, at)) and not item.phrase.refers and _is_thing(item):
            whole = Amount(kind="all", number=0)
            found.append(msgspec.structs.replace(item.things(), amount=whole, plural=True))
        at = item.end
    return tuple(found)
