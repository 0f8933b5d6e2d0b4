"""Write out units that a text leaves out: "two of 10 m2, one of 18", "bedrooms (one 14m, other 11m)"."""

from dataclasses import dataclass, replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["with_units"]

_OPENING = frozenset({":", "(", "-", "–"})
_JOINTS = frozenset({",", "and", "&", ";"})
_SIZES = frozenset("small smaller large larger big bigger little medium mid-size".split())
_LEADS = frozenset("of with at à about is = : approx around the ca".split())
_OTHERS = frozenset({"other", "another", "second", "third", "rest"})
_LONGEST = 40
"""Tokens of a list, at most."""
_LEAST_AREA, _MOST_AREA = 3, 2000
"""Square metres that an area whose unit is left out has."""


@dataclass(frozen=True)
class _Entry:
    """An entry of a list of areas: the token of its number, and where the words between count and number stand."""

    number: int
    ones: tuple[int, ...]


def with_units(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the square metres of such numbers, and "two small ones of 10 m2" as "two of 10 m2"."""
    result = _middle_of_ranges(_areas_in_metres(tokens))
    found: list[Token] = []
    index = 0
    while index < len(result):
        found.append(result[index])
        counted = index > 1 and (result[index - 1].plural or _is_counted(result, index - 1))
        last, entries = _list_after(result, index + 1) if counted and result[index].text in _OPENING else (0, [])
        if last and _measured(result, entries):
            found += _written_out(result, index + 1, last, entries)
            index = last
        else:
            index += 1
    return found


def _is_counted(tokens: list[Token], index: int) -> bool:
    """Whether a noun stands at a token with a number before it: "2 bedroom"."""
    return index > 0 and tokens[index].kind == "word" and any(t.kind == "number" for t in tokens[index - 2 : index])


def _areas_in_metres(tokens: list[Token]) -> list[Token]:
    """Read "area is 160 meters" and "area: 160m" in square metres."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        led = index > 2 and token.kind == "unit" and token.text == "m" and tokens[index - 1].kind == "number"
        at = index - 2
        while led and at > 0 and tokens[at].text in _LEADS and index - at < 6:
            at -= 1
        area = led and tokens[at].text in ("area", "surface") and tokens[index - 1].value >= _LEAST_AREA
        result.append(replace(token, text="m2") if area else token)
    return result


def _middle_of_ranges(tokens: list[Token]) -> list[Token]:
    """Read "rooms between 14 and 18 m2" as rooms of 16 m2."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        kinds = [token.kind for token in tokens[index : index + 5]]
        ranged = tokens[index].text == "between" and kinds == ["word", "number", "word", "number", "unit"]
        if not ranged or tokens[index + 4].text not in AREA or tokens[index + 2].text not in ("and", "to"):
            result.append(tokens[index])
            index += 1
            continue
        low, high = tokens[index + 1], tokens[index + 3]
        middle = (low.value + high.value) / 2
        result.append(replace(tokens[index], text="of"))
        result.append(Token("number", f"{middle:g}", low.start, high.end, middle))
        result.append(tokens[index + 4])
        index += 5
    return result


def _list_after(tokens: list[Token], index: int) -> tuple[int, list[_Entry]]:
    """Return where the list of areas that begins at a token ends, and its entries; 0 where there is no such list."""
    entries: list[_Entry] = []
    at = index
    while at < len(tokens) and at - index < _LONGEST:
        counted = tokens[at].text in _OTHERS or (tokens[at].kind == "number" and tokens[at].text.isalpha())
        counted = counted or (tokens[at].text == "the" and at + 1 < len(tokens) and tokens[at + 1].text in _OTHERS)
        if not counted:
            break
        at += 1 + (tokens[at].text == "the")
        ones: list[int] = []
        while at < len(tokens) and (tokens[at].text in _SIZES | _LEADS or tokens[at].text == "one"):
            if tokens[at].text not in _LEADS:
                ones.append(at)
            at += 1
        if at >= len(tokens) or tokens[at].kind != "number":
            break
        entries.append(_Entry(at, tuple(ones)))
        at += 1 + (at + 1 < len(tokens) and tokens[at + 1].kind == "unit")
        end = at
        while at < len(tokens) and tokens[at].text in _JOINTS:
            at += 1
        if at == end:
            break
    if len(entries) < 2:
        return 0, []
    end = entries[-1].number + 1
    return end + (end < len(tokens) and tokens[end].kind == "unit"), entries


def _measured(tokens: list[Token], entries: list[_Entry]) -> bool:
    """Whether numbers are areas: some have the unit, or all are in metres."""
    units = [tokens[entry.number + 1].text if entry.number + 1 < len(tokens) else "" for entry in entries]
    sizes = all(_LEAST_AREA <= tokens[entry.number].value <= _MOST_AREA for entry in entries)
    return sizes and (any(unit in AREA for unit in units) or all(unit == "m" for unit in units))


def _written_out(tokens: list[Token], first: int, last: int, entries: list[_Entry]) -> list[Token]:
    """Return the tokens of a list with a unit behind each number."""
    left_out = {at for entry in entries for at in entry.ones}
    numbers = {entry.number for entry in entries}
    result: list[Token] = []
    for index in range(first, last):
        token = tokens[index]
        if index in left_out:
            continue
        if index - 1 in numbers and token.text == "m":
            token = replace(token, text="m2")
        result.append(token)
        bare = index in numbers and (index + 1 >= len(tokens) or tokens[index + 1].kind != "unit")
        if bare:
            result.append(Token("unit", "m2", token.end, token.end))
    return result
