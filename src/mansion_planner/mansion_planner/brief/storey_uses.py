"""Read what a storey is used for, where a list of its rooms follows: "the practice on the ground floor: ..."."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from mansion_planner.brief.facts import FloorRef, UseFact
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Place, Reading
from mansion_planner.brief.storey_attachment import Attachment

__all__ = ["read_storey_uses"]

_PRACTICES = {"practice": "clinic", "surgery": "clinic", "clinic": "clinic", "office": "office"}
"""What people work in, and the kind of building that a storey with it is like, where the whole name is none."""
_OWNERS = frozenset({"law", "lawyer", "architect", "architecture", "tax", "notary", "accountant", "accounting"})
"""Those whose practice is an office."""
_LISTS = frozenset({"with", "of", "comprising", "including", "containing", "having"})


def read_storey_uses(
    reading: Reading,
    places: Sequence[Place],
    phrases: list[Phrase],
    attached: Mapping[int, Attachment],
    building: int | None,
) -> None:
    """Add the uses of storeys whose rooms are listed; the phrases that name them are no rooms any more.

    A use is told apart from a room by the list: "on the second floor a dentist's practice with a waiting room and three
    treatment rooms", "he has the practice on the ground floor: ...". A lone "office with two desks" stays a room.

    Parameters
    ----------
    attached : mapping of int to Attachment
        Storeys by phrase.
    building : int, optional
        Number of the phrase that names the building itself.
    """
    for number, phrase in enumerate(phrases):
        single = phrase.head in ("room", "building") and not phrase.plural and number != building
        kind = _kind(reading, phrase) if single else ""
        refs, end = _storey_of(reading, places, phrase, attached.get(number))
        if not kind or not refs or not _heads_list(reading, phrases, number, end):
            continue
        reading.facts.uses.append(UseFact(kind, refs, reading.span(phrase.begin, phrase.last)))
        phrases[number] = replace(phrase, head="unknown", room_type="", building="")


def _kind(reading: Reading, phrase: Phrase) -> str:
    """Return the kind of building that a phrase says a storey is like; empty for what is no such use."""
    known = reading.knowledge.buildings.get(phrase.building)
    if known is not None:
        return known.name if known.family != "home" else ""
    words = reading.words(phrase.begin, phrase.noun_end)
    if words[-1] in ("practice", "surgery") and not _OWNERS.isdisjoint(words):
        return "office"
    return _PRACTICES.get(words[-1], "")


def _storey_of(
    reading: Reading, places: Sequence[Place], phrase: Phrase, attachment: Attachment | None
) -> tuple[tuple[FloorRef, ...], int]:
    """Return the storeys of a phrase, and the token after it and a storey that follows it right away."""
    after = next((place for place in places if place.first == phrase.last), None)
    if after is not None and reading.word(after.last) in (":", "("):
        return after.refs, after.last
    return (attachment.refs if attachment is not None else ()), phrase.last


def _heads_list(reading: Reading, phrases: Sequence[Phrase], number: int, end: int) -> bool:
    """Whether a list of two rooms or more follows a token: after a colon, or after "with" and in brackets
    where a practice is meant: "a library (a hidden study next to it)" stays a room.
    """
    sentence = reading.sentence[phrases[number].first]
    listed = [p for p in phrases[number + 1 :] if p.head == "room" and reading.sentence[p.first] == sentence]
    if len(listed) < 2 or listed[0].begin - end > 4:
        return False
    if reading.word(end) == ":":
        return True
    practice = reading.word(phrases[number].noun_end - 1) in ("practice", "surgery")
    return practice and reading.word(end) in _LISTS | {"("}
