"""Read the rooms that a brief wants, with count, area and storeys."""

import re
from dataclasses import replace

from mansion_planner.brief.facts import FloorRef, RoomFact, UseFact
from mansion_planner.brief.places import Place
from mansion_planner.brief.quantities import area_at
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import HEAD_TYPES, similar_room_type

__all__ = ["AS_ROOM", "read_rooms"]

AS_ROOM = {
    "office": "private_office", "flat": "apartment", "apartment_building": "apartment",
    "studio_flat": "studio_apartment", "hotel": "hotel_room", "supermarket": "sales_area",
    "factory": "production_hall", "bank": "bank_hall", "clinic": "consultation_room",
    "museum": "gallery", "cinema": "cinema_hall", "theater": "auditorium", "nightclub": "bar",
    "casino": "casino_floor", "kindergarten": "kindergarten_classroom", "sports_center": "sports_hall",
    "church": "prayer_hall", "mosque": "prayer_hall", "coworking": "coworking_area",
    "conference_center": "conference_hall", "swimming_center": "indoor_pool",
    "data_center": "server_room", "dental_clinic": "dental_room", "student_dormitory": "dorm_room",
    "school": "classroom", "post_office": "service_counter", "shopping_mall": "shop",
    "parking_garage": "parking", "hostel": "hostel_dorm", "library_building": "library",
    "police_station": "security_room", "penthouse": "apartment", "townhouse": "apartment",
    "community_center": "assembly_hall", "spa_building": "spa", "farm_building": "stable",
    "university": "lecture_hall", "hospital": "treatment_room", "town_hall": "service_counter",
    "courthouse": "courtroom", "fire_station": "apparatus_bay", "car_dealership": "showroom",
    "train_station": "waiting_hall", "airport_terminal": "departure_lounge",
    "veterinary_clinic": "consultation_room", "rehabilitation_center": "physiotherapy_room",
    "nursing_home": "resident_room", "entertainment_center": "arcade", "media_house": "newsroom",
    "music_school": "music_room", "art_gallery": "gallery", "call_center": "open_office",
    "observatory": "observatory_dome", "hair_salon": "salon_floor", "house": "apartment",
    "villa": "apartment", "bungalow": "apartment",
}  # fmt: skip

_AS_USE = {"flat": "apartment_building", "studio_flat": "apartment_building", "shop_building": "shopping_mall",
           "house": "apartment_building", "penthouse": "apartment_building"}  # fmt: skip


_STOP = frozenset(
    [
        "a",
        "an",
        "the",
        "with",
        "and",
        "or",
        "of",
        "in",
        "on",
        "at",
        "to",
        "for",
        "from",
        "no",
        "not",
        "without",
        "has",
        "have",
        "is",
        "are",
        "be",
        "that",
        "this",
        "it",
        "its",
        "which",
        "each",
        "every",
        "all",
        "one",
        "per",
        "by",
        "as",
        "plus",
        "also",
        "any",
        "some",
        "several",
        "many",
        "few",
        "more",
        "most",
        "least",
        "than",
        "total",
        "about",
        "around",
        "i",
        "we",
        "want",
        "need",
        "like",
        "please",
        "build",
        "design",
        "create",
        "make",
        "give",
        "us",
        "me",
        "would",
        "should",
        "must",
        "can",
        "will",
        "could",
        "there",
        "their",
        "our",
        "my",
        "your",
        "including",
        "containing",
        "contain",
        "include",
        "provide",
        "includ",
        "contain",
        "where",
        "when",
        "who",
        "whose",
        "next",
        "beside",
        "adjacent",
        "near",
        "between",
        "above",
        "below",
        "under",
        "over",
        "into",
        "onto",
        "onto",
        "across",
        "other",
        "same",
        "another",
        "extra",
        "additional",
        "living",
        "floor",
        "storey",
        "story",
        "level",
        "m2",
        "square",
        "m",
        "metre",
        "meter",
        "sq",
        "ft",
        "feet",
        "foot",
        "large",
        "small",
        "big",
        "main",
        "own",
        "separate",
        "shared",
        "common",
        "only",
        "just",
        "very",
        "quite",
        "new",
        "nice",
        "modern",
        "open",
        "outdoor",
        "indoor",
        "so",
        "but",
        "then",
        "upper",
        "lower",
        "top",
        "ground",
        "located",
        "shall",
        "featuring",
        "have",
        "having",
        "both",
        "either",
        "neither",
        "enough",
        "direct",
        "connected",
        "connecting",
        "opening",
        "opens",
        "open",
        "close",
        "between",
        "rest",
        "entire",
        "whole",
        "such",
        "lots",
        "lot",
        "plenty",
        "use",
        "used",
        "using",
        "parking",
        "story",
        "stories",
        "footprint",
        "sampl",
        "unused",
        "empty",
        "free",
        "useful",
        "usable",
        "remaining",
        "gross",
        "net",
        "living",
        "dead",
        "storage",
        "green",
        "public",
        "private",
        "work",
        "working",
        "outside",
        "available",
        "little",
        "much",
        "less",
        "wide",
        "tall",
        "first",
        "double",
        "single",
        "l",
        "u",
        "t",
        "h",
        "shaped",
    ]
)

_SOFT_PLURAL = frozenset(
    {"several", "multiple", "various", "many", "few", "some", "numerous", "more"}
)


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
    _attach_places(reading, places, found)


