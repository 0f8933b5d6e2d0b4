"""Give rooms the storeys that the brief names for them, by where the two stand in its clauses."""

from mansion_planner.brief.facts import FloorRef, RoomFact, UseFact
from mansion_planner.brief.places import Place
from mansion_planner.brief.reading import Reading

__all__ = ["attach_places"]

_AS_USE = {"flat": "apartment_building", "studio_flat": "apartment_building", "shop_building": "shopping_mall",
           "house": "apartment_building", "penthouse": "apartment_building"}  # fmt: skip


def attach_places(reading: Reading, places: list[Place], found: list[tuple[int, int, RoomFact]]) -> None:
    """Give each room the storeys that the brief names for it.

    A floor reference right before a room ("ground-floor cafeteria") is the room's; one after it ("a gym and a sauna on
    the top floor") belongs to the rooms listed just before it; one that opens a clause ("the second floor has ...") to
    the rooms that follow it in the clause.
    """
    assigned: dict[int, tuple[FloorRef, ...]] = {}
    each: set[int] = set()
    for place in sorted(places, key=lambda entry: entry.first):
        rooms = _rooms_of(reading, place, places, found, set(assigned))
        for number in rooms:
            assigned[number] = place.refs
            several = place.refs[0].kind in ("every", "range", "upper", "middle", "lower") or len(place.refs) > 1
            if several and not _shared_out(reading, found[number][0], place):
                each.add(number)
    for number, (first, _, fact) in enumerate(found):
        mention = reading.mention_at.get(first)
        building = _use_of(reading, found[number]) if assigned.get(number) else ""
        if building and fact.area is None and (fact.count is None or mention is not None):
            reading.facts.uses.append(UseFact(building, assigned[number], fact.span))
            continue
        room = RoomFact(
            fact.room_type, fact.name, fact.span, fact.count, fact.area,
            assigned.get(number, ()), fact.each or number in each,
        )  # fmt: skip
        if not _said_before(reading, room):
            reading.facts.rooms.append(room)


_SHARED_OUT = frozenset({"spread", "distributed", "divided", "split"})


def _shared_out(reading: Reading, first: int, place: Place) -> bool:
    """Whether a number of rooms is that of all the named storeys ("six wards spread over the upper floors")."""
    words = [reading.word(index) for index in range(first - 3, place.first)]
    return "total of" in " ".join(words[:5]) or not _SHARED_OUT.isdisjoint(words)


_MORE = ("another", "second", "extra", "additional", "further", "more")


def _said_before(reading: Reading, room: RoomFact) -> bool:
    """Whether an unnumbered room only says again what the brief wants already ("a library ... library")."""
    before = reading.text[: room.span.start].lower().split()
    numbered = room.span.words[:1].isdigit() or room.count not in (None, 1)
    if numbered or (before and before[-1] in _MORE):
        return False
    return any(
        (other.name, other.count, other.area, other.each) == (room.name, room.count, room.area, room.each)
        and [(r.kind, r.first, r.last) for r in other.floors] == [(r.kind, r.first, r.last) for r in room.floors]
        for other in reading.facts.rooms
    )


def _use_of(reading: Reading, entry: tuple[int, int, RoomFact]) -> str:
    """Return the building type when the phrase is a plural use of whole storeys ("offices", "apartments", "shops")."""
    first, last, fact = entry
    for index in range(first, last):
        mention = reading.mention_at.get(index)
        if mention is not None and mention.building and mention.plural and fact.count is None:
            return _AS_USE.get(mention.building, mention.building)
    return ""


def _rooms_of(
    reading: Reading, place: Place, places: list[Place], found: list[tuple[int, int, RoomFact]], done: set[int]
) -> list[int]:
    after = [n for n, entry in enumerate(found) if entry[0] >= place.last and n not in done]
    before = [n for n, entry in enumerate(found) if entry[1] <= place.first and n not in done]
    if _opens_clause(reading, place):
        stop = _clause_end(reading, place.last)
        others = [other.first for other in places if other.first >= place.last]
        limit = min([stop, *others])
        return [n for n in after if found[n][0] < limit]
    if after and reading.word(place.last) == "with" and place.refs[0].kind == "basement":
        return after[:1]
    if after and not place.led and _touches(reading, place.last, found[after[0]][0]):
        return after[:1]
    if before and _no_break(reading, found[before[-1]][1], place.first):
        return _conjuncts(reading, found, before, place)
    if after and _touches(reading, place.last, found[after[0]][0]):
        return after[:1]
    return []


def _opens_clause(reading: Reading, place: Place) -> bool:
    before = reading.word(place.first - 1)
    opens = place.first == 0 or before in (".", ";", ":", "\n", "and", ",", "while", "but", "!", "–", "where", "then")
    after = reading.word(place.last)
    verbs = ("has", "have", "contain", "hold", "house", "include", ":", "host", "feature", "is", "are", "with",
             "comprise", "offer", "should", "must", "provide", "accommodate", "consist", "there", "will", "–",
             "housing", "containing", "for", "used")  # fmt: skip
    if after in verbs:
        return after not in ("with", "for", "is", "are", "used") or opens
    return (
        opens
        and place.led
        and (
            after == ","
            or place.first == 0
            or before in (".", ";", "\n")
            or after in ("a", "an", "the", "we", "put", "i", "you")
            or reading.kind(place.last) == "number"
        )
    )


def _clause_end(reading: Reading, index: int) -> int:
    while index < len(reading.tokens) and reading.word(index) not in (".", ";", "\n", "!", "?"):
        index += 1
    return index


def _touches(reading: Reading, begin: int, end: int) -> bool:
    return (
        end >= begin
        and end - begin <= 3
        and all(
            reading.kind(i) in ("word", "number", "unit") and reading.word(i) not in ("and", "with", "or")
            for i in range(begin, end)
        )
    )


def _no_break(reading: Reading, begin: int, end: int) -> bool:
    return end - begin <= 6 and not any(
        reading.word(i) in (".", ";", ":", "\n", ",", "with", "and", "but") for i in range(begin, end)
    )


def _conjuncts(reading: Reading, found: list[tuple[int, int, RoomFact]], before: list[int], place: Place) -> list[int]:
    """The rooms listed just before a floor reference, as far back as the list goes and the storey suits them."""
    chosen = [before[-1]]
    for number in reversed(before[:-1]):
        _first, last, fact = found[number]
        between = [reading.word(i) for i in range(last, found[chosen[-1]][0])]
        linked = all(word in ("and", "a", "an", "the", ",", "&", "one", "large", "small") for word in between)
        joined = "and" in between or "&" in between or (len(chosen) > 1 and "," in between)
        if not linked or not joined or not _suits(reading, fact, place):
            break
        chosen.append(number)
    return chosen


def _suits(reading: Reading, fact: RoomFact, place: Place) -> bool:
    storey = reading.knowledge.room(fact.room_type).storey
    kinds = {ref.kind for ref in place.refs}
    if fact.count is None or fact.count > 2:
        return False
    if "basement" in kinds or "roof" in kinds:
        return storey in ("any", "basement")
    return not ("top" in kinds and storey in ("ground", "basement"))
