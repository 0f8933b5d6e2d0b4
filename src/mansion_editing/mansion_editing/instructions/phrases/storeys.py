"""Storeys in an instruction, ``the second floor``, ``4F``, ``upstairs``, ``one flight up``, and where counts begin."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.amounts import number_at
from mansion_editing.instructions.phrases.word_sets import BEFORE_STOREYS
from mansion_editing.instructions.phrases.words import BE, MODALS, PREPOSITIONS, Word, text_at

__all__ = [
    "RelativeStorey",
    "Storeys",
    "counted_from_ground",
    "counts_above_ground",
    "read_relative_storey",
    "read_storeys",
]

Storeys = tuple[tuple[int, ...], bool, int]
"""Their numbers, whether every one of them is meant on its own, and the place in the words after them."""

_NAMED: Final = frozenset(["ground", "entrance", "street"])
_LOWEST: Final = frozenset(["lowest", "bottom", "lower"])
_HIGHEST: Final = frozenset(["top", "topmost", "uppermost", "highest", "last", "upper"])
_ABOVE: Final = frozenset(["upstairs"])
_AFTER_STOREYS: Final = BE | MODALS | frozenset(["too", "please", "has", "have", "need"])
_BELOW: Final = frozenset(["basement", "cellar"])


def read_storeys(words: Sequence[Word], at: int, floors: Sequence[int]) -> Storeys | None:
    """Return the storeys that the words at a place name, None where they name none.

    Parameters
    ----------
    floors : sequence of int
        Those of the building, ascending; the ground floor is 1.

    Notes
    -----
    A number counts from the ground floor: ``second floor`` is 2. A storey that the building lacks is returned as it is
    named, so that the answer can say so.
    """
    place = at
    every = False
    while place < len(words) and words[place].text in BEFORE_STOREYS:
        every = every or words[place].text in ("all", "both", "each", "every")
        place += 1
    if place >= len(words):
        return None
    word = words[place]
    bare = _bare_numbers(words, at, floors) if place == at else ()
    if bare:
        return bare, len(bare) > 1, at + 2 * len(bare) - 1
    if word.kind == "level":
        return (int(word.value),), False, place + 1
    if word.text == "floor":
        return _after_noun(words, place, floors, every=every)
    if word.text in _ABOVE:
        return tuple(f for f in floors if f > 1)[: 1 if len(floors) < 3 else None] or (2,), False, place + 1
    if word.text == "downstairs":
        return (1,), False, place + 1
    if word.text in _BELOW:
        own = tuple(f for f in floors if f < 1)[-1:] or (0,)
        return own, False, place + 1 + _is(words, place + 1, "floor")
    return _before_noun(words, place, at, floors, every=every)


def _bare_numbers(words: Sequence[Word], at: int, floors: Sequence[int]) -> tuple[int, ...]:
    """Return the storeys of ``on 2``, ``on two and three`` where the phrase ends with them; none for other words."""
    if at == 0 or words[at - 1].text != "on":
        return ()
    found: list[int] = []
    place = at
    while place < len(words) and words[place].kind == "number" and words[place].value in floors:
        found.append(int(words[place].value))
        if not (_is(words, place + 1, "and") and place + 2 < len(words) and words[place + 2].kind == "number"):
            break
        place += 2
    ends = place + 1 >= len(words) or words[place + 1].kind == "mark" or words[place + 1].text in _AFTER_STOREYS
    return tuple(found) if ends and found else ()


def _is(words: Sequence[Word], at: int, text: str) -> bool:
    return at < len(words) and words[at].text == text


def _after_noun(words: Sequence[Word], place: int, floors: Sequence[int], *, every: bool) -> Storeys | None:
    """Read ``floor 2``, ``floors 1, 2 and 3``, ``floors 1 to 3``, ``every floor``."""
    numbers: list[int] = []
    end = place + 1
    if _is(words, end, "number") or _is(words, end, "no"):
        end += 1
    while end < len(words):
        word = words[end]
        if word.kind == "number" and word.value == int(word.value):
            if numbers and words[end - 1].kind == "number":
                break
            through = end > 0 and words[end - 1].text in ("to", "–", "-", "through") and bool(numbers)
            low = numbers[-1] + 1 if through else int(word.value)
            numbers += range(low, int(word.value) + 1) if through else [low]
            end += 1
        elif numbers and word.text in (",", "and", "to", "–", "through", "&") and _number_at(words, end + 1):
            end += 1
        else:
            break
    if numbers:
        return tuple(dict.fromkeys(numbers[:40])), len(numbers) > 1, end
    plural = words[place].plural
    return (tuple(floors), True, place + 1) if every and (plural or every) else None


def _number_at(words: Sequence[Word], at: int) -> bool:
    if not (at < len(words) and words[at].kind == "number"):
        return False
    following = words[at + 1].text if at + 1 < len(words) else ""
    return following == "" or not following.isalpha() or following in PREPOSITIONS or following in ("and", "to", "is")


def _before_noun(
    words: Sequence[Word], place: int, start: int, floors: Sequence[int], *, every: bool
) -> Storeys | None:
    """Read ``second floor``, ``the top two floors``, ``first and second floor``, and ``the fifth`` alone."""
    if words[place].text in ("middle", "mid") and _is(words, place + 1, "floor") and len(floors) % 2:
        return (floors[len(floors) // 2],), False, place + 2
    found: list[int] = []
    end = place
    while end < len(words):
        number = _ordinal(words[end], floors)
        if number is None:
            break
        found.append(number)
        end += 1
        if end < len(words) and words[end].text in ("and", ",", "&", "or"):
            later = end + 1 + _is(words, end + 1, "the")
            if later < len(words) and _ordinal(words[later], floors) is not None:
                end = later
                continue
        break
    if not found:
        return None
    if _is(words, end, "floor"):
        plural = words[end].plural and words[place].text == "upper"
        chosen = [f for f in floors if f > 1] if plural else found
        return tuple(chosen), len(chosen) > 1, end + 1
    alone = end >= len(words) or not words[end].text[:1].isalpha() or words[end].text in PREPOSITIONS
    ordinal = words[place].kind == "ordinal" and start < place and words[place - 1].text == "the"
    joined = end < len(words) and words[end].text in ("and", "is", "has")
    if (alone or joined) and ordinal and start > 0 and words[start - 1].text in ("on", "from", "to", "at"):
        return tuple(found), every, end
    if words[place].text == "ground" and alone and start > 0 and words[start - 1].text in ("at", "from"):
        return (1,), False, end
    return None


def _ordinal(word: Word, floors: Sequence[int]) -> int | None:
    if word.kind == "ordinal" and word.value == int(word.value):
        return int(word.value)
    if word.text in _NAMED:
        return 1
    if word.text in _LOWEST:
        return floors[0]
    if word.text in _HIGHEST:
        return floors[-1]
    return None


RelativeStorey = tuple[int, int]
"""How many storeys up, and the place in the words after them."""

_STEPS: Final = frozenset(["flight", "floor", "level", "storey", "story"])
_UP: Final = {"up": 1, "higher": 1, "above": 1, "upstairs": 1, "down": -1, "lower": -1, "below": -1, "downstairs": -1}
_AHEAD: Final = {"up": 1, "down": -1}


def read_relative_storey(words: Sequence[Word], at: int) -> RelativeStorey | None:
    """Read storeys that are counted from elsewhere; None where the words at a place are none."""
    place = at + (text_at(words, at) in ("on", "at") and text_at(words, at + 1) in ("the", "next"))
    if text_at(words, place) in _AHEAD:
        steps = _steps(words, place + 1)
        return None if steps is None else (_AHEAD[words[place].text] * steps[0], steps[1])
    steps = _steps(words, place)
    if steps is None or text_at(words, steps[1]) not in _UP:
        return None
    number, end = steps
    return _UP[words[end].text] * number, end + 1


def _steps(words: Sequence[Word], at: int) -> tuple[int, int] | None:
    """Read ``one floor``, ``two flights of stairs``, ``another level``, ``the next floor``, ``the floor``."""
    place = at
    number = number_at(words, place)
    if number is not None:
        place += 1
    else:
        number = 1
        while text_at(words, place) in ("a", "an", "another", "the", "next", "single"):
            place += 1
    if text_at(words, place) not in _STEPS or place == at:
        return None
    place += 1
    place += 2 * (text_at(words, place) == "of" and text_at(words, place + 1) in ("stair", "stairs"))
    return number, place


_SAID: Final = re.compile(
    r"ground (floor|level|storey) (is|as|being|counts as|=) (zero|0|nought|null)|british (count|way|style|floor)"
    r"|(above|not counting|without) the ground floor", re.IGNORECASE
)  # fmt: skip
_GROUND: Final = re.compile(r"\bground[- ](floor|level|storey)\b", re.IGNORECASE)
_FIRST: Final = re.compile(r"\b(first|1st)[- ](floor|storey|level|upper)\b", re.IGNORECASE)

_AFTER_UP: Final = frozenset("please is are has have need".split())


def counts_above_ground(text: str, brief: str) -> bool:
    """Whether ``first floor`` means the storey above the ground floor, as a text or the building's brief has it.

    Examples
    --------
    >>> counts_above_ground("a plant on the first floor", "Ground floor: lobby. First floor: offices.")
    True
    >>> counts_above_ground("a plant on the first floor", "Ground floor: lobby. Second floor: offices.")
    False
    """
    if _SAID.search(text):
        return True
    return any(_GROUND.search(words) and _FIRST.search(words) for words in (text, brief))


def counted_from_ground(words: Sequence[Word], text: str, brief: str, floors: Sequence[int]) -> list[Word]:
    """Return words with the ordinals of storeys as if the ground floor were the first.

    A number beside the ordinal tells how it counts, ``first floor (level 2)``; so does a storey that the building
    would not have. ``The first floor up`` is above the ground floor, however the others count.

    Parameters
    ----------
    floors : sequence of int
        Those of the building.
    """
    named = [at for at, word in enumerate(words) if word.kind == "ordinal" and _is_of_storey(words, at)]
    told = next((level for at in named if (level := _level_beside(words, at)) is not None), None)
    if told is not None:
        above = told[1] == told[0] + 1
    else:
        outside = any(words[at].value >= floors[-1] for at in named if not _is_up(words, at))
        known = all(words[at].value <= floors[-1] for at in named)
        above = counts_above_ground(text, brief) and (bool(_SAID.search(text)) or not (outside and known))
    up = {at for at in named if _is_up(words, at)}
    return [
        replace(word, value=word.value + 1) if at in named and (above or at in up) else word
        for at, word in enumerate(words)
        if at - 2 not in up
    ]


def _is_up(words: Sequence[Word], at: int) -> bool:
    """Whether ``floor up`` follows an ordinal, and no way that leads up."""
    following = words[at + 3] if at + 3 < len(words) else None
    ends = following is None or following.kind == "mark" or following.text in _AFTER_UP
    return (text_at(words, at + 1), text_at(words, at + 2)) == ("floor", "up") and ends


def _level_beside(words: Sequence[Word], at: int) -> tuple[float, float] | None:
    """Return an ordinal and the number of its storey: 1 and 2 of ``first floor (level 2)``; None for others."""
    place = at + 2 + _is_up(words, at)
    if text_at(words, at + 1) != "floor" or text_at(words, place) not in ("(", ",") or place + 1 >= len(words):
        return None
    level = words[place + 1]
    if level.text == "floor" and place + 2 < len(words) and words[place + 2].kind == "number":
        level = words[place + 2]
    elif level.kind != "level":
        return None
    return words[at].value, level.value


def _is_of_storey(words: Sequence[Word], at: int) -> bool:
    after = at + 1
    while text_at(words, after) in ("and", ",", "or", "the") or (after < len(words) and words[after].kind == "ordinal"):
        after += 1
    return text_at(words, after) == "floor"
