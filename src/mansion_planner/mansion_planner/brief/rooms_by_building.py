"""Read what a room is by the building that it stands in: "40 rooms" of a hotel, the cabin of a director."""

import re
from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.building import is_compound
from mansion_planner.brief.persons import is_person
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import HEAD_TYPES, elliptic_room_type, similar_room_type

__all__ = ["room_for_building"]


def room_for_building(reading: Reading, phrase: Phrase) -> Phrase:
    """Return a phrase with the room that it names in a building of the kind that the brief is about.

    "40 rooms" in a hotel, hospital or dormitory are the rooms that it is for; elsewhere they stay unread.
    """
    if phrase.name == "cabin" and phrase.plural and phrase.counted and phrase.building:
        return replace(phrase, head="room", building="", room_type=HEAD_TYPES["cabin"], known=False)
    if "_for_two_car" in phrase.name and not phrase.counted:
        return replace(phrase, count=1, plural=False)  # "a garage for two cars"
    facts = reading.facts
    kind = facts.building[0][0] if facts.building else facts.building_like
    record = reading.knowledge.buildings.get(kind)
    family, like = (record.family, record.like) if record is not None else ("", "")
    itself = reading.tokens[phrase.begin].start in {span.start for _, span in facts.building if span.words}
    base = re.sub(r"_\d+$", "", phrase.name)
    named = _NAMED.get((base, kind)) or _NAMED.get((base, like))
    if named is not None and not itself:
        return replace(phrase, head="room", building="", room_type=named, known=True)
    if (
        base == "studio"
        and phrase.room_type == "studio_apartment"
        and kind in _HOMES
        and not itself
        and not phrase.plural
        and phrase.determiner != "the"
    ):
        painted = not _PAINTING.isdisjoint(token.text for token in reading.tokens)
        return replace(phrase, head="room", building="", room_type="art_room", known=painted)
    lodging = _PLAIN.get(kind) or _PLAIN.get(like)
    if (
        lodging
        and lodging != "hostel_dorm"
        and phrase.room_type == "hotel_room"
        and phrase.name.partition("_")[0] in _BEDS
    ):
        return replace(phrase, room_type=lodging, known=True)  # "twelve double rooms" of a dormitory
    own = None if itself else _by_family(reading, phrase, family)
    if own is not None:
        return own
    if phrase.head == "building" and not phrase.room_type:
        return replace(phrase, room_type=similar_room_type(phrase.name, reading.knowledge), known=False)
    if phrase.head == "building" and phrase.counted and phrase.plural and is_compound(reading, phrase):
        return replace(phrase, known=False)
    if phrase.name in _ENTRANCES and family not in ("", "home") and not phrase.areas:
        return replace(phrase, room_type="lobby")
    hall = phrase.name.split("_")[0] == "hall" and phrase.room_type == "hallway"
    big = not _BIG.isdisjoint(reading.words(phrase.first, phrase.noun_end)) and family not in _DWELT_IN
    big = big or (reading.word(phrase.last) == "for" and reading.value(phrase.last + 1) >= _CROWD)
    big = big or (phrase.name == "hall" and family not in ("", *_DWELT_IN) and _holds_things(reading, phrase))
    if hall and big and family == "industry":
        return replace(phrase, room_type="production_hall")
    if hall and (big or sum(phrase.areas[:1]) >= 40.0):
        return replace(phrase, room_type="assembly_hall")
    if phrase.head != "room" or phrase.name not in ("room", "guest_room") or not phrase.counted:
        return phrase
    if lodging is not None:
        return replace(phrase, room_type=lodging, known=True)
    if not _BEDS.isdisjoint(reading.words(phrase.first, phrase.noun_end)) and (not family or family in _DWELT_IN):
        return replace(phrase, room_type="bedroom", known=True)  # "six single rooms"
    if phrase.name != "room" or reading.word(phrase.last) == "with":
        return phrase  # "one open room with 20 desks"
    reading.taken.difference_update(range(phrase.first, phrase.last))
    return replace(phrase, head="unknown")


