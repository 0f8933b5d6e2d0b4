"""What becomes of rooms and tables as wholes: names, finishes, what alone is left in them, a laid table."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.pairs.wording import (
    SURFACES,
    Joined,
    names_only_room,
    said_in,
    texts_of,
    with_the,
)
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import singular

__all__ = ["given_finishes", "left_only", "lined_with", "made_of", "renamed_in_turn", "table_laid", "told_in_detail"]

_ELABORATED: Final = frozenset(
    "warm fold make turn prepare freshen rearrange change decorate brighten dress refresh organise organize update do "
    "improve cheer liven ready fix arrange furnish set".split()
)
"""Verbs of what a colon tells in detail: ``warm the kitchen: ...``."""


def told_in_detail(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``in the kitchen`` for ``warm the kitchen:``, of which what follows tells all."""
    clause = clauses[at]
    said = said_in(clause, words)
    colon = clause.end < len(words) and words[clause.end].text == ":" and at + 1 < len(clauses)
    if not colon or clause.form != "order" or said[0].verb not in _ELABORATED:
        return None
    start = 1 + (said[1].tag == "preposition")
    end = end_of_noun_group(said, start)
    idle = all(
        word.tag in ("adverb", "adjective", "determiner", "preposition") or word.text == "bit" for word in said[end:]
    )
    room = tuple(singular(word.text) for word in said[start:end] if word.tag in ("noun", "number"))
    if not room or not idle or not lexicon.is_own_room(room):
        return None
    return at + 1, f"in {with_the(said[start:end])}"


def lined_with(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``put two benches along the wall in the hall`` for ``line the hall with two benches along the wall``."""
    said = said_in(clauses[at], words)
    if clauses[at].form != "order" or said[0].verb not in ("line", "dress", "ring"):
        return None
    joint = end_of_noun_group(said, 1)
    if joint >= len(said) - 1 or said[joint].text != "with" or end_of_noun_group(said, joint + 1) == joint + 1:
        return None
    return at + 1, f"put {joined(said[joint + 1 :])} in {joined(said[1:joint])}"


def left_only(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``remove everything from the hall except the bench`` for ``leave only the bench in the hall``."""
    said = said_in(clauses[at], words)
    stays = next((k for k in range(2, len(said) - 1) if said[k].verb in ("stay", "remain")), 0)
    if said[0].text == "only" and stays and said[stays - 1].tag == "modal" and said[stays + 1].text in ("in", "on"):
        where = joined(said[stays + 2 :])
        named = names_something(said[stays + 2 :], lexicon) and names_something(said[1 : stays - 1], lexicon)
        return (at + 1, f"remove everything from {where} except {joined(said[1 : stays - 1])}") if named else None
    if clauses[at].form != "order" or texts_of(said[:2]) not in (["leave", "only"], ["keep", "only"]):
        return None
    place = next((k for k in range(3, len(said)) if said[k].text in ("in", "on")), 0)
    if not place or not names_something(said[place:], lexicon):
        return None
    return at + 1, f"remove everything from {joined(said[place + 1 :])} except {joined(said[2:place])}"


_COVERS: Final = ("plates", "forks", "knives", "glasses")
"""What a table is laid with for each person."""

_NAME: Final = r"[A-Z][\w' -]*?"

_RENAMED: Final = re.compile(
    rf"rename (.+?) (\d+)(?: ?(?:to|-) ?)(\d+) (?:to |as |into )?({_NAME}(?:, {_NAME})+(?:,? and {_NAME})?)"
    r"(?:,? (?:in that order|in this order|respectively))?$"
)


def renamed_in_turn(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``rename room 1 to North and rename room 2 to South`` for ``rename rooms 1 to 2 North, South``."""
    if words[clauses[at].start].text != "rename":
        return None
    last = max(k for k, one in enumerate(clauses) if one.sentence == clauses[at].sentence)
    first, *rest = words[clauses[at].start : clauses[last].end]
    found = _RENAMED.match(joined([replace(first, raw="rename"), *rest]))
    if found is None:
        return None
    names = re.split(r",? and |, ", found[4])
    numbers = range(int(found[2]), int(found[3]) + 1)
    if len(names) != len(numbers):
        return None
    room = singular(found[1].split()[-1])
    kind = " ".join([*found[1].split()[:-1], room])
    orders = [f'rename {kind} {number} to "{name}"' for number, name in zip(numbers, names, strict=True)]
    return last + 1, " and ".join(orders)


def made_of(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``change the floor of hall 1 to white tile`` for ``make hall 1's floor white tile``."""
    said = said_in(clauses[at], words)
    part = next((k for k in range(2, len(said) - 1) if singular(said[k].text) in SURFACES), 0)
    if clauses[at].form != "order" or said[0].verb != "make" or not part:
        return None
    room = joined(said[1:part])
    owned = room.removesuffix("'s")
    if owned == room or not lexicon.is_room(
        tuple(singular(w) for w in owned.lower().split() if not w.isdecimal() and w != "the")
    ):
        return None
    look = [word for word in said[part + 1 :] if word.tag != "preposition"]
    return at + 1, f"change the {SURFACES[singular(said[part].text)]} of {owned} to {joined(look)}"


def table_laid(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``there should be four plates, four forks, ... on the table`` for ``lay the table for four``."""
    said = said_in(clauses[at], words)
    persons = next((k for k in range(2, len(said) - 1) if said[k].text == "for" and said[k + 1].tag == "number"), 0)
    laying = clauses[at].form == "order" and said[0].verb in ("lay", "set") and said[1].text in ("the", "our", "my")
    colon = clauses[at].end < len(words) and words[clauses[at].end].text in (":", "-")
    table = end_of_noun_group(said, 1)
    if (
        not (laying and persons)
        or colon
        or singular(said[table - 1].text) != "table"
        or said[table - 1].text == "tables"
    ):
        return None
    after = persons + 2 + (persons + 2 < len(said) and said[persons + 2].text in ("people", "persons", "guests"))
    if any(word.tag != "preposition" for word in said[after : after + 1]) or (
        names_something(said[after:], lexicon) and said[after].text not in ("in", "at")
    ):
        return None
    number = said[persons + 1].text
    covers = [f"{number} {cover}" if number not in ("one", "1") else f"one {singular(cover)}" for cover in _COVERS]
    where = joined([*said[1:persons], *said[after:]])
    return at + 1, f"there should be {', '.join(covers[:-1])} and {covers[-1]} on {where}"


def given_finishes(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``make the floor of the hall wooden and paint the walls white`` for ``give the hall a wooden floor ...``."""
    said = said_in(clauses[at], words)
    end = end_of_noun_group(said, 1)
    if clauses[at].form != "order" or said[0].verb != "give" or not names_only_room(said[1:end], lexicon):
        return None
    out: list[str] = []
    start = end
    while start < len(said):
        stop = next((k for k in range(start, len(said)) if singular(said[k].text) in SURFACES), 0)
        look = [word for word in said[start:stop] if word.tag not in ("determiner", "joint", "mark")]
        if not stop or not look:
            return None
        part = SURFACES[singular(said[stop].text)]
        room = joined(said[1:end])
        colour = part == "walls" or look[-1].text in COLOUR_WORDS
        way = (
            f"paint the {part} of {room} {joined(look)}" if colour else f"change the {part} of {room} to {joined(look)}"
        )
        out.append(way)
        start = stop + 1
    return (at + 1, " and ".join(out)) if out else None
