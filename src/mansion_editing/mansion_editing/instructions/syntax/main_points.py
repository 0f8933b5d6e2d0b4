"""An instruction without the clauses that only tell something; what pronouns took up of them stands in their place."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.phrases.words import PLURAL_PRONOUNS, SENTENCE_ENDS
from mansion_editing.instructions.syntax.appositions import without_appositions
from mansion_editing.instructions.syntax.clauses import Clause, clauses_of
from mansion_editing.instructions.syntax.marks import without_list_colons
from mansion_editing.instructions.syntax.mentions import Mentioned, mentioned_in, taken_up
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.numbers import made_number, with_number_made, with_room_numbers
from mansion_editing.instructions.syntax.pairs.joining import with_pairs_joined
from mansion_editing.instructions.syntax.plain_requests import plainly_asked
from mansion_editing.instructions.syntax.requests import is_person, names_something, only_tells
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined, tagged
from mansion_editing.instructions.syntax.wished_states import with_wished_states
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import plural, singular

__all__ = ["MainPoints", "main_points"]

_EXISTS: Final = re.compile(r"there (?:should|must|shall) be\b")
_IN_IT: Final = re.compile(r" in (?:it|there)\b")
"""What means the room that is told of, where nothing but what shall be there is named."""
_PRONOUNS: Final = frozenset("it them they this that these those both".split())
_THAT: Final = frozenset("that this the those these".split())
_ONES: Final = frozenset(["one", "ones"])
_HITHER: Final = frozenset("in over across along".split())
_ALSO: Final = frozenset("too also well likewise ditto".split())
_CORRECTING: Final = frozenset("no nope sorry wait oops correction scratch forget rather actually".split())
_PARTS_OF_ROOMS: Final = frozenset("door wall window corner floor ceiling middle entrance".split())
_WAYS: Final = frozenset(["into", "onto", "to"])
"""Prepositions by which a clause without a verb asks that something goes somewhere."""
_FOREIGN: Final = frozenset('$ { } \\ / ~ & * _ = < > | # @ % ^ " “ ”'.split())
"""Marks of names and of code, which are no English."""


@dataclass(frozen=True)
class MainPoints:
    """What an instruction asks for, and the clauses that were left out.

    Attributes
    ----------
    described : tuple of str
        Those of the clauses that only say what there is, or what somebody or something has.
    """

    text: str
    remarks: tuple[str, ...]
    described: tuple[str, ...] = ()


class _Uncertain(Exception):
    """A pronoun of a request may mean one or the other thing that was told of."""


def main_points(text: str, lexicon: Lexicon) -> Iterator[MainPoints]:
    """Yield what a text asks for as plain orders and then in its own words.

    Nothing where all of it only tells, or a pronoun is not certain.

    Parameters
    ----------
    text : str
        In running text, without contractions.
    """
    text = with_pairs_joined(with_room_numbers(text, lexicon), lexicon)
    words: Sequence[TaggedWord] = with_wished_states(without_appositions(without_list_colons(tagged(text, lexicon))))
    if any(word.text in _FOREIGN for word in words):
        return
    clauses, words = _wished(clauses_of(words), words)
    told = [only_tells(clause, words, lexicon) for clause in clauses]
    told = [
        (
            tells
            and not (
                _goes_on_wishing(clauses, words, number)
                or _is_listed(clauses, words, number, lexicon)
                or _asks_opinion(clauses, words, number)
            )
        )
        or _is_topic(clauses, words, number)
        or _is_counted_before(clauses, words, number)
        or _repeats_swap(clauses, words, number)
        or _is_met_next(clauses, words, number)
        or _is_heading(clauses, words, number, lexicon)
        for number, tells in enumerate(told)
    ]
    if all(told) or any(tells and _corrects(clause, words) for clause, tells in zip(clauses, told, strict=True)):
        return
    for plainly in (True, False):
        try:
            points = _Points(text, words, lexicon, plainly=plainly)
            for clause, tells in zip(clauses, told, strict=True):
                points.add(clause, tells=tells)
        except _Uncertain:
            return
        yield MainPoints(points.said(), tuple(points.remarks), tuple(points.described))


@dataclass
class _Points:
    """What is asked for in the clauses so far."""

    text: str
    words: Sequence[TaggedWord]
    lexicon: Lexicon
    plainly: bool
    mentions: list[list[Mentioned]] = field(default_factory=list)
    asked: list[tuple[Clause, list[TaggedWord]]] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    names_rooms: bool = False
    described: list[str] = field(default_factory=list)
    named_again: list[str] = field(default_factory=list)

    def add(self, clause: Clause, *, tells: bool) -> None:
        """Add a clause.

        Raises
        ------
        _Uncertain
        """
        mentions = mentioned_in(clause, self.words, self.text, self.lexicon, told=tells)
        if tells:
            said_so = self.text[self.words[clause.start].start : self.words[clause.end - 1].end]
            self.remarks.append(said_so)
            coloured = self.words[clause.verb].tag == "be" and self.words[clause.end - 1].text in COLOUR_WORDS
            if clause.form == "existence" or self.words[clause.verb].tag == "have" or coloured:
                self.described.append(said_so)
        elif self._makes_number(clause):
            pass
        else:
            said = [*self._shared_subject(clause), *self._with_antecedents(clause, mentions)]
            said = self._with_counted_noun(self._with_replaced(said))
            said = self._with_room_as_goal(self._with_room_for_there(said)) if self._tells_room() else said
            said = self._in_each_room(self._with_verb_before(clause, said) or said)
            if self.remarks and not self.asked and any(w.text == "there" and w.tag == "adverb" for w in said):
                raise _Uncertain
            self.asked.append((clause, plainly_asked(said, self.lexicon) if self.plainly else said))
        if clause.form != "dependent":
            self.mentions.append(mentions)

    def _makes_number(self, clause: Clause) -> bool:
        """Add ``there should be exactly two monitors`` for ``make it two`` after words about one monitor."""
        number = made_number(self.words[clause.start : clause.end])
        things = next((found for m in reversed(self.mentions) if (found := [t for t in m if t.kind == "thing"])), [])
        rooms = self._told_rooms()
        said = with_number_made(number, things, self.words, rooms[0] if len(rooms) == 1 else "") if number else []
        if not said or not (things[0].told or (self.asked and self.asked[-1][0].form == "statement")):
            return False
        if not things[0].told:
            self.asked.pop()  # "one monitor is too few"
        self.asked.append((clause, said))
        return True

    def said(self) -> str:
        """Return what is asked for in running text."""
        parts: list[str] = []
        last: Clause | None = None
        mark = "."
        for clause, said in self.asked:
            if last is not None:
                parts.append(_joint(last, clause, self.words, mark))
            parts.append(joined(said))
            ended = next((word.text for word in self.words[clause.end :] if word.text in SENTENCE_ENDS), ".")
            mark = "?" if ended == "?" and said[0].form != "base" else "."
            last = clause
        whole = "".join(parts)
        rooms = self._told_rooms()
        named = any(one.kind == "room" and not one.told for mentions in self.mentions for one in mentions)
        if len(rooms) == 1 and not (named or self.names_rooms) and rooms[0] not in whole:
            return f"in {rooms[0]}, {_IN_IT.sub('', whole, count=1) if _EXISTS.match(whole) else whole}{mark}"
        return f"{whole}{mark}"

    def _shared_subject(self, clause: Clause) -> list[TaggedWord]:
        """Return the subject that a clause shares with one before it that only tells."""
        last = self.asked[-1][0].subject if self.asked else -1
        if not clause.shares_subject or last == clause.subject:
            return []
        first, *more = self.words[clause.subject : clause.subject_end]
        return [first if first.tag == "noun" else replace(first, raw=first.text), *more]

    def _told_rooms(self) -> list[str]:
        rooms = (one.words for mentions in self.mentions for one in mentions if one.kind == "room" and one.told)
        return list(dict.fromkeys(rooms))

    def _tells_room(self) -> bool:
        last = next((m for m in reversed(self.mentions) if any(one.kind == "room" for one in m)), [])
        return any(one.kind == "room" and one.told for one in last)

    def _with_room_for_there(self, said: list[TaggedWord]) -> list[TaggedWord]:
        """Return a clause with the room that was told of for ``there``, at its end."""
        at = next((k for k, word in enumerate(said) if word.text == "there"), None)
        rooms = [one for one in self.mentions[-1] if one.kind == "room"] if self.mentions else []
        if at is None or at == 0 or len(rooms) != 1 or said[at - 1].tag == "preposition":
            return said
        room = replace(said[at], raw=f"in {rooms[0].words}", tag="noun")
        told_with = said[at - 1].tag in ("noun", "pronoun", "number")
        return [*said[:at], room, *said[at + 1 :]] if told_with else [*said[:at], *said[at + 1 :], room]

    def _with_room_as_goal(self, said: list[TaggedWord]) -> list[TaggedWord]:
        """Return ``bring the chair to the hall`` for ``bring in the chair`` after words about the hall."""
        rooms = [one for one in self.mentions[-1] if one.kind == "room" and one.told] if self.mentions else []
        brought = said[0].form == "base" and BY_WORDS.get((said[0].verb,)) in ("bring", "move", "take")
        at = 1 if len(said) > 2 and said[1].text in _HITHER else len(said) - 1
        goal = any(word.text in ("to", "into", "onto", "there", "here") for word in said)
        if not brought or goal or len(rooms) != 1 or said[at].text not in _HITHER:
            return said
        room = replace(said[at], raw=f"to {rooms[0].words}", tag="noun")
        return [*said[:at], *said[at + 1 :], room]

    def _in_each_room(self, said: list[TaggedWord]) -> list[TaggedWord]:
        """Return ``put a rug in room 4 and put a rug in room 5`` for ``put a rug in each`` after words about both."""
        rooms = [one for one in self.mentions[-1] if one.kind == "room" and one.told] if self.mentions else []
        if len(rooms) < 2 or [word.text for word in said[-2:]] != ["in", "each"]:
            return said
        first, *more = ([*said[:-1], replace(said[-1], raw=room.words, tag="noun")] for room in rooms)
        joint = replace(said[-1], text="and", raw="and", tag="joint")
        return [*first, *(word for other in more for word in (joint, *other))]

    def _with_counted_noun(self, said: list[TaggedWord]) -> list[TaggedWord]:
        """Return a clause in which a number without a noun counts what was told of: ``three of the five hammers``."""
        for at, word in enumerate(said):
            following = said[at + 1] if at + 1 < len(said) else None
            before = said[at - 1] if at else None
            counted = word.tag == "number" and before is not None and before.text in ("the", "all", "those", "other")
            ends = following is None or following.tag in ("preposition", "mark", "verb", "modal", "adverb", "to")
            if counted and ends and not (following is not None and following.text == "of"):
                noun = self._noun_for("ones")
                any_of_them = noun and before is not None and before.text == "other" and not self.asked
                if any_of_them and at > 1 and said[at - 2].text == "the":
                    of = replace(word, raw=f"of the {noun}", tag="noun")
                    return [*said[: at - 2], word, of, *said[at + 1 :]]
                return [*said[: at + 1], replace(word, raw=noun, tag="noun"), *said[at + 1 :]] if noun else said
        return said

    def _with_verb_before(self, clause: Clause, said: list[TaggedWord]) -> list[TaggedWord]:
        """Return ``take the bed away`` for ``and the bed too`` after ``take the tree away``; nothing else."""
        before = self.asked[-1][1] if self.asked else []
        also = said[-1].text in _ALSO
        if clause.form != "fragment" or not also or not before or before[0].form != "base":
            return []
        end = len(said) - 1 - (said[-2:-1] != [] and said[-2].text == "as")
        named = end_of_noun_group(said[:end], 0)
        start = 1 + (before[1].text in ("out", "up", "down", "off", "away"))
        rest = before[max(start, _end_of_list(before, start)) :]
        rest = [word for word in rest if word.tag in ("preposition", "adverb")][:1] if named < end else rest
        again = [replace(before[0], raw=before[0].text), *before[1:start]]
        named_first = said[0] if said[0].tag == "noun" else replace(said[0], raw=said[0].text)
        return [*again, named_first, *said[1:end], *rest] if named else []

    def _with_antecedents(self, clause: Clause, own: Sequence[Mentioned]) -> list[TaggedWord]:
        """Return the words of a clause with what pronouns of it take up of clauses that only tell.

        Raises
        ------
        _Uncertain
        """
        out: list[TaggedWord] = []
        taken_up = False
        for number in range(clause.start, clause.end):
            word = self.words[number]
            thing = word.text in ("thing", "things") and bool(out) and out[-1].text in _THAT
            within = number != clause.subject and any(one.kind == "thing" and one.end <= number for one in own)
            new = ""
            if thing:
                new = self._antecedent("them" if word.text == "things" else "it")
                out = out[:-1] if new else out
            elif word.text in _ONES and word.tag in ("pronoun", "number") and not within:
                new = self._instead_of_one(clause, number)
            elif word.tag == "number" and out and out[-1].text == "in" and (rooms := self._numbered_rooms(number)):
                out.append(replace(word, raw=f"{rooms} {word.raw}"))
                continue
            elif word.text in ("their", "his", "her") and (owner := self._owner_of_room(number)):
                out.append(replace(word, text=owner, raw=owner, tag="possessive"))
                continue
            elif word.text == "its" and self._is_part_of_told_room(number):
                out.append(replace(word, text="the", raw="the", tag="determiner"))
                continue
            elif word.text == "none" and (noun := self._noun_for("ones")):
                new = f"no {noun}"
            elif word.text == "it" and _is_of_part(out) and len(self._told_rooms()) == 1:
                out.append(replace(word, raw=self._told_rooms()[0], tag="noun"))
                self.names_rooms = True
                continue
            elif word.text == "each" and out and out[-1].tag == "preposition" and word.tag == "pronoun":
                new = self._each_of_them()
            elif word.tag == "pronoun" and word.text in _PRONOUNS and not (within or taken_up):
                new, out = self._instead_of_pronoun(word, out, last=number + 1 == clause.end)
            taken_up = taken_up or (bool(new) and word.text not in _ONES)
            out.append(replace(word, raw=new, tag="noun") if new else word)
        return out

    def _instead_of_pronoun(
        self, word: TaggedWord, before: list[TaggedWord], *, last: bool
    ) -> tuple[str, list[TaggedWord]]:
        """Return what a pronoun takes up, and the words before it, which may lose their ``of``.

        Raises
        ------
        _Uncertain
        """
        new = self._antecedent(word.text)
        if new in self.named_again[:1] and self.asked:
            return "", before  # "bring both of them down and put them on the desk"
        self.named_again[:] = [new] if new else self.named_again
        bare = new.removeprefix("the ")
        if new and len(before) > 1 and before[-1].text == "of" and before[-2].tag == "number" and self._is_kind(bare):
            return bare, before[:-1]  # "bandages! there should be ten of them"
        if new and last and before and before[0].verb in ("leave", "keep"):
            return f"{new} as {'they are' if word.text in PLURAL_PRONOUNS else 'it is'}", before
        return new, before

    def _with_replaced(self, said: list[TaggedWord]) -> list[TaggedWord]:
        """Return ``replace the plants by lamps`` for ``replace by lamps, as many as there were plants``.

        Raises
        ------
        _Uncertain
        """
        if (
            said[0].verb not in ("replace", "swap", "exchange")
            or len(said) < 3
            or said[1].text not in ("by", "with", "for")
        ):
            return said
        things = next((found for m in reversed(self.mentions) if (found := [t for t in m if t.kind == "thing"])), [])
        if len(things) != 1 or not things[0].told:
            return said
        texts = [word.text for word in said]
        many = next((k for k in range(len(texts) - 2) if texts[k : k + 3] == ["as", "many", "as"]), len(said))
        rest = said[1 : many - (texts[many - 1] == ",")]
        return [said[0], replace(said[1], raw=things[0].words, tag="noun"), *rest]

    def _numbered_rooms(self, at: int) -> str:
        """Return ``nap rooms`` for ``in 2, 3 and 4`` after words about them; empty where no such were told of."""
        following = self.words[at + 1] if at + 1 < len(self.words) else None
        bare = following is None or following.tag in ("mark", "joint")
        rooms = self.mentions[-1] if self.mentions else []
        several = [one for one in rooms if one.kind == "room" and one.told and one.plural]
        numbered = self.words[at].text.isdecimal() and bare and len(several) == 1
        self.names_rooms = self.names_rooms or numbered
        return several[0].noun if numbered else ""

    def _owner_of_room(self, at: int) -> str:
        """Return ``the kids'`` for ``their`` before ``room`` after words about the kids, whose room there is."""
        room = self.words[at + 1].text if at + 1 < len(self.words) else ""
        for person in reversed(self.words[:at]):
            name = (singular(person.text), room)
            if person.tag == "noun" and is_person([person]) and self.lexicon.is_own_room(name):
                return f"the {person.text}'" if person.text.endswith("s") else f"the {person.text}'s"
        return ""

    def _is_part_of_told_room(self, at: int) -> bool:
        """Whether ``its`` stands before a part of the room that was told of just before: ``by its door``."""
        last = self.mentions[-1] if self.mentions else []
        part = self.words[at + 1].text if at + 1 < len(self.words) else ""
        return singular(part) in _PARTS_OF_ROOMS and [one.kind for one in last] == ["room"] and last[0].told

    def _each_of_them(self) -> str:
        """Return ``each of the six desks`` for ``each`` after words about them; empty where none were told of."""
        for mentions in reversed(self.mentions):
            several = [one for one in mentions if one.kind == "thing" and one.plural]
            if several:
                return f"each of {several[0].words}" if len(several) == 1 and several[0].told else ""
        return ""

    def _instead_of_one(self, clause: Clause, number: int) -> str:
        """Return the noun that ``one`` stands for, with an article where it has none; empty where none was told of."""
        noun = "" if self.words[clause.start].text in ("of", "from") else self._noun_for(self.words[number].text)
        if not noun or _is_the_one(self.words, number):
            return noun
        article = "an" if noun[:1] in tuple("aeiou") else "a"
        return f"{article} {noun}" if self.words[number].tag == "pronoun" else ""

    def _is_kind(self, noun: str) -> bool:
        """Whether a noun was last mentioned as a kind, without an article: ``we run out of bandages``."""
        last = [one for one in self.mentions[-1] if one.kind == "thing"] if self.mentions else []
        bare = len(last) == 1 and self.words[last[0].start].tag == "noun"
        return bare and noun.lower().startswith(last[0].noun.lower())

    def _noun_for(self, one: str) -> str:
        """Return the noun of the last clause with things that ``one`` or ``ones`` stands for; empty if it was kept."""
        things = next((found for m in reversed(self.mentions) if (found := [t for t in m if t.kind == "thing"])), [])
        if not things or not things[0].told:
            return ""
        return singular(things[0].noun) if one == "one" else plural(singular(things[0].noun))

    def _antecedent(self, pronoun: str) -> str:
        """Return what a pronoun takes up of the last clause that names things; empty where that was kept.

        Raises
        ------
        _Uncertain
        """
        for mentions in reversed(self.mentions):
            things = [one for one in mentions if one.kind == "thing"]
            if not things:
                continue
            if not things[0].told:
                return ""
            meant = taken_up(pronoun, things, self.words)
            if not meant or "same" in meant.split():
                raise _Uncertain
            return meant
        return ""


