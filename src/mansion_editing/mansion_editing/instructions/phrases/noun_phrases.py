"""Noun phrases: an amount, modifiers and a noun for things or rooms."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal

from mansion_editing.instructions.phrases.amounts import number_at, read_amount
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.nouns import Noun, read_noun
from mansion_editing.instructions.phrases.runs import ENDS_RUN, end_of_run
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.word_sets import BARE_PRONOUNS, PAIRED, PRINTED, TOPICS
from mansion_editing.instructions.phrases.words import ADVERBS, DETERMINERS, PREPOSITIONS, STATE_WORDS, Word, text_at
from mansion_editing.instructions.statements import JOINED, Amount, AmountKind, Place, Rooms, Things
from mansion_language.colours import COLOUR_WORDS

__all__ = ["NounPhrase", "noun_phrase"]

_COLOUR: Final = ("colour", "color")
_ROOM_SIZES: Final[dict[str, Literal["largest", "smallest"]]] = {"large": "largest", "small": "smallest"}
_IN_PHRASES: Final = frozenset(["only", "just", "exactly", "back", "first", "next"])
"""Adverbs that may belong to a noun phrase."""


@dataclass(frozen=True)
class NounPhrase:
    """A noun phrase and its end.

    Attributes
    ----------
    end : int
        Place in the words after it.
    each : bool
        Every one on its own ("each desk").
    """

    noun: Noun
    amount: Amount
    definite: bool
    start: int
    end: int
    each: bool = False
    refers: Literal["", "last", "others"] = ""
    bearing: Things | None = None

    @property
    def plural(self) -> bool:
        """Whether several are meant."""
        return self.noun.plural or self.amount.number > 1 or self.amount.kind in ("all", "all_but", "half")

    def things(self) -> Things:
        """Return the phrase as a description of objects."""
        noun = self.noun
        return Things(
            noun=""
            if noun.kind == "anything" and noun.words[-1:] != ("one",)
            else " ".join((*noun.words, *filter(None, [noun.number]))),
            amount=self.amount,
            definite=self.definite,
            plural=self.noun.plural and not (self.amount.number == 1 and self.amount.kind in ("some", "more")),
            colour=noun.colour,
            material=noun.material,
            states=dict(noun.states),
            ordinal=noun.ordinal,
            size=noun.size,
            hints=noun.hints if noun.kind != "room" else (),
            refers=self.refers,
            owned=noun.owned,
            bearing=self.bearing,
            each=self.each,
            place=Place(rooms=Rooms(floors=noun.floors)) if noun.floors else None,
        )

    def rooms(self) -> Rooms:
        """Return the phrase as a description of rooms."""
        noun = self.noun
        if self.refers == "last" and not noun.words and self.amount.kind == "some":
            return Rooms(same=True)
        words = " ".join((*filter(None, [noun.owned]), *noun.words, *filter(None, [noun.number])))
        words = "" if words == "room" else words
        if noun.numbers:
            base = words.removesuffix(noun.number)
            words = JOINED.join([words, *(f"{base}{number}" for number in noun.numbers)])
            return Rooms(words=words, floors=noun.floors, every=True, number=1 + len(noun.numbers))
        others = self.refers == "others"
        one = self.amount.kind == "some" and self.amount.number == 1
        several = (noun.plural and not one) or self.each or self.amount.kind == "all"
        return Rooms(
            words=words,
            floors=noun.floors,
            every=several and self.amount.kind in ("some", "all"),
            number=self.amount.number if noun.plural and self.amount.number > 1 else 0,
            ordinal=noun.ordinal,
            size=self._size_of_room(),
            others=others,
        )

    def _size_of_room(self) -> Literal["", "largest", "smallest"]:
        """Return which of several rooms is meant by its size: ``the largest office``, ``the big gym``."""
        if self.noun.size in ("largest", "smallest"):
            return self.noun.size
        told = [_ROOM_SIZES[hint] for hint in self.noun.hints if hint in _ROOM_SIZES]
        return told[0] if told and self.definite and not self.plural else ""


def noun_phrase(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> NounPhrase | None:
    """Read the noun phrase at a place; None where there is none.

    Parameters
    ----------
    floors : sequence of int
        Those of the building.
    """
    start = at
    while text_at(words, at) in ADVERBS - _IN_PHRASES:
        at += 1
    if text_at(words, at) in ("only", "just") and text_at(words, at + 1) in DETERMINERS:
        at += 1
    if at < len(words) and words[at].kind == "id":
        noun = Noun((words[at].raw,), "room" if lexicon.is_room_id(words[at].raw) else "object")
        return NounPhrase(noun, Amount(number=1), True, start, at + 1)
    if tuple(w.text for w in words[at : at + 3]) == ("every", "single", "one"):
        return None
    whatever = _whatever(words, at)
    if whatever is not None:
        return whatever
    amount, definite, each, place = read_amount(words, at)
    pronoun = _pronoun(words, start, at, place, amount)
    if pronoun is not None:
        return pronoun
    if text_at(words, place) in ("other", "rest", "remaining", "remainder"):
        others = _others(words, at, place, amount, lexicon, floors)
        if others is not None:
            return others
    storeys: tuple[int, ...] = ()
    level = read_storeys(words, place, floors)
    if level is not None and not level[1] and end_of_run(words, level[2], lexicon) > level[2]:
        storeys, place = level[0], level[2]
    end = end_of_run(words, place, lexicon)
    if end == place:
        return _bare_amount(words, start, place, amount)
    found, end = read_noun(words, place, end, lexicon)
    if found is None:
        return None
    if text_at(words, end) in ("more", "less", "fewer") and amount.kind == "some" and amount.number and not definite:
        kind: AmountKind = "more" if words[end].text == "more" else "fewer"
        return NounPhrase(
            replace(found, floors=storeys), Amount(kind=kind, number=amount.number), False, start, end + 1
        )
    noun = replace(found, floors=storeys)
    phrase = _with_what_follows(words, NounPhrase(noun, amount, definite, start, end, each=each), lexicon)
    return _with_what_it_bears(words, phrase, lexicon, floors)


def _with_what_it_bears(
    words: Sequence[Word], phrase: NounPhrase, lexicon: Lexicon, floors: Sequence[int]
) -> NounPhrase:
    """Read ``with the lamp on it`` after certain furniture, which tells one of several by what is on or in it."""
    if text_at(words, phrase.end) != "with" or not phrase.definite or phrase.noun.kind == "room":
        return phrase
    borne = noun_phrase(words, phrase.end + 1, lexicon, floors)
    if borne is None or borne.noun.kind not in ("object", "both") or borne.noun.unknown:
        return phrase
    held = (text_at(words, borne.end), text_at(words, borne.end + 1))
    if held not in (("on", "it"), ("in", "it"), ("on", "them"), ("in", "them"), ("on", "top")):
        return phrase
    return replace(phrase, bearing=borne.things(), end=borne.end + 2)


def _with_what_follows(words: Sequence[Word], phrase: NounPhrase, lexicon: Lexicon) -> NounPhrase:
    """Return a phrase with what stands after its noun: a colour, an owner, a number, an exception."""
    amount, definite = phrase.amount, phrase.definite
    found, end = _coloured(words, phrase.noun, phrase.end)
    found, end = _of_owner(words, found, end, lexicon)
    count = _number_after(words, end, plural=found.plural)
    if count is not None and amount.number in (0, 1) and not definite:
        amount, end = Amount(number=count[0]), count[1]
    whole = _whole_after(words, end)
    if whole is not None and (found.plural or amount.kind == "all"):
        amount, definite, end = whole[0], True, whole[1]
    if amount.number == 0 and amount.kind == "some" and not definite and not found.plural:
        amount = Amount(number=1)
    if definite and not amount.number and found.words[-1:] and found.words[-1] in PAIRED:
        found = replace(found, plural=True)
    if amount.kind == "all":
        amount, definite, end = _all_but(words, end, lexicon, amount, definite=definite)
    end += text_at(words, end) in ("itself", "themselves")
    if not definite and amount.kind not in ("all", "none", "all_but", "half") and _is_topic(found):
        found = replace(found, unknown=())
    more, end = _further_numbers(words, found, end, lexicon)
    return replace(phrase, noun=replace(found, numbers=more), amount=amount, definite=definite, end=end)


def _is_topic(noun: Noun) -> bool:
    """Whether the words before a noun only tell what something printed is about: ``law books``."""
    return bool(noun.unknown) and noun.words[:1] != () and noun.words[0] in PRINTED and {*noun.unknown} <= TOPICS


def _coloured(words: Sequence[Word], noun: Noun, at: int) -> tuple[Noun, int]:
    """Read ``in green colour``, ``in the colour green`` after a noun."""
    if text_at(words, at) != "in" or noun.kind == "room" or noun.colour:
        return noun, at
    place = at + 1 + (text_at(words, at + 1) in ("a", "the"))
    first, second = text_at(words, place), text_at(words, place + 1)
    if second in _COLOUR and first in COLOUR_WORDS:
        return replace(noun, colour=COLOUR_WORDS[first]), place + 2
    if first in _COLOUR and second in COLOUR_WORDS:
        return replace(noun, colour=COLOUR_WORDS[second]), place + 2
    ends = place + 1 >= len(words) or words[place + 1].kind == "mark"
    if noun.words == ("one",) and first in COLOUR_WORDS and ends:
        return replace(noun, colour=COLOUR_WORDS[first]), place + 1
    return noun, at


def _of_owner(words: Sequence[Word], noun: Noun, at: int, lexicon: Lexicon) -> tuple[Noun, int]:
    """Read ``bedroom of the parents`` as the parents' bedroom, where a room is called so."""
    if text_at(words, at) != "of" or noun.kind not in ("room", "both") or noun.owned or noun.number:
        return noun, at
    start = at + 1 + (text_at(words, at + 1) in ("the", "our", "my"))
    for end in (start + 2, start + 1):
        owner = tuple(word.text for word in words[start:end])
        if len(owner) == end - start and lexicon.is_own_room((*owner, *noun.words)):
            return replace(noun, words=(*owner, *noun.words), kind="room"), end
    return noun, at


