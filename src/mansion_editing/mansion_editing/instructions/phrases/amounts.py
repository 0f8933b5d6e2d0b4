"""Amounts that noun phrases begin with: articles, numbers and quantifiers."""

from collections.abc import Sequence
from typing import Final, TypeAlias

from mansion_editing.instructions.phrases.word_sets import BEFORE_ALL_OF, WHOLES
from mansion_editing.instructions.phrases.words import DETERMINERS, PREPOSITIONS, Word, text_at
from mansion_editing.instructions.statements import Amount, AmountKind

__all__ = ["PARTS", "Amounted", "is_compound", "number_at", "read_amount"]

Amounted: TypeAlias = tuple[Amount, bool, bool, int]
"""Amount, whether the phrase is definite, whether every one is meant on its own, and the place after the words."""


PARTS: Final = frozenset("seat seater person drawer door piece tier legged leg burner arm door shelf panel".split())
_COUNTED_IN_NAMES: Final = frozenset("drawer door leg shelf panel".split())
"""Parts that names of whole things begin with too: ``two door mats``."""


def is_compound(words: Sequence[Word], at: int) -> bool:
    """Whether a number only tells of a part, as in ``three-seat sofa``."""
    names = text_at(words, at + 1) in _COUNTED_IN_NAMES and text_at(words, at - 1) not in DETERMINERS
    if names and at + 2 < len(words) and words[at + 2].plural:
        return False
    return (
        at + 2 < len(words)
        and words[at + 1].text in PARTS
        and words[at].end + 1 == words[at + 1].start
        and not words[at + 1].plural
        and words[at + 2].kind == "word"
        and words[at + 2].text not in PREPOSITIONS | {"higher", "lower"}
    )


def number_at(words: Sequence[Word], at: int) -> int | None:
    if at >= len(words) or is_compound(words, at):
        return None
    word = words[at]
    if word.kind == "number" and word.value == int(word.value):
        return int(word.value)
    return {"few": 3, "several": 3}.get(word.text)


_PHRASES: Final[tuple[tuple[tuple[str, ...], AmountKind], ...]] = (
    (("at", "least"), "at_least"), (("no", "less", "than"), "at_least"), (("no", "fewer", "than"), "at_least"),
    (("minimum",), "at_least"), (("min",), "at_least"), (("not", "less", "than"), "at_least"),
    (("at", "most"), "at_most"), (("no", "more", "than"), "at_most"), (("not", "more", "than"), "at_most"),
    (("up", "to"), "at_most"), (("maximum",), "at_most"), (("max",), "at_most"), (("a", "maximum", "of"), "at_most"),
    (("a", "minimum", "of"), "at_least"),
    (("a", "total", "of"), "exactly"), (("exactly",), "exactly"), (("only",), "exactly"), (("just",), "exactly"),
    (("precisely",), "exactly"), (("fewer", "than"), "at_most"), (("less", "than"), "at_most"),
    (("more", "than"), "at_least"),
)  # fmt: skip
_PHRASES_BY_FIRST: Final = {
    first: [(phrase, kind) for phrase, kind in _PHRASES if phrase[0] == first] for (first, *_), _ in _PHRASES
}

_BEYOND: Final[dict[tuple[str, ...], int]] = {("fewer", "than"): -1, ("less", "than"): -1, ("more", "than"): 1}
"""What the number is off by after words that leave it out."""


def read_amount(words: Sequence[Word], at: int) -> Amounted:
    """Read the amount that a noun phrase begins with: articles, numbers and quantifiers."""
    for phrase, kind in _PHRASES_BY_FIRST.get(text_at(words, at), ()):
        if tuple(w.text for w in words[at : at + len(phrase)]) == phrase:
            place = at + len(phrase)
            place += text_at(words, place) == "the"
            number = number_at(words, place)
            if number is None and text_at(words, place) in ("a", "an"):
                number = 1
            part = text_at(words, place + 1) == "of" and text_at(words, place + 2) in DETERMINERS
            if number is not None and part and kind == "exactly":
                return _counted(words, place, number, definite=False)
            if number is not None:
                number += _BEYOND.get(phrase, 0)
                return Amount(kind=kind, number=number), False, False, place + 1
    first = text_at(words, at)
    number = number_at(words, at)
    if first == "half" and text_at(words, at + 1) in ("of", "the", "our", "my", "these", "those", "all"):
        return _half(words, at + 1)
    nth = words[at + 1] if first in ("every", "each") and at + 1 < len(words) else None
    if nth is not None and (nth.text == "other" or (nth.kind == "ordinal" and nth.value == 2)):
        return Amount(kind="half", number=0), True, False, at + 2
    if first == "half" or (nth is not None and nth.kind == "ordinal"):
        return Amount(number=0), False, False, len(words)  # no share of things can be asked for
    if first in WHOLES:
        return _all(words, at)
    if first in ("no", "none", "neither") or (first == "not" and text_at(words, at + 1) in ("a", "any", "one")):
        place = at + 1 + (first == "not")
        place += text_at(words, place) == "single"
        while text_at(words, place) in ("of", "the", "any"):
            place += 1
        return Amount(kind="none", number=0), False, False, place
    if first == "another":
        number = number_at(words, at + 1)
        return Amount(kind="more", number=number or 1), False, False, at + 1 + (number is not None)
    if first in ("a", "an"):
        return _indefinite(words, at)
    if first in ("more", "additional", "extra", "further") and text_at(words, at + 1) not in ("than", ""):
        return Amount(kind="more", number=2), False, False, at + 1
    if number is not None and words[at].text not in ("double", "twin", "triple", "single"):
        return _counted(words, at, number, definite=False)
    if first in ("its", "their", "his", "her", "the") and text_at(words, at + 1) == "own":
        return Amount(number=1), False, False, at + 2  # "each desk its own lamp"
    if first in DETERMINERS:
        return _definite(words, at)
    return Amount(number=0), False, False, at


