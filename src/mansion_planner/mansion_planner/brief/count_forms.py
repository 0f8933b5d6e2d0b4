"""Bring counts after their noun or in a table into one form: "4 nos. of flats", "lift 2 nos.", "hall - 1 - 80 m2"."""

from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["count_forms"]

_CLASSIFIERS = frozenset({"no", "nos", "pc", "pcs", "piece", "unit", "number", "set", "off"})
_BEDROOMED = frozenset({"bhk", "ldk"})
"""Short forms that the number of bedrooms stands before: "2BHK"."""

_BARS = frozenset({"-", "|", "–"})
_ENDS = frozenset({"", "\n", ",", ";", ".", ")", "|", "-", "/"})
_CORES = frozenset({"lift", "elevator", "stair", "staircase", "stairs"})
_TIMES = frozenset({"x", "a", "@", "à"})
_STOREYS = frozenset({"floor", "storey", "level", "story", "basement", "deck", "phase", "block", "version"})


def count_forms(tokens: list[Token]) -> list[Token]:
    """Return the tokens with every count before its noun, or after it as "x 4"."""
    return _with_tables(_with_classifiers(tokens))


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _is_count(tokens: list[Token], index: int) -> bool:
    if not 0 <= index < len(tokens) or tokens[index].kind != "number":
        return False
    return tokens[index].value == int(tokens[index].value) and 1 <= tokens[index].value <= 500


def _is_noun(tokens: list[Token], index: int) -> bool:
    """Whether a token can be the noun that a count after it is of."""
    token = tokens[index] if 0 <= index < len(tokens) else None
    return token is not None and token.kind == "word" and len(token.text) > 1 and token.text not in _NO_NOUNS


_NO_NOUNS = _STOREYS | frozenset(
    """
    of for with and or at in on the a an to from by is are has have be about around approx circa least most exactly
    only each every per all total minus plus up than over under between x
    """.split()
)


