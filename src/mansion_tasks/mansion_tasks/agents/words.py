"""How well a noun of an instruction names a category or a room."""

from typing import Final

from mansion_tasks.words.nouns import singular
from mansion_tasks.words.things import ROOMS, THINGS

__all__ = ["match_score", "matches"]

_GROUPS: Final = {word: group.same + group.talk for group in (*THINGS, *ROOMS) for word in group.same + group.talk}


def match_score(noun: str, name: str) -> int:
    """Return how well a noun names a category or a room.

    Returns
    -------
    int
        3: with the same or an equal word, and number. 2: the name is of a kind of the noun, or lacks the number ("1" is
        understood). 1: the noun is of a kind of the name. 0: not at all.

    Examples
    --------
    >>> match_score("couch", "sofa"), match_score("table", "dining_table"), match_score("pen", "open_shelf")
    (3, 2, 0)
    >>> match_score("round table", "table"), match_score("office 2", "office_3"), match_score("hall 1", "hall")
    (1, 0, 2)
    """
    wanted, known = _plain(noun), _plain(name)
    asked, given = _number(noun), _number(name)
    if not wanted or not known or (asked and asked != (given or "1")):
        return 0
    if any(a == b for a in _spellings(wanted) for b in _spellings(known)):
        return 3 if asked in ("", given) else 2
    if any(f" {known}".endswith(f" {a}") for a in _spellings(wanted)):
        return 2
    return int(any(f" {wanted}".endswith(f" {b}") for b in _spellings(known)))


def matches(noun: str, name: str) -> bool:
    """Whether a noun may name a category or a room."""
    return match_score(noun, name) > 0


def _plain(text: str) -> str:
    words = text.casefold().replace("_", " ").replace("-", " ").split()
    while words and words[-1].isdigit():
        words.pop()
    return " ".join([*words[:-1], singular(words[-1])]) if words else ""


def _number(text: str) -> str:
    """Return the number that a name ends with, empty for none."""
    last = text.replace("_", " ").split()[-1:]
    return last[0] if last and last[0].isdigit() else ""


def _spellings(text: str) -> tuple[str, ...]:
    """Return a noun, its joined spelling, and its synonyms."""
    joined = text.replace(" ", "")
    return tuple(dict.fromkeys((text, joined, *_GROUPS.get(text, ()))))