def _further_numbers(words: Sequence[Word], noun: Noun, at: int, lexicon: Lexicon) -> tuple[tuple[str, ...], int]:
    """Read ``2 and 3`` of ``classrooms 1, 2 and 3``, ``+5`` of ``rooms 4+5``."""
    out: list[str] = []
    while noun.number and noun.plural and noun.kind in ("room", "both"):
        through = text_at(words, at) in ("to", "-", "–", "through")
        place = at + (text_at(words, at) == "," or through)
        place += text_at(words, place) in ("and", "&", "+")
        if place == at or place >= len(words) or not (words[place].kind == "code" or words[place].raw.isdecimal()):
            break
        following = words[place + 1] if place + 1 < len(words) else None
        if following is not None and (following.kind == "unit" or lexicon.is_object((following.text,))):
            break
        if through and noun.number.isdecimal() and words[place].raw.isdecimal():
            out += [str(number) for number in range(int((out or [noun.number])[-1]) + 1, int(words[place].raw))][:40]
        out.append(words[place].raw)
        at = place + 1
    return tuple(out), at


def _pronoun(words: Sequence[Word], start: int, at: int, place: int, amount: Amount) -> NounPhrase | None:
    """Read ``it``, ``two of them``, ``these``; an amount was read up to `place`."""
    if text_at(words, place) in ("it", "them", "they", "those", "these") and place <= at + 2:
        noun = Noun((), "anything", plural=words[place].text != "it")
        whole = text_at(words, place + 1) in ("all", "both") and text_at(words, place + 2) in PREPOSITIONS | {""}
        if whole and noun.plural and not amount.number:  # "put them all in the box"
            number = 2 if words[place + 1].text == "both" else 0
            amount, place = Amount(kind="all", number=number, of=number), place + 1
        return NounPhrase(noun, amount, True, start, place + 1, refers="last")
    if place != at + 1 or words[at].text not in BARE_PRONOUNS:
        return None
    bare = place >= len(words) or not words[place].text[:1].isalpha() or words[place].text in ENDS_RUN
    if not bare or text_at(words, place) == "with":
        return None
    noun = Noun((), "anything", plural=words[at].text in ("these", "those", "both", "all"))
    return NounPhrase(noun, amount, True, start, place, refers="last")


