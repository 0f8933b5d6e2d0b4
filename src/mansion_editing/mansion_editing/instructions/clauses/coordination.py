"""Lists of things that run on into the next clause: ``switch on A, B and C stay off`` asks for A alone."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Final

from mansion_editing.instructions.clauses.items import Item
from mansion_editing.instructions.phrases.words import Word

__all__ = ["first_subject", "is_for_one", "is_one_list"]

_LEAST_LEAD: Final = 2
"""By how much the best way to part a list must be better than the next one."""
_NUMBERED: Final = frozenset("is are stay remain need has have go get belong lack want was were keep".split())
"""Verbs whose form tells whether one thing or several are their subject."""


def _joints_of(words: Sequence[Word], items: Sequence[Item]) -> list[str]:
    """Return what stands between each two items of a list: ``,``, ``and`` or ``, and``."""
    between = [words[one.end : other.phrase.start] for one, other in pairwise(items)]
    return [" ".join(word.text for word in part if word.text in (",", "and", "or", "&", "plus")) for part in between]


def first_subject(words: Sequence[Word], items: Sequence[Item]) -> int | None:
    """Return which of some items is the first subject of the clause that follows the last of them.

    Those before it are objects of the verb before the list. A list before ``stay`` may be parted at any of its
    commas and conjunctions; the parts must be lists of their own, and agree with the verb.

    Returns
    -------
    int or None
        None where the words can be parted in two ways that are as good.
    """
    joints = _joints_of(words, items)
    verb = words[items[-1].end] if items[-1].end < len(words) else None
    faults = {
        at: _faults(items, joints, at, verb) for at in range(1, len(items)) if _may_begin(items, joints, at, verb)
    }
    if not faults:
        return len(items) - 1
    best, *others = sorted(faults, key=lambda at: faults[at])
    if others and faults[others[0]] < faults[best] + _LEAST_LEAD:
        return None
    return best


def is_one_list(words: Sequence[Word], items: Sequence[Item]) -> bool:
    """Whether items are one list of their own: all of a kind, commas first and a conjunction before the last."""
    joints = _joints_of(words, items)
    alike = len({_is_known(item) for item in items}) == 1
    return alike and all(joint == "," for joint in joints[:-1]) and (not joints or joints[-1] not in (",", ""))


def _may_begin(items: Sequence[Item], joints: Sequence[str], at: int, verb: Word | None) -> bool:
    """Whether the items from one on can be the subject of a verb."""
    if at == len(items) - 1:
        return True
    if joints[-1] == "," or is_for_one(verb):
        return False
    directed = any(place.goal or place.source for item in items[at:-1] for place in item.places)
    return not directed and all(_is_known(item) == _is_known(items[-1]) for item in items[at:])


def _faults(items: Sequence[Item], joints: Sequence[str], at: int, verb: Word | None) -> int:
    """Return how unlikely it is that a clause begins with an item."""
    commas = any("," in joint for joint in joints)
    found = 2 if commas and "," not in joints[at - 1] else 0
    found += at > 1 and joints[at - 2] == ","
    several = verb is not None and verb.text in _NUMBERED and not is_for_one(verb)
    found += at == len(items) - 1 and several and not items[-1].phrase.plural
    placed = any(item.places for item in items[at:-1]) and not any(item.places for item in items[:at])
    return found + placed


def is_for_one(verb: Word | None) -> bool:
    """Whether a verb's form has one thing as its subject: ``stays``, ``is``."""
    return verb is not None and verb.text in _NUMBERED and verb.raw.endswith("s")


def _is_known(item: Item) -> bool:
    """Whether an item is there already, rather than something new."""
    phrase = item.phrase
    return phrase.definite or bool(phrase.refers) or item.is_room or phrase.amount.kind == "all"
