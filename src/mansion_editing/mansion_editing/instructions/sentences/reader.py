"""Instructions in English to statements: sentences, their clauses in order, and what one sentence tells of another."""

import re
from collections.abc import Sequence
from itertools import pairwise
from typing import Final, Literal, TypeGuard

import msgspec

from mansion_assets.catalogue.descriptions import hypernyms_of
from mansion_editing.instructions.clauses.items import NotUnderstood, TwoReadings, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader, of_each_room
from mansion_editing.instructions.phrases.lexicon import HYPERNYMS
from mansion_editing.instructions.phrases.nouns import SIZE_HINTS, is_comparative
from mansion_editing.instructions.phrases.places import merged, read_place
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import PRINTED, TOPICS
from mansion_editing.instructions.phrases.words import MODALS, STATE_WORDS, UNRECORDED, Word
from mansion_editing.instructions.sentences.accounting import (
    brought_after_moving,
    brought_beside_empty,
    laid_on_seats,
    unaccounted,
)
from mansion_editing.instructions.sentences.antecedents import (
    about_its_room,
    brought_together,
    owners_named,
    painted_rooms,
    with_former_places,
    with_states_of_each,
    with_those_taken,
)
from mansion_editing.instructions.sentences.asides import Asides
from mansion_editing.instructions.sentences.background import is_background, is_told, split_sentences
from mansion_editing.instructions.sentences.clearing import with_takings_first
from mansion_editing.instructions.sentences.conditions import Condition, Depending, begins_condition, else_at
from mansion_editing.instructions.sentences.correcting import Correcting
from mansion_editing.instructions.sentences.gathering import Gathering
from mansion_editing.instructions.sentences.headings import Headings
from mansion_editing.instructions.sentences.lacking import LackingSome
from mansion_editing.instructions.sentences.lids import opened_as_whole
from mansion_editing.instructions.sentences.old_ones import (
    with_companions_first,
    with_former_ones_first,
    with_last_of_them_first,
    with_old_ones_first,
    with_replacements,
)
from mansion_editing.instructions.sentences.questions import further_question, read_question
from mansion_editing.instructions.sentences.recounting import Recounting
from mansion_editing.instructions.sentences.referring import Referring
from mansion_editing.instructions.sentences.refinement import (
    exactly,
    in_place_of,
    must_contain,
    of_none,
    on_each_side,
    one_more_there,
    only_so_many_stay,
    sets_as_one,
    sharing_as_told,
    sparing_what_goes,
    turned_by_list,
    with_noun_at,
    with_storeys,
)
from mansion_editing.instructions.sentences.repeating import Repeating
from mansion_editing.instructions.sentences.scene_setting import SceneSetting
from mansion_editing.instructions.sentences.telling import Telling
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Furnish,
    Instruction,
    Keep,
    Mention,
    Move,
    Place,
    Rename,
    Rooms,
    SetState,
    Statement,
    When,
)
from mansion_editing.state import SceneState

__all__ = ["read_instruction"]


