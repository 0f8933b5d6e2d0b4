"""Read the rooms that a brief wants, with count, area and storeys."""

import re
from dataclasses import replace

from mansion_planner.brief.attachment import attach_places
from mansion_planner.brief.facts import RoomFact
from mansion_planner.brief.places import Place
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.room_areas import area_after, area_ending
from mansion_planner.brief.similarity import AS_ROOM, HEAD_TYPES, similar_room_type

__all__ = ["read_rooms"]

_STOP = frozenset(
    {
        "a", "an", "the", "with", "and", "or", "of", "in", "on", "at", "to", "for", "from", "no", "not", "without",
        "has", "have", "is", "are", "be", "that", "this", "it", "its", "which", "each", "every", "all", "one",
        "per", "by", "as", "plus", "also", "any", "some", "several", "many", "few", "more", "most", "least", "than",
        "total", "about", "around", "i", "we", "want", "need", "like", "please", "build", "design", "create",
        "make", "give", "us", "me", "would", "should", "must", "can", "will", "could", "there", "their", "our",
        "my", "your", "including", "containing", "contain", "include", "provide", "includ", "where",
        "when", "who", "whose", "next", "beside", "adjacent", "near", "between", "above", "below", "under", "over",
        "into", "onto", "across", "other", "same", "another", "extra", "additional", "living", "floor",
        "storey", "story", "level", "m2", "square", "m", "metre", "meter", "sq", "ft", "feet", "foot", "large",
        "small", "big", "main", "own", "separate", "shared", "common", "only", "just", "very", "quite", "new",
        "nice", "modern", "open", "outdoor", "indoor", "so", "but", "then", "upper", "lower", "top", "ground",
        "located", "shall", "featuring", "having", "both", "either", "neither", "enough", "direct",
        "connected", "connecting", "opening", "opens", "close", "rest", "entire", "whole",
        "such", "lots", "lot", "plenty", "use", "used", "using", "parking", "stories", "footprint",
        "sampl", "unused", "empty", "free", "useful", "usable", "remaining", "gross", "net", "dead",
        "storage", "green", "public", "private", "work", "working", "outside", "available", "little", "much",
        "less", "wide", "tall", "first", "double", "single", "l", "u", "t", "h", "shaped",
    }
)  # fmt: skip

_SOFT_PLURAL = frozenset({"several", "multiple", "various", "many", "few", "some", "numerous", "more"})


def read_rooms(reading: Reading, places: list[Place], repeated: set[int]) -> None:
    """Read every room mention that is not part of another fact.

    Parameters
    ----------
    repeated : set of int
        First tokens of mentions that speak of a room again; their area goes to the room.
    """
    found: list[tuple[int, int, RoomFact]] = []
    again: list[RoomFact] = []
    for mention in reading.mentions:
        if set(range(mention.first, mention.last)) & reading.taken:
            continue
        name = mention.room or AS_ROOM.get(mention.building, "")
        if name:
            reading.take(mention.first, mention.last)
            entry = _fact(reading, mention.first, mention.last, name, name)
            if mention.first in repeated:
                again.append(entry[2])
            else:
                found.append(entry)
    found += _plain_rooms(reading)
    found += _unknown_rooms(reading)
    found.sort(key=lambda entry: entry[0])
    for fact in again:
        _restate(found, fact)
    attach_places(reading, places, found)


def _restate(found: list[tuple[int, int, RoomFact]], fact: RoomFact) -> None:
    """Give the area of a repeated mention to the room that it repeats."""
    for number, (first, last, earlier) in enumerate(found):
        if earlier.room_type == fact.room_type and earlier.area is None and fact.area is not None:
            found[number] = (first, last, replace(earlier, area=fact.area))
            return


def _fact(reading: Reading, first: int, last: int, room_type: str, name: str) -> tuple[int, int, RoomFact]:
    """Read what stands before and after a room phrase: its count and its area."""
    plural = reading.tokens[last - 1].plural
    count: int | None = None if plural else 1
    area: float | None = None
    index = first - 1
    steps = 0
    while index >= 0 and steps < 6:
        token = reading.tokens[index]
        measured = area_ending(reading, index + 1)
        if measured is not None:
            area, index = measured[0], measured[1] - 1
            continue
        if token.kind == "number" and index not in reading.taken:
            adjective = plural and token.text in ("single", "double", "twin")
            if token.value == int(token.value) and 1 <= token.value <= 500 and not adjective:
                count = int(token.value)
                first = index
                break
        elif token.kind != "word" or token.text in ("and", "or", "with", "a", "an", "the", "of", "no"):
            if token.text == "of" and reading.kind(index - 1) == "number":
                index -= 1
                continue
            break
        elif token.text in _SOFT_PLURAL:
            count = None
        if index in reading.taken and token.kind == "word":
            break
        index -= 1
        steps += 1
    after = area_after(reading, last)
    if area is None and after is not None:
        area, end = after
        reading.take(last, end)
        last = end
    fact = RoomFact(room_type, name, reading.span(min(first, last - 1), last), count, area)
    return first, last, fact


_PLAIN = {"hotel": "hotel_room", "hospital": "patient_room", "hostel": "hostel_dorm",
          "student_dormitory": "dorm_room", "nursing_home": "resident_room"}  # fmt: skip


def _plain_rooms(reading: Reading) -> list[tuple[int, int, RoomFact]]:
    """Read "40 rooms" in a hotel, hospital or dormitory as the rooms that it is for."""
    name = _PLAIN.get(reading.facts.building[0][0]) if reading.facts.building else None
    if name is None or any(occupant.noun == "bed" for occupant in reading.facts.occupants):
        return []
    found = []
    for index, token in enumerate(reading.tokens):
        first = index - 1
        while reading.word(first) in ("guest", "patient", "comfortable", "private", "single", "double", "standard"):
            first -= 1
        if token.text == "room" and token.plural and index not in reading.taken and reading.kind(first) == "number":
            reading.take(first + 1, index + 1)
            found.append(_fact(reading, first + 1, index + 1, name, name))
    return found


def _unknown_rooms(reading: Reading) -> list[tuple[int, int, RoomFact]]:
    """Read phrases such as "a pottery room" that the knowledge base does not hold."""
    found = []
    for index, token in enumerate(reading.tokens):
        if token.kind != "word" or token.text not in HEAD_TYPES or index in reading.taken:
            continue
        first = index
        while (
            first > 0
            and index - first < 3
            and reading.kind(first - 1) == "word"
            and reading.word(first - 1) not in _STOP
            and first - 1 not in reading.taken
            and reading.word(first - 1) not in _SOFT_PLURAL
        ):
            first -= 1
        if first == index:
            continue
        words = [reading.word(i) for i in range(first, index + 1)]
        name = re.sub(r"[^a-z0-9_]", "", "_".join(words))[:60]
        room_type = similar_room_type(name, reading.knowledge)
        reading.take(first, index + 1)
        found.append(_fact(reading, first, index + 1, room_type, name))
    return found
