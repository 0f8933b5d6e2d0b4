"""Give the noun to what is named without it: "12 doubles per floor", "an office, open-plan", "2 two-beds"."""

from dataclasses import replace
from itertools import pairwise

from mansion_language import Token

__all__ = ["flat_types", "shortened_nouns"]

_BEDS = frozenset({"double", "single", "twin", "triple"})
_LODGINGS = frozenset(
    "hotel hostel dorm dormitory inn guesthouse lodge residence motel pension coliving resort guest student".split()
)
"""Words of a brief that is about rooms to sleep in."""
_OFFICES = frozenset("office headquarter headquarters workspace workstation coworking desk startup agency".split())
"""Words of a brief that is about places to work."""
_ENDS = frozenset({"", ",", ".", ";", ":", ")", "\n", "with", "and", "or", "per", "on", "in", "each", "plus"})

_HAIR = frozenset("hair hairdresser hairdressing barber barbershop salon".split())
"""Words of a brief that is about a hairdresser's."""


_WRITTEN_OUT = {"abt": "about"}
"""Words that people write in short."""
_SUM_MARKS = frozenset({"=", "+"})
_OF_EACH = frozenset({"each", "every", "a", "an", "one", "per"})


def shortened_nouns(tokens: list[Token]) -> list[Token]:
    """Return the tokens with rooms where "doubles" are counted, offices where "open-plan" ends, and "w/" as "with".

    The stations of a hairdresser are styling chairs.
    """
    tokens = _without_storey_of_flat(_with_baths_behind(_with_full_names(tokens)))
    texts = {token.text for token in tokens}
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before, after = _text(tokens, index - 1), _text(tokens, index + 1)
        if token.text == "/" and before == "with" and not token.spaced:
            continue
        if _is_of_suite(tokens, index):
            continue
        result.append(replace(token, text=_WRITTEN_OUT.get(token.text, token.text)))
        if token.text in _SUM_MARKS and _is_sum(tokens, index):
            result[-1] = (
                Token("word", "has", token.start, token.end)
                if token.text == "="
                else replace(token, kind="word", text="and")
            )
            continue
        if _sizes_a_home(tokens, index):
            result[-1] = replace(token, spaced=False)
            continue
        if _is_bedroom(tokens, index):
            result[-1] = replace(token, text="bedroom")
            continue
        if _is_master(tokens, index, texts):
            result.append(Token("word", "bedroom", token.end, token.end))
            continue
        if _is_changing(tokens, index):
            result.append(Token("word", "room", token.end, token.end, plural=True))
            continue
        if after not in _ENDS:
            continue
        counted = index > 0 and tokens[index - 1].kind == "number"
        if token.text in _BEDS and token.plural and counted and not _LODGINGS.isdisjoint(texts):
            result[-1] = replace(token, plural=False)
            result.append(Token("word", "room", token.end, token.end, plural=True))
        elif token.text in ("station", "chair") and counted and not _HAIR.isdisjoint(texts):
            result[-1:] = [Token("word", "styling", token.start, token.start), replace(token, text="chair")]
        elif (before, token.text) == ("open", "plan") and not _OFFICES.isdisjoint(texts):
            result.append(Token("word", "office", token.end, token.end))
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


_SEMI = ("semi", "detached", "house")
_FOR_STORAGE = frozenset({("self", "storage"), ("storage", "unit"), ("storage", "center"), ("storage", "centre")})