def _half(words: Sequence[Word], at: int) -> Amounted:
    """Read ``half of the six chairs``."""
    place = at
    while text_at(words, place) in BEFORE_ALL_OF:
        place += 1
    whole = number_at(words, place)
    return Amount(kind="half", number=0, of=whole or 0), True, False, place + (whole is not None)


def _all(words: Sequence[Word], at: int) -> Amounted:
    first = words[at].text
    place = at + 1
    if first in ("all", "everything") and text_at(words, place) in ("but", "except"):
        number = number_at(words, place + 1) or (1 if text_at(words, place + 1) in ("a", "an") else None)
        if number is not None:
            place += 2
            while text_at(words, place) in ("of", "the", "these", "those"):
                place += 1
            if text_at(words, place - 1) == "of" and text_at(words, place) == "them":
                return Amount(kind="all_but", number=number), True, False, place + 1
            whole = number_at(words, place)
            return Amount(kind="all_but", number=number, of=whole or 0), True, False, place + (whole is not None)
    if first == "everything":
        return Amount(kind="all", number=0), True, False, at
    if text_at(words, place) == "single" or text_at(words, place) == "one":
        place += 1
    while text_at(words, place) in BEFORE_ALL_OF:
        place += 1
    if first == "either":
        return Amount(kind="some", number=1), False, False, place
    if first == "any":
        return Amount(kind="all", number=0), False, False, place
    number = number_at(words, place)
    if number is not None and words[place].kind == "number":
        place += 1
    else:
        number = 2 if first == "both" else 0
    return Amount(kind="all", number=number, of=number), True, first in ("each", "every", "both"), place


def _indefinite(words: Sequence[Word], at: int) -> Amounted:
    place = at + 1
    if text_at(words, place) in ("couple", "pair", "few", "dozen", "single") or number_at(words, place):
        number = number_at(words, place) or 1
        place += 1
        scale = number_at(words, place)
        if scale is not None and words[place].kind == "number":
            number, place = number * scale, place + 1
        more = text_at(words, place) in ("more", "additional", "extra", "further")
        place += more
        place += text_at(words, place) == "of"
        if text_at(words, place) in ("the", "these", "those"):
            place += 1
            whole = number_at(words, place)
            return Amount(number=number, of=whole or 0), False, False, place + (whole is not None)
        return Amount(kind="more" if more else "some", number=number), False, False, place
    further = words[place] if place < len(words) else None
    if further is not None and (
        (further.kind == "ordinal" and further.value > 1)
        or further.text in ("additional", "extra", "further", "second")
    ):
        return Amount(kind="more", number=1), False, False, place + 1
    return Amount(number=1), False, False, place


def _counted(words: Sequence[Word], at: int, number: int, *, definite: bool) -> Amounted:
    place = at + 1
    if text_at(words, place) == "of" and text_at(words, place + 1) in ("the", "these", "those", "them", "my", "our"):
        place += 1 if text_at(words, place + 1) == "them" else 2
        whole = number_at(words, place)
        return Amount(number=number, of=whole or 0), False, False, place + (whole is not None)
    if text_at(words, place) == "or" and text_at(words, place + 1) in ("more", "fewer", "less"):
        limit: AmountKind = "at_least" if words[place + 1].text == "more" else "at_most"
        return Amount(kind=limit, number=number), definite, False, place + 2
    if text_at(words, place) in ("more", "additional", "extra", "further"):
        return Amount(kind="more", number=number), definite, False, place + 1
    if text_at(words, place) == "other" and not definite:
        return Amount(kind="more", number=number), definite, False, place + 1
    place += text_at(words, place) == "x"
    if text_at(words, place) == "(" and number_at(words, place + 1) == number and text_at(words, place + 2) == ")":
        place += 3
    return Amount(number=number), definite, False, place


def _definite(words: Sequence[Word], at: int) -> Amounted:
    first = words[at].text
    place = at + 1
    if first in ("some", "such", "enough"):
        more = text_at(words, place) == "more"
        return Amount(kind="more", number=2) if more else Amount(number=0), False, False, place + more
    definite = True
    number = number_at(words, place)
    if number is not None and words[place].text not in ("double", "twin", "triple", "single", "couple", "pair"):
        amount, _, _, place = _counted(words, place, number, definite=True)
        return amount, definite, False, place
    return Amount(number=0), definite, False, place
