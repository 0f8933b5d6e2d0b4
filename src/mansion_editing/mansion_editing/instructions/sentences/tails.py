"""What may follow a clause in its sentence: courtesies, limits of its number, conditions, what is not meant."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import NotUnderstood, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader, sparing
from mansion_editing.instructions.phrases.loads import end_of_load
from mansion_editing.instructions.phrases.places import read_place, with_place
from mansion_editing.instructions.phrases.word_sets import (
    AFTER_CLAUSES,
    BESIDE_RELATIONS,
    EVENTS,
    JOINING,
    PEOPLE,
    RELATIVES,
)
from mansion_editing.instructions.phrases.words import (
    COURTESIES,
    DETERMINERS,
    MODALS,
    PERSONS,
    PREPOSITIONS,
    STATE_WORDS,
    Word,
    next_mark,
    text_at,
)
from mansion_editing.instructions.sentences.background import end_of_background, end_of_purpose
from mansion_editing.instructions.sentences.conditions import on_condition, read_condition
from mansion_editing.instructions.sentences.ending_numbers import Counting, EndingNumbers
from mansion_editing.instructions.sentences.lacking import end_of_presence, given_where_none_is, lacking_at
from mansion_editing.instructions.sentences.refinement import given_but_to
from mansion_editing.instructions.sentences.resulting import Resulting
from mansion_editing.instructions.statements import (
    JOINED,
    Add,
    Amount,
    Clear,
    Ensure,
    Furnish,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Replace,
    Rooms,
    SetState,
    Statement,
    Swap,
    Things,
    Turn,
)

__all__ = ["Tails"]

_OF_EACH_HAVING: Final = frozenset("so that each every all of them has have get one its their own a an the".split())
"""Words of ``so that each of them has its own``, besides the names of what is given and where."""

_EVERY_ONE: Final = (("every", "single", "one"), ("all", "of", "them"), ("each", "of", "them"), ("from", "now", "on"))
_BEFORE_ASIDES: Final = frozenset("for before after when while until".split())
_PAIRS_AFTER_CLAUSES: Final = (
    ("any", "more"), ("you", "find"), ("you", "see"), ("nothing", "else"), ("no", "other"), ("as", "well"),
    ("at", "all"), ("if", "possible"), ("for", "me"), ("for", "us"), ("for", "now"), ("for", "each"),
    ("from", "now"), ("now", "on"), ("at", "once"), ("right", "away"), ("straight", "away"),
    ("of", "course"), ("from", "today"), ("from", "tomorrow"), ("as", "usual"), ("in", "total"), ("or", "so"),
)  # fmt: skip


_EXCEPTING: Final = frozenset("except apart save excluding".split())
_DISTURBING: Final = frozenset(
    "touching moving shifting disturbing removing changing altering displacing rearranging opening closing".split()
)


_INTENTS: Final = frozenset("welcome surprise treat greeting memento thank-you present gift joke reward".split())
"""What something is meant as, which no scene records."""


class Tails(EndingNumbers, Resulting, Counting):
    """Reads what follows a clause and is none itself."""

    def _read_tail(self, reader: ClauseReader, words: Sequence[Word], end: int) -> tuple[int, bool]:
        """Read what may follow a clause: ``please``, ``if possible``; the rest must begin a new clause.

        Returns
        -------
        end : int
        exact : bool
            The number that was named is meant exactly ("two forks, no more").
        """
        exact = False
        while end < len(words):
            limit = self._end_of_limit(words, end)
            stop = limit or self._end_of_addition(reader, words, end) or self._end_of_adjunct(reader, words, end)
            if not stop:
                break
            end, exact = stop, exact or bool(limit)
        return self._end_of_remark(reader, words, end), exact

    def _end_of_addition(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read what tells more of what the clause asks for, or what it is for; return its end, 0 for other words."""
        start = at + (words[at].text in (",", "and"))
        if tuple(word.text for word in words[start : start + 3]) in _EVERY_ONE:
            return self._past_whole_building(reader, start + 3)
        counted = self._in_number(reader, at)
        if counted:
            return counted
        meant = self._end_of_intent(words, at)
        if meant:
            self.statements.append(Mention(quote=self._quote(words, at, meant), passed_over=True))
            return meant
        more = (
            self._turned_around(words, at)
            or self._listed_rooms(reader, words, at)
            or self._until_so_many_are_left(words, at)
            or self._so_that_so_many_are_there(words, at)
            or self._in_state(reader, at)
            or self._without_touching(reader, at)
        )
        if more:
            return more
        told = end_of_presence(reader, at) or self._where_none_is(reader, at) or self._so_each_has_one(words, at)
        told = told or self._and_nothing_else(words, at) or end_of_purpose(words, at, self.clause)
        if told:
            self.statements.append(Mention(quote=self._quote(words, at, told)))
        return told or self._besides(reader, at)

    def _end_of_adjunct(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read a condition, a contrast or a courtesy after a clause; return its end, 0 for other words."""
        pair = (words[at].text, text_at(words, at + 1))
        fits = self._if_it_fits(words, at)
        depends = fits or self._depends_on(reader, at + (words[at].text == ","))
        if depends:
            return depends
        if (*pair, text_at(words, at + 2)) == ("from", "now", "on"):
            return at + 3
        contrast = self._contrasted(reader, at + 2) if pair in (("rather", "than"), ("instead", "of")) else 0
        if contrast:
            return contrast
        rather = pair[0] == "than" and "rather" in {word.text for word in words[:at]}
        other = self._contrasted(reader, at + 1) if rather else 0
        if other:
            return other
        if pair in _PAIRS_AFTER_CLAUSES:
            return at + 2
        return at + 1 if words[at].text in COURTESIES or self._ends_clause(reader, at) else 0

    def _end_of_remark(self, reader: ClauseReader, words: Sequence[Word], end: int) -> int:
        """Return the end of a remark after a clause; what is none and begins no other clause is not understood."""
        if end >= len(words) or words[end].kind == "mark" or words[end].text in JOINING:
            return end
        if end_of_background(words, end) > end or reader.starts_clause(end):
            return end
        stop = reader.boundary(end)
        aside = words[end].text in _BEFORE_ASIDES or self._is_for_some_purpose(words[end:stop])
        aside = aside and not any(w.kind == "number" for w in words[end:stop])
        aside = aside and not self._is_for_somewhere(words[end:stop])
        quote = self._quote(words, end, stop)
        if aside and not self._names_anything(words[end:stop]):
            self.statements.append(Mention(quote=quote))
        else:
            self.unknown.append(quote)
        return stop

    def _is_for_somewhere(self, words: Sequence[Word]) -> bool:
        """Whether ``for the lab`` after new things without a place may be their place, of no known name."""
        new = bool(self.clause) and all(isinstance(s, Add | Ensure) and s.place == Place() for s in self.clause)
        named = len(words) > 2 and words[0].text == "for" and words[1].text in ("the", "our", "my")
        somebody = PEOPLE | PERSONS | RELATIVES | EVENTS
        return new and named and not any(w.text in somebody or w.text.endswith("ing") for w in words[2:])

    def _past_whole_building(self, reader: ClauseReader, at: int) -> int:
        """Return the end of ``in the building`` after ``every single one``, which leaves nothing out."""
        read = read_place(reader.words, at, self.lexicon, self.floors)
        return at if read is None or read.place != Place() else read.end

    def _ends_clause(self, reader: ClauseReader, at: int) -> bool:
        """Whether a word is the last one of a clause: ``only``, ``each`` of several, ``in`` of what is brought."""
        text = reader.text(at)
        if text == "in":
            return self._comes_in(reader, at + 1)
        if text in ("around", "round", "over") and self._ends_at(reader, at + 1):
            return bool(self.clause) and all(isinstance(s, Swap) for s in self.clause)
        if text == "up" and self._ends_at(reader, at + 1):
            return all(isinstance(s, Add | Ensure) for s in self.clause)  # "hang one up"
        return text in AFTER_CLAUSES and (text != "each" or _is_of_several(self.clause))

    def _comes_in(self, reader: ClauseReader, after: int) -> bool:
        """Whether ``in`` ends a clause that brings something: ``take the desks out and put four beds in``."""
        brought = [s for s in self.clause if isinstance(s, Add | Ensure) and s.place == Place()]
        if not self._ends_at(reader, after) or not brought or len(brought) < len(self.clause):
            return False
        here = Place(rooms=Rooms(same=True))
        self.clause = [msgspec.structs.replace(s, place=here) for s in brought]
        return True

    def _is_for_some_purpose(self, words: Sequence[Word]) -> bool:
        """Whether words after a state say what it is good for: ``to air``, ``to cool down``."""
        plain = len(words) > 1 and all(word.kind == "word" and not word.capital for word in words)
        verb = plain and words[0].text == "to" and words[1].text not in DETERMINERS | PREPOSITIONS
        return verb and bool(self.clause) and all(isinstance(s, SetState) for s in self.clause)

    def _besides(self, reader: ClauseReader, at: int) -> int:
        """Read what comes with new things, or an exception; return its end, 0 for others."""
        return (
            self._furnished_with(reader, at)
            or self._with_contents(reader, at)
            or self._with_companions(reader, at)
            or self._all_except(reader, at)
            or self._with_what_lies_on_it(reader, at)
            or self._as_exchanged(reader, at)
            or self._where_somebody_is(reader, at)
        )

    def _where_somebody_is(self, reader: ClauseReader, at: int) -> int:
        """Return the end of ``where someone is asleep`` after a room that its number tells; 0 for others."""
        start = at + (reader.text(at) == ",")
        numbered = at > 0 and reader.words[at - 1 - (reader.text(at - 1) == ",")].raw.isdecimal()
        if reader.text(start) != "where" or not numbered:
            return 0
        end = next_mark(reader.words, start)
        said = reader.words[start + 1 : end]
        somebody = {word.text for word in said[:3]} & (PERSONS | PEOPLE)
        plain = all(word.kind == "word" and word.text not in STATE_WORDS for word in said)
        asking = {word.text for word in said} & ({"and", "not", "no"} | MODALS)
        return end if somebody and plain and not asking and not self._names_anything(said) else 0

    def _with_what_lies_on_it(self, reader: ClauseReader, at: int) -> int:
        """Return the end of ``with everything that lies on it`` after what goes, which takes that along; else 0."""
        done = bool(self.clause) and all(isinstance(s, Move | Remove) for s in self.clause)
        end = end_of_load(reader.words, at) if done else 0
        return end if end and self._ends_at(reader, end) else 0

    def _ends_at(self, reader: ClauseReader, at: int) -> bool:
        return at >= len(reader.words) or reader.words[at].kind == "mark" or reader.text(at) in JOINING

    def _as_exchanged(self, reader: ClauseReader, at: int) -> int:
        """Return the end of ``so that each is where the other one was`` after an exchange; 0 for others."""
        at += reader.text(at) == ","
        if not self.clause or not isinstance(self.clause[-1], Swap):
            return 0
        if (reader.text(at), reader.text(at + 1)) != ("so", "that"):
            return 0
        end = next_mark(reader.words, at)
        said = [word.text for word in reader.words[at + 2 : end]]
        return end if said[:1] in (["each"], ["they"], ["one"], ["both"]) and {"other", "place"} & set(said) else 0

    def _furnished_with(self, reader: ClauseReader, at: int) -> int:
        """Read ``with two single beds`` of a room that becomes another one."""
        last = self.clause[-1] if self.clause else None
        if reader.text(at) != "with" or not isinstance(last, Furnish) or not last.kind:
            return 0
        try:
            contents, end = reader.contained(at + 1)
        except NotUnderstood:
            return 0
        self.clause = [*self.clause, *contents]
        return end

    def _with_contents(self, reader: ClauseReader, at: int) -> int:
        """Read ``with a bag in it`` of furniture that opens; return its end, 0 for others."""
        last = self.clause[-1] if self.clause else None
        start = at + (reader.text(at) in (",", "and"))
        if reader.text(start) != "with" or not isinstance(last, SetState) or reader.phrase(start + 1) is None:
            return 0
        try:
            items = reader.items(start + 1)
        except NotUnderstood:
            return 0
        goals = [item.goal()[0] for item in items]
        shared = goals[-1]
        inside = shared.relation in ("in", "on") and shared.anchor is not None and shared.anchor.refers == "last"
        if not inside or any(goal not in (Place(), shared) for goal in goals) or last.things.plural:
            return 0
        holder = msgspec.structs.replace(last.things, definite=True)
        place = Place(relation=shared.relation, anchor=holder)
        end = items[-1].end
        mark, stop = reader.places(end + 1) if reader.text(end) == "," else ((), end)
        near = joined_places(mark)[0] if mark else Place()
        if near.anchor is not None and near.relation in BESIDE_RELATIONS and near.anchor.definite:
            place = msgspec.structs.replace(near, anchor=with_place(near.anchor, place))
            end = stop
        quote = self._quote(reader.words, start, end)
        self.clause = [*self.clause, *(Ensure(things=i.phrase.things(), place=place, quote=quote) for i in items)]
        return end

    def _with_companions(self, reader: ClauseReader, at: int) -> int:
        """Read ``, with a stool each`` after a clause that brings something."""
        if not self.clause or not isinstance(self.clause[-1], Add | Ensure | Replace):
            return 0
        start = at + (reader.text(at) == ",")
        start += reader.text(start) == "each"
        if reader.text(start) != "with" or reader.phrase(start + 1) is None:
            return 0
        try:
            said, end = reader.with_companions(self.clause, start, at)
        except NotUnderstood:
            return 0
        if end <= start:
            return 0
        begins = self.text.find(self.clause[0].quote)
        quote = self.text[max(0, begins) : reader.words[end - 1].end]
        known = len(self.clause)
        self.clause = [*said[:known], *(msgspec.structs.replace(s, quote=quote) for s in said[known:])]
        return end

    def _all_except(self, reader: ClauseReader, at: int) -> int:
        """Read ``, except for the one in the bathroom`` after what is done with all of a kind."""
        if not self.clause or reader.text(at + (reader.text(at) == ",")) not in _EXCEPTING:
            return 0
        end, spared = reader.exceptions(at)
        if spared and all(isinstance(s, Add | Ensure) for s in self.clause):
            given = [given_but_to(s, spared) for s in self.clause if isinstance(s, Add | Ensure)]
            kept = [s for s in given if s is not None]
            self.clause = [*kept] if len(kept) == len(given) else self.clause
            return end if len(kept) == len(given) else 0
        if not all(isinstance(s, SetState | Remove | Paint) for s in self.clause):
            return 0
        done = [s for s in self.clause if isinstance(s, SetState | Remove | Paint)]
        if not spared or any(s.things.amount.kind != "all" for s in done):
            return 0
        self.clause = [sparing(s, spared) for s in done]
        return end

    def _where_none_is(self, reader: ClauseReader, at: int) -> int:
        """Read ``that has none yet`` after places that are each given one; return its end, 0 for others."""
        end = lacking_at(reader, at, self.clause)
        given = given_where_none_is(self.clause) if end else None
        if given is None:
            return 0
        self.clause = [*given]
        return end

    def _so_each_has_one(self, words: Sequence[Word], at: int) -> int:
        """Read ``so that each table has one`` after what each is given; return its end, 0 for others."""
        start = at + (words[at].text == ",")
        end = next_mark(words, start)
        given = given_where_none_is(self.clause)
        if given is None or [word.text for word in words[start : start + 1]] != ["so"]:
            return 0
        holders = {noun for s in given if (anchor := s.place.anchor) is not None for noun in anchor.noun.split()}
        rooms = {noun for s in given if s.place.rooms is not None for noun in s.place.rooms.words.split()}
        things = {noun for s in given for noun in s.things.noun.split()}
        said = {word.text for word in words[start:end]} - _OF_EACH_HAVING - holders - rooms - things
        whole = {"each", "every", "all"} & {word.text for word in words[start:end]}
        if said or not whole or not {"one", "own", *things} & {word.text for word in words[start:end]}:
            return 0
        self.clause = [*given]
        return end

    def _and_nothing_else(self, words: Sequence[Word], at: int) -> int:
        """Read ``and nothing else`` after what changes nothing else anyway; return its end, 0 for others.

        After what is put somewhere it may mean that all else there goes.
        """
        joined = at + (words[at].text in (",", "and", "-", "but"))
        joined += text_at(words, joined) == "and"
        said = (text_at(words, joined), text_at(words, joined + 1))
        plain = all(isinstance(s, SetState | Remove | Paint | Swap | Clear | Keep) for s in self.clause)
        plain = plain or (all(isinstance(s, Add | Ensure) for s in self.clause) and self._goes_where_all_went())
        if joined == at or said not in (("nothing", "else"), ("nothing", "more")) or not plain:
            return 0
        return joined + 2 if next_mark(words, joined) == joined + 2 else 0

    def _goes_where_all_went(self) -> bool:
        """Whether new things come to furniture that was cleared just before: ``clear it, then put a lamp on it``."""
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        cleared = last.place.anchor if isinstance(last, Clear) else None
        goals = [s.place.anchor for s in self.clause if isinstance(s, Add | Ensure)]
        return cleared is not None and all(
            goal is not None and (goal.noun == cleared.noun or (goal.refers == "last" and not goal.noun))
            for goal in goals
        )

    def _turned_around(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``so it faces the other way`` after a half turn; 0 for other words."""
        start = at + (words[at].text == ",")
        said = [word.text for word in words[start : start + 7]]
        it = 1 + (said[1:2] == ["that"])
        faces = said[:1] == ["so"] and said[it : it + 1] in (["it"], ["they"]) and said[it + 1 : it + 2] == ["face"]
        half = bool(self.clause) and all(isinstance(s, Turn) and s.degrees == 180.0 for s in self.clause)
        return start + it + 5 if faces and half and said[it + 2 : it + 5] == ["the", "other", "way"] else 0

    def _listed_rooms(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read ``: the study, the office and the hall`` after all rooms, which tells which of them."""
        given = [s.place.rooms for s in self.clause if isinstance(s, Add | Ensure)]
        every = bool(given) and all(rooms is not None and rooms.every and not rooms.number for rooms in given)
        if words[at].text != ":" or not every or len(given) < len(self.clause):
            return 0
        end, names = at + 1, []
        while (item := reader.item(end)) is not None and reader.lexicon.is_own_room(item.phrase.noun.words):
            names.append(item.rooms().words)
            end = item.end
            after = reader.conjunction(end)
            if not after:
                break
            end = after
        if len(names) < 2 or not self._ends_at(reader, end):
            return 0
        floors = given[0].floors if given[0] is not None else ()
        rooms = Rooms(words=JOINED.join(names), floors=floors, every=True, number=len(names))
        done = [s for s in self.clause if isinstance(s, Add | Ensure)]
        self.clause = [msgspec.structs.replace(s, place=msgspec.structs.replace(s.place, rooms=rooms)) for s in done]
        self.statements.append(Mention(quote=self._quote(words, at + 1, end)))
        return end

    def _end_of_intent(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``as a welcome``, ``as a surprise for Ann``; 0 for words that ask for something."""
        texts = [word.text for word in words[at : at + 3]]
        if len(texts) < 3 or texts[0] != "as" or texts[1] not in ("a", "an", "our", "my") or texts[2] not in _INTENTS:
            return 0
        end = at + 3
        if end < len(words) and words[end].text == "for":
            stop = next_mark(words, end)
            whom = words[end + 1 : stop]
            plain = len(whom) <= 3 and all(word.kind == "word" for word in whom) and not self._names_anything(whom)
            end = stop if plain else end
        return end

    def _without_touching(self, reader: ClauseReader, at: int) -> int:
        """Read ``without moving the tables``, ``without touching what is on it``; return its end, 0 for others."""
        at += reader.text(at) == ","
        verb = reader.words[at + 1].raw if at + 1 < len(reader.words) else ""
        if reader.text(at) != "without" or verb not in _DISTURBING:
            return 0
        place = at + 2
        if reader.text(place) in ("anything", "something"):
            return place + 1 + (reader.text(place + 1) in ("else", "there"))
        kept, end = self._what_is_there(reader, place), place
        if kept is not None:
            things, end = kept
            everything = [things]
        else:
            items = reader.items(place) if reader.item(place) is not None else []
            if not items or not all(item.phrase.definite and item.phrase.noun.words for item in items):
                return 0
            whole = Amount(kind="all", number=0)
            everything = [msgspec.structs.replace(item.things(), amount=whole, plural=True) for item in items]
            end = items[-1].end
        quote = self._quote(reader.words, at, end)
        self.clause = [*self.clause, *(Keep(things=things, quote=quote) for things in everything)]
        return end

    def _what_is_there(self, reader: ClauseReader, at: int) -> tuple[Things, int] | None:
        """Read ``what is inside``, ``what is on it`` of the furniture that the clause before is about."""
        holder = next((named for s in self.clause for named in [_holder_of(s)] if named is not None), None)
        if reader.text(at) not in ("what", "everything") or holder is None or not (holder.noun and not holder.refers):
            return None
        end = at + 1 + (reader.text(at + 1) in ("is", "lie", "stand", "that"))
        end += reader.text(end - 1) == "that" and reader.text(end) in ("is", "lie", "stand")
        relation = {"inside": "in", "in": "in", "on": "on"}.get(reader.text(end))
        if relation is None:
            return None
        end += 1 + (reader.text(end + 1) in ("it", "them", "there"))
        place = Place(relation="in" if relation == "in" else "on", anchor=holder)
        return Things(amount=Amount(kind="all", number=0), definite=True, plural=True, place=place), end

    def _if_it_fits(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``if there is room for it``, ``if it fits``: so wherever it can be done; 0 for others."""
        at += words[at].text == ","
        texts = [w.text for w in words[at : at + 8]]
        for said in (["if", "there", "is"], ["if", "it", "fit"], ["if", "they", "fit"]):
            if texts[:3] != said:
                continue
            end = 3 + (said[1] == "there" and texts[3:4] in (["enough"], ["still"], ["any"]))
            if said[1] == "there" and texts[end : end + 1] not in (["room"], ["space"]):
                return 0
            end += said[1] == "there"
            if texts[end : end + 1] == ["for"] and texts[end + 1 : end + 2] in (["it"], ["them"], ["that"]):
                end += 2
            end += texts[end : end + 1] in (["there"], ["left"])
            return at + end if at + end >= len(words) or words[at + end].kind == "mark" else 0
        return 0

    def _depends_on(self, reader: ClauseReader, at: int) -> int:
        """Read a condition after a clause, on which its statements then depend; return its end, 0 where it is none."""
        last = [self._said_before(statement) for statement in self.clause]
        things = next((s.things for s in last if isinstance(s, Add | Ensure | Move | SetState)), None)
        found = read_condition(reader, at, things)
        if found is None or not last:
            return 0
        joined = "and" in (reader.text(at), reader.text(at - 1)) or "but" in (reader.text(at), reader.text(at - 1))
        after = found[1] - (reader.text(found[1] - 1) == ",")
        if joined and reader.text(after) == "," and reader.starts_clause(after + 1):
            return 0  # "..., and if the lamp is off, turn it on"
        start = self.text.find(last[0].quote)
        quote = self.text[max(0, start) : reader.words[found[1] - 1].end]
        self.clause = [on_condition(msgspec.structs.replace(s, quote=quote), found[0]) for s in last]
        return found[1]

    def _said_before(self, statement: Statement) -> Statement:
        """Return what the clause before said should be there for ``add one``."""
        last = self.statements[-1] if self.statements else None
        bare = isinstance(statement, Add | Ensure | Move) and statement.things.refers == "last"
        if bare and isinstance(last, Ensure) and not getattr(statement, "things", Things()).noun:
            return msgspec.structs.replace(last, quote=statement.quote)
        return statement

    def _contrasted(self, reader: ClauseReader, at: int) -> int:
        """Return the end of what is not meant: ``than two``, ``of on the shelf``; 0 where it is a thing."""
        if at < len(reader.words) and reader.words[at].kind == "number":
            return at + 1
        places, end = reader.places(at)
        return end if places else 0

    def _from_to(self, first: Statement, last: Statement) -> str:
        """Return the words from one statement's to another's."""
        return self.text[self.text.find(first.quote) : self.text.rfind(last.quote) + len(last.quote)]


def _is_of_several(clause: Sequence[Statement]) -> bool:
    """Whether ``each`` after a clause may mean several that it names, and nobody that only a reader knows."""
    for statement in clause:
        if not isinstance(statement, Add | Ensure):
            return True
        anchor, rooms = statement.place.anchor, statement.place.rooms
        several = statement.each or (anchor is not None and (anchor.plural or anchor.amount.number > 1))
        if several or bool(anchor is not None and anchor.refers) or (rooms is not None and rooms.every):
            return True
    return False


def _holder_of(statement: Statement) -> Things | None:
    """Return the furniture that something is put on or in, or that is opened."""
    if isinstance(statement, Add | Ensure | Move):
        anchor = statement.place.anchor
        rooms = statement.place.rooms
        return anchor if anchor is None or rooms is None else with_place(anchor, Place(rooms=rooms))
    return statement.things if isinstance(statement, SetState) else None
