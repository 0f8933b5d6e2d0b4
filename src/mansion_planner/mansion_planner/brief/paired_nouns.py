"""Count nouns that are told in pairs: "one flat left and one flat right", "home and away changing rooms"."""

from dataclasses import replace

from mansion_language import Token
from mansion_language.inflection import singular

__all__ = ["paired_nouns"]

_ONE = frozenset({"one", "a", "an", "1"})
_SIDES = {
    "left": "right", "right": "left", "front": "rear", "rear": "front", "back": "front", "east": "west", "west": "east",
    "north": "south", "south": "north",
}  # fmt: skip
_DWELLINGS = frozenset({"flat", "apartment", "unit", "maisonette", "studio", "dwelling"})
_LEADS = frozenset({"on", "to", "at", "in", "the"})
_AND = frozenset({"and", ",", "&", "/"})


def paired_nouns(tokens: list[Token]) -> list[Token]:
    """Return the tokens with each pair as a number and a noun in the plural; the sides stay where they were told.

    "One flat left and one flat right, each with two bedrooms" becomes "two flats (left), each with two bedrooms": where
    on a storey a flat lies is not planned, and stays unread.
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        pair = _flats_by_side(tokens, index) or _home_and_away(tokens, index) or _by_users(tokens, index)
        if pair is None:
            result.append(tokens[index])
            index += 1
            continue
        made, index = pair
        result += made
    return result


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _two(token: Token) -> Token:
    return replace(token, kind="number", text="two", value=2.0, plural=False, soft=False)


def _flats_by_side(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Read "one flat on the left and one (flat) on the right", "a left flat and a right flat"."""
    first = _flat_at(tokens, index)
    if first is None or _word(tokens, first[2]) not in _AND:
        return None
    noun, side, end = first
    second = _flat_at(tokens, end + 1, noun=tokens[noun].text)
    if second is None or _SIDES.get(tokens[side].text) != tokens[second[1]].text:
        return None
    flats = replace(tokens[noun], plural=True)
    last = tokens[second[1]]
    sides = replace(tokens[side], start=max(tokens[side].start, flats.end), end=max(last.end, tokens[second[0]].end))
    return [_two(tokens[index]), flats, _mark(sides, "("), sides, _mark(sides, ")")], second[2]


def _mark(token: Token, text: str) -> Token:
    """Return a bracket at the end of a token, which parts it from what stands around it."""
    return replace(token, kind="mark", text=text, start=token.end, plural=False)


def _flat_at(tokens: list[Token], index: int, *, noun: str = "") -> tuple[int, int, int] | None:
    """Return where the noun and the side of one flat stand, and where it ends; its noun may be left out, if known."""
    if _word(tokens, index) not in _ONE:
        return None
    at = index + 1
    if _word(tokens, at) in _SIDES and _word(tokens, at + 1) in _DWELLINGS:
        return at + 1, at, at + 2
    named = _word(tokens, at) in _DWELLINGS
    if not named and not noun:
        return None
    place = at + named
    while _word(tokens, place) in _LEADS:
        place += 1
    return (at, place, place + 1) if _word(tokens, place) in _SIDES else None


_USERS = frozenset(
    "public staff guest customer patient visitor student teacher pupil employee client member resident".split()
)
_TOILETS = frozenset({"wc", "toilet", "restroom", "washroom", "lavatory"})


def _by_users(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Read "public and staff WC" as two rooms of that noun."""
    users = _word(tokens, index) in _USERS and _word(tokens, index + 2) in _USERS
    joined = _word(tokens, index + 1) in ("and", "&", "+") and _word(tokens, index) != _word(tokens, index + 2)
    if not (users and joined) or _word(tokens, index + 3) not in _TOILETS:
        return None
    noun = tokens[index + 3]
    again = replace(noun, start=tokens[index].end, end=tokens[index].end)
    return [tokens[index], again, tokens[index + 1], tokens[index + 2], noun], index + 4


def _home_and_away(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Read "home and away changing rooms", "changing rooms for home and away (teams)"."""
    at = index + (_word(tokens, index) in ("for", "("))
    if _word(tokens, at) != "home" or _word(tokens, at + 1) not in _AND or _word(tokens, at + 2) != "away":
        return None
    end = at + 3 + (singular(_word(tokens, at + 3)) in ("team", "side", "player"))
    counted = index > 0 and tokens[index - 1].kind == "number"
    if at > index:
        if index == 0 or not tokens[index - 1].plural:
            return None
        end += _word(tokens, index) == "(" and _word(tokens, end) == ")"
        two = replace(_two(tokens[at]), end=tokens[end - 1].end)
        return [replace(tokens[index], kind="mark", text="("), two, _mark(two, ")")], end
    if end < len(tokens) and tokens[end].kind == "word":
        return ([] if counted else [_two(tokens[at])]), end
    return None
