"""Bring turns of spoken English into written ones, which the readers know: answered questions, "let's say", "too"."""

from dataclasses import replace
from itertools import pairwise

from mansion_language import Token

__all__ = ["spoken_turns"]

_DENIALS = (
    ("no", "thank", "you"), ("no", "thank"), ("no", "need"), ("not", "need"), ("not", "needed"), ("not", "required"),
    ("not", "necessary"), ("rather", "not"), ("better", "not"), ("not", "really"), ("not", "at", "all"), ("nope",),
    ("no",),
)  # fmt: skip
"""Answers that do not want what was asked about."""
_ENDS = frozenset({".", "!", ";", "\n", ")", ""})
_PAUSES = frozenset({",", "-", "–", ":"})
_APART = frozenset("a an its their his her own separate single proper distinct closed independent two three of".split())
"""Words of "as a separate room", "as two rooms of their own" before the noun."""
_ROOMS = frozenset({"room", "space"})
_UP_AND_DOWN = {"up": "upstairs", "down": "downstairs"}
_AFTER = frozenset({",", ".", ")", ";", "and", "\n", ""})
_HEDGES = (("let", "say"), ("let", "us", "say"), ("shall", "we", "say"), ("say",), ("i", "guess"), ("i", "think"))
"""What is said between commas before a number that is not meant exactly."""


