"""Pronouns for a list of things that the clause before told of: ``The bike and the ladder are sold, take them out``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.words import PLURAL_PRONOUNS, PREPOSITIONS, Word, text_at

__all__ = ["listed_in", "with_list_for_pronoun"]

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