def _whatever(words: Sequence[Word], at: int) -> NounPhrase | None:
    """Read ``whatever stands open``, ``everything that is on``."""
    place = at + 1
    if text_at(words, at) not in ("whatever", "everything", "anything", "all"):
        return None
    relative = text_at(words, place) in ("that", "which")
    contracted = relative and words[place].raw in ("that's", "which's")
    place += relative
    if text_at(words, place) not in ("is", "are", "stand", "remain", "stay") and not contracted:
        return None
    place += not contracted
    place += text_at(words, place) in ("still", "switched", "turned", "left", "currently")
    if text_at(words, place) not in STATE_WORDS:
        return None
    name, value = STATE_WORDS[text_at(words, place)]
    if name == "on" and place + 1 < len(words) and words[place + 1].text in ("the", "a", "my"):
        return None
    noun = Noun((), "anything", plural=True, states={name: value})
    return NounPhrase(noun, Amount(kind="all", number=0), True, at, place + 1)


def _bare_amount(words: Sequence[Word], start: int, place: int, amount: Amount) -> NounPhrase | None:
    """Read an amount without a noun: ``one more``, ``two``, ``none``."""
    counted = place > start and (amount.kind == "more" or words[place - 1].kind == "number")
    of_them = amount.kind == "all_but" and text_at(words, place - 1) == "them"
    if not (counted or of_them):
        return None
    if amount.kind == "all_but":
        return NounPhrase(Noun((), "anything", plural=True), amount, True, start, place, refers="last")
    if text_at(words, place - 1) == "one" and text_at(words, place - 2) in ("the", "that", "this"):
        return NounPhrase(Noun(("one",), "anything"), Amount(number=0), True, start, place)
    return NounPhrase(Noun((), "anything"), amount, amount.of > 0, start, place, refers="last")


