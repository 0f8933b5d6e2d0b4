"""Read numbers that a brief takes back: "80 m2, no, 92 m2", "two lifts (sorry, three)", "two rooms, make that four".

The number that is given last holds; it takes the place of the first, and the words that take that back are left out.
"""

from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["FILLERS", "PAUSES", "WEAK", "corrected_numbers", "sign_at", "taken_back_by"]

_MISCOUNTED = (
    ("i", "counted", "wrong"),
    ("counted", "wrong"),
    ("i", "miscounted"),
    ("miscounted",),
    ("wrong", "count"),
)
"""Signs that take back a count, not an area."""
_SIGNS = (
    ("make", "that"), ("make", "it"), ("i", "mean"), ("or", "rather"), ("or", "better"), ("scratch", "that"),
    ("strike", "that"), ("no", "wait"), ("hold", "on"), ("wait",), ("sorry",), ("pardon",), ("oop",), ("no",),
    ("correction",), ("actually",), ("rather",), ("i", "meant"), ("better",), ("well",),
    ("excuse", "me"), ("scrap", "that"), ("forget", "that"), ("cancel", "that"), ("on", "second", "thought"),
    ("second", "thought"), ("my", "mistake"), ("my", "bad"), ("i", "was", "wrong"), *_MISCOUNTED,
    ("let", "go", "with"), ("let", "make", "it"), ("let", "take"), ("go", "with"), ("settle", "on"),
)  # fmt: skip
"""What is said to take back a number, several of them one after the other at times."""
WEAK = frozenset({("no",), ("well",), ("better",), ("rather",), ("actually",), ("make", "it"), ("wait",)})
"""Signs that take something back only after a comma, a bracket or a dash."""
PAUSES = frozenset({",", "(", "-", "–", "—", "…", ":", "?"})
"""Marks that set apart what takes something back."""
FILLERS = frozenset({"hmm", "hm", "um", "uh", "er", "erm", "ah", "oh"})
"""What is said while one thinks again."""
_ENDS = frozenset({"", ",", ".", ")", ";", "-", "–", "\n", "and", "with", "in", "on", "plus", "!"})
_POINTING = frozenset({"another", "this", "that", "the", "no", "which", "other"})
"""Words before "one" where it stands for a noun: "the board approved another one"."""
_REACH = 14
"""Tokens before a sign among which the number that it takes back is looked for."""


def corrected_numbers(tokens: list[Token]) -> tuple[list[Token], list[tuple[int, int]]]:
    """Return the tokens with every number as it is told last, and where numbers are told twice.

    Returns
    -------
    tokens : list of Token
        The later number stands in the place of the earlier one.
    places : list of (int, int)
        From each earlier number to the end of what takes it back, in characters.
    """
    result: list[Token] = []
    places: list[tuple[int, int]] = []
    index = 0
    while index < len(tokens):
        found = _correction(tokens, result, index)
        if found is None:
            result.append(tokens[index])
            index += 1
            continue
        earlier, number, last = found
        old, new = result[earlier], tokens[number]
        result[earlier] = replace(old, text=new.text, value=new.value, soft=new.soft)
        places.append((old.start, tokens[last - 1].end))
        index = last
    return result, places


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


_CHANGED = frozenset(
    """
    cut cuts reduce reduces reduced lower lowered raise raised increase increased trim trimmed change changed bring
    brought limit limited drop dropped shrink shrank shrunk bump bumped expand expanded correct corrected revise revised
    go went come came set knock knocked whittle whittled settle settled agree agreed become became
    """.split()
)
"""Verbs that tell the number that something has in the end: "the board cut it to four"."""
_TURNS = frozenset(
    {"but", "then", "however", "yet", "though", "later", "now", ",", "(", "-", "–", "since", "meanwhile", "so"}
)
_MOVED = frozenset("it them that this these those number down up back have been be was were has to at on with".split())
_LONGEST_SUBJECT = 7


def _changed_to(tokens: list[Token], before: list[Token], index: int) -> tuple[int, int, int] | None:
    """Return what `_correction` does of "five rooms, but the board cut it to four" and "(reduced to four)"."""
    if _word(tokens, index) not in _TURNS:
        return None
    number = 0
    for at in range(index + 1, index + 2 + _LONGEST_SUBJECT):
        if at >= len(tokens) or tokens[at].kind != "word":
            return None
        number = _number_after(tokens, at) if tokens[at].text in _CHANGED else 0
        if number:
            break
    if not number:
        return None
    earlier = _taken_back(tokens, before, number, counts=_word(tokens, number + 1) not in AREA)
    if earlier is None or before[earlier].value == tokens[number].value:
        return None
    return earlier, number, _end(tokens, before, earlier, number, opened=_word(tokens, index))


def _number_after(tokens: list[Token], verb: int) -> int:
    """Return the token of the number that "cut it to four" and "became four" end with; 0 where there is none."""
    number = verb + 1
    while _word(tokens, number) in _MOVED:
        number += 1
    to = _word(tokens, number - 1) in ("to", "at", "on", "with") or _word(tokens, verb) in ("become", "became")
    return number if to and number < len(tokens) and tokens[number].kind == "number" else 0


_RECALLING = frozenset({"that", "it", "this", "those", "these", "they"})
_GOING_ON = frozenset(
    """
    now today meanwhile instead we i they it you need want have is are only just should be must take make has this year
    """.split()
)
_LONGEST_RECALL = 9


