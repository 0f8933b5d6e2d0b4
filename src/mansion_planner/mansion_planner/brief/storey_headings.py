"""Bring headings of storeys into one form: "Workshop level (ground): ...", "Level 1,2,3 same: ...", "- upper: ..."."""

import itertools
from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token
from mansion_planner.brief.storey_forms import ABOVE_GROUND

__all__ = ["storey_headings"]

_SIDES = frozenset(
    "ground upper lower top middle basement cellar upstairs downstairs upstair downstair up down attic".split()
)
"""Words that name a storey by its place, without a noun."""
_LOW = frozenset({"down", "downstairs", "downstair", "below", "ground"})
_HIGH = frozenset({"up", "upstairs", "upstair", "above"})
_ENDS = frozenset({".", ";", "\n", "!", "?"})
_COLONS = frozenset({":", "="})
_HOLD = frozenset({"has", "have", "with", "hold", "holds", "contain", "contains", "get", "each", ":", "both", "all"})
_ALIKE = frozenset({"same", "identical", "alike", "typical", "equal"})
_NO_ROOMS = frozenset(
    """
    is are be has have hold contain with and or to of for the a an as like same identical typical equal only will
    should must can get take house above below at on in from up down that which where plus by through each both all
    it we they serve repeat again too also floor level storey deck
    """.split()
)
"""Words after a storey's number that no room is called by."""
_LONGEST_TITLE = 4
_LONGEST_CLAUSE = 12


