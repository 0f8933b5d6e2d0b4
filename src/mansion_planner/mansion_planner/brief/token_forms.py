"""Bring tokens into the forms that the lexicon and the readers of storeys know, before anything is read from them."""

from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = [
    "abbreviated_storeys",
    "capacities",
    "compounds",
    "decades",
    "equal_rooms",
    "foreign_storeys",
    "gross_areas",
    "kinds_of_area",
    "metering",
    "open_decks",
    "owned_by_each",
    "parts_before_of_which",
    "to_the_ceiling",
    "upward_ranges",
    "workplaces",
]


def compounds(tokens: list[Token], words: frozenset[str]) -> list[Token]:
    """Join hyphenated words that the lexicon writes as one: "co-working", "check-in"."""
    joined: list[Token] = []
    for index, token in enumerate(tokens):
        last = joined[-1] if joined else None
        after = tokens[index + 1].text if index + 1 < len(tokens) else ""
        diner = last is not None and last.text == "kitchen" and after in ("diner", "dining")
        if token.text == "/" and last is not None and (last.text == "living" or diner) and not token.spaced:
            continue  # "living/dining room" is one room
        if last is not None and (last.text, token.text) == ("double", "height") and not token.spaced:
            joined[-1] = replace(token, text="double-height", start=last.start, spaced=last.spaced)
            continue
        if token.text == "bed" and last is not None and last.kind == "number" and _has_own_bath(tokens, index + 1):
            token = replace(token, text="bedroom", plural=last.value > 1)  # "2 bed attached bath each"
        beds = len(joined) > 1 and joined[-2].kind == "number" and not joined[-1].spaced  # "two-bed rooms"
        if (last is not None and (last.text, token.text) in _APART and not beds) or (
            last is not None
            and not token.spaced
            and last.kind == token.kind == "word"
            and last.text + token.text in words
        ):
            joined[-1] = replace(last, text=last.text + token.text, end=token.end, plural=token.plural)
        else:
            joined.append(token)
    return joined


def _has_own_bath(tokens: list[Token], index: int) -> bool:
    """Whether "(with) attached bath" follows a bed, which is a bedroom then."""
    texts = [token.text for token in tokens[index : index + 3]]
    texts = texts[1:] if texts[:1] == ["with"] else texts
    return texts[:1] in (["attached"], ["ensuite"]) and texts[1:2] in (["bath"], ["bathroom"], ["toilet"], ["washroom"])


_APART = frozenset(
    {("work", "station"), ("class", "room"), ("bed", "room"), ("bath", "room"), ("book", "shelf"), ("ware", "house")}
)
"""Nouns that are one word, and that people write as two."""


_GROSS = (
    *((word, middle, "area") for word in ("gross", "total", "overall") for middle in ("floor", "internal", "external")),
    ("in", "sum"), ("summing", "up", "to"), ("adding", "up", "to"), ("gross", "area"),
    ("built", "up", "area"), ("built", "-", "up", "area"), ("gfa",), ("gia",), ("gea",),
)  # fmt: skip
"""What the area of all storeys is called in a schedule."""


def areas_behind_capacities(tokens: list[Token]) -> list[Token]:
    """Return tokens with "a hall for 10 buses 900 m2" as "a hall for 10 buses, 900 m2"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before = tokens[max(index - 3, 0) : index]
        held = [other.kind for other in before] == ["word", "number", "word"] and before[2].plural
        area = index + 1 < len(tokens) and tokens[index + 1].text in AREA
        if token.kind == "number" and area and held and before[0].text == "for":
            result.append(Token("mark", ",", before[2].end, before[2].end))
        result.append(token)
    return result


def gross_areas(tokens: list[Token]) -> list[Token]:
    """Read "gross floor area: 900 m2" and "GFA 900 m2" as "total area": neither a room nor the area of one floor."""
    result: list[Token] = []
    at = 0
    while at < len(tokens):
        texts = tuple(token.text for token in tokens[at : at + 4])
        named = next((words for words in _GROSS if texts[: len(words)] == words), None)
        if named is None:
            result.append(tokens[at])
            at += 1
            continue
        end = at + len(named)
        shared = end < len(tokens) and tokens[end].text in ("each", "apiece", "per", "/")
        if not (shared and result and result[-1].kind == "unit"):  # "300 m2 gross floor area each" is each storey's
            first, last = tokens[at], tokens[end - 1]
            result += [replace(first, text="total", plural=False), replace(last, text="area", plural=False)]
        at = end
    return result


_KINDS_OF_AREA = frozenset(
    "general overall construction constructed built building covered plinth carpet usable".split()
)
"""What the area of a building is called by, as in "construction area": no room's."""
_TO_MEASURE = frozenset(": = is of about around approx approximately should be must has have with".split())


