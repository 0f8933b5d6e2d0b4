"""Bring counts of all forms into one: "lift 2 nos.", "hall - 1 - 80 m2", "2BHK", "half a dozen"."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["count_forms"]

_CLASSIFIERS = frozenset({"no", "nos", "pc", "pcs", "piece", "unit", "number", "set", "off"})
_BEDROOMED = frozenset({"bhk", "ldk"})
"""Short forms that the number of bedrooms stands before: "2BHK"."""

_HOMES = frozenset({"house", "home", "flat", "apartment", "villa"})
"""Nouns that such a short form may stand behind: "a flat 2BHK"."""

_BARS = frozenset({"-", "|", "–"})
_ENDS = frozenset({"", "\n", ",", ";", ".", ")", "|", "-", "/"})
_CORES = frozenset({"lift", "elevator", "stair", "staircase", "stairs"})
_TIMES = frozenset({"x", "a", "@", "à"})
_STOREYS = frozenset({"floor", "storey", "level", "story", "basement", "deck", "phase", "block", "version"})


def count_forms(tokens: list[Token]) -> list[Token]:
    """Return the tokens with every count before its noun, or after it as "x 4"."""
    return _rewritten(_rewritten(tokens, _CLASSIFIED), _TABULATED)


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
    only each every per all total minus plus up than over under between x having including containing comprising
    featuring holding offering
    """.split()
)


_Read: TypeAlias = "Callable[[list[Token], int], _Form | None]"