def storey_headings(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with each such heading at the start of a sentence, with a noun and a colon."""
    found = _shared_out(_one_and_another(tokens, floor_words), floor_words)
    found = _rooms_each(found, floor_words)
    found = _numbers_in_a_row(_split_decimals(found, floor_words), floor_words)
    found = _by_bracket(found, floor_words)
    found = _above_rooms(_behind_rooms(_with_marks(found), floor_words), floor_words)
    found = _set_apart(_without_uses(found, floor_words), floor_words)
    return _with_colons(_by_ordinals(found, floor_words), floor_words)


def _starts(tokens: list[Token], index: int) -> bool:
    """Whether a token is the first of its sentence."""
    return index == 0 or tokens[index - 1].text in _ENDS


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _split_decimals(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "1,2" after a word for storeys as two numbers: "levels 1,2,3"."""
    result: list[Token] = []
    listed = False
    for token in tokens:
        parts = token.text.split(",") if token.kind == "number" else []
        if listed and len(parts) == 2 and all(part.isdigit() and len(part) < 3 for part in parts):
            comma = token.start + len(parts[0])
            result.append(replace(token, text=parts[0], end=comma, value=float(parts[0])))
            result.append(Token("mark", ",", comma, comma + 1, spaced=False))
            result.append(replace(token, text=parts[1], start=comma + 1, value=float(parts[1]), spaced=False))
            continue
        listed = token.text in floor_words or (listed and (token.kind == "number" or token.text in (",", "and", "&")))
        result.append(token)
    return result


def _numbers_in_a_row(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "Level 1, 2, 3 same:" as "Levels 1 to 3:"."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        last = _row_end(tokens, index + 1) if token.text in floor_words and _starts(tokens, index) else 0
        if not last:
            result.append(token)
            index += 1
            continue
        first, final = tokens[index + 1], tokens[last - 1]
        link = Token("word", "to", first.end, final.start)
        result += [replace(token, plural=True), first, link, final]
        index = last
        after = _text(tokens, index) in _ALIKE and _text(tokens, index + 1) in _COLONS
        index += after
    return result


def _row_end(tokens: list[Token], index: int) -> int:
    """Return where three storeys or more in a row end before a colon or a word that they are alike, or 0."""
    numbers: list[float] = []
    at = index
    while at < len(tokens) and tokens[at].kind == "number":
        numbers.append(tokens[at].value)
        at += 1
        joint = _text(tokens, at) in (",", "and", "&", "/") and at + 1 < len(tokens) and tokens[at + 1].kind == "number"
        if not joint:
            break
        at += 1
    following = all(later == earlier + 1 for earlier, later in itertools.pairwise(numbers))
    headed = _text(tokens, at) in _COLONS | _ALIKE
    return at if len(numbers) > 2 and following and headed else 0


def _one_and_another(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "one storey for the public, one above for monks" as "two storeys for the public, for monks"."""
    for index, token in enumerate(tokens[:-1]):
        if token.kind != "number" or _text(tokens, index + 1) not in floor_words or not 1 <= token.value <= 99:
            continue
        for at in range(index + 2, min(index + _LONGEST_CLAUSE, len(tokens) - 1)):
            if tokens[at].text in _ENDS:
                break
            above = tokens[at].kind == "number" and tokens[at + 1].text in ("above", "over")
            goes_on = _text(tokens, at + 2) not in floor_words | {"ground", "the"}
            if above and goes_on and tokens[at - 1].text in (",", "and"):
                value = token.value + tokens[at].value
                sum_of_both = replace(token, text=f"{value:.0f}", value=value)
                noun = replace(tokens[index + 1], plural=True)
                return [*tokens[:index], sum_of_both, noun, *tokens[index + 2 : at], *tokens[at + 2 :]]
    return tokens


def _shared_out(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "8 flats on two floors (4 per floor)" as "two floors, 4 flats on each floor"."""
    for index in range(len(tokens) - 5):
        texts = [token.text for token in tokens[index : index + 5]]
        bracket = texts[0] == "(" and texts[2] in ("per", "each", "a") and texts[3] in floor_words and texts[4] == ")"
        if not bracket or tokens[index + 1].kind != "number":
            continue
        each = tokens[index + 1].value
        storeys = tokens[index - 2].value if index > 1 and tokens[index - 1].text in floor_words else 0
        lead = index - 3
        total = next((at for at in range(lead, max(lead - 8, -1), -1) if tokens[at].value == each * storeys), None)
        if not storeys or total is None or tokens[lead].text not in ("on", "over", "across", "in"):
            continue
        count = replace(tokens[index + 1], start=tokens[total].start, end=tokens[total].end)
        at = tokens[index + 2]
        every = [replace(at, text="on"), replace(at, text="each", start=at.end), tokens[index + 3]]
        comma = Token("mark", ",", tokens[index - 1].end, tokens[index - 1].end)
        held = [count, *tokens[total + 1 : lead], *every]
        return [*tokens[:total], *tokens[index - 2 : index], comma, *held, *tokens[index + 5 :]]
    return tokens


def _rooms_each(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "three levels above ground, sixteen rooms each" as "three levels, each with sixteen rooms"."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        result.append(token)
        index += 1
        counted = token.text in floor_words and token.plural and _text(tokens, index - 1) == token.text
        if not counted or not any(before.kind == "number" for before in tokens[max(index - 4, 0) : index - 1]):
            continue
        comma = index + 2 * ([t.text for t in tokens[index : index + 2]] == ["above", "ground"])
        last = _closing_each(tokens, comma + 1) if _text(tokens, comma) == "," else 0
        if last:
            at = tokens[comma].end
            result += [tokens[comma], Token("word", "each", at, at), Token("word", "with", at, at)]
            result += tokens[comma + 1 : last]
            index = last + 1
    return result


def _closing_each(tokens: list[Token], index: int) -> int:
    """Return the "each" that closes a number of rooms at a token, "sixteen rooms each,", or 0."""
    if index >= len(tokens) or tokens[index].kind != "number":
        return 0
    last = index + 1
    while last < len(tokens) and tokens[last].kind == "word" and tokens[last].text != "each" and last - index < 4:
        last += 1
    closed = last + 1 >= len(tokens) or tokens[last + 1].text in _ENDS | {","}
    return last if _text(tokens, last) == "each" and tokens[last - 1].plural and closed else 0


def _by_bracket(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "Workshop level (ground): ..." as "ground level: ...": what a storey is called tells no room of it."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        noun = _titled(tokens, index, floor_words)
        if not noun:
            result.append(tokens[index])
            index += 1
            continue
        place = tokens[noun + 2]
        result.append(replace(place, start=tokens[index].start))
        if place.text not in _SIDES - {"ground", "upper", "lower", "top", "middle"}:
            result.append(replace(tokens[noun], start=place.end, end=place.end))
        index = noun + 4 + (_text(tokens, noun + 3) in floor_words)
    return result


def _titled(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the noun of a storey with a title and its place in brackets that begins at a token, or 0."""
    if not _starts(tokens, index) and _text(tokens, index - 1) != ":":
        return 0
    at = index
    while at < len(tokens) and tokens[at].kind == "word" and tokens[at].text not in floor_words:
        at += 1
    if not index < at <= index + _LONGEST_TITLE or _text(tokens, at) not in floor_words or at + 3 >= len(tokens):
        return 0
    place = tokens[at + 2]
    end = at + 3 + (_text(tokens, at + 3) in floor_words)
    placed = place.kind == "ordinal" or place.text in _SIDES
    bracketed = _text(tokens, at + 1) == "(" and placed and _text(tokens, end) == ")"
    return at if bracketed and _text(tokens, end + 1) in _COLONS else 0


def _without_uses(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "L2-L4: wards, each level with ten rooms" without the wards: the rooms are what the storeys hold."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        result.append(tokens[index])
        index = _after_use(tokens, index, floor_words) or index + 1
    return result


def _after_use(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the token after ": wards, each level with" that begins at a token, or 0."""
    if tokens[index].text != ":" or index + 6 > len(tokens):
        return 0
    noun = index + 1 + (tokens[index + 1].kind == "word" and tokens[index + 2].kind == "word")
    used = tokens[noun].kind == "word" and tokens[noun].plural and _text(tokens, noun + 1) == ","
    each = _text(tokens, noun + 2) in ("each", "every") and _text(tokens, noun + 3) in floor_words
    headed = any(t.kind == "level" or t.text in floor_words for t in tokens[max(index - 5, 0) : index])
    return noun + 5 if used and each and headed and _text(tokens, noun + 4) in ("with", "has", "having") else 0


def _set_apart(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Begin a sentence at a heading within one: "two floors - ground: a hall", "she wants all down: her bedroom"."""
    headings = {
        tokens[at].text
        for at in range(len(tokens) - 1)
        if _text(tokens, _heading_end(tokens, at, floor_words)) in _COLONS
    }
    paired = bool(headings & _LOW) and bool(headings & _HIGH | headings & {"upper"})
    result: list[Token] = []
    for index, token in enumerate(tokens):
        headed = _text(tokens, _heading_end(tokens, index, floor_words)) in _COLONS
        before = result[-1] if result else None
        if headed and before is not None and token.text in _SIDES and before.text not in _ENDS:
            if before.text in (",", "-", "–", ":") and (before.text != "-" or before.spaced):
                result[-1] = replace(before, kind="mark", text=";")
            elif paired and token.text in _LOW | _HIGH and token.text != "ground" and _tells_who(before):
                result.append(Token("mark", ".", before.end, before.end))
        result.append(token)
    return result


def _tells_who(token: Token) -> bool:
    """Whether a token ends what is said before a place: "she wants everything down:", not "one flight up:"."""
    return token.kind == "word" and token.text not in _WAYS


_WAYS = frozenset("flight floor storey level way one stair step deck further half all the very".split())


_SHORT = frozenset({"g", "basement", "roof", "attic"})
"""Names of storeys beside which a number before "=" is one too."""


def _with_marks(tokens: list[Token]) -> list[Token]:
    """Read "G = lobby", "1 = wards" and "; up - two offices" with a colon, where other storeys are headed so."""
    heads = {
        at for at, token in enumerate(tokens[:-1])
        if _starts(tokens, at) and tokens[at + 1].text == "="
        and (token.kind in ("number", "level") or token.text in _SHORT)
    }  # fmt: skip
    headed = len(heads) > 1 and any(tokens[at].text in _SHORT for at in heads)
    grounded = any(tokens[at].text == "g" for at in heads)
    result: list[Token] = []
    for index, token in enumerate(tokens):
        after_head = headed and index - 1 in heads
        sides = _text(tokens, index - 1) in ("up", "down", "above", "below") and _starts(tokens, index - 1)
        dash = token.text in ("-", "–") and sides and token.spaced
        if after_head and tokens[index - 1].kind == "number":
            result[-1] = replace(result[-1], kind="level", text=ABOVE_GROUND if grounded else f"l{result[-1].text}")
        result.append(replace(token, kind="mark", text=":") if after_head or dash else token)
    return result


_NOT_BEFORE = frozenset(
    """
    the a an on in at of to from for and or with our its each every all both per first second third one is are be as
    over above below under than by through until into only this that no without not , ( - – : ; .
    """.split()
)
"""Words and marks before a storey that is named in a form of its own."""


def _behind_rooms(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "classrooms and lounge first floor, bedrooms second floor" with "on the" before the storeys."""
    others = {at for at, token in enumerate(tokens) if token.text in floor_words | _OTHER_STOREYS}
    result: list[Token] = []
    for index, token in enumerate(tokens):
        if token.kind == "ordinal" and token.value == 1 and _text(tokens, index + 1) in ("basement", "cellar"):
            continue  # "the first basement level"
        named = token.kind == "ordinal" or token.text in ("ground", "top")
        storey = named and _text(tokens, index + 1) in floor_words and not tokens[index + 1].plural
        closed = index + 2 >= len(tokens) or tokens[index + 2].text in _ENDS | {","}
        before = tokens[index - 1] if index else None
        room = before is not None and before.kind == "word" and before.text not in _NOT_BEFORE | floor_words
        room = room and before is not None and len(before.text) > 1 and not _starts(tokens, index - 1)
        grounded = before is not None and before.text == "all" and token.text == "ground"
        if storey and closed and (room or grounded) and _other_than(others, index):
            at = token.start
            if grounded and _text(tokens, index - 2) in ("-", "–"):
                result[-2] = replace(result[-2], kind="mark", text=",")
            result += [Token("word", "on", at, at), Token("word", "the", at, at)]
        result.append(token)
    return result


_OTHER_STOREYS = frozenset({"upstairs", "upstair", "downstairs", "basement"})


def _other_than(storeys: AbstractSet[int], index: int) -> bool:
    """Whether storeys stand elsewhere than at a token and the one after it."""
    return len(storeys) > (index in storeys) + (index + 1 in storeys)


_HOMES = frozenset({"flat", "apartment", "maisonette", "home"})
_LIVED_IN = frozenset({"bedroom", "bed", "living", "kitchen"})
_OWN = frozenset({"her", "his", "their", "our", "my", "the", "a", "an"})


def _above_rooms(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "Above the shop: her apartment, bedroom, bath" as "upper floor: her apartment has bedroom, bath"."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        noun = index + 1 + (_text(tokens, index + 1) in _OWN)
        headed = token.text in ("above", "over") and _starts(tokens, index) and noun > index + 1
        colon = noun + 1 if _text(tokens, noun + 1) == ":" else noun + 2
        if not headed or _text(tokens, colon) != ":" or not all(t.kind == "word" for t in tokens[noun:colon]):
            result.append(token)
            index += 1
            continue
        if tokens[noun].text in floor_words | {"ground"}:
            result.append(token)
            index += 1
            continue
        floor = Token("word", "floor", token.end, tokens[colon - 1].end)
        result += [replace(token, text="upper"), floor, tokens[colon]]
        index = colon + 1
        home = index + (_text(tokens, index) in _OWN)
        lists = {t.text for t in tokens[home : home + 12]} & _LIVED_IN
        if _text(tokens, home) in _HOMES and _text(tokens, home + 1) in (",", ":", "-") and lists:
            article = Token("word", "a", tokens[home].start, tokens[home].start)
            result += [article, tokens[home], Token("word", "with", tokens[home].end, tokens[home].end)]
            index = home + 2
    return result


def _heading_end(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the token after a storey that is named by its place; the end of the text where none is."""
    if tokens[index].text not in _SIDES | _HIGH | _LOW:
        return len(tokens)
    return index + 1 + (_text(tokens, index + 1) in floor_words)


def _by_ordinals(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "First to third each have ..." as "First to third floor each have ...", where other storeys have rooms."""
    headed = any(
        _starts(tokens, at) and token.text in ("ground", "basement") and _text(tokens, at + 1) in _HOLD
        for at, token in enumerate(tokens)
    )
    result: list[Token] = []
    for index, token in enumerate(tokens):
        result.append(token)
        ranged = index > 1 and token.kind == tokens[index - 2].kind == "ordinal"
        ranged = ranged and tokens[index - 1].text in ("to", "-", "–", "and") and _starts(tokens, index - 2)
        if headed and ranged and _text(tokens, index + 1) in _HOLD:
            result.append(Token("word", "floor", token.end, token.end, plural=True))
    return result


def _with_colons(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Read "Level 0 entrance hall and canteen" as "Level 0: entrance hall and canteen"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        result.append(token)
        named = token.kind == "level" and _starts(tokens, index)
        numbered = token.kind == "number" and _text(tokens, index - 1) in floor_words and _starts(tokens, index - 1)
        if not (named or numbered) or index + 2 >= len(tokens):
            continue
        following = tokens[index + 1]
        if following.kind == "word" and following.text not in _NO_ROOMS and following.spaced:
            result.append(Token("mark", ":", token.end, token.end))
    return result