def _is_of_part(words: Sequence[TaggedWord]) -> bool:
    """Whether words end with ``in the middle of``, which only a room can follow."""
    return len(words) > 1 and words[-1].text == "of" and words[-2].text in _PARTS_OF_ROOMS | {"centre", "center"}


def _end_of_list(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of the noun groups that are listed from a place on: ``the mug and the plate``."""
    end = end_of_noun_group(words, at)
    while end < len(words) and words[end].text in ("and", ","):
        following = end_of_noun_group(words, end + 1)
        if following == end + 1:
            break
        end = following
    return end


def _joint(last: Clause, clause: Clause, words: Sequence[TaggedWord], mark: str) -> str:
    """Return what stands between two clauses: as it was within a sentence, a comma after a place that begins one."""
    if clause.form == "fragment" and clause.after in ("-", ":") and words[clause.start].tag == "preposition":
        return " "
    if last.form == "fragment" and words[last.start].tag == "preposition":
        return ", "
    if last.form == "fragment" and clause.after == ":":
        return ": "
    if clause.sentence != last.sentence or clause.after in (":", "-", "(", "–"):
        return f"{mark} "
    if clause.after == "then":
        return ", then "
    return f" {clause.after} " if clause.after.isalpha() else ", "


def _wished(clauses: Sequence[Clause], words: Sequence[TaggedWord]) -> tuple[Sequence[Clause], Sequence[TaggedWord]]:
    """Return ``the rug should be moved`` for ``I would be happy if the rug were moved``."""
    for number, clause in enumerate(clauses):
        before = clauses[number - 1] if number else None
        wishing = before is not None and "would" in {word.text for word in words[before.start : before.end]}
        supposed = clause.form == "dependent" and words[clause.start].text == "if" and words[clause.verb].text in _WERE
        if before is None or not (wishing and supposed) or words[before.subject].tag not in ("somebody", "pronoun"):
            continue
        should = replace(words[clause.verb], text="should", raw="should", tag="modal")
        more = [] if words[clause.verb + 1].text == "be" else [replace(should, text="be", raw="be", tag="be")]
        start = clause.start + 1
        end = clause.end + len(more)
        asked = replace(
            clause, form="statement", start=start, end=end, subject=start, subject_end=clause.verb, after=""
        )
        new = [*words[: clause.verb], should, *more, *words[clause.verb + 1 :]]
        later = [_moved(one, len(more)) for one in clauses[number + 1 :]]
        return [*clauses[: number - 1], asked, *later], new
    return clauses, words


def _moved(clause: Clause, by: int) -> Clause:
    """Return a clause whose words stand so many places later."""
    places = {name: getattr(clause, name) + by for name in ("start", "end", "verb", "subject", "subject_end")}
    return replace(clause, **places)


_WERE: Final = frozenset("were was could would".split())


def _asks_opinion(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int) -> bool:
    """Whether a clause makes a question of the request beside it: ``could we fit a piano in, what do you think?``."""
    clause = clauses[number]
    beside = any(one.sentence == clause.sentence and one is not clause for one in clauses)
    ended = next((word.text for word in words[clause.end :] if word.text in SENTENCE_ENDS), "")
    return beside and ended == "?" and words[clause.start].text in _ASKING


_ASKING: Final = frozenset("what how why which who where when".split())


def _is_counted_before(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int) -> bool:
    """Whether a number of things is told of, to which the next clause objects: ``five bikes but nobody uses two``."""
    clause = clauses[number]
    following = clauses[number + 1] if number + 1 < len(clauses) else None
    objected = following is not None and following.after == "but" and following.form in ("statement", "existence")
    return clause.form == "fragment" and words[clause.start].tag == "number" and objected


def _is_listed(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int, lexicon: Lexicon) -> bool:
    """Whether a fragment stands in a list with others that name things, and may name one too."""
    clause = clauses[number]
    if clause.form != "fragment" or words[clause.end - 1].tag != "noun":
        return False
    beside = [*clauses[max(0, number - 1) : number], *clauses[number + 1 : number + 2]]
    listed = (one for one in beside if one.form == "fragment" and one.sentence == clause.sentence)
    return any(names_something(words[one.start : one.end], lexicon) for one in listed)


def _repeats_swap(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int) -> bool:
    """Whether a clause says again what a swap brings about: ``so that each stands where the other was``."""
    before = clauses[number - 1] if number else None
    clause = clauses[number]
    if before is None or clause.after != "so" or words[before.verb].verb not in ("swap", "swop", "trade", "exchange"):
        return False
    return any(word.text in ("other", "other's") for word in words[clause.start : clause.end])


_VAGUELY: Final = frozenset("more some light seating storage space colour color greenery warmth".split())


def _is_met_next(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int) -> bool:
    """Whether ``the hall needs more light`` only says why the next clause adds a lamp."""
    clause = clauses[number]
    following = clauses[number + 1] if number + 1 < len(clauses) else None
    if clause.form != "statement" or following is None or following.form != "order":
        return False
    adding = BY_WORDS.get((words[following.verb].verb,)) in ("add", "bring")
    needed = [word for word in words[clause.verb : clause.end] if word.tag not in ("adverb", "verb")]
    vague = len(needed) == 2 and all(word.text in _VAGUELY for word in needed)
    return adding and vague and words[clause.verb].verb in ("need", "want", "require", "lack")


def _goes_on_wishing(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int) -> bool:
    """Whether a clause lists more of what the one before needs: ``..., a mug for her and the rack opened``."""
    clause = clauses[number]
    before = clauses[number - 1] if number else None
    if before is None or before.sentence != clause.sentence or clause.after != ",":
        return False
    wishing = any(word.verb in ("need", "want", "require") for word in words[before.start : before.end])
    return wishing and words[clause.start].text in ("a", "an", "two", "three", "some", "one")


def _is_heading(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int, lexicon: Lexicon) -> bool:
    """Whether a sentence only names the room that the next ones are about: ``Crisis room. Take the lamp away.``."""
    clause = clauses[number]
    said = words[clause.start : clause.end]
    alone = number == 0 and clause.form == "fragment" and len(clauses) > 1 and clauses[1].sentence != clause.sentence
    nouns = tuple(singular(word.text) for word in said if word.tag != "determiner")
    return alone and lexicon.is_own_room(nouns) and not lexicon.is_called(nouns)


def _corrects(clause: Clause, words: Sequence[TaggedWord]) -> bool:
    """Whether a clause takes back or puts right what was said: ``I mean the other one``."""
    texts = [word.text for word in words[clause.start : clause.end]]
    return texts[0] in _CORRECTING or "mean" in texts[:3] or "meant" in texts[:3]


def _is_the_one(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether ``one`` stands for a noun: ``the one in the hall``, ``a white one``."""
    before = words[at - 1] if at else None
    return before is not None and before.tag in ("determiner", "adjective", "number")


def _is_topic(clauses: Sequence[Clause], words: Sequence[TaggedWord], number: int) -> bool:
    """Whether a fragment only names what the next clause takes up by a pronoun: ``the red cushion: swap it``."""
    clause = clauses[number]
    following = clauses[number + 1] if number + 1 < len(clauses) else None
    if clause.form != "fragment" or following is None or following.form in ("fragment", "dependent"):
        return False
    later = words[following.start : following.end]
    concerning = [word.text for word in words[clause.start : clause.start + 2]] == ["as", "for"]
    first = words[clause.start + 2 * concerning]
    opens = first.tag in ("determiner", "possessive", "noun", "number") and first.text not in ("no", "every")
    opens = opens and not any(word.text in _WAYS for word in words[clause.start : clause.end])
    pronoun = next((at for at, word in enumerate(later) if word.tag == "pronoun" and word.text in _PRONOUNS), None)
    named = pronoun is not None and any(word.tag == "noun" for word in later[:pronoun])
    return opens and pronoun is not None and not named
