"""Count the people who have a room each: "the parents and three children each have a bedroom of their own"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["rooms_by_person"]

_ONE = frozenset({"the", "a", "an", "our", "my", "one", "his", "her", "their", "each", "also"})
_PAIRS = frozenset({"parent", "couple", "grandparent"})
"""Those who share a room as a pair, in the plural too."""
_PERSONS = _PAIRS | frozenset(
    """
    child kid boy girl son daughter grandmother grandfather grandma grandpa granny mother father mum mom dad aunt uncle
    teenager baby guest nanny au-pair lodger tenant partner doctor dentist therapist lawyer editor director manager
    teacher researcher professor engineer architect consultant secretary assistant developer nurse vet physio me
    """.split()
)
_VERBS = frozenset({"has", "have", "get", "gets", "need", "needs", "want", "wants", "sleep", "should", "must", "will"})
_LEADS = frozenset({"in", "to", "have", "get", "a", "an", "his", "her", "its", "their", "own"})


def rooms_by_person(tokens: list[Token]) -> list[Token]:
    """Return the tokens with a number of rooms where several persons have one each.

    "The parents and three children each have a bedroom of their own" becomes "four bedrooms".
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        friends = _friends(tokens, index)
        if friends is not None:
            many, last = friends
            result.append(Token("number", str(many), tokens[index].start, tokens[last].end, float(many)))
            index = last + 1
            continue
        found = _owners(tokens, index)
        if found is None:
            result.append(tokens[index])
            index += 1
            continue
        many, begin, last = found
        result.append(Token("number", str(many), tokens[index].start, tokens[begin - 1].end, float(many)))
        nouns = tokens[begin:last]
        result += [*nouns[:-1], replace(nouns[-1], plural=True)]
        index = _after_own(tokens, last)
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _friends(tokens: list[Token], index: int) -> tuple[int, int] | None:
    """Return how many rooms "each of us one bedroom" is after "me and 3 friends", and the token of "one"."""
    if tuple(token.text for token in tokens[index : index + 3]) != ("each", "of", "us"):
        return None
    one = index + 3 + (_text(tokens, index + 3) in _VERBS)
    if _text(tokens, one) not in ("a", "an", "one"):
        return None
    for at in range(index - 3, -1, -1):
        writer = _text(tokens, at) in ("me", "i", "myself") and _text(tokens, at + 1) in ("and", "plus", "with")
        number = at + 2 + (_text(tokens, at + 2) in ("my", "the"))
        if writer and tokens[number].kind == "number":
            return int(tokens[number].value) + 1, one
    return None


def _owners(tokens: list[Token], index: int) -> tuple[int, int, int] | None:
    """Return how many rooms persons listed at a token have, and the first and the last token of the rooms' noun."""
    if _text(tokens, index - 1) in _ONE or (index and tokens[index - 1].kind == "number"):
        return None
    many, groups, at = 0, 0, index
    while True:
        at += _text(tokens, at) in _ONE and at + 1 < len(tokens) and tokens[at + 1].kind == "number"
        at -= _text(tokens, at) in _PERSONS and at > index and _text(tokens, at - 1) in _ONE  # "the couple"
        counted = at < len(tokens) and tokens[at].kind == "number" and tokens[at].text not in _PERSONS
        begin = at
        at += counted or _text(tokens, at) in _ONE
        if _text(tokens, at) not in _PERSONS:
            return None
        shared = tokens[at].text in _PAIRS
        if tokens[at].plural and not counted and not shared:
            return None
        many += int(tokens[begin].value) if counted and not shared else 1
        groups += 1
        at += 1
        at += _text(tokens, at) == "," and _text(tokens, at + 1) == "and"
        if _text(tokens, at) not in ("and", ",", "&", "plus"):
            break
        at += 1
    if groups < 2 or _text(tokens, at) not in {"each", "all"} | _VERBS:
        return None
    begin = at
    while _text(tokens, begin) in {"each", "all"} | _VERBS | _LEADS:
        begin += 1
    said = {_text(tokens, k) for k in range(at, begin)}
    last = begin
    while last < len(tokens) and last - begin < 3 and tokens[last].kind == "word" and _text(tokens, last) not in _LINKS:
        last += 1
    own = "own" in said or _text(tokens, last) == "of" or _text(tokens, last) == "each" or "each" in said
    return (many, begin, last) if own and last > begin and many > 1 else None


_LINKS = frozenset("of each and with on in at for which that to next , all there upstairs downstairs".split())


def _after_own(tokens: list[Token], index: int) -> int:
    """Return the token after "of their own" or "each"."""
    if _text(tokens, index) == "of" and _text(tokens, index + 2) == "own":
        return index + 3
    return index + (_text(tokens, index) == "each")