def kinds_of_area(tokens: list[Token]) -> list[Token]:
    """Read "construction area: 900 m2" and "total built area of 900 m2" as "area" and "total area"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        following = index + 2
        while following < len(tokens) and tokens[following].text in _TO_MEASURE and following < index + 6:
            following += 1
        kind = token.text in _KINDS_OF_AREA and index + 1 < len(tokens) and tokens[index + 1].text == "area"
        if not (kind and following < len(tokens) and tokens[following].kind == "number"):
            result.append(token)
    return result


def capacities(tokens: list[Token], nouns: frozenset[str]) -> list[Token]:
    """Read "a canteen with room for 150" and "canteen seats 150" as "a canteen for 150".

    Parameters
    ----------
    nouns : frozenset of str
        What the names of rooms and buildings end with.
    """
    tokens = _seating_verbs(tokens, nouns)
    texts = [token.text for token in tokens]
    left_out: set[int] = set()
    for index in range(len(tokens) - 3):
        spacious = texts[index] == "with" and texts[index + 1] in ("room", "space") and not tokens[index + 1].plural
        if spacious and texts[index + 2] == "for" and tokens[index + 3].kind == "number":
            left_out |= {index, index + 1}
    return [token for index, token in enumerate(tokens) if index not in left_out]


def _seating_verbs(tokens: list[Token], nouns: frozenset[str]) -> list[Token]:
    """Read "seats 30" after a room as "for 30"; the seats of a list ("table 4, seats 30") have no room before them."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        last = result[-1] if result else None
        verb = token.text == "seat" and last is not None and last.kind == "word" and last.text in nouns
        verb = verb and last is not None and token.plural != last.plural
        number = index + 1 + (index + 1 < len(tokens) and tokens[index + 1].text in ("x", ":"))
        counted = number < len(tokens) and tokens[number].kind == "number"
        if token.text == "x" and last is not None and last.text == "for":
            continue
        result.append(replace(token, text="for", plural=False) if verb and counted else token)
    return result


_WORKPLACES = frozenset("desk workstation workplace seat position employee worker people staff".split())
_AROUND_PLAN = frozenset({",", "(", ":", "-", "–", "with", "for", "of", "about", "to", "at", "least"})


def workplaces(tokens: list[Token]) -> list[Token]:
    """Read "80 covers" as 80 seats, and "open plan, 30 desks" as an open plan office with them.

    "An open plan kitchen" stays what it is, and "bed covers" are not counted by a number before them.
    """
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before = result[-1] if result else None
        counted = before is not None and before.kind == "number" and before.value >= _FEWEST_COVERS
        if counted and token.text == "cover" and token.plural:
            token = replace(token, text="seat")
        result.append(token)
        planned = (before.text if before is not None else "", token.text) == ("open", "plan")
        refused = planned and index > 1 and tokens[index - 2].text in ("no", "not", "without")
        closes = index + 1 == len(tokens) or tokens[index + 1].kind == "mark"
        if planned and (_has_desks(tokens, index + 1) or (refused and closes)):
            result.append(replace(token, text="office", start=token.end))
    return result


def metering(tokens: list[Token]) -> list[Token]:
    """Read the meter of "an electrical meter room" as a noun: no number stands before it."""
    return [
        replace(token, kind="word", text="meter")
        if token.text == "m" and token.end - token.start > 1 and index and tokens[index - 1].kind != "number"
        else token
        for index, token in enumerate(tokens)
    ]


_FEWEST_COVERS = 8
"""Covers that a house for eating out has at least; fewer may cover something."""


def _has_desks(tokens: list[Token], index: int) -> bool:
    """Whether a number of desks follows right after some marks: ", 30 desks", "(24 desks)", "for 40 people"."""
    at = index
    while at < len(tokens) and at < index + 4 and tokens[at].text in _AROUND_PLAN:
        at += 1
    if not index < at < len(tokens) - 1 or tokens[at].kind != "number":
        return False
    return any(token.text in _WORKPLACES for token in tokens[at + 1 : at + 3])