def _rewritten(tokens: list[Token], forms: Sequence[_Read]) -> list[Token]:
    """Return the tokens with the first of the forms that is read at each of them in its place."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        form = next((form for read in forms if (form := read(tokens, index)) is not None), None)
        if form is None:
            result.append(tokens[index])
            index += 1
            continue
        del result[len(result) - form.dropped :]
        result += form.tokens
        index = form.last
    return result


@dataclass(frozen=True)
class _Form:
    """What stands for the tokens up to `last` (exclusive), and for so many before them (`dropped`)."""

    tokens: tuple[Token, ...]
    last: int
    dropped: int = 0


def _bedroomed(tokens: list[Token], index: int) -> _Form | None:
    """Read "2BHK" as two bedrooms."""
    if tokens[index].kind != "number" or _word(tokens, index + 1) not in _BEDROOMED:
        return None
    if _word(tokens, index + 2) in ("type", "layout", "plan"):  # "1LDK type" is no noun of a flat
        return _Form((tokens[index], replace(tokens[index + 1], text="bedroom", spaced=True)), index + 3)
    after = _word(tokens, index + 2) in _ENDS | {"of", "with", "on", "in", "and"}
    alone = _word(tokens, index - 1) in _ENDS | _HOMES | {"with", "has", "have"} and after
    bedrooms = replace(tokens[index + 1], text="bedroom", plural=alone, spaced=alone)
    if alone and _word(tokens, index + 2) == "of":  # "a home with 4BHK of 120 m2" is that large in all
        return _Form((tokens[index], bedrooms, Token("mark", ",", bedrooms.end, bedrooms.end)), index + 2)
    return _Form((tokens[index], bedrooms), index + 2)


def _half_dozen(tokens: list[Token], index: int) -> _Form | None:
    """Read "half a dozen" as six."""
    dozen = index + 1 + (_word(tokens, index + 1) == "a")
    if tokens[index].text != "half" or _word(tokens, dozen) != "dozen":
        return None
    six = replace(tokens[dozen], kind="number", text="six", start=tokens[index].start, value=6.0)
    return _Form((six,), dozen + 1)


def _advertised_bedroom(tokens: list[Token], index: int) -> _Form | None:
    """Read "Bed 1: 12 m2" and "3 beds, 1 bath" as of bedrooms."""
    if _numbers_bedroom(tokens, index):
        return _Form((replace(tokens[index], text="bedroom"),), index + 1)
    if _opens_advert(tokens, index):
        return _Form((tokens[index], replace(tokens[index + 1], text="bedroom")), index + 2)
    return None


def _multiplied(tokens: list[Token], index: int) -> _Form | None:
    """Read "phone booth (2x)", "meeting room 3x", "2x storage", "2 x exam room"."""
    mark = index + 1
    if not _is_count(tokens, index) or _word(tokens, mark) != "x":
        return None
    if tokens[mark].spaced and (_is_noun(tokens, index - 1) or not _is_noun(tokens, mark + 1)):
        return None
    if tokens[mark].spaced and not tokens[mark + 1].spaced:
        return None  # "1 x-ray room"
    following = _word(tokens, index + 2)
    if following in ("x", "by") or (index + 2 < len(tokens) and tokens[index + 2].kind in ("number", "unit")):
        return None
    bracketed = _word(tokens, index - 1) == "(" and following == ")"
    after = bracketed or (_is_noun(tokens, index - 1) and following in _ENDS)
    return _Form((*([_times(tokens[index])] * after), tokens[index]), index + 2 + bracketed, dropped=int(bracketed))


def _abbreviated_each(tokens: list[Token], index: int) -> _Form | None:
    """Read "16 m2 ea" and "two offices, 1 phone booth ea.;" with "each"."""
    if tokens[index].text != "ea" or index == 0 or tokens[index - 1].kind not in ("unit", "word"):
        return None
    goes_on = _word(tokens, index + 1) == "." and (
        _word(tokens, index + 2) in (";", ",", ")") or _goes_on(tokens, index + 1)
    )
    return _Form((replace(tokens[index], text="each"),), index + 1 + goes_on)


def _repeated_noun(tokens: list[Token], index: int) -> _Form | None:
    """Read "guest room 9 rooms"."""
    word = _word(tokens, index + 1)
    again = word in _REPEATED and word == _word(tokens, index - 1) and _is_noun(tokens, index - 1)
    return _Form((_times(tokens[index]), tokens[index]), index + 2) if again and _is_count(tokens, index) else None


def _classified(tokens: list[Token], index: int) -> _Form | None:
    """Read "toilets 2 nos.", "4 nos. of flats"."""
    word, noun = _word(tokens, index + 1), _is_noun(tokens, index - 1)
    if not _is_count(tokens, index) or word not in _CLASSIFIERS:
        return None
    if word in ("no", "off", "number", "set", "unit", "piece") and not noun:
        return None
    if word == "off" and _word(tokens, index + 2) in ("the", "a", "it", "this", "that"):
        return None  # "store 20 off the hall" is an area
    last = index + 2
    last += _word(tokens, last) == "." and word in ("no", "nos", "pc", "pcs") and _goes_on(tokens, last)
    if noun and word != "number":
        return _Form((_times(tokens[index]), tokens[index]), last)
    if word in ("nos", "pcs", "pc", "no"):
        return _Form((tokens[index],), last + (_word(tokens, last) == "of"))
    return None


def _entered(tokens: list[Token], index: int) -> _Form | None:
    """Read "Bedrooms: 4", all that a line says."""
    if not _is_count(tokens, index) or _word(tokens, index - 1) != ":" or not _is_noun(tokens, index - 2):
        return None
    times = (_times(tokens[index]), tokens[index])
    return _Form(times, index + 1, dropped=1) if _is_entry(tokens, index) else None


def _trailing(tokens: list[Token], index: int) -> _Form | None:
    """Read "lift 2, classrooms 8"."""
    ends = _word(tokens, index + 1) in _ENDS - {"-", "/", "|"}
    if not _is_count(tokens, index) or not _is_noun(tokens, index - 1) or not ends:
        return None
    core = _word(tokens, index - 1) in _CORES and not tokens[index - 1].plural
    listed = tokens[index - 1].plural and not _is_count(tokens, index + 2) and tokens[index].text.isdigit()
    return _Form((_times(tokens[index]), tokens[index]), index + 1) if core or listed else None


_CLASSIFIED = (
    _bedroomed,
    _half_dozen,
    _advertised_bedroom,
    _multiplied,
    _repeated_noun,
    _abbreviated_each,
    _classified,
    _entered,
    _trailing,
)
"""Forms of a number beside its noun: "4 nos. of flats", "toilets 2 nos.", "room 9 rooms"."""


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


def _counted_area(tokens: list[Token], index: int) -> _Form | None:
    """Read "labs: 4 x 55 m2" as "labs x 4 of 55 m2 each"."""
    if not (_is_count(tokens, index) and _word(tokens, index + 1) in _TIMES and _is_area(tokens, index + 2)):
        return None
    before, last = _word(tokens, index - 1), index + 4
    marked = before in (":", "(", "-", "=", "|")
    closes = before == "(" and _word(tokens, last) == ")"
    of_area = (tokens[index], replace(tokens[index + 1], kind="word", text="of"), *tokens[index + 2 : last])
    if not (marked or before == "," or _is_noun(tokens, index - 1)):
        return _Form(of_area, last + closes)
    return _Form((_times(tokens[index]), *of_area, _each_after(tokens[last - 1])), last + closes, dropped=int(marked))


def _area_apiece(tokens: list[Token], index: int) -> _Form | None:
    """Read "offices @ 14 m2" as "offices of 14 m2 each"."""
    plural = index > 0 and tokens[index - 1].kind == "word" and tokens[index - 1].plural
    if not plural or tokens[index].text not in _TIMES or not _is_area(tokens, index + 1):
        return None
    of_area = (replace(tokens[index], kind="word", text="of"), *tokens[index + 1 : index + 3])
    return _Form((*of_area, _each_after(tokens[index + 2])), index + 3)


def _row(tokens: list[Token], index: int) -> _Form | None:
    """Read "rooms - 4 - 55 m2" as "rooms x 4 of 55 m2"."""
    if tokens[index].text not in _BARS or not tokens[index].spaced or not _is_noun(tokens, index - 1):
        return None
    following = _word(tokens, index + 2)
    spaced = _is_count(tokens, index + 1) and tokens[index + 1].spaced
    if not spaced or following not in _BARS | {"\n", "", ","}:
        return None
    counted = (_times(tokens[index]), tokens[index + 1])
    if following not in _BARS | {","} or not _is_area(tokens, index + 3):
        return _Form(counted, index + 2)
    return _Form((*counted, replace(tokens[index + 2], kind="word", text="of")), index + 3)


_TABULATED = (_counted_area, _area_apiece, _row)
"""Forms of a row of a schedule, or of an entry with an area for each: "4 x 55 m2"."""


def _each_after(token: Token) -> Token:
    return Token("word", "each", token.end, token.end)


def _is_area(tokens: list[Token], index: int) -> bool:
    unit = tokens[index + 1] if index + 1 < len(tokens) else None
    return index < len(tokens) and tokens[index].kind == "number" and unit is not None and unit.text in AREA
