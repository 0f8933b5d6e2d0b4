"""Leave out what only tells again or why: sums of what was listed, work done at home, what people do in a room."""

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["without_asides"]

_SUMS = (
    ("make",),
    ("makes",),
    ("give",),
    ("gives",),
    ("come", "to"),
    ("comes", "to"),
    ("add", "up", "to"),
    ("adds", "up", "to"),
)
_POINTING = frozenset({"that", "this", "which"})
_HOUSES = frozenset({"floor", "storey", "story", "level", "building", "house", "flat", "apartment", "unit", "room"})
"""What a sum may state for the first time: how many storeys or dwellings there are."""
_ENDS = frozenset({".", ";", "\n", "!", "?", ",", ")", "–", "-", "("})
_WORKING = frozenset({"work", "works", "working", "worked"})
_WHO = frozenset({"people", "person", "visitor", "guest", "customer", "client", "kid", "child", "patient"})
_USUAL = frozenset("eat cook sleep sit meet live stay eats sleeps".split())
"""What is done in rooms that the reader knows by it."""
_NAMING = frozenset({"a", "an", "the", "one", "some", "their"})
"""Words before what is there itself: "where guests find a bar"."""
_LONGEST = 7


def without_asides(tokens: list[Token]) -> list[Token]:
    """Return the tokens without those that state nothing of their own.

    "That makes 48 beds" sums up what was listed, "because I work from home" wants no second home, and in "a reception
    where people rent shoes" nobody asks for shoes. One room for two uses ("living/kitchen") is open anyway.
    """
    tokens = _said_otherwise(tokens)
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        skipped = (
            _sum(tokens, index)
            or _total_of_each(tokens, index)
            or _at_home(tokens, index)
            or _done_there(tokens, index)
            or _open_anyway(tokens, index)
            or _some_day(tokens, index)
            or _height_of_somebody(tokens, index)
            or _signature(tokens, index)
            or _on_stage(tokens, index)
            or _order(tokens, index)
        )
        if not skipped:
            result.append(tokens[index])
        index += skipped or 1
    return result


def _order(tokens: list[Token], index: int) -> int:
    """Return the length of "design" where it asks for what follows without an article: "please design office"."""
    asked = _word(tokens, index) == "design" and _word(tokens, index - 1) in ("please", "kindly", "to", "you")
    bare = (
        index + 1 < len(tokens) and tokens[index + 1].kind == "word" and _word(tokens, index + 1) not in _NAMING | _OURS
    )
    return int(asked and bare)


_OURS = frozenset({"my", "our", "your", "me", "us", "this", "that", "it"})


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _end(tokens: list[Token], index: int) -> int:
    while index < len(tokens) and tokens[index].text not in _ENDS:
        index += 1
    return index


def _said_otherwise(tokens: list[Token]) -> list[Token]:
    """Return the tokens with what a bracket explains said outright: "overlooking (i.e. adjoining) the hall"."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        result.append(tokens[index])
        index += 1
        if not result[-1].text.endswith("ing") or _word(tokens, index) != "(":
            continue
        at = index + 1
        lead = {_word(tokens, at), _word(tokens, at + 1), _word(tokens, at + 2)}
        at += 4 if {"i", "e"} <= lead else 2 if _word(tokens, at + 1) == "is" else 1
        explained = ({"i", "e"} <= lead) or _word(tokens, index + 1) in ("that", "meaning", "ie")
        end = next((k for k in range(at, min(at + 4, len(tokens))) if tokens[k].text == ")"), 0)
        if explained and end and _word(tokens, end + 1) == "the":
            result[-1:] = [token for token in tokens[at:end] if token.kind == "word"]
            index = end + 1
    return result


def _sum(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "that makes 48 dorm beds" is; 0 where it states an area or how many storeys."""
    if _word(tokens, index) not in _POINTING:
        return 0
    texts = tuple(token.text for token in tokens[index + 1 : index + 4])
    verb = next((words for words in _SUMS if texts[: len(words)] == words), ())
    number = index + 1 + len(verb)
    if not verb or number >= len(tokens) or tokens[number].kind != "number":
        return 0
    end = _end(tokens, number)
    said = {token.text for token in tokens[number:end]}
    return 0 if said & (_HOUSES | set(AREA)) or end - index > 2 * _LONGEST else end - index


_IN_ALL = (("in", "all"), ("in", "total"), ("in", "sum"), ("altogether",))