_FOREIGN_STOREYS = {"etage": "floor", "niveau": "level", "niveaux": "level", "planta": "floor", "plant": "floor"}
_SUPERLATIVES = {
    ("most", "upper"): "uppermost", ("most", "top"): "uppermost", ("most", "high"): "uppermost",
    ("most", "lower"): "lowest", ("most", "bottom"): "lowest", ("most", "low"): "lowest",
}  # fmt: skip
_FOREIGN_SIDES = {"low": "ground", "high": "upper", "superior": "upper", "principal": "ground", "inferior": "ground"}


def foreign_storeys(tokens: list[Token]) -> list[Token]:
    """Read words for storeys that writers carry over from their language: "two etages", "the low plant", "up floor"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        side = _FOREIGN_SIDES.get(tokens[index - 1].text, "") if index else ""
        if result and (result[-1].text, token.text) in _SUPERLATIVES:
            result[-1] = replace(token, text=_SUPERLATIVES[result[-1].text, token.text], start=result[-1].start)
            continue
        if token.text in ("floor", "level", "storey") and not token.plural and _is_side(tokens, index - 1):
            result[-1] = replace(result[-1], text="ground" if result[-1].text == "down" else "upper")
        carried = token.text in _FOREIGN_STOREYS and (token.text != "plant" or _is_storey(tokens, index))
        if side and (carried or (token.text in ("floor", "level") and tokens[index - 1].text not in ("low", "high"))):
            result[-1] = replace(result[-1], text=side)
        if carried:
            plural = token.plural or token.text == "niveaux"
            token = replace(token, text=_FOREIGN_STOREYS[token.text], plural=plural)
        result.append(token)
    return result


def abbreviated_storeys(text: str, tokens: list[Token]) -> list[Token]:
    """Read "2 st.,", "per st.", "St. 2-6:" and "typ. floor" in full, and not the saint of "St. Mary".

    Parameters
    ----------
    text : str
        The brief, whose capitals tell whether a full stop ends a sentence.
    tokens : list of Token
    """
    result: list[Token] = []
    shortened, headed = False, -1
    for index, token in enumerate(tokens):
        if index == headed and token.text not in (":", "="):
            result.append(Token("mark", ":", token.start, token.start))
        if token.text == "." and shortened and not _ends_sentence(text, tokens, index):
            shortened = False
            continue
        full = _in_full(tokens, index)
        headed = index + 3 if full is not None and _heads_storey(tokens, index) else headed
        shortened = full is not None
        result.append(full or token)
    return result


_SHORT_STOREYS = {"st": "storey", "fl": "floor", "flr": "floor", "lvl": "level"}


def _in_full(tokens: list[Token], index: int) -> Token | None:
    """Return the word that a token is short for: "typical", or a storey that is counted, numbered or each of them."""
    token, before = tokens[index], tokens[index - 1] if index else None
    if token.text == "typ":
        return replace(token, text="typical")
    if token.text not in _SHORT_STOREYS:
        return None
    noun = replace(token, text=_SHORT_STOREYS[token.text], plural=False)
    if before is not None and before.text in ("per", "/", "each", "every"):
        return noun
    dotted = index + 1 < len(tokens) and tokens[index + 1].text == "."
    following = [other.text for other in tokens[index + 1 : index + 3]]
    if before is not None and before.kind == "number" and token.spaced and dotted:
        return replace(noun, plural=True) if set(following[1:]) <= _AFTER_STOREYS else None
    opens = before is None or before.text in (".", ";", "\n", "-", "*")
    if opens and _heads_storey(tokens, index):
        return noun
    last = _after_numbers(tokens, index + 1 + dotted) if opens else 0
    return replace(noun, plural=last > index + 2 + dotted) if last else None


def _heads_storey(tokens: list[Token], index: int) -> bool:
    """Whether a short form opens a line about a storey: "Fl. 1 reception, two studios"."""
    before = tokens[index - 1].text if index else "."
    after = [token.text if token.kind != "number" else "0" for token in tokens[index + 1 : index + 4]]
    opens = before in (".", ";", "\n", "-", "*") and tokens[index].text in _SHORT_STOREYS.keys() - {"st"}
    return opens and after[:2] == [".", "0"] and after[2:] not in (["-"], ["–"], ["to"], ["and"], [","])


def _after_numbers(tokens: list[Token], index: int) -> int:
    """Return the token after the numbers of a heading such as "2-6:" and "2 and 3 (typical):", or 0."""
    last = index
    while last < len(tokens) and (tokens[last].kind == "number" or tokens[last].text in _NUMBER_LINKS):
        last += 1
    headed = last < len(tokens) and tokens[last].text in (":", "=", "(", "typical", "typ", "identical")
    return last if headed and tokens[index].kind == "number" else 0


_NUMBER_LINKS = frozenset({"-", "–", "to", ",", "and", "&"})


def _ends_sentence(text: str, tokens: list[Token], index: int) -> bool:
    """Whether the full stop of a short form ends a sentence: a capital, a break or nothing comes after it."""
    if index + 1 == len(tokens):
        return True
    following = tokens[index + 1]
    return following.text == "\n" or text[following.start].isupper()


def _attached_to_each(tokens: list[Token]) -> list[Token]:
    """Read "two courtrooms with a chamber attached to each" as "two courtrooms, each with a chamber"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        link = tokens[index - 1].text if index else ""
        end = len(result) - 1 if link == "to" else len(result)
        joined = token.text in ("each", "both") and end > 0 and result[end - 1].text in _ATTACHED
        closed = index + 1 == len(tokens) or tokens[index + 1].text in (",", ".", ";", "\n", ")", "and")
        start = next((at for at in range(end - 2, max(end - 8, 0), -1) if result[at].text == "with"), 0)
        if not (joined and closed and start):
            result.append(token)
            continue
        comma = replace(result[start], kind="mark", text=",", end=result[start].start)
        result[start:] = [comma, replace(token, text="each"), *result[start : end - 1]]
    return result


