"""Read words for what is done somewhere as rooms: "living downstairs, sleeping upstairs", "entrance, kitchen"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["activities", "entrances"]

_ROOMS = {"sleeping": ("bedroom", True), "cooking": ("kitchen", False), "eating": ("dining", False),
          "dining": ("dining", False), "bathing": ("bathroom", False), "living": ("living", False)}  # fmt: skip
"""The room for what is done, and whether there are several."""
_STOREYS = frozenset({"upstairs", "downstairs", "upstair", "downstair"})


def activities(tokens: list[Token]) -> list[Token]:
    """Read "sleeping upstairs" as "bedrooms upstairs", or as where the bedrooms are that stand elsewhere in the text.

    What a colon leads to after it is all the building's.
    """
    result: list[Token] = []
    moved: dict[int, Token] = {}
    index = 0
    while index < len(tokens):
        room = _ROOMS.get(tokens[index].text) if _is_told_of_storey(tokens, index) else None
        if room is None:
            result.append(tokens[index])
            index += 1
            continue
        named = next((at for at, token in enumerate(tokens) if token.text == room[0] and at != index), None)
        if named is None:
            result += [replace(tokens[index], text=room[0], plural=room[1]), tokens[index + 1]]
        else:
            moved[tokens[named].end] = tokens[index + 1]
        index += 2
        if index < len(tokens) and tokens[index].text == ":":
            result.append(replace(tokens[index], text="."))
            index += 1
    return [part for token in result for part in _followed(token, moved)]


def _followed(token: Token, moved: dict[int, Token]) -> list[Token]:
    """Return a token, and after the noun of a room the storey that was said of what is done there."""
    storey = moved.get(token.end)
    return [token] if storey is None else [token, replace(storey, start=token.end, end=token.end)]


def _is_told_of_storey(tokens: list[Token], index: int) -> bool:
    """Whether a storey stands after a token, and a clause begins at it: nothing, a mark or "and" before it."""
    if index + 1 >= len(tokens) or tokens[index + 1].text not in _STOREYS:
        return False
    return index == 0 or tokens[index - 1].kind == "mark" or tokens[index - 1].text in ("and", "with")


_OPENS = frozenset({"", ":", ",", "\n", "-", "*", "•", ".", "an", "with"})
_CLOSES = frozenset({"", ",", ".", ";", "\n", "(", "with", "and", "&"})


_BESIDE = (
    ("next", "to"),
    ("close", "to"),
    ("by",),
    ("beside",),
    ("near",),
    ("at",),
    ("off",),
    ("behind",),
    ("adjoining",),
)
_DOORS = (("main", "entrance"), ("front", "entrance"), ("entrance",), ("front", "door"), ("main", "door"), ("entry",))


def _beside_entrance(tokens: list[Token], index: int) -> int:
    """Return where the words for the entrance end that a room before a token is to lie at: "by the entrance"; or 0."""
    texts = [token.text for token in tokens[index : index + 6]]
    lead = next((len(words) for words in _BESIDE if tuple(texts[: len(words)]) == words), 0)
    if not lead or texts[lead : lead + 1] != ["the"] or not index or tokens[index - 1].kind not in ("word", "mark"):
        return 0
    door = next((len(w) for w in _DOORS if tuple(texts[lead + 1 : lead + 1 + len(w)]) == w), 0)
    end = index + lead + 1 + door
    after = tokens[end].text if end < len(tokens) else ""
    return end if door and after in _CLOSES | {"!", "?", "-", "–", "because", "so", "for"} else 0


def entrances(tokens: list[Token]) -> list[Token]:
    """Read "entrance" as the hall that people come in by: "floor 1: entrance, kitchen", "a den by the entrance"."""
    result: list[Token] = []
    beside = 0
    for index, token in enumerate(tokens):
        end = _beside_entrance(tokens, index)
        beside = end or beside
        if index < beside - 1 and token.text in ("main", "front") and tokens[index + 1].text in ("entrance", "door"):
            continue
        if index == beside - 1 and beside:
            result += [replace(token, text="entrance"), replace(token, text="hall", start=token.end)]
            continue
        result.append(token)
        before = tokens[index - 1].text if index else ""
        after = tokens[index + 1].text if index + 1 < len(tokens) else ""
        entry = token.text == "entrance" and not token.plural and before in _OPENS and after in _CLOSES
        if entry and (before != "." or after == "with"):
            result.append(replace(token, text="hall", start=token.end))
    return result
