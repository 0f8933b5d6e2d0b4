"""Read rooms without a name of their own as those that the building is for: "40 rooms" of a hotel, a home's chamber."""

from dataclasses import replace

from mansion_planner.brief.building import is_compound
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import HEAD_TYPES, similar_room_type

__all__ = ["plain_room"]

_WORKING = frozenset({"office", "industry", "education", "culture", "sport", "retail"})
"""Families of buildings whose studios are to work in."""
_HOMES = frozenset({"home"})
"""Families of buildings whose chambers are to sleep in."""

_PLAIN = {
    "hotel": "hotel_room",
    "hospital": "patient_room",
    "hostel": "hostel_dorm",
    "student_dormitory": "dorm_room",
    "nursing_home": "resident_room",
}


def plain_room(reading: Reading, phrase: Phrase) -> Phrase:
    """Read "40 rooms" in a hotel, hospital or dormitory as the rooms that it is for; elsewhere they stay unread."""
    if phrase.name == "cabin" and phrase.plural and phrase.counted and phrase.building:
        return replace(phrase, head="room", building="", room_type=HEAD_TYPES["cabin"], known=False)
    if phrase.head == "building" and not phrase.room_type:
        return replace(phrase, room_type=similar_room_type(phrase.name, reading.knowledge), known=False)
    if phrase.head == "building" and phrase.counted and phrase.plural and is_compound(reading, phrase):
        return replace(phrase, known=False)
    if phrase.name.split("_")[0] == "hall" and phrase.room_type == "hallway" and sum(phrase.areas[:1]) >= 40.0:
        return replace(phrase, room_type="assembly_hall")
    kind = reading.facts.building[0][0] if reading.facts.building else ""
    record = reading.knowledge.buildings.get(kind)
    works = record is not None and record.family in _WORKING
    homely = record is not None and record.family in _HOMES
    if homely and phrase.room_type == HEAD_TYPES["chamber"] and phrase.name == "chamber":
        return replace(phrase, room_type="bedroom", known=True)
    if works and phrase.room_type == "studio_apartment" and phrase.name.rpartition("_")[2] == "studio":
        # nobody lives in a dance school
        return replace(phrase, head="room", building="", room_type=HEAD_TYPES["studio"], known=False)
    if phrase.head != "room" or phrase.name not in ("room", "guest_room") or not phrase.counted:
        return phrase
    room = _PLAIN.get(kind) or _PLAIN.get(record.like if record is not None else "")
    if room is not None:
        return replace(phrase, room_type=room, known=True)
    if phrase.name != "room":
        return phrase
    reading.taken.difference_update(range(phrase.first, phrase.last))
    return replace(phrase, head="unknown")
