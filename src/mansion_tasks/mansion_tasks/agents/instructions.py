"""Read an instruction as a person would who has never seen the building: what, from where, to where."""

import re
from dataclasses import dataclass, replace
from typing import Literal

from mansion_language import singular
from mansion_language.colours import COLOUR_WORDS
from mansion_language.numbers import ORDINALS
from mansion_tasks.language.matching import matches

__all__ = ["ParsedInstruction", "NounPhrase", "read_instruction"]

Relation = Literal["room", "on", "in", "near"]

_FETCH = re.compile(
    r"\b(go to where|find|fetch|get|grab|pick up|collect|locate|look for|search for|retrieve|needs?|bring me|take|"
    r"bring|carry|move|put|place|deliver)\b(?! (?:it|them)\b)"
)
_DELIVER = re.compile(
    r"\b(?:bring|take|deliver|carry|move|put|place|return|leave|drop|set)\b(?= (?:it|them|that|this)\b)|"
    r"\bcome back\b|\bgo back\b|\breturn\b|\bgo (?:and )?stand\b|\bput it\b"
)
_OPEN = re.compile(r"\bopen (?:the|a|an) ([^,.;]+?)(?= and\b|[,.;]|$)")
_ASIDE = re.compile(r"\([^)]*\)")
_CLOSE = re.compile(r"\bclose (?:it|them|that|this|the)\b|\bclosed afterwards\b")
_TAIL = re.compile(
    r"[,;]? (?:which|you are done|make sure|and close|then close|and stop|and go up)\b|"
    r"[,;] (?:and )?open\b|\band open\b"
)
_PREPOSITION = re.compile(
    r"\b(on top of|next to|in front of|inside|into|onto|from|near|beside|by|on|in|at|to|of|under)\b"
)
_STOPS = re.compile(r"[,.;:!?]|\b(?:and|then|that|which|where|so|with)\b")
_ARTICLE = re.compile(r"^(?:the|a|an|my|your|some|any|one|another|this|that|its|his|her|their)\b\s*")
_FILLERS = frozenset(
    ("the", "colored", "coloured", "somewhere", "anywhere", "building", "it", "is", "are", "there", "back")
)
_FLOOR = re.compile(
    r"\b(?:(?P<word>" + "|".join(ORDINALS) + r")|(?P<digits>\d+)(?:st|nd|rd|th)) (?:floor|storey|story|level)\b|"
    r"\b(?:floor|storey|story|level) (?P<number>-?\d+|[a-z]{1,2}\d?)\b|\b(?P<named>ground|top) floor\b|"
    r"\b(?P<basement>basement)\b"
)


@dataclass(frozen=True)
class NounPhrase:
    """An object or a place in words.

    Attributes
    ----------
    noun : str
        In the singular, with what stands before it but articles and colours.
    places, place_colors : tuple of str
        Rooms or furniture named with it, and the colour of each, empty for any.
    floor : int, optional
    """

    noun: str
    color: str = ""
    places: tuple[str, ...] = ()
    place_colors: tuple[str, ...] = ()
    floor: int | None = None


@dataclass(frozen=True)
class ParsedInstruction:
    """What an instruction asks for.

    Attributes
    ----------
    target : NounPhrase
        What is to be found.
    destination : NounPhrase, optional
        Where it is to go; ``None`` when finding it is all.
    relation : {"room", "on", "in", "near"}
        How it is to lie there; ``room`` when the words leave it open.
    close : bool
        Whether the destination is to be closed again.
    """

    target: NounPhrase
    destination: NounPhrase | None = None
    relation: Relation = "room"
    close: bool = False


def read_instruction(text: str, floors: tuple[int, ...] = (1,), labels: tuple[str, ...] = ()) -> ParsedInstruction:
    """Return the errand that an instruction describes.

    Parameters
    ----------
    text : str
        English, a sentence or a few.
    floors, labels : tuples
        Floors of the building, to understand "top floor" and "floor G".

    Examples
    --------
    >>> errand = read_instruction("Find a box on the bed and bring it to the bathroom.")
    >>> errand.target.noun, errand.target.places, errand.destination.noun
    ('box', ('bed',), 'bathroom')
    """
    plain = " ".join(_ASIDE.sub(" ", text.casefold()).replace("-", " ").replace(" .", ".").split())
    fetch = _FETCH.search(plain)
    body = plain[fetch.end() :] if fetch else plain
    split = _DELIVER.search(body)
    if split is not None:
        first, second = body[: split.start()], body[split.end() :]
    else:
        first, second = _one_clause(body, fetch.group(1) if fetch else "")
    first, second = _TAIL.split(first)[0], _TAIL.split(second)[0]
    number = _Floors(floors, labels)
    before = number.of(plain[: fetch.start()]) if fetch else None
    target = _phrase(first, number)
    opened = _OPEN.search(plain)
    if target.floor is None and not (opened and fetch and opened.start() < fetch.start()):
        target = replace(target, floor=before)
    if not second.strip(" .,"):
        return ParsedInstruction(target)
    errand = _with_destination(target, second, opened.group(1) if opened else "", number)
    return replace(errand, close=_CLOSE.search(plain) is not None)