_MISSING: Final = re.compile(r"\b(too few|short)\b", re.IGNORECASE)
_FOR_ALL: Final = re.compile(r"for (everybody|everyone)\b", re.IGNORECASE)
"""A share for each person: how many that are is not told."""
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
    Asides,
    LackingSome,
    Telling,
    Gathering,
    Headings,
    Repeating,
    Referring,
    Depending,
    Correcting,
    SceneSetting,
    Recounting,
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
        self.statements = [of_none(self._told_later(one)) for one in self.statements]
        self.statements = [one_more_there(s, self.statements[:number]) for number, s in enumerate(self.statements)]
        self.unknown += [s.quote for s in self.statements if '"noun":"one"' in msgspec.json.encode(s).decode()]
        self.unknown += self._instead_of_nothing() + self._complained_in_vain()
        self.unknown += laid_on_seats(self.statements) + brought_after_moving(self.statements)
        self.unknown += brought_beside_empty(self.statements, self.lexicon)
        self.unknown += [s.quote for s in self.statements if isinstance(s, Mention) and _FOR_ALL.match(s.quote)]
        if not self.unknown:
            self.unknown = unaccounted(self.text, self.words, self.statements, self.lexicon) or self._asks_in_vain()
        self.statements += self._told_to_be_missing()
        if not self.unknown and all(isinstance(statement, Mention) for statement in self.statements):
            self.unknown = [self.text.strip()]
        told = msgspec.json.encode(self.statements).decode()
        topics = [word for word, following in pairwise(self.words) if word.text in TOPICS and following.text in PRINTED]
        plain = [*(word for word in self.words if word.text in UNRECORDED), *topics]
        compared = [w for w in plain if is_comparative(SIZE_HINTS.get(w.text, "")) and '"type":"Replace"' in told]
        plain = [w for w in plain if w not in compared]
        ignored = list(dict.fromkeys(w.raw for w in plain if not re.search(rf'"noun":"[^"]*\b{w.text}\b', told)))
        chosen = with_states_of_each(brought_together(with_those_taken(self.statements)))
        ordered = with_old_ones_first(with_replacements(with_former_ones_first(chosen)))
        ordered = with_companions_first(with_last_of_them_first(ordered))
        ordered = with_takings_first(ordered, self.lexicon)
        statements = turned_by_list(with_storeys(ordered), self.text)
        statements = sets_as_one(sparing_what_goes(painted_rooms(statements)), self.lexicon)
        statements = [
            about_its_room(s, self._words_of(s.quote), self.lexicon, self.floors) if self._tells(s) else s
            for s in statements
        ]
        statements = [side for one in only_so_many_stay(sharing_as_told(statements)) for side in on_each_side(one)]
        return Instruction(
            statements=statements, not_understood=self.unknown, ignored=ignored, undecided=self.undecided
        )

    def _told_to_be_missing(self) -> list[Statement]:
        """Return what is told to be missing somewhere as new there, where nothing else is asked."""
        topic = self.topic
        told = bool(self.statements) and all(isinstance(statement, Mention) for statement in self.statements)
        missing = topic is not None and topic.amount.kind == "more" and topic.place is not None
        if topic is None or topic.place is None or not (told and missing) or not _MISSING.search(self.text):
            return []
        things = msgspec.structs.replace(topic, place=None)
        return [Add(things=things, place=topic.place, quote=self.statements[-1].quote)]

    def _tells(self, statement: Statement) -> TypeGuard[Mention]:
        """Whether a statement only tells something, in words that do not begin as a request does."""
        if not isinstance(statement, Mention):
            return False
        first = next(iter(self._words_of(statement.quote)), None)
        return first is not None and first.text not in ("go", "come") and not self._begins_with_order(statement.quote)

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
            if isinstance(following, Keep) and statement.quote.lower().split()[-1] in ("out", "away", "off"):
                return [statement.quote]
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
        if not words:
            return
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
            start, told = at, len(self.statements)
            at = self._goes_to_rest(reader, at) or self._read_clause(reader, words, at)
            if reader.text(at) == ":":
                self._tidied_before(reader, start)
                self._told_before(reader, told, reader.skip(at))

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

    def _told_before(self, reader: ClauseReader, first: int, at: int) -> None:
        """Let ``the hall gets new chairs: replace the armchairs`` ask for no more than the order after the colon."""
        told = self.statements[first:]
        if verb_at(reader.words, at, self.lexicon) is None or not told:
            return
        after = [word.text for word in reader.words[at:]]
        for statement in told:
            head = statement.things.noun.split()[-1:] if isinstance(statement, Add | Ensure) else []
            if not head or not any(text.endswith(head[0]) for text in after):
                return
        if not {"it", "them", "they", "these", "those", "both"} & {*after}:
            self.statements[first:] = [Mention(quote=told[0].quote)]
            if reader.frame == Place() and isinstance(told[0], Add | Ensure) and told[0].place.anchor is None:
                reader.frame = Place(rooms=told[0].place.rooms)

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
        stop = self._contained(reader, words, at) or self._forgotten(reader, words, at)
        if stop:
            return stop
        reader.follows = bool(self.statements) and isinstance(self.statements[-1], Add | Ensure | Move)
        try:
            found, end = self._clause_at(reader, words, at)
        except NotUnderstood as fault:
            return self._read_otherwise_told(reader, words, at, fault)
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
        self._take([exactly(statement) for statement in self.clause] if exact else self.clause)
        return end

    def _forgotten(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read ``actually, forget the bowl``, which takes back what was asked for before; return its end, else 0."""
        while reader.text(at) in ("actually", ",", "no", "wait"):
            at += 1
        item = reader.item(at + 1 + (reader.text(at + 1) == "about")) if reader.text(at) == "forget" else None
        if item is None or not item.phrase.definite or item.is_room or reader.skip(item.end) < len(words):
            return 0
        noun = " ".join(item.phrase.noun.words)
        asked = [s for s in self.statements if isinstance(s, Add | Ensure | Move) and s.things.noun == noun]
        if len(asked) != 1 or not noun:
            return 0
        whole = asked[0].quote
        kept = re.sub(r"[,\s]*(and)?\s*(an?|the|\d+|\w+)?\s*$", "", whole[: whole.lower().rfind(noun.split()[-1])])
        if any(s.quote == whole and isinstance(s, Mention) for s in self.statements) or not kept:
            return 0
        left = [s for s in self.statements if s is not asked[0]]
        self.statements[:] = [msgspec.structs.replace(s, quote=kept) if s.quote == whole else s for s in left]
        self.statements.append(Mention(quote=self._quote(words, at, item.end)))
        return item.end

    def _contained(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read ``it must contain a piano`` of a room that was furnished just before; return its end, 0 for others."""
        last = self.statements[-1] if self.statements else None
        if not isinstance(last, Furnish) or not must_contain(reader, at):
            return 0
        try:
            contents, end = reader.contained(at + 2)
        except NotUnderstood:
            return 0
        if not contents or not (end >= len(words) or words[end].kind == "mark"):
            return 0
        self._take(contents)
        return end

    def _clause_at(self, reader: ClauseReader, words: Sequence[Word], at: int) -> tuple[list[Statement], int]:
        """Read a clause in each of the places that its sentence began with; what is only affirmed asks for nothing.

        Raises
        ------
        NotUnderstood
        """
        found, end = reader.read(at)
        affirmed = reader.taken_affirmed()
        if affirmed is not None and not (self.is_last and reader.skip(end) >= len(words)):
            reader.topic = msgspec.structs.replace(affirmed, definite=True)
            found = [Mention(quote=self._quote(words, at, end))]
        for other in self.frames:
            first, reader.frame = reader.frame, other
            found = [*found, *reader.read(at)[0]]
            reader.frame = first
        return found, end

    def _read_otherwise_told(self, reader: ClauseReader, words: Sequence[Word], at: int, fault: NotUnderstood) -> int:
        """Read words that make no clause as more of the last one or as what is only told; return their end."""
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

    def _name_ones(self, reader: ClauseReader, found: Sequence[Statement]) -> None:
        """Let ``a second one`` after a wish mean what was wished for."""
        wished = next((s.things.noun for s in found if isinstance(s, Add | Ensure) and s.things.noun), "")
        if wished and reader.last_noun is None:
            reader.last_noun = reader.phrase_of(wished)

    def _reads_question(self, reader: ClauseReader, words: Sequence[Word], at: int, *, marked: bool) -> bool:
        try:
            found = read_question(reader, words, at, marked=marked)
            more = None if found is None else further_question(reader, found, marked=marked)
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
            if more is not None:
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
        end += reader.text(end) == "only" and reader.text(end + 1) == ","  # "in the kitchen only, ..."
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