_ATTACHED = frozenset({"attached", "adjoining", "connected", "annexed", "adjacent", "next", "beside"})


def owned_by_each(tokens: list[Token]) -> list[Token]:
    """Read "every bedroom own bathroom" as "every bedroom its own bathroom"."""
    tokens = _attached_to_each(tokens)
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before = [other.text for other in tokens[max(index - 3, 0) : index]]
        noun = index > 0 and tokens[index - 1].kind == "word" and before[-1] not in _POSSESSIVES
        if token.text == "own" and noun and {"every", "each"} & set(before[:-1]):
            result.append(Token("word", "its", token.start, token.start))
        result.append(token)
    return result


_POSSESSIVES = frozenset(
    {"its", "their", "an", "his", "her", "with", "has", "have", "having", "get", "need", "of", "the"}
)
"""Words before "own" that tell whose something is by themselves, or that "own" goes with."""


def upward_ranges(tokens: list[Token], floor_words: frozenset[str]) -> list[Token]:
    """Read "from the second up to the fourth storey" as "from the second to the fourth storey"."""

    def names_storey(index: int) -> bool:
        token = tokens[index] if 0 <= index < len(tokens) else None
        named = token is not None and (token.kind in ("ordinal", "level") or token.text in floor_words)
        return named or (index > 0 and tokens[index].kind == "number" and tokens[index - 1].text in floor_words)

    result: list[Token] = []
    for index, token in enumerate(tokens):
        following = [other.text for other in tokens[index + 1 : index + 3]]
        final = index + 2 + (following[1:] == ["the"])
        first = names_storey(index - 1) or (index > 0 and tokens[index - 1].kind == "ordinal")
        up = token.text == "up" and following[:1] == ["to"] and first
        if not (up and final < len(tokens) and (names_storey(final) or tokens[final].kind == "number")):
            result.append(token)
    return result


def _is_storey(tokens: list[Token], index: int) -> bool:
    """Whether a plant is a storey: "a school of two plants", "the low plant", and not "with two plants"."""
    if index and tokens[index - 1].text in ("low", "high"):
        return True
    counted = index > 1 and tokens[index - 1].kind in ("number", "ordinal")
    several = tokens[index].plural or (counted and tokens[index - 1].text in ("one", "1"))
    return counted and several and tokens[index - 2].text in ("of", "on", "in", "over")


