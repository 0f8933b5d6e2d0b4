"""Name the rooms of each part of a number: "Dorms: 2 with 4 beds and 3 with 6", "two meeting rooms (one for 6, ...)".

Rooms may also be counted by the groups that they are for: "changing rooms for four teams" are four.
"""

from dataclasses import replace

from mansion_language import Token

__all__ = ["counted_parts"]

_LINKS = frozenset({"with", "of", "for", "having", "seating", "à", "a", "@"})
_OF_PEOPLE = frozenset({"with", "for", "seating"})
"""Links of parts behind a number; the areas of such parts are shared out by other readers."""
_JOINTS = frozenset({",", "and", "&", "plus", "+", ";"})
_ENDS = frozenset({".", "\n", "!", "?", ")", ""})
_STARTS = frozenset({".", "\n", "!", "?", ";", "", "*", "-", "("})
_FLATS = frozenset({"flat", "apartment", "unit", "dwelling", "maisonette", "floor", "storey", "level", "storie"})
"""Nouns whose parts other readers know."""
_LONGEST_PART = 8
_NOUNS = 3
"""Words of the noun that heads a list of parts, at most."""


def counted_parts(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the noun behind each number of such a list, and rooms of teams counted."""
    tokens = _for_others(_rooms_of_teams(tokens))
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        found = _list_at(tokens, index)
        if found is None:
            result.append(tokens[index])
            index += 1
            continue
        result += found[0]
        index = found[1]
    return result


def _for_others(tokens: list[Token]) -> list[Token]:
    """Return tokens with "one bedroom for us, three for the kids" as three bedrooms for the kids."""
    result: list[Token] = []
    noun: list[Token] = []
    for index, token in enumerate(tokens):
        result.append(token)
        noun = [] if token.text in _ENDS - {")"} else noun
        person = _text(tokens, index + 1) == "for" and _text(tokens, index + 2) in _WHOM
        if not person:
            continue
        if token.kind == "number" and noun and _text(tokens, index - 1) in (",", "and", ";"):
            several = token.value != 1
            result += [replace(word, start=token.end, end=token.end, plural=several) for word in noun]
        elif token.kind == "word" and index and tokens[index - 1].kind == "number":
            noun = [token]
    return result


_WHOM = frozenset(
    {"the", "us", "our", "my", "me", "guests", "guest", "visitors", "kids", "children", "staff", "parents"}
)


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _is_number(tokens: list[Token], index: int) -> bool:
    token = tokens[index] if 0 <= index < len(tokens) else None
    return token is not None and token.kind == "number" and token.value == int(token.value) and token.value < 100


def _list_at(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Read a list of parts whose noun, or the number before it, stands at a token; return it and its end."""
    total = int(tokens[index].value) if _is_number(tokens, index) else 0
    first = index + (total > 0)
    if not total and _text(tokens, index - 1) not in _STARTS:
        return None
    last = first
    while last - first < _NOUNS and last < len(tokens) and tokens[last].kind == "word":
        last += 1
    flats = _text(tokens, last - 1) in _FLATS and _text(tokens, last - 2) != "storage"
    if last == first or not tokens[last - 1].plural or flats:
        return None
    mark = _text(tokens, last)
    if mark != ":" and not (total and mark in ("(", ",")):
        return None
    parts, end = _parts(tokens, last + 1, _LINKS if mark == ":" else _OF_PEOPLE)
    counts = [int(tokens[part].value) for part, _ in parts]
    if len(parts) < 2 or (total and sum(counts) != total):
        return None
    named: list[Token] = []
    for (part, until), count in zip(parts, counts, strict=True):
        noun = [replace(token, start=tokens[part].end, end=tokens[part].end) for token in tokens[first:last]]
        noun[-1] = replace(noun[-1], plural=count > 1)
        at = tokens[part].start
        named += [Token("mark", ",", at, at)] * bool(named)
        named += [replace(tokens[part], spaced=True), *noun, *tokens[part + 1 : until]]
    return named, end + (mark == "(" and _text(tokens, end) == ")")


def _parts(tokens: list[Token], index: int, links: frozenset[str]) -> tuple[list[tuple[int, int]], int]:
    """Return where each part of a list begins and ends, and where the list does."""
    parts: list[tuple[int, int]] = []
    while _is_number(tokens, index) and _text(tokens, index + 1) in links and _is_number(tokens, index + 2):
        end = index + 3
        while _text(tokens, end) not in _JOINTS | _ENDS and end - index < _LONGEST_PART:
            end += 1
        parts.append((index, end))
        index = end
        while _text(tokens, index) in _JOINTS:
            index += 1
    return parts, parts[-1][1] if parts else index


_FOR_TEAMS = frozenset({"changing", "locker", "dressing", "change"})
_OF_GROUPS = {"team": ("team", "room"), "class": ("classroom",), "department": ("department", "office")}
"""Groups of people, and the rooms in which each of them works by itself."""


def _rooms_of_teams(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "changing rooms for four teams" and "3 teams, each in its own room" as counted rooms."""
    for index in range(len(tokens) - 4):
        if _text(tokens, index) in _FOR_TEAMS and tokens[index + 1].plural and _text(tokens, index + 2) == "for":
            counted = _is_number(tokens, index + 3) and _text(tokens, index + 4) in ("team", "club", "side")
            if counted and (index == 0 or tokens[index - 1].kind != "number"):
                rest = _rooms_of_teams(tokens[index + 5 :])
                comma = [Token("mark", ",", tokens[index + 4].end, tokens[index + 4].end)] * (
                    bool(rest) and rest[0].text == "each"
                )
                return [*tokens[:index], tokens[index + 3], *tokens[index : index + 2], *comma, *rest]
        found = _rooms_of_groups(tokens, index)
        if found is not None:
            return [*tokens[:index], *found[0], *_rooms_of_teams(tokens[found[1] :])]
    return tokens


def _rooms_of_groups(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Read "3 teams of 8, each team in its own room" at a token; return the rooms and where it ends."""
    noun = _text(tokens, index + 1)
    counted = _is_number(tokens, index) and noun in _OF_GROUPS and tokens[index + 1].plural
    if not counted or _text(tokens, index + 2) != "of" or not _is_number(tokens, index + 3):
        return None
    at = index + 4 + (_text(tokens, index + 4) in ("people", "person", "pupil", "member"))
    at += _text(tokens, at) == ","
    each = at + 1 + (_text(tokens, at + 1) == noun)
    own = [token.text for token in tokens[each : each + 4]]
    if _text(tokens, at) not in ("each", "every") or own[:3] not in (["in", "its", "own"], ["in", "their", "own"]):
        return None
    place = tokens[index + 1]
    rooms = [replace(place, text=word, plural=False) for word in _OF_GROUPS[noun]]
    rooms[-1] = replace(rooms[-1], plural=True)
    people = replace(tokens[index + 3], start=tokens[index + 3].end, end=tokens[index + 3].end)
    link, person = (replace(people, kind="word", text=text, plural=text == "person") for text in ("for", "person"))
    return [tokens[index], *rooms, link, tokens[index + 3], person], each + 4
