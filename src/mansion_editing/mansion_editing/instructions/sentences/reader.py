"""Instructions in English to statements: sentences, their clauses in order, and what one sentence tells of another."""

import re
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Final, Literal

import msgspec

from mansion_assets.catalogue.descriptions import hypernyms_of
from mansion_editing.instructions.clauses.items import NotUnderstood, TwoReadings, joined_places
from mansion_editing.instructions.clauses.outcomes import everything_at
from mansion_editing.instructions.clauses.reader import ClauseReader, of_each_room, sparing
from mansion_editing.instructions.phrases.lexicon import HYPERNYMS
from mansion_editing.instructions.phrases.places import merged, read_place
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import PRINTED, TOPICS
from mansion_editing.instructions.phrases.words import MODALS, STATE_WORDS, UNRECORDED, Word
from mansion_editing.instructions.sentences.accounting import unaccounted
from mansion_editing.instructions.sentences.asides import Asides
from mansion_editing.instructions.sentences.background import is_background, is_told, split_sentences
from mansion_editing.instructions.sentences.clearing import with_takings_first
from mansion_editing.instructions.sentences.conditions import Condition, begins_condition, else_at
from mansion_editing.instructions.sentences.correcting import Correcting
from mansion_editing.instructions.sentences.depending import Depending
from mansion_editing.instructions.sentences.former_places import with_former_places
from mansion_editing.instructions.sentences.headings import Headings
from mansion_editing.instructions.sentences.lacking_some import LackingSome
from mansion_editing.instructions.sentences.lids import opened_as_whole
from mansion_editing.instructions.sentences.old_ones import (
    with_companions_first,
    with_last_of_them_first,
    with_old_ones_first,
)
from mansion_editing.instructions.sentences.owners import owners_named
from mansion_editing.instructions.sentences.questions import read_question
from mansion_editing.instructions.sentences.recounting import Recounting
from mansion_editing.instructions.sentences.referring import Referring
from mansion_editing.instructions.sentences.refinement import (
    adds_it,
    counted_by,
    counts_those_brought,
    exactly,
    goes_as_well,
    goes_while_others_stay,
    in_place_of,
    is_everything,
    is_only_fetched,
    is_surplus,
    left_where_brought,
    moved_on,
    moves_it,
    must_contain,
    only_brings_it,
    placed_at_last,
    removes_all_of_it,
    removes_what_went,
    sets_as_one,
    spared_of,
    sparing_what_goes,
    surplus_of,
    tells_of_surplus,
    tells_who_may_stay,
    turned_by_list,
    with_noun_at,
    with_storeys,
)
from mansion_editing.instructions.sentences.repeating import Repeating
from mansion_editing.instructions.sentences.scene_setting import SceneSetting
from mansion_editing.instructions.sentences.tails import Tails
from mansion_editing.instructions.sentences.taken_off import taken_off
from mansion_editing.instructions.sentences.telling import Telling
from mansion_editing.instructions.statements import (
    Add,
    Clear,
    Ensure,
    Finish,
    Furnish,
    Instruction,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Rename,
    Reshape,
    Rooms,
    SetState,
    Statement,
    Things,
    When,
)
from mansion_editing.state import SceneState

__all__ = ["read_instruction"]


_TOO_MANY: Final = re.compile(r"\btoo (many|much)\b", re.IGNORECASE)


def read_instruction(text: str, state: SceneState, brief: str = "") -> Instruction:
    """Read what an instruction says.

    Parameters
    ----------
    brief : str
        The building's own, which may count its storeys from the one above the ground floor.
    state : SceneState
        Gives the names of rooms and objects; nothing is looked up in it.

    Returns
    -------
    Instruction
        With the words that belong to no statement, none where it was understood whole.
    """
    return _Reader(text, state, brief).read()