def _is_side(tokens: list[Token], index: int) -> bool:
    """Whether a token is the side in "in up floor", "Down floor:", and not a way: "one flight up, level 2"."""
    if index < 0 or tokens[index].text not in ("up", "down") or tokens[index].spaced is False:
        return False
    return index == 0 or tokens[index - 1].text in _BEFORE_SIDE


_BEFORE_SIDE = frozenset({"in", "on", "at", "the", "to", "and", ".", ",", ";", ":", "\n", "-", "*"})


def open_decks(tokens: list[Token]) -> list[Token]:
    """Tell the deck that one sits on from the decks of a ship, which are counted or said to be upper and lower."""
    texts = [token.text for token in tokens]
    storeys = any(
        text == "deck"
        and (token.plural or before in ("upper", "lower", "main") or tokens[at].kind in ("number", "ordinal"))
        for at, (before, text, token) in enumerate(zip(texts, texts[1:], tokens[1:], strict=False))
    )
    if storeys:
        return tokens
    return [replace(token, text="sundeck") if token.text == "deck" else token for token in tokens]


_EQUAL = frozenset({"identical", "equal", "similar", "matching"})


def equal_rooms(tokens: list[Token], floor_words: frozenset[str]) -> list[Token]:
    """Read "two identical flats on each floor" as two flats: rooms of one name are alike; storeys may differ."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        counted = bool(result) and result[-1].kind == "number" and token.text in _EQUAL
        noun = tokens[index + 1] if index + 1 < len(tokens) else None
        if not (counted and noun is not None and noun.plural and noun.text not in floor_words | {"house", "home"}):
            result.append(token)
    return result


_AFTER_STOREYS = frozenset({",", ";", "+", "/", "(", "-", "–", "\n", "plus", "and", "with", "on", "in", "of", "high"})


_STYLED = frozenset({"style", "styled", "look", "feel", "flavour", "flavor", "spirit", "manner", "design"})


def decades(tokens: list[Token]) -> list[Token]:
    """Read "1970s", "60s" and "seventies style" as the style of the time: retro, or vintage where it is another.

    "The 1960s" tell when something was built, and after "retro" a decade says nothing more.
    """
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before = result[-1] if result else None
        lead = tokens[index - 2].text if index > 1 else ""
        year = int(before.value) if before is not None and before.kind == "number" else 0
        told = token.text == "s" and not token.spaced and year % 10 == 0 and (20 <= year <= 90 or 1900 <= year < 2000)
        after = tokens[index + 1].text if index + 1 < len(tokens) else ""
        spelt = token.kind == "word" and token.plural and token.text in _SPELT_DECADES and after in _STYLED
        if before is not None and told and lead not in ("the", "retro", "vintage"):
            result[-1] = replace(before, kind="word", text=_style_of(year), end=token.end, value=0.0)
        elif spelt:
            result.append(replace(token, text=_style_of(_SPELT_DECADES[token.text]), plural=False))
        else:
            result.append(token)
    return result


_SPELT_DECADES = {"fifty": 50, "sixty": 60, "seventy": 70, "eighty": 80, "ninety": 90}


def _style_of(year: int) -> str:
    """Return the word for the style of a decade."""
    return "retro" if year % 100 in (50, 60, 70) else "vintage"


def to_the_ceiling(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "floor-to-ceiling" as one word, which names no storey."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        words = tuple(token.text for token in tokens[index : index + 3])
        if words == ("floor", "to", "ceiling"):
            last = tokens[index + 2]
            result.append(replace(tokens[index], text="ceiling-high", kind="word", end=last.end, plural=False))
            index += 3
        else:
            result.append(tokens[index])
            index += 1
    return result


_HAVING = frozenset({"have", "has", "get", "with"})


def parts_before_of_which(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "four bedrooms of which two have a balcony" as "... two of which have a balcony"."""
    result = list(tokens)
    for index in range(1, len(tokens) - 3):
        of, which, number, verb = tokens[index : index + 4]
        parts = (of.text, which.text, number.kind) == ("of", "which", "number") and verb.text in _HAVING
        if parts and tokens[index - 1].kind == "word":
            result[index] = replace(number, start=of.start)
            result[index + 1] = replace(of, start=number.end, end=number.end)
            result[index + 2] = replace(which, start=number.end, end=number.end)
    return result