def _by_family(reading: Reading, phrase: Phrase, family: str) -> Phrase | None:
    """Return a room as the kind that it is in a family of buildings; nothing where the family makes no difference."""
    words = phrase.name.split("_")
    if phrase.building and phrase.head in ("room", "building") and words[0] != words[-1]:
        if words[-1] == "cabin" and family and family not in _DWELT_IN:
            kind = elliptic_room_type(tuple(words[:-1]), reading.knowledge)
            told = bool(kind) or is_person(words[-2]) or len(words[-2]) < 3  # "MD cabin"
            return replace(phrase, head="room", building="", room_type=kind or "private_office", known=told)
        if words[-1] == "house" and phrase.building == "house" and family in _WORKING | {"retail", "health"}:
            kind = elliptic_room_type(tuple(words[:-1]), reading.knowledge)
            kind = kind or ("production_hall" if family == "industry" else "storage")
            return replace(phrase, head="room", building="", room_type=kind, known=False)  # a winery's press house
        if words[-1] == "station" and phrase.building == "train_station" and not phrase.plural:
            return replace(phrase, head="room", building="", room_type=HEAD_TYPES["station"], known=False)
    kinds = [reading.facts.building_name, *(kind for kind, _ in reading.facts.building[:1])]
    taught = next((kind for word, kind in _STUDIOS.items() if any(word in name for name in kinds)), "")
    if taught and words == ["studio"]:
        return replace(phrase, head="room", building="", room_type=taught, known=True)
    if phrase.room_type == "studio_apartment" and words[-1] == "studio" and family in _WORKING:
        told = reading.word(phrase.last) == "for" and reading.kind(phrase.last + 1) == "word"
        desks = family == "office" and len(words) == 1 and not told  # "a studio for podcasts"
        studio = "open_office" if desks else HEAD_TYPES["studio"]
        # nobody lives in a dance school
        return replace(phrase, head="room", building="", room_type=studio, known=False)
    if phrase.name == "cell" and phrase.room_type == "holding_cell" and family in _DWELT_IN | {"worship", "culture"}:
        return replace(phrase, room_type="bedroom", known=False)  # a monk's
    if family == "health" and phrase.name in ("theatre", "theater"):
        return replace(phrase, head="room", building="", room_type="operating_room", known=True)
    if family == "lodging" and phrase.name in _LET:
        return replace(phrase, room_type="hotel_room", known=True)
    if family in ("home", "") and (found := _at_home(reading, phrase, words, family)):
        return found
    if family == "industry" and phrase.room_type == "assembly_hall" and words[0] == "assembly":
        return replace(phrase, room_type="production_hall")
    if family == "industry" and words[-2:] == ["machine", "room"]:
        return replace(phrase, room_type="production_hall")
    if phrase.room_type == "car_workshop" and words[-1] == "bay" and _holds_instruments(reading, words, family):
        return replace(phrase, room_type="laboratory", known=True)
    if family == "health" and words[-1] in ("theatre", "theater") and phrase.room_type == "auditorium":
        return replace(phrase, head="room", building="", room_type="operating_room", known=True)
    if family == "lodging" and len(words) > 1 and words[-1] == "room" and _is_slept_in(phrase):
        return replace(phrase, room_type="hotel_room", known=True)  # a crew hotel's crew rooms
    if family == "sport" and words[-2:] == ["shower", "room"] and not phrase.building:
        return replace(phrase, room_type="shower_area")
    if phrase.name == "student_room" and not phrase.counted and not phrase.plural and family in _WORKING:
        return replace(phrase, room_type="study_room", known=False)
    return None


def _at_home(reading: Reading, phrase: Phrase, words: Sequence[str], family: str) -> Phrase | None:
    """The room that a phrase means in a home, or in a building of no known kind."""
    if not phrase.known and _is_of_somebody(words) and phrase.head == "room":
        return replace(phrase, room_type="childrens_room" if words[0] in _YOUNG else "bedroom", known=True)
    if not family:
        diner = phrase.name == "diner"
        return replace(phrase, head="room", building="", room_type=_AT_HOME["diner"], known=True) if diner else None
    if phrase.name == "loft" and (phrase.building or phrase.head == "room"):
        sleeping = reading.word(phrase.last) == "for" and reading.word(phrase.last + 1).startswith("sleep")
        return replace(phrase, head="room", building="", room_type="bedroom" if sleeping else "attic", known=True)
    if phrase.name == "parent" and phrase.head == "room":
        return replace(phrase, room_type="master_bedroom", count=1, counted=False, plural=False)
    if phrase.name in _AT_HOME:
        return replace(phrase, head="room", building="", room_type=_AT_HOME[phrase.name], known=True)
    if phrase.name == "library" and phrase.room_type == "library":
        return replace(phrase, head="room", building="", room_type="library_room", known=True)
    if phrase.name == "chamber" and phrase.room_type == HEAD_TYPES["chamber"]:
        return replace(phrase, room_type="bedroom", known=True)
    return None


def _is_of_somebody(words: Sequence[str]) -> bool:
    """Whether a room is called after a member of a family: "the teenager's room", "grandma's room"."""
    return len(words) == 2 and words[1] == "room" and words[0] in _YOUNG | _GROWN