def _with_full_names(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "3 bed semi" as a semi-detached house, and the units of a self-storage as for storage."""
    pairs = set(pairwise(token.text for token in tokens))
    stored = not pairs.isdisjoint(_FOR_STORAGE)
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before, after = _text(tokens, index - 1), _text(tokens, index + 1)
        if _lives_and_works(tokens, index):
            continue
        if token.text == "semi" and after in _ENDS:
            result += [replace(token, text=word, plural=False) for word in _SEMI]
            continue
        counted = index > 0 and tokens[index - 1].kind == "number"
        if token.text == "unit" and stored and (counted or before in _OF_EACH | {"large", "small"} or after == ":"):
            result.append(Token("word", "storage", token.start, token.start))
        result.append(token)
    return result


_LIVE_WORK = (("live", "/", "work"), ("live", "work"), ("work", "/", "live"), ("living", "/", "working"))
_STUDIOS = frozenset({"studio", "unit", "loft", "apartment", "flat"})


def _lives_and_works(tokens: list[Token], index: int) -> bool:
    """Whether a token is one of "live/work" before a studio, which is a dwelling all the same."""
    for words in _LIVE_WORK:
        for first in range(index - len(words) + 1, index + 1):
            said = tuple(token.text for token in tokens[max(first, 0) : first + len(words)])
            if said == words and _text(tokens, first + len(words)) in _STUDIOS:
                return True
    return False


def _with_baths_behind(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "ten en-suite rooms" as "ten rooms en suite", where rooms are those to sleep in."""
    if _LODGINGS.isdisjoint(token.text for token in tokens):
        return tokens
    result = list(tokens)
    for index in range(len(tokens) - 2, 0, -1):
        size = 2 if [token.text for token in tokens[index : index + 2]] == ["en", "suite"] else 1
        noun = index + size
        led = tokens[index].text == "ensuite" or size == 2
        rooms = noun < len(tokens) and tokens[noun].text == "room" and tokens[noun].plural
        if led and rooms and tokens[index - 1].kind == "number":
            result[index : noun + 1] = [tokens[noun], *tokens[index:noun]]
    return result


_ONE_HOME = frozenset(
    {"flat", "apartment", "house", "bungalow", "home", "maisonette", "condo", "penthouse", "cottage", "villa"}
)


def _sizes_a_home(tokens: list[Token], index: int) -> bool:
    """Whether bedrooms are counted for one home whose noun follows, hyphen or not: "two bedroom flat"."""
    if tokens[index].text not in ("bed", "bedroom") or tokens[index].plural or not index:
        return False
    after = tokens[index + 1 : index + 2]
    counted = tokens[index - 1].kind == "number" and not tokens[index - 1].soft
    several = index > 1 and tokens[index - 2].kind == "number"  # "six two bedroom flats"
    return counted and bool(after) and after[0].text in _ONE_HOME and (several or not after[0].plural)


def _without_storey_of_flat(tokens: list[Token]) -> list[Token]:
    """Return the tokens without where the flat lies that is asked for: "two-bedroom ground floor flat"."""
    for index in range(min(len(tokens) - 3, _OPENING)):
        floor = tokens[index + 1].text in ("floor", "storey", "story", "level") and not tokens[index + 1].plural
        where = tokens[index].text in ("ground", "top", "upper") or tokens[index].kind == "ordinal"
        sized = index and tokens[index - 1].text in ("bed", "bedroom", "room")
        if where and floor and sized and tokens[index + 2].text in ("flat", "apartment"):
            return [*tokens[:index], *tokens[index + 2 :]]
    return tokens


_OPENING = 8
"""Tokens from the start in which a brief names the flat that it is about."""


def _is_sum(tokens: list[Token], index: int) -> bool:
    """Whether a mark tells what each of several holds: "every lodge = bedroom + shower + kitchenette"."""
    first = index
    while first > 0 and tokens[first - 1].text not in (".", ";", "\n", ":", ",", "!"):
        first -= 1
    equal = next((at for at in range(first, index + 1) if tokens[at].text == "="), 0)
    return equal - first in (2, 3) and tokens[first].text in _OF_EACH and tokens[equal - 1].kind == "word"


def _is_of_suite(tokens: list[Token], index: int) -> bool:
    """Whether a bedroom, or the mark after it, opens "each suite = bedroom + bathroom": it is the suite itself."""
    at = index - (tokens[index].text in ("+", ","))
    bedroom = at >= 2 and tokens[at].text == "bedroom" and tokens[at - 1].text in ("=", "has", "with", "of")
    if not (bedroom and tokens[at - 2].text == "suite" and _text(tokens, at + 1) in ("+", ",")):
        return False
    return any(token.text == "bedroom" and _text(tokens, k + 1) == "suite" for k, token in enumerate(tokens[:at]))


_BATHS = frozenset({"bath", "bathroom", "ba", "ensuite", "shower", "wc"})
_BEFORE_ROOMS = frozenset(
    {"", ":", ",", "upstairs", "upstair", "downstairs", "downstair", "up", ".", "\n", ";", "-", "("}
)
_SENTENCE = 24
"""Tokens in which the bathroom is looked for that is listed beside "3 beds"."""


def _is_bedroom(tokens: list[Token], index: int) -> bool:
    """Whether a bed stands for a bedroom, as in adverts: "3 bed, 1 bath", "an ensuite to the main bed"."""
    if tokens[index].text != "bed" or index == 0:
        return False
    if tokens[index - 1].text in ("main", "master"):
        return _text(tokens, index + 1) in _ENDS
    if tokens[index - 1].kind != "number" or tokens[index - 1].soft or _text(tokens, index - 2) not in _BEFORE_ROOMS:
        return False
    at = index + 1
    while at < len(tokens) and at - index < _SENTENCE and tokens[at].text not in (".", ";", "\n"):
        listed = tokens[at - 1].kind == "number" or tokens[at - 1].text in ("a", "one", "family", ",", "and", "+", "&")
        if tokens[at].text in _BATHS and listed:
            return _text(tokens, index + 1) in (",", "(", "and", "&", "+")
        if tokens[at].text in ("with", "room", "each", "per"):
            return False
        at += 1
    return False


def _is_master(tokens: list[Token], index: int, texts: set[str]) -> bool:
    """Whether a master stands for the main bedroom of a home: "first floor: master with ensuite"."""
    bedrooms = not {"bedroom", "ensuite", "bed", "br"}.isdisjoint(texts)
    listed = _text(tokens, index - 1) in _BEFORE_ROOMS | {"and", "a", "one", "large", "big"}
    followed = _text(tokens, index + 1) in (",", "with", "and", "+", ".", "w", "ensuite", ";", "")
    return tokens[index].text == "master" and bedrooms and listed and followed


def _is_changing(tokens: list[Token], index: int) -> bool:
    """Whether changing rooms are named by their sexes alone: "a store, changing m/f"."""
    sexes = [token.text for token in tokens[index + 1 : index + 4]]
    parted = sexes in (["m", "/", "f"], ["f", "/", "m"], ["m", "&", "f"], ["m", "and", "f"], ["m", "/", "w"])
    return tokens[index].text in ("changing", "locker") and parted and not tokens[index].plural


_HOUSING = frozenset(
    """
    apartment flat residential housing studio tenement condominium condo maisonette dwelling penthouse
    """.split()
)
"""Words of a brief that is about flats: elsewhere "two-bed" may be of a hospital."""
_SIZES = frozenset({"bed", "bedroom", "br", "bdr", "bedder", "room", "roomer"})
_UNITS = frozenset({"unit", "apt", "dwelling", "residence"})
_NOUNS = frozenset({"flat", "apartment", "maisonette", "home", "penthouse", "suite"}) | _UNITS
_JOINTS = frozenset({"and", ",", "&", "+", "/", "plus", "or"})
_ENDS_OF_TYPES = (
    frozenset({"", ".", ";", ")", ":", "\n", "per", "on", "each", "in", "at", "for", "a", "with"}) | _JOINTS
)


def flat_types(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the noun that "two-bed", "2BR unit" and "three-bedder" leave out."""
    if _HOUSING.isdisjoint(token.text for token in tokens):
        return tokens
    result: list[Token] = []
    for index, token in enumerate(tokens):
        previous = tokens[index - 1] if index else None
        if token.text in _UNITS and index > 1 and _is_size(tokens, index - 1):
            result.append(replace(token, text="flat"))
            continue
        if previous is not None and _is_size(tokens, index):
            many = tokens[index - 2].value if index > 1 and tokens[index - 2].kind == "number" else 1.0
            several = token.plural or many > 1
            counted = token.plural or (index > 1 and (tokens[index - 2].kind == "number" or _is_article(tokens, index)))
            noun = "bed" if token.text == "bedder" else "room" if token.text == "roomer" else token.text
            result.append(replace(token, text=noun, plural=False))
            if counted and _word(tokens, index + 1) in _ENDS_OF_TYPES and not _shares_noun(tokens, index + 1):
                result.append(Token("word", "flat", token.start, token.end, plural=several))
            continue
        result.append(token)
    return result


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _is_article(tokens: list[Token], index: int) -> bool:
    return _word(tokens, index - 2) in ("a", "an", "another", "each", "every")


def _is_size(tokens: list[Token], index: int) -> bool:
    """Whether "bed" of "two-bed" stands at a token."""
    size, number = tokens[index], tokens[index - 1]
    return size.text in _SIZES and not size.spaced and number.kind == "number" and 1 <= number.value <= 8


def _shares_noun(tokens: list[Token], index: int) -> bool:
    """Whether types that are joined have their noun at the end: "one 1-bed and two 2-bed flats"."""
    while _word(tokens, index) in _JOINTS:
        while _word(tokens, index) in _JOINTS | {"a", "an"}:
            index += 1
        while index < len(tokens) and (tokens[index].kind == "number" or tokens[index].text in _SIZES):
            index += 1
        if _word(tokens, index) in _NOUNS:
            return index > 1 and _is_size(tokens, index - 1)
    return False
