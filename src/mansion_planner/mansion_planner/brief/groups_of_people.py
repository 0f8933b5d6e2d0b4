"""Give groups of people their rooms: "three groups of eight residents, each with a kitchen" have eight rooms each."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["groups_of_people"]

_GROUPS = frozenset({"group", "household", "cluster", "unit", "wing", "pod", "ward", "family", "house"})
_ROOMS = {
    "resident": ("resident", "room"), "patient": ("patient", "room"), "senior": ("resident", "room"),
    "elderly": ("resident", "room"), "tenant": ("bedroom",), "student": ("bedroom",), "boarder": ("bedroom",),
    "lodger": ("bedroom",), "guest": ("guest", "room"),
}  # fmt: skip
"""What those who live in a group have a room in."""
_SLEEPING = frozenset({"bedroom", "bed", "room", "dormitory", "dorm", "single", "double", "cell", "bedsit"})
_ENDS = frozenset({".", ";", "\n", "!", "?"})
_LONGEST = 40


def groups_of_people(tokens: list[Token]) -> list[Token]:
    """Return the tokens with a room for each of the people, where the list of each group names no rooms to sleep in."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        start = _list_start(tokens, index)
        if not start:
            result.append(tokens[index])
            index += 1
            continue
        number, people = tokens[index + 2], tokens[index + 3]
        at = tokens[start - 1].end
        nouns = [Token("word", text, people.start, people.end) for text in _ROOMS[people.text]]
        rooms = [replace(number), *nouns[:-1], replace(nouns[-1], plural=number.value > 1)]
        result += [tokens[index], Token("mark", ",", people.end, people.end), *tokens[_each(tokens, index + 4) : start]]
        result += [*rooms, Token("mark", ",", at, at)]
        index = start
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _each(tokens: list[Token], index: int) -> int:
    return index + (_text(tokens, index) == ",")


def _list_start(tokens: list[Token], index: int) -> int:
    """Return where the list of what each group has begins, after the group's noun at a token; or 0."""
    token = tokens[index]
    counted = token.text in _GROUPS and token.plural and index > 0 and tokens[index - 1].kind == "number"
    if not counted or _text(tokens, index + 1) != "of" or _text(tokens, index + 3) not in _ROOMS:
        return 0
    if tokens[index + 2].kind != "number" or not 2 <= tokens[index + 2].value <= 60:
        return 0
    each = _each(tokens, index + 4)
    if _text(tokens, each) not in ("each", "all") or _text(tokens, each + 1) not in ("with", "has", "having", "have"):
        return 0
    start = at = each + 2
    while at < len(tokens) and at - start < _LONGEST and tokens[at].text not in _ENDS:
        counts = at > start and tokens[at - 1].kind == "number"
        if tokens[at].text in _SLEEPING and (tokens[at].plural or counts):
            return 0
        at += 1
    return start