def _restate(found: list[tuple[int, int, RoomFact]], fact: RoomFact) -> None:
    """Give the area of a repeated mention to the room that it repeats."""
    for number, (first, last, earlier) in enumerate(found):
        if earlier.room_type == fact.room_type and earlier.area is None and fact.area is not None:
            found[number] = (first, last, replace(earlier, area=fact.area))
            return


def _fact(
    reading: Reading, first: int, last: int, room_type: str, name: str
) -> tuple[int, int, RoomFact]:
    """Read what stands before and after a room phrase: its count and its area."""
    plural = reading.tokens[last - 1].plural
    count: int | None = None if plural else 1
    area: float | None = None
    index = first - 1
    steps = 0
    each = False
    while index >= 0 and steps < 6:
        token = reading.tokens[index]
        measured = _area_ending(reading, index + 1)
        if measured is not None:
            area, index = measured[0], measured[1] - 1
            continue
        if token.kind == "number" and index not in reading.taken:
            if token.value == int(token.value) and 1 <= token.value <= 500:
                if not (token.soft and token.text in ("single", "double", "twin") and plural):
                    count = int(token.value)
                    if reading.word(index - 1) == "a" and token.text in ("dozen",):
                        count = 12
                    first = index
                    break
        elif token.kind != "word" or token.text in (
            "and",
            "or",
            "with",
            "a",
            "an",
            "the",
            "of",
            "no",
        ):
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
    after = _area_after(reading, last)
    if area is None and after is not None:
        area, end = after
        reading.take(last, end)
        last = end
    if reading.word(last) in ("each", "apiece"):
        last += 1
    if reading.word(last) in ("per", "on", "for") and reading.word(
        last + (reading.word(last) != "per")
    ) in ("floor", "storey", "level"):
        each = True
    fact = RoomFact(
        room_type, name, reading.span(min(first, last - 1), last), count, area, (), each
    )
    return first, last, fact


def _area_ending(reading: Reading, end: int) -> tuple[float, int] | None:
    for start in range(end - 4, end - 1):
        if start >= 0 and start not in reading.taken:
            found = area_at(reading, start)
            if found is not None and found[1] == end:
                reading.take(start, end)
                return found[0], start
    return None


def _area_after(reading: Reading, index: int) -> tuple[float, int] | None:
    begin = index
    while index - begin < 6 and reading.word(index) in (
        "of", "with", "(", "measuring", "about", "around", "at", "least", "is", "has", "an", "area", "be",
        "should", "roughly", "approximately", "each", ":", "a", "having", "covering", "sized", "size", "must",
        "will", "exactly", "occupying", "minimum", "more", "than", "floor",
    ):  # fmt: skip
        index += 1
    found = area_at(reading, index) if index not in reading.taken else None
    if found is None:
        return None
    value, end = found
    return value, end + (reading.word(end) == ")")


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
        while reading.word(first) in (
            "guest",
            "patient",
            "comfortable",
            "private",
            "single",
            "double",
            "standard",
        ):
            first -= 1
        if (
            token.text == "room"
            and token.plural
            and index not in reading.taken
            and reading.kind(first) == "number"
        ):
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


def _attach_places(
    reading: Reading, places: list[Place], found: list[tuple[int, int, RoomFact]]
) -> None:
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
            if (
                place.refs[0].kind in ("every", "range", "upper", "middle", "lower")
                or len(place.refs) > 1
            ):
                each.add(number)
    for number, (first, last, fact) in enumerate(found):
        mention = reading.mention_at.get(first)
        building = _use_of(reading, found[number]) if assigned.get(number) else ""
        if building and fact.area is None and (fact.count is None or mention is not None):
            reading.facts.uses.append(UseFact(building, assigned[number], fact.span))
            continue
        reading.facts.rooms.append(
            RoomFact(
                fact.room_type, fact.name, fact.span, fact.count, fact.area,
                assigned.get(number, ()), fact.each or number in each,
            )
        )  # fmt: skip
        del last


def _use_of(reading: Reading, entry: tuple[int, int, RoomFact]) -> str:
    """Return the building type when the phrase is a plural use of whole storeys ("offices", "apartments", "shops")."""
    first, last, fact = entry
    for index in range(first, last):
        mention = reading.mention_at.get(index)
        if mention is not None and mention.building and mention.plural and fact.count is None:
            return _AS_USE.get(mention.building, mention.building)
    return ""


def _rooms_of(
    reading: Reading,
    place: Place,
    places: list[Place],
    found: list[tuple[int, int, RoomFact]],
    done: set[int],
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
    opens = place.first == 0 or before in (
        ".",
        ";",
        ":",
        "\n",
        "and",
        ",",
        "while",
        "but",
        "!",
        "–",
        "where",
        "then",
    )
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
            reading.kind(i) in ("word", "number", "unit")
            and reading.word(i) not in ("and", "with", "or")
            for i in range(begin, end)
        )
    )


def _no_break(reading: Reading, begin: int, end: int) -> bool:
    return end - begin <= 6 and not any(
        reading.word(i) in (".", ";", ":", "\n", ",", "with", "and", "but")
        for i in range(begin, end)
    )


def _conjuncts(
    reading: Reading, found: list[tuple[int, int, RoomFact]], before: list[int], place: Place
) -> list[int]:
    """The rooms listed just before a floor reference, as far back as the list goes and the storey suits them."""
    chosen = [before[-1]]
    for number in reversed(before[:-1]):
        _first, last, fact = found[number]
        between = [reading.word(i) for i in range(last, found[chosen[-1]][0])]
        linked = all(
            word in ("and", "a", "an", "the", ",", "&", "one", "large", "small") for word in between
        )
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
