"""Find which mention of a brief names the building itself."""

from mansion_planner.brief.places import Place
from mansion_planner.brief.reading import Reading

__all__ = ["read_building"]

_OPENERS = frozenset({"with", "containing", "including", "featuring", "contain", "include", "featur", "housing"})
_INNER = frozenset({"with", "and", "or", "next", "no", "without", "beside", "one", "plus", "near", "above", "over"})
_GENERIC = frozenset({"building", "block", "tower", "complex", "center", "centre", "facility", "centr"})


def read_building(reading: Reading, places: list[Place]) -> None:
    """Record the building type: the first building phrase that no clause makes a part of another.

    "A four-storey office with a cafeteria" is an office; "a gym on the third floor" leaves the type open.
    """
    best: tuple[int, int] | None = None
    for order, mention in enumerate(reading.mentions):
        if not mention.building or set(range(mention.first, mention.last)) & reading.taken:
            continue
        score = _headness(reading, places, mention.first, mention.last, bool(mention.room))
        if score > 0 and (best is None or score > best[0]):
            best = (score, order)
    if best is not None:
        mention = reading.mentions[best[1]]
        name = mention.building
        if name == "flat" and mention.plural:
            name = "apartment_building"
        reading.facts.building.append((name, reading.span(mention.first, mention.last)))
        reading.take(mention.first, mention.last)
        doubled = reading.mention_at.get(mention.last)
        if doubled is not None and doubled.building and not doubled.plural:
            reading.take(doubled.first, doubled.last)


def _headness(reading: Reading, places: list[Place], first: int, last: int, is_room: bool) -> int:
    """How likely the mention is the building: 0 for a part of it."""
    begin = first
    while begin > 0 and reading.word(begin - 1) not in _OPENERS | {".", ";", ":", "\n"} and first - begin < 14:
        begin -= 1
    opened = any(reading.word(i) in _OPENERS for i in range(first))
    score = 6 if not opened else 3
    stated = any(reading.word(i) in ("has", "have", "contain", "hold") for i in range(first))
    if _in_section(reading, places, first) or "there" in [reading.word(first - k) for k in (2, 3, 4)]:
        return 0
    score -= 3 if stated and is_room else 0
    lead = first - 1
    while lead >= 0 and reading.kind(lead) in ("word", "number", "unit") and first - lead < 8:
        if reading.word(lead) in {"a", "an", "the", "our", "my", "this"} | _INNER:
            break
        lead -= 1
    before = reading.word(lead - 1)
    if reading.word(lead) in _INNER or before in _INNER or before in ("on", "in", "has", "have"):
        score -= 2 if not opened else 3
    if any(place.last == first and not place.led for place in places):
        return 0
    following = next((place for place in places if place.first in (last, last + 1) and place.led), None)
    if following is not None and not any(r.kind in ("every",) for r in following.refs):
        score -= 2 if first > 4 else 0
        if is_room or reading.tokens[last - 1].plural:
            score -= 3
    if reading.tokens[last - 1].plural and is_room:
        score -= 3
    if reading.word(last) in _GENERIC or reading.word(last - 1) in _GENERIC:
        score += 2
    if not is_room:
        score += 1
    return max(score, 0)


def _in_section(reading: Reading, places: list[Place], first: int) -> bool:
    """Whether the mention stands in a list that a storey opens ("ground floor: lobby, cafe")."""
    earlier = [place for place in places if place.last <= first]
    if not earlier:
        return False
    place = earlier[-1]
    between = [reading.word(i) for i in range(place.last, first)]
    if any(word in (".", ";", "\n") for word in between):
        return False
    return bool(between) and between[0] in (
        ":",
        "has",
        "have",
        "contain",
        "hold",
        "house",
        "include",
        ",",
        "host",
        "–",
        "with",
    )