def _total_of_each(tokens: list[Token], index: int) -> int:
    """Return of how many tokens ", 24 in all" or "so 4 bedrooms in sum" is after what each of several has; else 0."""
    if _word(tokens, index) not in (",", "so", "("):
        return 0
    number = index + 1
    while _word(tokens, number) in (",", "so", "that", "is", "make"):
        number += 1
    if number >= len(tokens) or tokens[number].kind != "number":
        return 0
    at = number + 1
    at += at < len(tokens) and tokens[at].kind == "word" and _word(tokens, at) not in ("in", "altogether", "and")
    texts = tuple(token.text for token in tokens[at : at + 2])
    total = next((len(words) for words in _IN_ALL if texts[: len(words)] == words), 0)
    bare = _word(tokens, number - 1) == "so" and at == number + 1 and _word(tokens, at) in _ENDS | {""}
    if not (total or bare):
        return 0
    first = index
    while first > 0 and tokens[first - 1].text not in (".", "\n", "!", "?"):
        first -= 1
    said = {token.text for token in tokens[max(first - 1, 0) : index]} | {
        _word(tokens, at) for at in range(first)[-40:]
    }
    if {"each", "every", "per", "both"}.isdisjoint(said):
        return 0
    end = at + total
    return end + (_word(tokens, index) == "(" and _word(tokens, end) == ")") - index


def _at_home(tokens: list[Token], index: int) -> int:
    """Return 2 for "from home" and "at home" after a form of "work", 1 for "home" after one of "come"; else 0."""
    if _word(tokens, index) == "home" and _word(tokens, index - 1) in _COMING:
        return 1
    home = _word(tokens, index) in ("from", "at") and _word(tokens, index + 1) == "home"
    return 2 if home and _word(tokens, index - 1) in _WORKING else 0


_COMING = frozenset(
    "come comes came coming go goes went going return returned returning back move moved moving".split()
)


def _height_of_somebody(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "1.90 m tall" after "I am" is; else 0."""
    told = tuple(token.text for token in tokens[index + 1 : index + 3]) in (
        ("m", "tall"),
        ("cm", "tall"),
        ("ft", "tall"),
    )
    somebody = {_word(tokens, index - 1), _word(tokens, index - 2)} & {"i", "he", "she", "we"}
    return 3 if tokens[index].kind == "number" and told and somebody else 0


_PARTING = frozenset(
    {"thank", "thanks", "cheer", "cheers", "regard", "regards", "sincerely", "greeting", "greetings", "yours", "love"}
)


def _signature(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "Thanks!! Marta" is at the end of a text; else 0."""
    if tokens[index].text not in _PARTING:
        return 0
    rest = tokens[index + 1 :]
    named = [token for token in rest if token.kind != "mark"]
    ends = len(named) < _LONGEST and all(token.kind == "word" and token.capital for token in named[-2:])
    talk = all(
        token.capital or token.text in _PARTING | {"and", "from", "a", "lot", "in", "advance"} for token in named
    )
    return len(rest) + 1 if named and ends and talk else 0


def _on_stage(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "on stage" is after what stands there: it is a part of the hall; else 0."""
    at = index + 1 + (_word(tokens, index + 1) == "the")
    return at + 1 - index if _word(tokens, index) == "on" and _word(tokens, at) == "stage" else 0


def _done_there(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "where people rent shoes" is; 0 where it tells what kind of room that is."""
    if _word(tokens, index) != "where" or _word(tokens, index + 1) not in _WHO:
        return 0
    end = _end(tokens, index)
    inside = tokens[index + 1 : end]
    usual = any(token.text in _USUAL | _NAMING or token.kind != "word" for token in inside)
    return 0 if usual or len(inside) > _LONGEST or len(inside) < 2 else end - index


def _open_anyway(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "open plan" after "living/kitchen" is; else 0."""
    end = index + 1 + (_word(tokens, index + 1) == "-")
    if (
        _word(tokens, index) != "open"
        or _word(tokens, end) != "plan"
        or _word(tokens, index - 2) not in ("/", "-", "+")
    ):
        return 0
    joined = {_word(tokens, index - 1), _word(tokens, index - 3)} <= _DAY_ROOMS
    return end + 1 - index if joined and (_word(tokens, end + 1) in _ENDS | {"", ":", "of", "with"}) else 0


_DAY_ROOMS = frozenset({"living", "kitchen", "dining", "diner", "lounge"})


_MAYBE = frozenset({"maybe", "perhaps", "possibly"})
_LATER = (("some", "day"), ("one", "day"), ("someday",), ("later",), ("in", "future"), ("in", "the", "future"),
          ("not", "now"), ("not", "yet"), ("eventually",), ("next", "year"))  # fmt: skip
_BRACKETS_AND_ENDS = frozenset({".", ";", "\n", "!", "?", ")"})


def _some_day(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "maybe a fourth one some day, not now" is: what is not wanted yet; else 0."""
    if _word(tokens, index) not in _MAYBE:
        return 0
    end = index
    while end < len(tokens) and tokens[end].text not in _BRACKETS_AND_ENDS and end - index <= 2 * _LONGEST:
        end += 1
    texts = [token.text for token in tokens[index:end]]
    later = any(tuple(texts[at : at + len(words)]) == words for words in _LATER for at in range(len(texts)))
    return end - index if later and _word(tokens, end) in _BRACKETS_AND_ENDS | {""} else 0
