"""Count a storey that is told beside a first one: "one storey plus a mezzanine-like second storey" are two."""

from collections.abc import Set as AbstractSet

from mansion_language import Token

__all__ = ["added_storeys"]

_JOINTS = frozenset({"plus", "and", "+", "with"})
_ARTICLES = frozenset({"a", "an", "one"})
_FURTHER = frozenset({"second", "upper", "further", "additional", "extra"})
_WORDS_BETWEEN = 4


def added_storeys(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with one storey and a second one as two storeys."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        end = _end(tokens, index, floor_words) or _attic_end(tokens, index, floor_words)
        if end:
            start, last = tokens[index].start, tokens[end - 1].end
            result.append(Token("number", "two", start, last, 2.0))
            result.append(Token("word", "storey", start, last, plural=True))
        else:
            result.append(tokens[index])
        index = end or index + 1
    return result


_ATTICS = frozenset({"attic", "loft"})


def _attic_end(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the token after "ground floor plus attic" where no number of storeys is told; else 0."""
    texts = [token.text for token in tokens[index : index + 6]]
    if len(texts) < 4 or texts[0] != "ground" or texts[1] not in floor_words or texts[2] not in _JOINTS:
        return 0
    attic = 3 + (texts[3] in ("a", "an", "the"))
    counted = any(token.kind == "number" and tokens[at + 1].text in floor_words for at, token in enumerate(tokens[:-1]))
    if texts[attic : attic + 1] == [] or texts[attic] not in _ATTICS or counted:
        return 0
    return index + attic + 1 + (texts[attic + 1 : attic + 2] != [] and texts[attic + 1] in floor_words)


def _end(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the token after "one storey plus a second storey" at a token; 0 where that is not told."""
    texts = [token.text for token in tokens[index : index + 5 + _WORDS_BETWEEN + 1]]
    one = tokens[index].kind == "number" and tokens[index].value == 1
    if not one or len(texts) < 5 or texts[1] not in floor_words or texts[2] not in _JOINTS:
        return 0
    article = 3 + (texts[3] == "with")
    if texts[article] not in _ARTICLES:
        return 0
    noun = next((at for at in range(article + 1, len(texts)) if texts[at] in floor_words), 0)
    further = not _FURTHER.isdisjoint(texts[article + 1 : noun])
    return index + noun + 1 if noun and further and not tokens[index + noun].plural else 0
