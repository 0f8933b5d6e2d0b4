"""Bring flats that lie one above the other into one form: "two flats, one above the other" are floors with one each."""

from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token

__all__ = ["stacked_flats"]

_FLATS = frozenset({"flat", "apartment", "maisonette"})
_STACKED = (
    ("one", "above", "the", "other"),
    ("one", "over", "the", "other"),
    ("one", "on", "top", "of", "the", "other"),
    ("one", "above", "another"),
    ("one", "over", "another"),
    ("one", "below", "the", "other"),
    ("stacked", "on", "top", "of", "each", "other"),
    ("on", "top", "of", "each", "other"),
    ("stacked",),
)
_ALIKE = frozenset({"alike", "identical", "equal"})
_OTHER_STOREYS = frozenset({"ground", "upstairs", "downstairs", "top", "basement", "cellar", "above", "over", "attic"})
"""Words of storeys that hold something else: the flats are then not all that there is."""


def stacked_flats(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with flats told so as storeys with a flat each, where the brief tells of no other storey."""
    texts = [token.text for token in tokens]
    for index in range(len(tokens) - 2):
        if tokens[index].kind != "number" or texts[index + 1] not in _FLATS or not tokens[index + 1].plural:
            continue
        sized = _size_end(tokens, index + 2)
        at = sized + (texts[sized : sized + 1] == [","])
        last = next((at + len(words) for words in _STACKED if tuple(texts[at : at + len(words)]) == words), 0)
        elsewhere = {
            text for k, text in enumerate(texts)
            if not index <= k < last and (text in _OTHER_STOREYS or (text in floor_words and texts[k - 1] != "own"))
        }  # fmt: skip
        if last and not elsewhere:
            told = _floors(tokens[index], tokens[index + 1], alike=not _ALIKE.isdisjoint(texts[last : last + 2]))
            rest = _by_storey(tokens[last:]) if tokens[index].value == _TWO else tokens[last:]
            if len(rest) != len(tokens) - last or any(a.text != b.text for a, b in zip(rest, tokens[last:])):
                rest = _of_each_floor(rest)
                told = _building(tokens, index) + told[:2]  # what each flat holds is told
            return [*tokens[:index], *told, *_of_each(tokens[index + 2 : sized]), *rest]
    return tokens


_TWO = 2.0
_PLACES = {"lower": "ground", "bottom": "ground", "upper": "upper", "top": "upper", "higher": "upper"}


def _size_end(tokens: list[Token], index: int) -> int:
    """Return where the area of each flat ends that may stand at a token: "of 60 m2 each"."""
    texts = [token.text for token in tokens[index : index + 5]]
    lead = int(texts[:1] in (["of"], ["à"], ["at"], ["with"]))
    lead += texts[lead : lead + 1] in (["about"], ["each"], ["approx"], ["around"])
    if texts[lead + 1 : lead + 2] not in (["m2"], ["ft2"]) or tokens[index + lead].kind != "number":
        return index
    return index + lead + 2 + (texts[lead + 2 : lead + 3] == ["each"])


def _of_each(size: list[Token]) -> list[Token]:
    """Return the area of flats as that of each storey."""
    measured = [token for token in size if token.kind in ("number", "unit")]
    if not measured:
        return []
    at = measured[0].start
    floor = [Token("mark", ",", at, at), *measured]
    return [
        *floor,
        Token("word", "per", measured[-1].end, measured[-1].end),
        Token("word", "floor", at, measured[-1].end),
    ]


def _building(tokens: list[Token], index: int) -> list[Token]:
    """Return the kind of building that flats make, where nothing before them names one."""
    if index and tokens[index - 1].text not in (".", "\n", ":", ";"):
        return []
    at = tokens[index].start
    texts = ("apartment", "building", "with")
    return [Token("word", text, at, tokens[index + 1].end) for text in texts]


def _of_each_floor(tokens: list[Token]) -> list[Token]:
    """Return tokens with "each has" as "each floor has"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        result.append(token)
        if (
            token.text in ("each", "both")
            and index + 1 < len(tokens)
            and tokens[index + 1].text in ("has", "have", "with")
        ):
            result[-1] = replace(token, text="each")
            result.append(Token("word", "floor", token.end, token.end))
    return result


def _by_storey(tokens: list[Token]) -> list[Token]:
    """Return further tokens with "the lower one has" and "the upper flat:" as headings of storeys."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        noun = tokens[index + 1].text if index + 1 < len(tokens) else ""
        if token.text in _PLACES and noun in _FLATS | {"one", "unit"}:
            heads = tokens[index + 2 : index + 3]
            opens = bool(heads) and heads[0].text in ("has", "have", "with", ":", "get", "contain")
            if result and result[-1].text == "the":
                result.pop()
            if opens and result and result[-1].text in ("and", ",", "while", "but"):
                result[-1] = replace(result[-1], kind="mark", text=";")
            floor = replace(tokens[index + 1], text="floor")
            lead = [] if opens else [replace(token, text="on"), replace(token, text="the")]
            result += [*lead, replace(token, text=_PLACES[token.text]), floor]
            if opens:
                held = noun != "one" and heads[0].text == ":" and _lists_rooms(tokens, index + 3)
                result.append(replace(heads[0], kind="mark", text=":"))
                result += _one_flat(tokens[index + 1]) if held else []
            index += 2 + opens
        elif _is_size_of_each(tokens, index):
            result += [*tokens[index : index + 2], Token("word", "per", token.start, token.start)]
            result.append(Token("word", "floor", token.start, tokens[index + 2].end))
            index += 3
        else:
            result.append(token)
            index += 1
    return result


def _lists_rooms(tokens: list[Token], index: int) -> bool:
    """Whether what a flat holds is listed at a token, and not what it is: "one bedroom, bath, kitchen"."""
    for token in tokens[index : index + _LONGEST_ENTRY]:
        if token.text in (",", "and"):
            return True
        if token.text in _ENDS:
            return False
    return False


_LONGEST_ENTRY = 8
_ENDS = frozenset({".", ";", "\n", ""})


def _one_flat(noun: Token) -> list[Token]:
    """Return the tokens of "one flat with", where `noun` stands for the flat."""
    number = Token("number", "one", noun.start, noun.start, 1.0)
    return [number, replace(noun, text="flat", plural=False), Token("word", "with", noun.end, noun.end)]


def _is_size_of_each(tokens: list[Token], index: int) -> bool:
    """Whether a sentence is no more than the area of each flat: "75 m2 each."."""
    texts = [token.text for token in tokens[index + 1 : index + 4]]
    alone = index == 0 or tokens[index - 1].text in _ENDS
    measured = tokens[index].kind == "number" and texts[:1] in (["m2"], ["ft2"]) and texts[1:2] == ["each"]
    return alone and measured and (len(texts) < 3 or texts[2] in _ENDS)


def _floors(number: Token, noun: Token, *, alike: bool) -> list[Token]:
    """Return the tokens of "two floors, each with one flat"."""

    def word(text: str) -> Token:
        return Token("word", text, noun.start, noun.end)

    return [
        number,
        *([word("identical")] * alike),
        replace(noun, text="floor"),
        Token("mark", ",", noun.end, noun.end),
        word("each"),
        word("with"),
        Token("number", "one", noun.start, noun.end, 1.0),
        replace(noun, plural=False),
    ]