def _number_after(words: Sequence[Word], at: int, *, plural: bool) -> tuple[int, int] | None:
    """Read ``x3``, ``(4)`` after a noun, and ``, three of them`` after one in the plural."""
    if text_at(words, at) == "x" and number_at(words, at + 1) is not None:
        return int(words[at + 1].value), at + 2
    if text_at(words, at) == "(" and number_at(words, at + 1) is not None and text_at(words, at + 2) == ")":
        return int(words[at + 1].value), at + 3
    place = at + (text_at(words, at) == ",")
    number = number_at(words, place)
    if (
        plural
        and number is not None
        and text_at(words, place + 1) == "of"
        and text_at(words, place + 2) in ("them", "those", "these")
    ):
        return number, place + 3
    return None


def _all_but(
    words: Sequence[Word], at: int, lexicon: Lexicon, amount: Amount, *, definite: bool
) -> tuple[Amount, bool, int]:
    """Read ``but two``, ``except for one`` after a noun of which all are meant."""
    if text_at(words, at) not in ("but", "except"):
        return amount, definite, at
    place = at + 1 + (text_at(words, at + 1) == "for")
    number = number_at(words, place)
    if number is None or end_of_run(words, place + 1, lexicon) > place + 1 or text_at(words, place + 1) == "of":
        return amount, definite, at
    return Amount(kind="all_but", number=number), True, place + 1


def _whole_after(words: Sequence[Word], at: int) -> tuple[Amount, int] | None:
    """Read ``, all three of them,`` and ``- both`` after a noun in the plural."""
    place = at + (text_at(words, at) in (",", "-", "("))
    if place == at or text_at(words, place) not in ("all", "both"):
        return None
    number = 2 if words[place].text == "both" else number_at(words, place + 1)
    end = place + 1 + (number is not None and words[place].text != "both")
    if text_at(words, end) == "of" and text_at(words, end + 1) in ("them", "these", "those"):
        end += 2
    if end < len(words) and words[end].kind != "mark":
        return None
    end += text_at(words, end) == ")" or (
        text_at(words, end) in (",", "-") and text_at(words, end + 1) in ("from", "in", "on", "at", "of", "out", "off")
    )
    return Amount(kind="all", number=number or 0, of=number or 0), end


def _others(
    words: Sequence[Word], start: int, place: int, amount: Amount, lexicon: Lexicon, floors: Sequence[int]
) -> NounPhrase | None:
    """Read ``the other two chairs``, ``the others``, ``the rest of the mugs``, ``the remaining desk``."""
    end = place + 1
    if text_at(words, end) == "one":
        end += 1
    number = number_at(words, end)
    if number is not None:
        amount, end = Amount(number=number), end + 1
    while text_at(words, end) in ("of", "the"):
        end += 1
    stop = end_of_run(words, end, lexicon)
    plural = words[place].plural or words[place].text in ("rest", "remaining", "remainder") or (number or 0) > 1
    if stop == end:
        kind: AmountKind = "all" if plural and number is None else amount.kind
        noun = Noun((), "anything", plural=plural)
        return NounPhrase(noun, Amount(kind=kind, number=amount.number), True, start, end, refers="others")
    found, stop = read_noun(words, end, stop, lexicon)
    if found is None:
        return None
    if number is None and found.plural:
        amount = Amount(kind="all", number=0)
    return NounPhrase(found, amount, True, start, stop, refers="others")