def _with_classifiers(tokens: list[Token]) -> list[Token]:
    """Read "4 nos. of 2BHK flats" as "4 2BHK flats", and "toilets 2 nos." and "room 9 rooms" as "x" the number."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        word = _word(tokens, index + 1)
        if word in _BEDROOMED and token.kind == "number":
            result += [token, replace(tokens[index + 1], text="bedroom", plural=False, spaced=False)]
            index += 2
            continue
        if token.text == "half" and _word(tokens, index + 1) in ("a", "dozen"):
            dozen = index + 1 + (_word(tokens, index + 1) == "a")
            if _word(tokens, dozen) == "dozen":
                result.append(replace(tokens[dozen], kind="number", text="six", start=token.start, value=6.0))
                index = dozen + 1
                continue
        if _numbers_bedroom(tokens, index):
            result.append(replace(token, text="bedroom"))
            index += 1
            continue
        if _opens_advert(tokens, index):
            result += [token, replace(tokens[index + 1], text="bedroom")]
            index += 2
            continue
        if not _is_count(tokens, index):
            result.append(token)
            index += 1
            continue
        noun = _is_noun(tokens, index - 1)
        times = word == "x" and not tokens[index + 1].spaced and _word(tokens, index + 2) not in ("x", "by")
        if times and not (index + 2 < len(tokens) and tokens[index + 2].kind in ("number", "unit")):
            bracketed = _word(tokens, index - 1) == "(" and _word(tokens, index + 2) == ")"
            if bracketed:
                result.pop()
            after = bracketed or (noun and _word(tokens, index + 2) in _ENDS)
            result += [*([_times(token)] * after), token]  # "phone booth (2x)", "meeting room 3x", "2x storage"
            index += 2 + bracketed
            continue
        repeated = noun and word == _word(tokens, index - 1) and word in _REPEATED
        last = index + 2
        last += _word(tokens, last) == "." and word in ("no", "nos", "pc", "pcs") and _goes_on(tokens, last)
        if repeated:
            result += [_times(token), token]
            index += 2
            continue
        if word in _CLASSIFIERS and not (word in ("no", "off", "number", "set", "unit", "piece") and not noun):
            if noun and word != "number":
                result += [_times(token), token]
                index = last
                continue
            if word in ("nos", "pcs", "pc", "no"):
                result.append(token)
                index = last + (_word(tokens, last) == "of")
                continue
        if _word(tokens, index - 1) == ":" and _is_noun(tokens, index - 2) and _is_entry(tokens, index):
            result[-1] = _times(token)
            result.append(token)
            index += 1
            continue
        core = _word(tokens, index - 1) in _CORES and not tokens[index - 1].plural
        listed = tokens[index - 1].plural and not _is_count(tokens, index + 2) and token.text.isdigit()
        if noun and _word(tokens, index + 1) in _ENDS - {"-", "/", "|"} and (core or listed):
            result.append(_times(token))
        result.append(token)
        index += 1
    return result


def _numbers_bedroom(tokens: list[Token], index: int) -> bool:
    """Whether "Bed 1:" names a bedroom, as adverts do."""
    bed = _word(tokens, index) == "bed" and not tokens[index].plural and _word(tokens, index - 1) in _STARTS
    return bed and _is_count(tokens, index + 1) and _word(tokens, index + 2) in (":", "(", "-", ",", "=")


def _is_entry(tokens: list[Token], index: int) -> bool:
    """Whether a number is all that a line says of its noun: "Bedrooms: 4, lifts: 2"."""
    before = _word(tokens, index - 3)
    return tokens[index - 2].plural and before in _STARTS and _word(tokens, index + 1) in _ENDS - {"-", "/"}


_STARTS = frozenset({"", "\n", ",", ";", ".", "(", "|", "-", "*", "and", "•"})


def _opens_advert(tokens: list[Token], index: int) -> bool:
    """Whether "3 beds, 1 bathroom" opens a list, where beds are bedrooms."""
    beds = _is_count(tokens, index) and _word(tokens, index + 1) == "bed" and tokens[index + 1].plural
    listed = (
        beds and _word(tokens, index - 1) in (":", "-", "\n") and _word(tokens, index + 2) in (",", "/", "and", "+")
    )
    bath = index + 3 + _is_count(tokens, index + 3)
    if listed and _word(tokens, bath) in ("bath", "bathroom"):
        return True
    bare = _is_count(tokens, index) and _word(tokens, index + 1) == "bed" and _is_count(tokens, index + 2)
    return bare and _word(tokens, index + 3) in ("bath", "bathroom")


_REPEATED = frozenset({"room", "bedroom", "classroom", "apartment", "flat"})
"""Nouns that are said again with their number: "guest room 9 rooms"."""


def _goes_on(tokens: list[Token], index: int) -> bool:
    """Whether the full stop at a token ends an abbreviation: a small letter or a number follows."""
    following = tokens[index + 1] if index + 1 < len(tokens) else None
    return following is not None and following.kind != "mark" and not following.capital


def _times(number: Token) -> Token:
    return Token("mark", "x", number.start, number.start)


def _with_tables(tokens: list[Token]) -> list[Token]:
    """Read a row of a schedule, "rooms - 4 - 55 m2 each", as "rooms x 4 of 55 m2 each", and "4 x 55 m2" so."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        each = _is_count(tokens, index) and _word(tokens, index + 1) in _TIMES and _is_area(tokens, index + 2)
        if each:
            at = tokens[index + 1]
            before = _word(tokens, index - 1)
            noun = before in (":", "(", "-", ",", "=", "|") or _is_noun(tokens, index - 1)
            if noun and before in (":", "-", "=", "|", "(") and result[-1:] == [tokens[index - 1]]:
                result.pop()
            last = index + 4
            closes = before == "(" and _word(tokens, last) == ")"
            result += [_times(token)] * noun
            result += [token, replace(at, kind="word", text="of"), *tokens[index + 2 : last]]
            result += [Token("word", "each", tokens[last - 1].end, tokens[last - 1].end)] if noun else []
            index = last + closes
            continue
        if (
            token.text in _TIMES
            and _is_area(tokens, index + 1)
            and index > 0
            and tokens[index - 1].kind == "word"
            and tokens[index - 1].plural
        ):
            end = tokens[index + 2].end
            result += [replace(token, kind="word", text="of"), *tokens[index + 1 : index + 3]]
            result.append(Token("word", "each", end, end))
            index += 3
            continue
        row = (
            token.text in _BARS
            and token.spaced
            and _is_noun(tokens, index - 1)
            and _is_count(tokens, index + 1)
            and tokens[index + 1].spaced
            and _word(tokens, index + 2) in _BARS | {"\n", "", ","}
        )
        if row:
            result += [_times(token), tokens[index + 1]]
            more = _word(tokens, index + 2) in _BARS | {","} and _is_area(tokens, index + 3)
            if more:
                result.append(replace(tokens[index + 2], kind="word", text="of"))
            index += 3 if more else 2
            continue
        result.append(token)
        index += 1
    return result


def _is_area(tokens: list[Token], index: int) -> bool:
    unit = tokens[index + 1] if index + 1 < len(tokens) else None
    return index < len(tokens) and tokens[index].kind == "number" and unit is not None and unit.text in AREA
