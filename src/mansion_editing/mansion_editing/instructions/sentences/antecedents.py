"""What words that take up an earlier clause stand for: owners, former places, rooms, lists, one or all of several."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.each_other import EACH_OTHER
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.noun_phrases import noun_phrase
from mansion_editing.instructions.phrases.places import merged, with_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.words import (
    DETERMINERS,
    FUNCTION_WORDS,
    PLURAL_PRONOUNS,
    PREPOSITIONS,
    Word,
    text_at,
)
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ensure,
    Finish,
    Furnish,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Rename,
    Rooms,
    SetState,
    Statement,
    Surface,
    Things,
)

__all__ = [
    "about_its_room",
    "brought_together",
    "listed_in",
    "owners_named",
    "painted_rooms",
    "with_former_places",
    "with_list_for_pronoun",
    "with_states_of_each",
    "with_those_taken",
]

_OPENING: Final = frozenset("door lid doors".split())


def owners_named(words: Sequence[Word], lexicon: Lexicon) -> list[Word]:
    """Return words with the owner for a pronoun: the mayor's for ``his office``, the umbrella's for ``its stand``."""
    out: list[Word] = []
    for at, word in enumerate(words):
        following = words[at + 1].text if at + 1 < len(words) else ""
        if word.text in _OPENING and out and out[-1].text in ("its", "their"):
            it = "it" if out[-1].text == "its" else "them"
            out[-1] = Word(it, it, "word", out[-1].start, word.end)  # "leave its door open"
            continue
        if word.text in ("its", "their") and following in _OPENING:
            out.append(word)
            continue
        if word.text in ("his", "her", "their", "its") and following:
            owner = next((w for w in reversed(out) if _owns(w, following, lexicon)), None)
            owner = None if out and out[-1].text == "and" and word.text in ("its", "their") else owner
            if owner is None and word.text == "its":
                word = Word("the", word.raw, "word", word.start, word.end)
            if owner is not None:
                out.append(Word("the", "the", "word", word.start, word.start))
                word = Word(owner.text, owner.raw, "word", word.start, word.end)
        out.append(word)
    return out


def _owns(owner: Word, noun: str, lexicon: Lexicon) -> bool:
    """Whether two words make the name of a room of the building, or of an object that no room owns."""
    if owner.kind != "word" or owner.text in FUNCTION_WORDS:
        return False
    pair = (owner.text, noun)
    thing = lexicon.is_object(pair) and lexicon.is_here(" ".join(pair)) and not lexicon.is_own_room((owner.text,))
    return thing or lexicon.is_own_room(pair)


_HAVING_BEEN: Final = (("used", "to", "be"), ("used", "to", "stand"), ("used", "to", "lie"), ("has", "been"),
                       ("had", "been"), ("was",), ("were",), ("stood",), ("lay",), ("hung",), ("sat",))  # fmt: skip
_FOLLOWED: Final = frozenset(["", ",", ".", "and", "before", "until", "now", "please"])
_LONGEST: Final = 4
"""Words of a name."""


def with_former_places(words: Sequence[Word], reader: ClauseReader) -> Sequence[Word]:
    """Return words with the furniture that something was told to come from for ``where it used to be``.

    Parameters
    ----------
    reader : ClauseReader
        Of the words.
    """
    for at in range(1, len(words)):
        found = _told_at(words, at) if words[at].text == "where" else None
        if found is None:
            continue
        name, end = found
        source = _source_of(words[:at], name, reader)
        if source:
            where, stop = words[at].start, words[end - 1].end
            placed = [replace(word, start=where, end=stop) for word in source]
            return [*words[:at], *placed, *words[end:]]
    return words


def _told_at(words: Sequence[Word], at: int) -> tuple[tuple[str, ...], int] | None:
    """Return the name of ``where the laptop used to be`` with the end of these words; None for others."""
    if text_at(words, at + 1) not in DETERMINERS:
        return None
    for verb in range(at + 3, at + 3 + _LONGEST):
        said = next((v for v in _HAVING_BEEN if tuple(w.raw for w in words[verb : verb + len(v)]) == v), ())
        end = verb + len(said)
        if said and text_at(words, end) in _FOLLOWED:
            end += text_at(words, end) in ("before", "until")
            return tuple(word.text for word in words[at + 2 : verb]), end
    return None


def _source_of(words: Sequence[Word], name: tuple[str, ...], reader: ClauseReader) -> list[Word]:
    """Return ``on the desk`` for the one place from which a thing of this name was told to go; else no words."""
    found: list[list[Word]] = []
    for at in range(len(words)):
        item = reader.item(at) if words[at].text in DETERMINERS else None
        if item is None or item.phrase.noun.words != name:
            continue
        read = next((place for place in item.places if place.source and place.place.anchor is not None), None)
        start = 0 if read is None else next((k for k in range(read.start, read.end) if words[k].text in DETERMINERS), 0)
        if read is not None and start:
            joint = "in" if read.place.relation == "in" else "on"
            found.append([replace(words[read.start], text=joint, raw=joint), *words[start : read.end]])
    return found[0] if len(found) == 1 else []


def about_its_room(told: Mention, words: Sequence[Word], lexicon: Lexicon, floors: Sequence[int]) -> Mention:
    """Return what is only told with the one room of the building that its words name, if they name just one.

    Parameters
    ----------
    words : sequence of Word
        Those of its quote.
    """
    if told.rooms is not None:
        return told
    named: list[Rooms] = []
    at = 0
    while at < len(words):
        phrase = noun_phrase(words, at, lexicon, floors)
        if phrase is None or phrase.end <= at:
            at += 1
            continue
        noun = phrase.noun
        if (
            noun.kind == "room"
            and not noun.unknown
            and lexicon.is_own_room((*noun.words, *filter(None, [noun.number])))
        ):
            named.append(phrase.rooms())
        at = phrase.end
    one = named[0] if len({msgspec.json.encode(rooms) for rooms in named}) == 1 else None
    return told if one is None or one.every or one.number > 1 else msgspec.structs.replace(told, rooms=one)


def painted_rooms(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which ``paint it`` right after words about one room means its walls."""
    out: list[Statement] = []
    for statement in statements:
        last = next((one for one in reversed(out) if not isinstance(one, Mention)), None)
        room = _room_of(last)
        bare = isinstance(statement, Paint) and statement.things.refers == "last" and not statement.things.noun
        if room is not None and bare and isinstance(statement, Paint) and statement.things.place is None:
            part: Surface = "walls"
            out.append(
                Finish(
                    rooms=room, part=part, colour=statement.colour, material=statement.material, quote=statement.quote
                )
            )
        else:
            out.append(statement)
    return out


