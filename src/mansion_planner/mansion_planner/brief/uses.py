"""Read what a building or a storey is used for: by its writer's trade, below another use, or by a list of its rooms."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from mansion_planner.brief.facts import FloorRef, RoomFact, UseFact
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import Place, Reading
from mansion_planner.brief.storey_attachment import Attachment

__all__ = ["read_stacking", "read_storey_uses", "read_trade"]

_TRADES = {
    "make": "factory", "build": "factory", "produce": "factory", "manufacture": "factory", "craft": "factory",
    "weave": "factory", "restore": "factory", "sell": "shop_building", "repair": "shop_building",
    "fix": "shop_building", "renovate": "", "install": "", "fit": "",
}  # fmt: skip
"""The kind of building that a trade needs, by its verb; empty for one that is done elsewhere."""

_TRADERS = frozenset({"i", "we", "who"})
_NO_GOODS = (FUNCTION_WORDS - {"fitted"}) | _TRADES.keys()


def read_trade(reading: Reading) -> None:
    """Record the building that the writer's trade needs: "I make fitted kitchens", "we repair and sell bicycles".

    The last of several verbs tells most: who repairs and sells has a shop.
    """
    for index in range(len(reading.tokens)):
        if reading.words(index, index + 3) == ("for", "a", "living"):
            reading.take(index, index + 3)
        if reading.word(index) in _TRADERS and _trade_at(reading, index + 1):
            verb = _trade_at(reading, index + 1)
            kind = _TRADES[reading.word(verb)]
            end = verb + 1
            while reading.kind(end) == "word" and reading.word(end) not in _NO_GOODS:
                end += 1
            if end > verb + 1 and reading.plural(end - 1):
                reading.facts.trades += [(kind, reading.span(index, end))] if kind else []
                reading.take(index + 1, end)


def _trade_at(reading: Reading, index: int) -> int:
    """Return the last verb of a trade that stands at a token: of "repair and sell"; or 0."""
    if reading.word(index) not in _TRADES:
        return 0
    joined = reading.word(index + 1) in ("and", "or") and reading.word(index + 2) in _TRADES
    return index + 2 if joined else index


_UNDER = frozenset({"under", "below", "beneath", "underneath"})
_UPPER = frozenset({"apartment_building", "flat", "office", "hotel", "student_dormitory", "residential_building"})
_JOINTS = frozenset(
    """
    a an the and , small large big new
    """.split()
)


def read_stacking(reading: Reading, phrases: list[Phrase]) -> set[int]:
    """Give the ground floor to what is named before "under" and the storeys above to the use after it.

    Returns
    -------
    set of int
        Numbers of the phrases that this reads; a phrase that may be a room becomes a room of the ground floor.
    """
    used: set[int] = set()
    for number, above in enumerate(phrases):
        link = above.first - 1
        if number == 0 or above.building not in _UPPER or reading.word(link) not in _UNDER or link in reading.taken:
            continue
        below = [number - 1]
        while below[0] > 0 and set(reading.words(phrases[below[0] - 1].last, phrases[below[0]].first)) <= _JOINTS:
            below.insert(0, below[0] - 1)
        if (
            any(not phrases[n].building or "parking" in phrases[n].building for n in below)
            or phrases[number - 1].last != link
        ):
            continue
        reading.take(link, link + 1)
        used |= {number, *below}
        span = reading.span(above.first, above.last)
        name = "apartment_building" if above.building == "flat" else above.building
        reading.facts.uses.append(UseFact(name, (FloorRef("upper", span=span),), span, count=1))
        for entry in (phrases[n] for n in below):
            words = reading.span(entry.first, entry.last)
            ground = (FloorRef("number", 1, 1, words),)
            if entry.head == "room":
                count = None if entry.plural else 1
                reading.facts.rooms.append(
                    RoomFact(entry.room_type, entry.name, words, count, floors=ground, label=entry.label)
                )
            else:
                reading.facts.uses.append(UseFact(entry.building, ground, words))
    return used


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
    if reading.words(phrase.begin, phrase.noun_end) == ("walk", "up"):
        return ""  # "a second-floor walk-up: ..." tells where a flat is and that there is no lift
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