def _with_destination(target: NounPhrase, text: str, opened: str, number: "_Floors") -> ParsedInstruction:
    relation, rest = _relation(re.sub(r"^\s*(?:it|them|that|this)\b", "", text))
    words = rest.strip(" .,")
    if words in ("", "it", "there", "inside") and opened:
        return ParsedInstruction(target, _phrase(opened, number), "in")
    place = _phrase(words, number)
    container = _phrase(opened, number)
    if container.noun and matches(container.noun, place.noun):
        return ParsedInstruction(target, container if place.floor is None else place, "in")
    return ParsedInstruction(target, place, relation)


def _relation(text: str) -> tuple[Relation, str]:
    """Return how the destination's first preposition puts objects, and what comes after it."""
    found = _PREPOSITION.search(text)
    if found is None:
        return "room", text
    rest = text[found.end() :]
    if found.group() in ("on", "onto", "on top of"):
        return "on", rest
    if found.group() in ("in", "into", "inside"):
        return "in", rest
    if found.group() in ("near", "next to", "beside", "by", "in front of"):
        return "near", rest
    nested = re.match(r"\s*(?:near|next to|beside)\b", rest)
    return ("near", rest[nested.end() :]) if nested else ("room", rest)


def _one_clause(body: str, verb: str) -> tuple[str, str]:
    """Split "(take) the mug from the den to the hall" or "(put) the mug on the desk" into what and where to."""
    if verb in ("put", "place"):
        found = re.search(r"\b(?:on|in|into|onto|inside|near|next to|beside)\b", body)
        return (body[: found.start()], body[found.start() :]) if found else (body, "")
    if verb in ("take", "bring", "carry", "move", "deliver", "bring me"):
        found = re.search(r"\b(?:in)?to (?:the|a|an|my|your)\b", body)
        return (body[: found.start()], body[found.start() :]) if found else (body, "")
    return body, ""


def _phrase(text: str, number: "_Floors") -> NounPhrase:
    """Return the object that a clause begins with, and the places that follow it."""
    floor = number.of(text)
    clause = _FLOOR.sub(" ", text)
    parts = _PREPOSITION.split(clause)
    head = _noun(parts[0])
    places = [_noun(part) for part in parts[2::2]]
    if not head[0] and places:
        head = places.pop(0)
    named = [place for place in places if place[0]]
    nouns, colors = tuple(noun for noun, _ in named), tuple(color for _, color in named)
    return NounPhrase(head[0], head[1], nouns, colors, floor)


def _noun(text: str) -> tuple[str, str]:
    """Return the noun of a piece, and its colour."""
    words = _ARTICLE.sub("", _STOPS.split(text.strip(" ,."))[0].strip()).split()
    color = next((COLOUR_WORDS[word] for word in words if word in COLOUR_WORDS), "")
    kept = [word for word in words if word not in COLOUR_WORDS and word not in _FILLERS]
    return " ".join([*kept[:-1], singular(kept[-1])]) if kept else "", color


@dataclass(frozen=True)
class _Floors:
    """Understands which floor words mean."""

    floors: tuple[int, ...]
    labels: tuple[str, ...]

    def of(self, text: str) -> int | None:
        found = _FLOOR.search(text)
        if found is None:
            return None
        if found["word"]:
            return ORDINALS[found["word"]]
        if found["digits"]:
            return int(found["digits"])
        if found["named"]:
            return max(self.floors) if found["named"] == "top" else 1
        if found["basement"]:
            return min(self.floors)
        label = found["number"]
        named = [f for f, known in zip(self.floors, self.labels) if known.casefold() == label]
        if named:
            return named[0]
        return int(label) if label.lstrip("-").isdigit() else None