_YOUNG = frozenset({"teenager", "teen", "son", "daughter", "baby", "toddler"})
_GROWN = frozenset(
    {"grandparent", "grandmother", "grandfather", "grandma", "grandpa", "nanny", "mother", "father", "aunt", "uncle"}
)
"""Members of a family who have a room of their own in a home."""


def _is_slept_in(phrase: Phrase) -> bool:
    """Whether rooms of a hotel that nobody knows are those that it is for."""
    many = phrase.name == "private_room" or (phrase.count or 0) >= _MANY
    return phrase.room_type in _NOT_SLEPT_IN and phrase.counted and many


_NOT_SLEPT_IN = frozenset({"break_room", "vip_room", "study_room"})
_MANY = 6
"""So many rooms of a name that nobody knows are what a hotel is for."""


def _holds_instruments(reading: Reading, words: Sequence[str], family: str) -> bool:
    """Whether a bay is one of a laboratory: an etching bay, a metrology bay."""
    laboratory = family in _INSTRUMENTS or reading.facts.building_like.startswith("laboratory")
    return laboratory and len(words) > 1 and _FOR_CARS.isdisjoint(words)


def _holds_things(reading: Reading, phrase: Phrase) -> bool:
    """Whether something stands in a hall: "a hall for ten buses", "hall with six check-in counters"."""
    number = phrase.last + 1
    counted = reading.kind(number) == "number" and reading.value(number) > 1 and reading.kind(number + 1) != "unit"
    return reading.word(phrase.last) in ("for", "with") and (counted or reading.plural(number))


_ENTRANCES = frozenset({"entrance_hall", "entry_hall", "entrance_room"})
"""What people come in by: in a building for the public, its lobby."""
_BIG = frozenset({"big", "large", "main", "great", "huge", "grand", "tall", "public"})
"""What is said of a hall where people meet; a hall that leads to other rooms is not told of so."""
_CROWD = 20
"""People from which on a hall is for them to meet in."""
_DWELT_IN = frozenset({"home", "lodging"})
"""Families of buildings whose cabins are to sleep in."""

_WORKING = frozenset({"office", "industry", "education", "culture", "sport", "retail"})
"""Families of buildings whose studios are to work in."""

_AT_HOME = {
    "private_room": "bedroom", "parent_room": "master_bedroom", "diner": "dining_room", "tech_room": "mechanical_room",
    "store": "storage",
}  # fmt: skip
"""Rooms of a home that other buildings have for something else, by their names."""

_LET = frozenset({"private_room", "family_room"})
"""Rooms of a hostel or a refuge that guests have to themselves."""

_INSTRUMENTS = frozenset({"education", "health", "office", ""})
"""Families of buildings whose bays hold instruments and not cars."""

_FOR_CARS = frozenset("car vehicle auto motor truck lorry bus van service repair workshop lift tyre tire wash".split())
"""What is said of the bays of a workshop for cars."""

_STUDIOS = {"dance": "dance_studio", "ballet": "dance_studio", "yoga": "yoga_studio", "pilates": "yoga_studio",
            "photo": "photo_studio", "radio": "recording_studio"}  # fmt: skip
"""What a studio is in a building called after what is done there."""
_HOMES = frozenset("flat house detached_house townhouse villa bungalow cottage farmhouse cabin".split())
"""Homes in which a studio is a room to work in, and no home of its own."""
_PAINTING = frozenset({"artist", "painter", "easel", "painting", "sculptor"})
"""Words that tell which art a studio is for."""
_NAMED = {
    ("surgery", "dental_clinic"): "dental_room",
    ("surgery", "dental_surgery"): "dental_room",
    ("hall", "cinema"): "cinema_hall",
    ("screen", "cinema"): "cinema_hall",
    ("sleeping_room", "kindergarten"): "nap_room",
    ("group_room", "kindergarten"): "kindergarten_classroom",
    ("bay", "fire_station"): "apparatus_bay",
    ("engine_bay", "fire_station"): "apparatus_bay",
    ("vehicle_bay", "fire_station"): "apparatus_bay",
    ("cell", "monastery"): "dorm_room",
    ("press_room", "brewery"): "production_hall",
    ("practice_room", "yoga_center"): "yoga_studio",
    ("bay", "bus_station"): "parking",
    ("studio", "radio_station"): "recording_studio",
    ("studio", "media_house"): "recording_studio",
}
"""Rooms that the same words name another kind of in other buildings, by their name and the kind of building."""

_BEDS = frozenset({"single", "double", "twin"})
"""For how many a room is that people sleep in."""

_PLAIN = {
    "hotel": "hotel_room",
    "hospital": "patient_room",
    "hostel": "hostel_dorm",
    "student_dormitory": "dorm_room",
    "flat_share": "bedroom",
    "nursing_home": "resident_room",
}
