"""Leave out what only explains a word: "cell here means a bedroom", "the safe room is for people to shelter in"."""

from mansion_language import Token

__all__ = ["without_glosses"]

_ENDS = frozenset({".", ";", "\n", "!", "?"})
_MEANING = (
    ("mean",),
    ("means",),
    ("stand", "for"),
    ("stands", "for"),
    ("refer", "to"),
    ("refers", "to"),
    ("here", "is"),
)
_COPULAS = frozenset({"is", "are"})
_ARTICLES = frozenset({"the", "a", "an", "that", "this", "our"})
_NO_SUBJECT = _ARTICLES | {"here", "word", "term", "by"}
_PRONOUNS = frozenset({"it", "that", "this", "which", "we", "i", "they", "these", "those", "all", "everything"})
_PLACES = frozenset({"room", "space", "place", "area", "corner", "spot", "somewhere", "part"})
"""Nouns that say nothing of a room: what they are for is all that is told of it."""
_LEADS = frozenset({"with", "where", "for", "that", "which"})
_LAST_PREPOSITIONS = frozenset({"in", "on", "at", "from", "with"})
_SAID = (("is",), ("are",))
_SUBJECT = 5
"""Tokens of what is explained, at most."""
_PURPOSE = 8
"""Tokens of what somebody does in a room, at most."""


def without_glosses(tokens: list[Token]) -> list[Token]:
    """Return the tokens without explanations of words that stand elsewhere in the text, which ask for nothing.

    Of "the cave is a room with projectors" the projectors stay.
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        opens = index == 0 or tokens[index - 1].text in _ENDS
        skipped = (_gloss(tokens, index) if opens else 0) or _purpose(tokens, index) or _contrast(tokens, index)
        skipped = skipped or _plain_room(tokens, index)
        if not skipped:
            result.append(tokens[index])
        index += skipped or 1
    return result


def _texts(tokens: list[Token], first: int, last: int) -> tuple[str, ...]:
    return tuple(token.text for token in tokens[max(first, 0) : max(last, 0)])


def _sentence_end(tokens: list[Token], index: int) -> int:
    while index < len(tokens) and tokens[index].text not in _ENDS:
        index += 1
    return index


def _after_sentence(tokens: list[Token], index: int) -> int:
    """Return where the next sentence begins."""
    return min(_sentence_end(tokens, index) + 1, len(tokens))


def _named_elsewhere(tokens: list[Token], first: int, last: int) -> bool:
    """Whether the words of a subject stand before its sentence, too."""
    words = [token.text for token in tokens[first:last] if token.kind == "word" and token.text not in _NO_SUBJECT]
    before = {token.text for token in tokens[:first]}
    return bool(words) and all(word in before for word in words)


def _gloss(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "Open means they have no doors" is; 0 where a sentence is none."""
    for verb in range(index + 1, min(index + 1 + _SUBJECT, len(tokens))):
        meant = any(_texts(tokens, verb, verb + len(words)) == words for words in _MEANING)
        if meant and tokens[index].text not in _PRONOUNS and _named_elsewhere(tokens, index, verb):
            return _after_sentence(tokens, verb) - index
    return _quoted_gloss(tokens, index)


def _quoted_gloss(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "'Suite' is an office suite" or "the rooms are 'cells' in the leaflet" is; else 0."""
    verb = next((at for at in range(index + 1, index + _SUBJECT + 1) if _texts(tokens, at, at + 1) in _SAID), 0)
    if not verb or not _named_elsewhere(tokens, index, verb):
        return 0
    subject = '"' in _texts(tokens, index, verb) and _texts(tokens, verb + 2, verb + 3) != ("room",)
    predicate = _texts(tokens, verb + 1, verb + 2) == ('"',) and tokens[verb].text == "are"
    return _after_sentence(tokens, verb) - index if subject or predicate else 0


def _plain_room(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "is a room" is in "the cave is a room with projectors"; else 0."""
    words = _texts(tokens, index, index + 4)
    plain = len(words) == 4 and words[0] in _COPULAS and words[1] in ("a", "an") and words[2] in _PLACES
    if not plain or words[3] not in _LEADS:
        return 0
    first = index
    while first > 0 and tokens[first - 1].text not in _ENDS:
        first -= 1
    return 3 if index - first <= _SUBJECT and _named_elsewhere(tokens, first, index) else 0


def _purpose(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "for the nurses to sit in" is after a room that has a name of its own; else 0."""
    if tokens[index].text != "for" or index < 2:
        return 0
    bare = tokens[index - 1].text in _PLACES and (
        tokens[index - 2].text in _ARTICLES or tokens[index - 2].kind != "word"
    )
    if bare:
        return 0
    person = index + 1 + (_texts(tokens, index + 1, index + 2) in (("the",), ("our",)))
    if person + 2 >= len(tokens) or tokens[person + 1].text != "to" or not tokens[person].plural:
        return 0
    end = person + 2
    while end < len(tokens) and tokens[end].kind == "word" and end - index <= _PURPOSE:
        if tokens[end].text in _LAST_PREPOSITIONS:
            closed = end + 1 == len(tokens) or tokens[end + 1].kind == "mark" or tokens[end + 1].text == "and"
            return end + 1 - index if closed else 0
        end += 1
    return 0


def _contrast(tokens: list[Token], index: int) -> int:
    """Return of how many tokens ", not for treating anybody" and ", not a room for a safe" after a gloss is; else 0."""
    if _texts(tokens, index, index + 2) != (",", "not") or index + 3 >= len(tokens):
        return 0
    end = _sentence_end(tokens, index)
    treating = tokens[index + 2].text == "for" and tokens[index + 3].text.endswith("ing")
    first = index
    while first > 0 and tokens[first - 1].text not in _ENDS:
        first -= 1
    explained = tokens[first].text in ("the", "that", "this") and bool(_COPULAS & set(_texts(tokens, first, index)))
    named = tokens[index + 2].text in ("a", "an", "that") and "for" in _texts(tokens, first, index)
    return end - index if treating or (explained and named) else 0
