"""Read what a room is by the building that it stands in: "40 rooms" of a hotel, the studio of an agency."""

from dataclasses import replace

from mansion_planner.brief.building import is_compound
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import HEAD_TYPES, similar_room_type

__all__ = ["room_for_building"]


def room_for_building(reading: Reading, phrase: Phrase) -> Phrase:
    """Return a phrase with the room that it names in a building of the kind that the brief is about.

    "40 rooms" in a hotel, hospital or dormitory are the rooms that it is for; elsewhere they stay unread.
    """
    if phrase.name == "cabin" and phrase.plural and phrase.counted and phrase.building:
        return replace(phrase, head="room", building="", room_type=HEAD_TYPES["cabin"], known=False)
    if phrase.head == "building" and not phrase.room_type:
        return replace(phrase, room_type=similar_room_type(phrase.name, reading.knowledge), known=False)
    if phrase.head == "building" and phrase.counted and phrase.plural and is_compound(reading, phrase):
        return replace(phrase, known=False)
    if phrase.name.split("_")[0] == "hall" and phrase.room_type == "hallway" and sum(phrase.areas[:1]) >= 40.0:
        return replace(phrase, room_type="assembly_hall")
    facts = reading.facts
    kind = facts.building[0][0] if facts.building else facts.building_like
    record = reading.knowledge.buildings.get(kind)
    family, like = (record.family, record.like) if record is not None else ("", "")
    if family in _WORKING and phrase.room_type == "studio_apartment" and phrase.name.rpartition("_")[2] == "studio":
        # nobody lives in a dance school
        desks = family == "office" and reading.word(phrase.begin - 1) == "open"
        studio = "open_office" if desks else HEAD_TYPES["studio"]
        return replace(phrase, head="room", building="", room_type=studio, known=False)
    if phrase.head != "room" or phrase.name not in ("room", "guest_room") or not phrase.counted:
        return phrase
    room = _PLAIN.get(kind) or _PLAIN.get(like)
    if room is not None:
        return replace(phrase, room_type=room, known=True)
    if phrase.name != "room":
        return phrase
    reading.taken.difference_update(range(phrase.first, phrase.last))
    return replace(phrase, head="unknown")


_WORKING = frozenset({"office", "industry", "education", "culture", "sport", "retail"})
"""Families of buildings whose studios are to work in."""

_PLAIN = {
    "hotel": "hotel_room",
    "hospital": "patient_room",
    "hostel": "hostel_dorm",
    "student_dormitory": "dorm_room",
    "nursing_home": "resident_room",
}