def _after_recall(tokens: list[Token], index: int) -> int:
    """Return where the number stands in "(no,) that was last year, now we need 24"; `index` where there is none."""
    if _word(tokens, index) not in _RECALLING or _word(tokens, index + 1) not in ("was", "were", "is", "are"):
        return index
    at = index + 2
    while at < len(tokens) and _word(tokens, at) not in PAUSES | {".", ";"} and at - index < _LONGEST_RECALL:
        at += 1
    if _word(tokens, at) not in PAUSES | {".", ";"}:
        return index
    at += 1
    while _word(tokens, at) in _GOING_ON:
        at += 1
    return at if at < len(tokens) and tokens[at].kind == "number" else index


_SAYING = frozenset(
    """
    say says said want wants wanted need needs insist insists prefer prefers think thinks ask asks allow allows permit
    permits
    """.split()
)
_OWNERS = frozenset("my our the his her their".split())


def _after_speaker(tokens: list[Token], index: int) -> int:
    """Return where the number stands in "wait, my wife says four"; `index` where nobody is said to say one."""
    verb = index + 2 if _word(tokens, index) in _OWNERS else index + 1
    if _word(tokens, verb) not in _SAYING:
        return index
    at = verb + 1
    while _word(tokens, at) in ("that", "on", "for", "it", "is", "we", "need", "want", "only", "just", ":"):
        at += 1
    return at if at < len(tokens) and tokens[at].kind == "number" else index


def _correction(tokens: list[Token], before: list[Token], index: int) -> tuple[int, int, int] | None:
    """Return which earlier number is taken back at a token, the token of the later one, and where that ends."""
    changed = _changed_to(tokens, before, index)
    if changed is not None:
        return changed
    at, ended = _after_marks(tokens, index)
    paused, first, weak, signs, counts = at > index, at, True, 0, False
    while (sign := sign_at(tokens, at)) is not None:
        weak, signs, counts = weak and sign in WEAK, signs + 1, counts or sign in _MISCOUNTED
        at, _ = _after_marks(tokens, at + len(sign))
    at = _after_speaker(tokens, _after_recall(tokens, at)) if at > first else at
    if at == first or (weak and not paused) or at >= len(tokens) or tokens[at].kind != "number":
        return None
    if ended and weak and signs < 2:
        return None  # "Two bedrooms. No 3D cinema."
    spelt = tokens[at].text.isalpha() and _word(tokens, at + 1) not in AREA  # nobody spells an area without its unit
    earlier = _taken_back(tokens, before, at, counts=counts or spelt)
    if earlier is None and signs > 1 and not weak:
        earlier = _named_long_before(tokens, before, at)
    return None if earlier is None else (earlier, at, _end(tokens, before, earlier, at, opened=_word(tokens, index)))


def _after_marks(tokens: list[Token], index: int) -> tuple[int, bool]:
    """Return where pauses and fillers from a token on end, and whether one full stop was among them."""
    at = index
    while _word(tokens, at) in PAUSES | FILLERS | {"."}:
        at += 1
    words = [token.text for token in tokens[index:at]]
    return at, words.count(".") == 1


def taken_back_by(tokens: list[Token], first: int, last: int) -> int | None:
    """Return the token from which on words between two statements take the first back; none where they do not.

    Parameters
    ----------
    first, last : int
        Tokens between the statements, `last` exclusive: ", no, ", "... hmm, no, keep it a plain".
    """
    for index in range(first, min(last, first + _REACH)):
        sign = sign_at(tokens, index)
        paused = _word(tokens, index - 1) in PAUSES | FILLERS | {"."}
        if sign is not None and (sign not in WEAK or paused):
            return index
        if _word(tokens, index) in ("\n", ";"):
            return None
    return None


def sign_at(tokens: list[Token], index: int) -> tuple[str, ...] | None:
    """Return the words that take something back at a token, if there are any."""
    return next((s for s in _SIGNS if tuple(t.text for t in tokens[index : index + len(s)]) == s), None)


def _taken_back(tokens: list[Token], before: list[Token], number: int, *, counts: bool) -> int | None:
    """Return the last number before that is of the same thing as a later one; of anything where that stands alone."""
    of = _word(tokens, number + 1)
    for at in range(len(before) - 1, max(len(before) - _REACH, 0) - 1, -1):
        token = before[at]
        if token.text in (";", "\n") or (token.text == "." and _word(before, at - 1) != "." != _word(before, at + 1)):
            return None
        if token.kind != "number" or (token.text == "one" and _word(before, at - 1) in _POINTING):
            continue
        if counts and _word(before, at + 1) in AREA:
            continue
        if of in _ENDS or at == len(before) - 1:
            return at
        if of in AREA:
            return at if _word(before, at + 1) in AREA else None
        if any(before[noun].text == of for noun in range(at + 1, min(at + 4, len(before)))):
            return at
    return None


def _named_long_before(tokens: list[Token], before: list[Token], number: int) -> int | None:
    """Return the last number before of the noun that a later one has: "3 groups. ... Sorry, make that 4 groups"."""
    noun = _word(tokens, number + 1)
    if noun in _ENDS or noun in AREA:
        return None
    return next(
        (at for at in range(len(before) - 1, -1, -1) if before[at].kind == "number" and _word(before, at + 1) == noun),
        None,
    )


def _end(tokens: list[Token], before: list[Token], earlier: int, number: int, *, opened: str) -> int:
    """Return where what takes a number back ends: after the noun that is said again, and after a closing mark."""
    nouns = [token.text for token in before[earlier + 1 : earlier + 4]]
    last = number + 1
    while last < len(tokens) and tokens[last].text not in _ENDS and tokens[last].text in nouns:
        last += 1
    closed = {"(": ")", "-": "-", "–": "–"}.get(opened)
    return last + (closed is not None and _word(tokens, last) == closed)