class _Reader(
    Asides, LackingSome, Telling, Tails, Headings, Repeating, Referring, Depending, Correcting, SceneSetting, Recounting
):
    """Reads one instruction."""

    def read(self) -> Instruction:
        """Read all sentences in order."""
        self.words = list(with_former_places(self.words, self._reader(self.words)))
        sentences = list(split_sentences(self.words))
        for number, (own, marked) in enumerate(sentences):
            self.is_last = number + 1 == len(sentences)
            later = self.later = [] if self.is_last else sentences[number + 1][0]
            before = sentences[number - 1][0] if number else []
            whole = opened_as_whole(owners_named(own, self.lexicon), before, self.lexicon)
            sentence = self._with_listed(self._at_their_owner(whole))
            if self._gives_what_some_lack(sentence, later):
                continue
            if not self._spares_those_with_one(sentence, marked=marked):
                self._read_beside_asides(sentence, later, marked=marked)
        self.statements = [
            Mention(quote=s.quote) if self._introduces(s, self.statements[number + 1 :]) else s
            for number, s in enumerate(self.statements)
        ]
        self.statements = [s for one in self.statements for s in [self._told_later(one)]]
        self.unknown += [s.quote for s in self.statements if '"noun":"one"' in msgspec.json.encode(s).decode()]
        self.unknown += self._instead_of_nothing() + self._complained_in_vain()
        if not self.unknown:
            self.unknown = unaccounted(self.text, self.words, self.statements, self.lexicon) or self._asks_in_vain()
        if not self.unknown and all(isinstance(statement, Mention) for statement in self.statements):
            self.unknown = [self.text.strip()]
        told = msgspec.json.encode(self.statements).decode()
        topics = [word for word, following in pairwise(self.words) if word.text in TOPICS and following.text in PRINTED]
        plain = [*(word for word in self.words if word.text in UNRECORDED), *topics]
        ignored = list(dict.fromkeys(w.raw for w in plain if not re.search(rf'"noun":"[^"]*\b{w.text}\b', told)))
        ordered = with_companions_first(with_last_of_them_first(with_old_ones_first(self.statements)))
        ordered = with_takings_first(ordered, self.lexicon)
        statements = turned_by_list(with_storeys(ordered), self.text)
        statements = sets_as_one(sparing_what_goes(statements), self.lexicon)
        return Instruction(statements=statements, not_understood=self.unknown, ignored=ignored)

    def _introduces(self, statement: Statement, later: Sequence[Statement]) -> bool:
        """Whether things of a general name are told one by one later: ``something to eat with: two forks``."""
        if not isinstance(statement, Add | Ensure) or statement.things.noun not in HYPERNYMS:
            return False
        return any(
            isinstance(other, Add | Ensure)
            and other.things.noun not in HYPERNYMS
            and statement.things.noun in hypernyms_of(other.things.noun.replace(" ", "_"))
            for other in later
        )

    def _instead_of_nothing(self) -> list[str]:
        """Return what shall come ``instead`` of what was only told of: whether that goes is not said."""
        asked = [(at, s) for at, s in enumerate(self.statements) if not isinstance(s, Mention | Keep)]
        for at, statement in asked:
            told = at > 0 and isinstance(self.statements[at - 1], Mention)
            after = self.text.partition(statement.quote)[2]
            if told and isinstance(statement, Add | Ensure) and re.match(r"\W*instead\b(?! of)", after):
                return [statement.quote]
        return []

    def _complained_in_vain(self) -> list[str]:
        """Return what was said to be too many where nothing is asked of such things: which of them go is not told."""
        asked = msgspec.json.encode([s for s in self.statements if not isinstance(s, Mention)]).decode()
        return [quote for quote, noun in self.complaints if f'"noun":"{noun}"' not in asked]

    def _asks_in_vain(self) -> list[str]:
        """Return the last clause with a verb where it was only taken to begin what no other clause goes on with."""
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        after = self.statements if last is None else self.statements[self.statements.index(last) + 1 :]
        verbs = [s.quote for s in after if isinstance(s, Mention) and self._begins_with_order(s.quote)]
        return verbs[:1] or self._takes_in_vain()

    def _takes_in_vain(self) -> list[str]:
        """Return the first clause that only took something, of which the next one says nothing."""
        for number, statement in enumerate(self.statements):
            if not isinstance(statement, Mention) or not self._begins_with_order(statement.quote, ("take", "bring")):
                continue
            following = next((s for s in self.statements[number + 1 :] if not isinstance(s, Mention)), statement)
            said = msgspec.json.encode(following).decode()
            words = {word.text for word in self._words_of(statement.quote)}
            taken = [word for word in words if self.lexicon.is_object((word,)) and not self.lexicon.is_room((word,))]
            referring = words & {"it", "them", "both", "those", "these", "that"} or '"refers":"last"' in said
            if taken and not referring and not any(word in said for word in taken):
                return [statement.quote]
        return []

    def _told_later(self, statement: Statement) -> Statement:
        """Return a statement with the places of things that a sentence before it told."""
        for noun, place in self.told:
            statement = with_noun_at(statement, noun, place)
        return statement

    def _read_sentence(self, words: Sequence[Word], *, marked: bool) -> None:
        reader = ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))
        self.frames = ()
        reader.last_noun = self.last_noun
        first = len(self.statements)
        if words[0].text in ("otherwise", "else") and self.statements and isinstance(self.statements[-1], When):
            self._read_otherwise(words[1 + (reader.text(1) == ",") :], first - 1)
            return
        joint = else_at(words)
        self._read_words(
            reader if not joint else reader.until(joint[0]), words[: joint[0]] if joint else words, marked=marked
        )
        if joint:
            self._read_otherwise(words[joint[1] :], first)
        self.last_noun = reader.last_noun

    def _read_words(self, reader: ClauseReader, words: Sequence[Word], *, marked: bool) -> None:
        at = self._begin(reader, words)
        if at >= len(words):
            return
        told = 0 if marked else self._tells_numbers(reader, at) or self._sets_scene(reader, at)
        if told:
            at = reader.skip(told)
        elif self._tells_of_use(reader, at) or self._reads_scope(reader, at) or self._tells_of_person(reader, at):
            return
        conditional = begins_condition(words, at) and not marked
        if (
            not conditional
            and (marked or not reader.tells_what_stays(at))
            and self._reads_question(reader, words, at, marked=marked)
        ):
            return
        label, at = at, self._read_label(reader, words, at)
        if at > label and reader.frame == Place() and self._reads_question(reader, words, at, marked=marked):
            return
        at = self._read_heading(reader, words, at)
        at = self._read_exception(reader, at)
        at = self._read_frame(reader, at)
        self._keep_heading(reader, words, at)
        if self._repeats(reader, words, at):
            return
        if self._reads_state_of_topic(words, at):
            return
        while at < len(words):
            at = self._corrected(reader, words, at) or at
            at = self._end_of_ability(words, at) or self._end_of_present_number(words, at) or reader.skip(at)
            if at >= len(words):
                return
            if words[at].text == "otherwise":
                self._read_consequence(words, at)
                return
            at = self._read_later_frame(reader, at)
            at, condition = self._read_condition(reader, words, at)
            first = len(self.statements)
            if condition is not None:
                at = self._read_clause(reader, words, reader.skip(at)) if at < len(words) else at
                self._depend(condition, first, self._quote(words, 0, at))
                continue
            end = self._end_of_reason(reader, at)
            if end > at:
                self.statements.append(Mention(quote=self._quote(words, at, end)))
                at = end
                continue
            start = at
            at = self._goes_to_rest(reader, at) or self._read_clause(reader, words, at)
            if reader.text(at) == ":":
                self._tidied_before(reader, start)

    def _read_later_frame(self, reader: ClauseReader, at: int) -> int:
        """Read a room that a later clause begins with: ``leave the hall, but in the kitchen remove the mugs``."""
        if (
            at == 0
            or reader.text(at - 1) not in ("and", "but", "while", ",")
            or reader.text(at) not in ("in", "upstairs")
        ):
            return at
        places, end = reader.places(at)
        place = joined_places(places)[0] if places else Place()
        after = end + (reader.text(end) == ",")
        told = place.rooms is not None and place == Place(rooms=place.rooms) and not any(p.source for p in places)
        if not told or verb_at(reader.words, after, self.lexicon) is None:
            return at
        reader.frame = place
        return after

    def _tidied_before(self, reader: ClauseReader, start: int) -> None:
        """Let ``tidy the office:`` tell where all of it is that comes after the colon."""
        verb = verb_at(reader.words, start, self.lexicon)
        last = self.statements[-1] if self.statements else None
        told = isinstance(last, Mention) and last.rooms is not None and reader.frame == Place()
        if told and verb is not None and verb[0] == "tidy" and isinstance(last, Mention):
            reader.frame = Place(rooms=last.rooms)

    def _begin(self, reader: ClauseReader, words: Sequence[Word]) -> int:
        """Return the place after what a sentence only begins with: ``no, wait``, ``from now on``."""
        at = self._corrected(reader, words, 0) or reader.skip(0)
        if reader.text(at) in ("no", "nope") and (reader.text(at + 1) in (",", "wait", "-") or at + 1 >= len(words)):
            at = reader.skip(at + 1 + (reader.text(at + 1) == "wait"))
        if tuple(w.text for w in words[at : at + 3]) == ("from", "now", "on"):
            at = reader.skip(at + 3)
            at = self._end_of_new_name(reader, at) or at
        return at

    def _end_of_new_name(self, reader: ClauseReader, at: int) -> int:
        """Read ``the room called Office is "Studio"`` after ``from now on``; return its end, 0 for others."""
        called = reader.text(at + 1) == "room" and reader.text(at + 2) in ("called", "named")
        room = reader.item(at + 3 if called else at)
        if room is None or not room.is_room or reader.text(room.end) != "is" or reader.text(room.end + 1) != '"':
            return 0
        name, end = reader.name_at(room.end + 2)
        self.statements.append(Rename(room=room.rooms(), name=name, quote=self._quote(reader.words, at, end)))
        return end

    def _read_consequence(self, words: Sequence[Word], at: int) -> None:
        """Read ``otherwise the milk gets warm`` after a request, which says why; an order would need a condition."""
        quote = self._quote(words, at, len(words))
        if verb_at(words, at + 1, self.lexicon) is not None:
            self.unknown.append(quote)
        else:
            self.statements.append(Mention(quote=quote))

    def _read_otherwise(self, words: Sequence[Word], first: int) -> None:
        """Read what is to be done where the condition before does not hold."""
        last = next((s for s in reversed(self.statements[first:]) if isinstance(s, When)), None)
        if last is None:
            self.unknown.append(self._quote(words, 0, len(words)))
            return
        condition = Condition(last.ask, not last.holds)
        self.topic = self._topic_where(condition)
        start = len(self.statements)
        self._read_sentence(words, marked=False)
        self._depend(condition, start, self._quote(words, 0, len(words)))

    def _reads_state_of_topic(self, words: Sequence[Word], at: int) -> bool:
        """Read ``off`` after ``The table lamp in the dining area:``."""
        if self.topic is None or at + 1 != len(words) or words[at].text not in STATE_WORDS or words[at - 1].text != ":":
            return False
        name, value = STATE_WORDS[words[at].text]
        state: Literal["open", "on"] = "open" if name == "open" else "on"
        quote = self._quote(words, 0, len(words))
        self.statements[-1:] = [SetState(things=self.topic, state=state, value=value, quote=quote)]
        return True

    def _read_exception(self, reader: ClauseReader, at: int) -> int:
        """Read ``Apart from the vase, ...``, an exception to what comes next."""
        end, things = reader.exceptions(at)
        if not things or reader.text(end) != ",":
            return at
        self.spared, self.exception = things, self._quote(reader.words, at, end)
        return end + 1

    def _read_clause(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        same = self._same_of_others(reader, words, at)
        if same is not None:
            return same
        recounted = self._recounted(reader, words, at)
        if recounted:
            return recounted
        last = self.statements[-1] if self.statements else None
        if isinstance(last, Furnish) and must_contain(reader, at):
            try:
                contents, end = reader.contained(at + 2)
            except NotUnderstood:
                contents, end = [], at
            if contents and (end >= len(words) or words[end].kind == "mark"):
                self._take(contents)
                return end
        reader.follows = isinstance(last, Add | Ensure | Move)
        try:
            found, end = reader.read(at)
            affirmed = reader.taken_affirmed()
            if affirmed is not None and not (self.is_last and reader.skip(end) >= len(words)):
                reader.topic = msgspec.structs.replace(affirmed, definite=True)
                found = [Mention(quote=self._quote(words, at, end))]
            for other in self.frames:
                first, reader.frame = reader.frame, other
                found = [*found, *reader.read(at)[0]]
                reader.frame = first
        except NotUnderstood as fault:
            stop = max(fault.end, at + 1)
            if isinstance(fault, TwoReadings):
                self.undecided = True
                self.unknown.append(f"which things belong to which part of: {self._quote(words, at, stop)}")
                return stop
            more = self._more_of_the_same(reader, words, at)
            if more is not None:
                return more
            told = self._told_of_thing(reader, at)
            if (told and reader.skip(told) < len(words)) or (told and not self.is_last):
                self.statements.append(Mention(quote=self._quote(words, at, told)))
                return told
            only_told = verb_at(words, at, self.lexicon) is None and is_told(words[at:stop], self._is_named)
            if only_told or is_background(words[at:stop]) or self._is_label(words, at, stop):
                rooms = self._take_up_what_is_told(words[at:stop])
                self.statements.append(Mention(rooms=rooms, quote=self._quote(words, at, stop)))
            else:
                start = min(fault.start, at) if fault.start < len(words) else at
                self.unknown.append(self._quote(words, start, stop))
            return stop
        found, end = in_place_of(reader, found, end)
        self._name_ones(reader, found)
        topic, reader.topic = reader.topic, None
        if topic is not None and isinstance(found[0], Mention) and _TOO_MANY.search(found[0].quote):
            self.complaints.append((found[0].quote, topic.noun))
        found = [self._referred(one) for statement in found for one in self._of_scene(statement)]
        found = [self._in_scene(statement) for statement in found]
        if topic is not None or any(not isinstance(statement, Mention) for statement in found):
            self.topic = topic
        self.clause = [of_each_room(statement) for statement in found]
        end, exact = self._read_tail(reader, words, end)
        found = self.clause
        self._take([exactly(statement) for statement in found] if exact else found)
        return end

    def _name_ones(self, reader: ClauseReader, found: Sequence[Statement]) -> None:
        """Let ``a second one`` after a wish mean what was wished for."""
        wished = next((s.things.noun for s in found if isinstance(s, Add | Ensure) and s.things.noun), "")
        if wished and reader.last_noun is None:
            reader.last_noun = reader.phrase_of(wished)

    def _take(self, found: Iterable[Statement]) -> None:
        """Add statements; what stays is an exception of what is cleared or removed just before."""
        for statement in found:
            last = self.statements[-1] if self.statements else None
            statement = self._but_for_those_spared(statement)
            if isinstance(statement, Keep):
                statement = left_where_brought(statement, last) or self._of_the_kind(statement)
            if isinstance(statement, SetState | Remove | Paint | Move):
                statement = self._those_elsewhere(statement)
            if isinstance(statement, Remove):
                statement, self.statements[:] = taken_off(statement, self.statements, self._reader_of)
                last = self.statements[-1] if self.statements else None
            if _says_again(statement, last):
                continue
            if isinstance(statement, Rename) and statement.room == Rooms(same=True):
                self._rename_it(statement, last)
                continue
            if isinstance(statement, Remove) and isinstance(last, Add | Ensure | Move) and last.things.noun:
                statement = _one_of_its_kind(statement, last.things)
            readers = (self._extends, self._spares, self._moves_on, self._tells_of_rest)
            if not any(reads(statement, last) for reads in readers):
                self.statements += self._room_and_thing(statement)

    def _but_for_those_spared(self, statement: Statement) -> Statement:
        """Return what is done with all but the exception that the sentence began with."""
        if not self.spared or isinstance(statement, Mention):
            return statement
        spared, self.spared = self.spared, ()
        if isinstance(statement, Clear):
            return msgspec.structs.replace(statement, spare=(*statement.spare, *spared))
        whole = isinstance(statement, SetState | Remove | Paint | Move) and (
            statement.things.amount.kind == "all" or statement.things.plural
        )
        if isinstance(statement, SetState | Remove | Paint | Move) and whole:
            return sparing(statement, spared)
        if not self.exception.lower().startswith("not"):  # "not the floor lamp, the table lamp should be on"
            self.unknown.append(f"{self.exception} ({statement.quote})")
        return statement

    def _rename_it(self, statement: Rename, last: Statement | None) -> None:
        """Rename the room of the statement before; after a colon, the name is all that becomes of it."""
        if not isinstance(last, Furnish | Finish | Reshape | Mention) or last.rooms is None:
            self.unknown.append(statement.quote)
            return
        between = self._from_to(last, statement)[len(last.quote) : -len(statement.quote)]
        if isinstance(last, Furnish) and last.kind == statement.name.lower() and between.strip() == ":":
            statement = msgspec.structs.replace(statement, quote=self._from_to(last, statement))
            self.statements.pop()
        self.statements.append(msgspec.structs.replace(statement, room=last.rooms))

    def _room_and_thing(self, statement: Statement) -> list[Statement]:
        """Return what shall be left alone as the thing and the room that are called so: the bar, the kennel."""
        if not isinstance(statement, Keep) or statement.things.place is not None or statement.things.refers:
            return [statement]
        noun = tuple(statement.things.noun.split())
        if not noun or statement.things.plural or not self.lexicon.is_own_room(noun):
            return [statement]
        room = Place(rooms=Rooms(words=statement.things.noun))
        whole = Keep(things=everything_at(room), quote=statement.quote)
        return [statement, whole] if self.lexicon.is_here(statement.things.noun) else [whole]

    def _reader_of(self, quote: str) -> ClauseReader:
        return self._reader(self._words_of(quote))

    def _extends(self, statement: Statement, last: Statement | None) -> bool:
        """Read more of what the last statement clears or brings; return whether that is all."""
        if isinstance(last, Clear) and isinstance(statement, Clear) and _is_of_it(statement, last):
            self.statements[-1] = msgspec.structs.replace(last, spare=(*last.spare, *statement.spare))
            return True
        if isinstance(last, Add | Ensure) and isinstance(statement, Ensure) and counts_those_brought(statement, last):
            self.statements[-1] = counted_by(last, statement, self._from_to(last, statement))
            return True
        return False

    def _spares(self, statement: Statement, last: Statement | None) -> bool:
        """Read what stays of what the last statement clears or removes; return whether it does."""
        if isinstance(statement, Keep) and is_everything(statement.things):
            return False
        spared = spared_of(statement) if isinstance(last, Clear) else ()
        if isinstance(last, Clear) and spared:
            self.statements[-1] = msgspec.structs.replace(last, spare=(*last.spare, *spared))
            return True
        if tells_who_may_stay(statement):
            self.unknown.append(statement.quote)  # it is not told where
            return True
        if not isinstance(statement, Keep):
            return False
        alone = not isinstance(last, Clear | Remove) and not statement.things.place
        if alone and re.match(r"(keep|leave) (only|just)\b", statement.quote.lower()):
            self.unknown.append(statement.quote)  # it is not told what all else is
            return True
        only = re.search(r"\b(only|just|nothing but)\b", statement.quote)
        if isinstance(last, Remove) and last.things.noun and only and not self._removed_together()[2:]:
            self.unknown.append(statement.quote)  # more than what was named would have to go
            return True
        if isinstance(last, Remove) and last.things.amount.kind == "all":
            but = msgspec.structs.replace(last.things, beside=(*last.things.beside, statement.things))
            self.statements[-1] = msgspec.structs.replace(last, things=but)
            return True
        return False

    def _moves_on(self, statement: Statement, last: Statement | None) -> bool:
        """Read where what the last statement removes or moves goes; return whether it does."""
        if not isinstance(statement, Move):
            return False
        together = [s for s in self.statements if isinstance(s, Move) and last is not None and s.quote == last.quote]
        onward = moved_on(together, statement) if isinstance(last, Move) else None
        listed = self._removed_together()
        brought = placed_at_last(self.statements, statement)
        if brought:
            quote = self._from_to(brought[0], statement)
            self.statements[-len(brought) :] = [msgspec.structs.replace(new, quote=quote) for new in brought]
        elif onward is not None:
            quote = self._from_to(together[0], statement)
            self.statements[-len(together) :] = [msgspec.structs.replace(move, quote=quote) for move in onward]
        elif len(listed) > 1 and moves_it(statement) and statement.things.plural:
            quote = self._from_to(listed[0], statement)
            moved_all = [Move(things=gone.things, place=statement.place, quote=quote) for gone in listed]
            self.statements[-len(listed) :] = moved_all
        elif (isinstance(last, Remove) or is_only_fetched(last)) and last.things.noun and moves_it(statement):
            moved = Move(things=last.things, place=statement.place, quote=self._from_to(last, statement))
            if re.search(r"\bnot\b|n't\b", last.quote):  # "we do not need it here: take it to the hall"
                moved = msgspec.structs.replace(moved, quote=statement.quote)
                self.statements[-1:] = [Mention(quote=last.quote), moved]
            else:
                self.statements[-1] = moved
        else:
            return False
        return True

    def _tells_of_rest(self, statement: Statement, last: Statement | None) -> bool:
        """Read what becomes of those beyond the number that shall be; return whether that is said."""
        if isinstance(last, Ensure) and isinstance(statement, Move | Remove) and is_surplus(statement, last):
            rest = surplus_of(last, statement.things)
            self.statements[-1] = msgspec.structs.replace(statement, things=rest)
            return True
        shared = goes_while_others_stay(statement, last)
        if shared is not None:
            self.statements[-1] = shared
            return True
        if goes_as_well(statement, last):
            self.unknown.append(statement.quote)  # another one, or the same one further on
            return True
        if tells_of_surplus(statement):
            self.undecided = True
            self.unknown.append(statement.quote)  # it is not told how many shall be there
            return True
        if isinstance(last, Ensure) and isinstance(statement, Remove) and statement.things.refers == "others":
            self.statements[-1] = msgspec.structs.replace(exactly(last), quote=self._from_to(last, statement))
            return True
        return False

    def _removed_together(self) -> list[Remove]:
        """Return the removals of several things that the last clause asked for."""
        last = self.statements[-1] if self.statements else None
        if not isinstance(last, Remove):
            return []
        return [s for s in self.statements if isinstance(s, Remove) and s.quote == last.quote and s.things.noun]

    def _of_the_kind(self, keep: Keep) -> Keep:
        """Return ``those in the corridor`` as things of the kind that was mentioned before."""
        things = keep.things
        before = next((getattr(s, "things", None) for s in reversed(self.statements) if hasattr(s, "things")), None)
        bare = things.noun == "one" or (things.refers == "last" and not things.noun)
        last = self.statements[-1] if self.statements else None
        if bare and things.place is None and isinstance(last, Move) and last.place.rooms is not None:
            things = msgspec.structs.replace(things, place=Place(rooms=last.place.rooms))  # "the one already up there"
        if not bare or things.place is None or not isinstance(before, Things) or not before.noun:
            return keep
        named = msgspec.structs.replace(things, noun=before.noun, refers="", definite=True, plural=True)
        return msgspec.structs.replace(keep, things=named)

    def _those_elsewhere(self, statement: SetState | Remove | Paint | Move) -> SetState | Remove | Paint | Move:
        """Return ``those in the study`` as things of the kind that was named before: ``the lights here off, ...``."""
        things = statement.things
        rooms = None if things.place is None else things.place.rooms
        bare = things.refers == "last" and not things.noun and things.plural and not things.amount.number
        if not bare or rooms is None or not rooms.words or not re.search(r"\bthose\b", statement.quote.lower()):
            return statement
        told = (getattr(before, "things", None) for before in reversed(self.statements))
        noun = next((before.noun for before in told if isinstance(before, Things) and before.noun), "")
        named = things if not noun else msgspec.structs.replace(things, noun=noun, refers="")
        return msgspec.structs.replace(statement, things=named)

    def _reads_question(self, reader: ClauseReader, words: Sequence[Word], at: int, *, marked: bool) -> bool:
        try:
            found = read_question(reader, words, at, marked=marked)
        except NotUnderstood as fault:
            if words[at].text in MODALS:
                return False  # "could the black chairs be white ones?"
            self.unknown.append(self._quote(words, at, max(fault.end, len(words))))
            return True
        if found is None:
            return False
        ask, end = found
        self.statements.append(ask)
        end = reader.skip(end)
        if end < len(words):
            if words[end].text in ("and", "or") or words[end - 1].text in (",", "and"):
                more = read_question(reader, words, end, marked=marked)
                if more is not None and more[1] > end:
                    self.statements.append(more[0])
                    end = reader.skip(more[1])
            if end < len(words) and reader.starts_clause(end):
                self.topic = self._asked_for(ask)
                while end < len(words):
                    end = reader.skip(self._read_clause(reader, words, end))
            elif end < len(words):
                self.unknown.append(self._quote(words, end, len(words)))
        return True

    def _read_frame(self, reader: ClauseReader, at: int) -> int:
        """Read a place that the sentence begins with, up to its comma or the clause."""
        label = read_storeys(reader.words, at, self.floors)
        if label is not None and label[2] < len(reader.words) and reader.text(label[2]) in (":", "-"):
            reader.frame = Place(rooms=Rooms(floors=label[0]))
            return label[2] + 1
        room = reader.item(at, places=False)
        if room is not None and room.phrase.noun.kind in ("room", "both"):
            places, end = reader.places(room.end)
            end = self._end_of_occasion(reader, end)
            if reader.text(end) in (":", "-") and self.lexicon.is_own_room(room.phrase.noun.words):
                rooms = room.phrase.rooms()
                for read in places:
                    rooms = merged(Place(rooms=rooms), read.place).rooms or rooms
                reader.frame = Place(rooms=rooms)
                return end + 1
        first = read_place(reader.words, at, self.lexicon, self.floors)
        if reader.text(at) == "of":  # "instead of the lamp put a vase"
            return at
        if first is None or reader.text(at + 1) in ("most", "least"):  # "at most one" is an amount
            return at
        places, end = reader.places(at)
        more = read_place(reader.words, end + 1, self.lexicon, self.floors) if reader.text(end) == "and" else None
        if more is not None and more.place.rooms is not None and reader.starts_clause(reader.skip(more.end)):
            self.frames = (more.place,)
            end = more.end
        comma = reader.text(end) in (",", ":", "-")
        after = reader.skip(end)
        begins = reader.starts_clause(after) or reader.text(after) == "there" or reader.phrase(after) is not None
        if not (comma or begins) or after >= len(reader.words):
            return at
        place = Place()
        for read in places:
            place = read.place if place == Place() else merged(place, read.place)
        reader.frame = place
        return after if not comma else end + 1


def _one_of_its_kind(statement: Remove, named: Things) -> Remove:
    """Return ``one in the hall`` as one of the kind that was just named: ``two benches here, one in the hall goes``."""
    things = statement.things
    bare = things.refers == "last" and not things.noun and not things.definite and not things.amount.of
    elsewhere = things.place is not None and things.place.rooms is not None and bool(things.place.rooms.words)
    if not bare or not elsewhere or things.amount.kind != "some" or not things.amount.number:
        return statement
    return msgspec.structs.replace(statement, things=msgspec.structs.replace(things, noun=named.noun, refers=""))


def _says_again(statement: Statement, last: Statement | None) -> bool:
    """Whether a statement only says once more what the last one asks for: ``add a door and put it in``."""
    if isinstance(last, Clear):
        return removes_all_of_it(statement)
    if isinstance(last, Reshape):
        return last.what == "door" and adds_it(statement)
    if isinstance(last, Remove):
        return removes_what_went(statement)
    return isinstance(last, Add | Ensure | Move) and isinstance(statement, Move) and only_brings_it(statement)


def _is_of_it(statement: Clear, last: Clear) -> bool:
    """Whether a clearing only tells what stays of the one before: ``clear the desk, keep only the lamp on it``."""
    return _is_at_it(statement.place) and bool(statement.spare) and last.place.anchor is not None


def _is_at_it(place: Place) -> bool:
    return place.anchor is not None and place.anchor.refers == "last" and not place.anchor.noun