def spoken_turns(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the writer's own questions as statements, and without what comes between noun and area.

    "A cellar? No." becomes "a cellar: no.", "a diner? No - two rooms" becomes "a diner, no - two rooms"; "of, let's
    say, 45 m2" becomes "of 45 m2", "a reading corner as a separate room of 18 m2" and "a bedroom too, 7 m2" lose the
    words that only say that there is such a room.
    """
    tokens = _denied_again(_headed_storeys(_with_size_behind(_living_above(_without_ages(tokens)))))
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        answer = _answer(tokens, index) if tokens[index].text == "?" else 0
        hedge = 0 if answer else _hedge(tokens, index) or _own_room(tokens, index) or _also(tokens, index)
        if answer:
            end = index + 1 + answer
            closed = _word(tokens, end) in _ENDS
            result.append(replace(tokens[index], text=":" if closed else ","))
            result.append(replace(tokens[index + 1], text="no", end=tokens[end - 1].end))
            index = end
        elif hedge:
            index += hedge
        else:
            result.append(_storey_of_some(tokens, index))
            index += 1
    return result


_TITLE = 6
"""Tokens of a sentence that only names what is asked for, at most: "Just a bathroom"."""


def _with_size_behind(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "Just a bathroom. 6 m2, with a bathtub" as one sentence: the size is that of the room."""
    end = next((index for index, token in enumerate(tokens) if token.text in (".", "!")), 0)
    area = [token.kind for token in tokens[end + 1 : end + 3]] == ["number", "unit"]
    listed = [token.text for token in tokens[end + 3 : end + 5]] == [",", "with"]
    if not 1 < end <= _TITLE or not (area and listed):
        return tokens
    return [*tokens[:end], replace(tokens[end], text=","), *tokens[end + 1 :]]


_YEARS = frozenset({"yr", "yrs", "year", "yo"})


def _without_ages(tokens: list[Token]) -> list[Token]:
    """Return the tokens without for which age something is: "a daycare 0-6 yrs", "for children of 3 to 6 years"."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        kinds = [token.kind for token in tokens[index : index + 3]]
        ranged = kinds == ["number", "mark", "number"] or kinds == ["number", "word", "number"]
        ranged = ranged and _word(tokens, index + 1) in ("-", "–", "to") and _word(tokens, index + 3) in _YEARS
        if not ranged:
            result.append(tokens[index])
            index += 1
            continue
        while result and result[-1].text in ("aged", "age", "of", "from", "for", "ages"):
            result.pop()
        index += 4 + (_word(tokens, index + 4) in ("old", "olds"))
    return result


_BUSINESSES = frozenset(
    """
    shop store bakery bakehouse butcher cafe salon barber studio workshop pub bar inn tavern restaurant practice surgery
    garage forge smithy gallery kiosk pharmacy laundrette
    """.split()
)
_HOMES = frozenset({"flat", "apartment", "maisonette", "house"})
_WHOSE = frozenset("the a an my our his her their we i he she they family who and where while owner".split())


def _living_above(tokens: list[Token]) -> list[Token]:
    """Return the tokens of "a barber's shop below, the barber lives above" with a flat above."""
    texts = [token.text for token in tokens]
    for index in range(1, len(tokens) - 1):
        if texts[index] not in ("live", "life") or texts[index + 1] not in ("above", "upstairs", "upstair", "overhead"):
            continue
        subject = index - (tokens[index - 1].kind == "word" and texts[index - 1] not in _WHOSE)
        while subject > 0 and texts[subject - 1] in _WHOSE:
            subject -= 1
        business = not _BUSINESSES.isdisjoint(texts[:subject]) and _HOMES.isdisjoint(texts)
        if subject < index and business:
            article = Token("word", "a", tokens[index].start, tokens[index].start)
            flat = replace(tokens[index], text="flat", plural=False)
            return [*tokens[:subject], article, flat, *tokens[index + 1 :]]
    return tokens


_AGAIN = (
    ("also", "no"), ("again", "no"), ("likewise", "no"), ("equally", "no"), ("no", "either"), ("also", "not"),
    ("neither",), ("nor",), ("ditto",), ("same",), ("likewise",), ("also", "none"), ("not", "either"),
    ("no", "as", "well"),
)  # fmt: skip
"""Answers that deny one thing more after another one was denied."""


def _denied_again(tokens: list[Token]) -> list[Token]:
    """Return the tokens of "Garage: no. Carport: also no." with the second denial as plain as the first."""
    result: list[Token] = []
    index, denied = 0, False
    while index < len(tokens):
        result.append(tokens[index])
        index += 1
        if result[-1].text not in (":", "?", "-", "–", ","):
            continue
        again = next((words for words in _AGAIN if _is_said(tokens, index, words)), ())
        if denied and again:
            end = index + len(again)
            result.append(replace(tokens[index], text="no", end=tokens[end - 1].end))
            index = end
        elif result[-1].text != ",":
            denied = _word(tokens, index) in ("no", "none") and _word(tokens, index + 1) in _ENDS | {","}
    return result


def _is_said(tokens: list[Token], index: int, words: tuple[str, ...]) -> bool:
    """Whether some words, and nothing more of the sentence, stand at a token."""
    end = index + len(words)
    return tuple(token.text for token in tokens[index:end]) == words and _word(tokens, end) in _ENDS | {","}


_OPENING = {"below": "downstairs", "down": "downstairs", "above": "upstairs", "up": "upstairs"}
_TO_STOREYS = frozenset({"floor", "level", "storey", "story", "storie"})
_NO_HEADING = frozenset("the it them this that these those all each every to , : = is are a an our one".split())


def _headed_storeys(tokens: list[Token]) -> list[Token]:
    """Return the tokens of a brief on two storeys, "below" and "up" that open its lists as "downstairs" and "upstairs".

    "Two floors. Below reception and bar; up two bedrooms."
    """
    two = any(
        one.kind == "number" and one.value == 2.0 and other.text in _TO_STOREYS for one, other in pairwise(tokens)
    )
    if not two:
        return tokens
    tokens = _on_top(tokens)
    return [
        replace(token, text=_OPENING[token.text])
        if _closes_list(tokens, index)
        else replace(token, text=_OPENING[token.text])
        if token.text in _OPENING
        and _word(tokens, index - 1) in (".", ";", ":", "\n")
        and index + 1 < len(tokens)
        and (_word(tokens, index + 1) not in _NO_HEADING or _is_up_with(tokens, index))
        and (tokens[index + 1].kind != "number" or _word(tokens, index + 2) not in ("m2", "ft2"))
        else token
        for index, token in enumerate(tokens)
    ]


_FLATS = frozenset({"flat", "apartment", "maisonette", "studio"})


def _on_top(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "a flat on top" as one upstairs, and "the flat above: ..." without its storey again."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token, after = tokens[index], _word(tokens, index + 2)
        top = token.text == "on" and _word(tokens, index + 1) == "top" and after in _ENDS | {",", "(", "and"}
        if top and index and tokens[index - 1].kind == "word" and tokens[index - 1].text not in _TO_STOREYS:
            result.append(replace(token, text="upstairs", end=tokens[index + 1].end))
            index += 2
            continue
        again = token.text in ("above", "upstairs", "upstair") and _word(tokens, index + 1) == ":"
        if not (again and _word(tokens, index - 1) in _FLATS and _word(tokens, index - 2) == "the"):
            result.append(token)
        index += 1
    return result


_NO_LIST = _TO_STOREYS | frozenset(
    """
    go going goes come comes walk climb lead leads run runs sit slow calm set lie look open lock pick drive cut grow
    turn break clean wake get close shut step flight way side upside up down and it them one stair stairs staircase
    lift elevator line street hill slope from the or is are see mentioned described listed upon live lives all what
    which that look face facing back
    """.split()
)
"""Words before "up" or "below" where that is said of a movement, or of something else than a list of rooms."""


def _closes_list(tokens: list[Token], index: int) -> bool:
    """Whether "up" or "below" closes what is on a storey: "3 bedrooms + 1 bathroom up; kitchen, living room down"."""
    before = tokens[index - 1] if index else None
    after = _word(tokens, index + 1)
    also = after in ("too", "also") or (after == "as" and _word(tokens, index + 2) == "well")
    ends = after in _ENDS | {",", "and", "-", "–"} - {"!"} or also
    closes = tokens[index].text in _OPENING and ends
    return closes and before is not None and before.kind == "word" and before.text not in _NO_LIST


def _is_up_with(tokens: list[Token], index: int) -> bool:
    """Whether "up" or "down" stands before an article; "above a garage" tells where something else is."""
    return tokens[index].text in ("up", "down") and _word(tokens, index + 1) in ("a", "an", "one")


def _storey_of_some(tokens: list[Token], index: int) -> Token:
    """Return a token, "down" and "up" after a number or a room as "downstairs" and "upstairs": "four down, wc up"."""
    where = _UP_AND_DOWN.get(tokens[index].text)
    counted = where and index > 1 and tokens[index - 1].kind == "number" and tokens[index - 2].text not in _ENDS
    counted = counted or (where and _word(tokens, index - 1) in _NOUNS_OF_ROOMS)
    return (
        replace(tokens[index], text=where)
        if where and counted and _word(tokens, index + 1) in _AFTER
        else tokens[index]
    )


_NOUNS_OF_ROOMS = frozenset(
    "room office bedroom bathroom bath kitchen wc toilet loo lounge living study garage hall bed diner shop".split()
)


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _answer(tokens: list[Token], index: int) -> int:
    """Return of how many tokens a denial after a question mark is, if a pause or an end follows it."""
    for words in _DENIALS:
        end = index + 1 + len(words)
        if tuple(token.text for token in tokens[index + 1 : end]) != words:
            continue
        return len(words) if _word(tokens, end) in _ENDS or (words == ("no",) and _word(tokens, end) in _PAUSES) else 0
    return 0


def _hedge(tokens: list[Token], index: int) -> int:
    """Return of how many tokens a hedge with its commas is, if a number follows it."""
    if _word(tokens, index) != ",":
        return 0
    for words in _HEDGES:
        end = index + 1 + len(words)
        said = tuple(token.text for token in tokens[index + 1 : end]) == words
        if said and _word(tokens, end) == "," and end + 1 < len(tokens) and tokens[end + 1].kind == "number":
            return len(words) + 2
    return 0


def _own_room(tokens: list[Token], index: int) -> int:
    """Return of how many tokens "as a separate room", "as two rooms" is; 0 where there is none."""
    if _word(tokens, index) != "as" or not index or tokens[index - 1].kind != "word":
        return 0
    end = index + 1
    while end - index < 5 and _word(tokens, end) in _APART:
        end += 1
    one = _word(tokens, index + 1) in ("one", "1") and _word(tokens, index + 2) in _ROOMS | {"area"}
    if one and index + 4 < len(tokens) and [t.kind for t in tokens[index + 3 : index + 5]] == ["number", "unit"]:
        return 3  # "kitchen-living as one space 55 m2"
    return end + 1 - index if end > index + 1 and _word(tokens, end) in _ROOMS else 0


def _also(tokens: list[Token], index: int) -> int:
    """Return 1 for "too" and "separate" between a noun and the comma or bracket before its area; else 0."""
    after = index + 1 < len(tokens) and tokens[index + 1].text in (",", "(", ":")
    measured = index + 3 < len(tokens) and tokens[index + 2].kind == "number" and tokens[index + 3].kind == "unit"
    noun = index > 0 and tokens[index - 1].kind == "word"
    return int(noun and after and measured and _word(tokens, index) in ("too", "separate", "also"))