def _room_of(statement: Statement | None) -> Rooms | None:
    """Return the room that a statement is about; None for statements about things."""
    if isinstance(statement, Rename):
        return statement.room
    return statement.rooms if isinstance(statement, Finish | Furnish) else None


def with_states_of_each(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which a state that is told right after things at each of several places is that of all."""
    out: list[Statement] = []
    for statement in statements:
        last = out[-1] if out else None
        several = isinstance(last, Add | Ensure) and (last.each or last.things.amount.number > 1)
        if several and isinstance(statement, SetState) and statement.things.refers == "last":
            bare = not statement.things.noun and not statement.things.amount.number
            them = msgspec.structs.replace(statement.things, plural=True, amount=Amount(kind="all", number=0))
            statement = msgspec.structs.replace(statement, things=them) if bare else statement
        out.append(statement)
    return out


_TAKING: Final = re.compile(r"(?:and |so |please |then )*(?:take|use|choose|pick) the ones?\b", re.IGNORECASE)


def with_those_taken(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which ``take the one from the counter`` tells which thing moves, and removes nothing."""
    out: list[Statement] = []
    for statement in statements:
        at = next((k for k in range(len(out) - 1, -1, -1) if not isinstance(out[k], Mention)), -1)
        last = out[at] if at >= 0 else None
        told = isinstance(statement, Remove) and statement.things.place is not None
        if isinstance(last, Move) and isinstance(statement, Remove) and told and _names_one_of(statement, last):
            place = statement.things.place or Place()
            things = with_place(msgspec.structs.replace(last.things, place=None), place)
            out[at] = msgspec.structs.replace(last, things=things)
        else:
            out.append(statement)
    return out


def _names_one_of(statement: Remove, last: Move) -> bool:
    same = statement.things.noun == last.things.noun and bool(last.things.noun)
    return same and _TAKING.match(statement.quote) is not None


_THEM = Things(refers="last", definite=True, plural=True, amount=Amount(number=0))


def brought_together(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which what goes ``on the bed next to each other`` goes there and is then put together."""
    out: list[Statement] = []
    for statement in statements:
        place = statement.place if isinstance(statement, Add | Ensure | Move) else Place()
        anchor = place.anchor
        there = None if anchor is None or anchor.noun != EACH_OTHER.noun else anchor.place
        if there is None or not isinstance(statement, Add | Ensure | Move):
            out.append(statement)
            continue
        goal = there if place.rooms is None else merged(there, Place(rooms=place.rooms))
        together = Place(relation="beside", anchor=EACH_OTHER)
        out += [
            msgspec.structs.replace(statement, place=goal),
            Move(things=_THEM, place=together, quote=statement.quote),
        ]
    return out


_JOINTS: Final = frozenset(["and", ","])


def listed_in(reader: ClauseReader) -> Sequence[Word]:
    """Return the words of the first list of definite things in a clause; empty where it names fewer than two."""
    for at in range(len(reader.words)):
        try:
            items = reader.subjects(at) or (reader.items(at) if reader.item(at) is not None else [])
        except NotUnderstood:
            continue
        if len(items) > 1 and all(_is_listed(item) for item in items):
            return reader.words[at : items[-1].end]
    return ()


def _is_listed(item: Item) -> bool:
    phrase = item.phrase
    return not item.is_room and phrase.definite and bool(phrase.noun.words) and not phrase.refers


def with_list_for_pronoun(words: Sequence[Word], told: Sequence[Word], reader: ClauseReader) -> Sequence[Word]:
    """Return a clause with a list in place of its first pronoun; the clause itself where it names a thing before that.

    Parameters
    ----------
    told : sequence of Word
        The list.
    reader : ClauseReader
        Of the clause.
    """
    at = next((k for k, word in enumerate(words) if _stands_alone(words, k) and word.text in PLURAL_PRONOUNS), -1)
    start = reader.skip(0)
    verb = verb_at(words, start, reader.lexicon)
    first = start if verb is None else verb[1]
    if at < 0 or any(_names_thing(reader, k) for k in range(first, at)):
        return words
    end = at + 1
    if words[at].text == "both" and text_at(words, end) == "of" and text_at(words, end + 1) in PLURAL_PRONOUNS:
        end += 2
    where, stop = words[at].start, words[end - 1].end
    return [*words[:at], *(replace(word, start=where, end=stop) for word in told), *words[end:]]


def _stands_alone(words: Sequence[Word], at: int) -> bool:
    following = words[at + 1] if at + 1 < len(words) else None
    ends = following is None or following.kind == "mark" or following.text in PREPOSITIONS | {"and", "away", "there"}
    return ends or words[at].text in ("them", "they")


def _names_thing(reader: ClauseReader, at: int) -> bool:
    phrase = reader.phrase(at)
    return phrase is not None and phrase.noun.kind == "object" and bool(phrase.noun.words) and not phrase.noun.unknown
