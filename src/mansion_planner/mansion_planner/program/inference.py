"""Infer what a brief leaves open: the building type from its rooms, and the number of storeys (section C.1)."""

import numpy as np

from mansion_knowledge import BuildingType
from mansion_msgs_py.program import TraceEntry
from mansion_msgs_py.wording import with_article
from mansion_planner.brief.facts import BriefFacts, Span

__all__ = ["MOST_FLOORS", "infer_building", "infer_floors", "note"]

MOST_FLOORS = 100


def note(trace: list[TraceEntry], span: Span | None, effect: str) -> None:
    """Add a line to the trace: the words (or none, for a rule) and what they led to."""
    if span is None:
        trace.append(TraceEntry(words="", effect=effect))
    else:
        trace.append(TraceEntry(words=span.words, effect=effect, start=span.start, end=span.end))


_SIZES = {"high_rise": (10, 1.0), "mid_rise": (6, 1.0), "low_rise": (3, 1.0), "duplex": (2, 1.0),
          "triplex": (3, 1.0), "bungalow": (1, 1.0)}  # fmt: skip


_HINTS = {
    "home": "house", "classroom": "school", "patient_room": "hospital", "hotel_room": "hotel",
    "consultation_room": "clinic", "open_office": "office", "private_office": "office",
    "meeting_room": "office", "bedroom": "house", "living_room": "house", "apartment": "apartment_building",
    "shop": "shopping_mall", "sales_area": "supermarket", "gallery": "museum", "laboratory": "laboratory_building",
    "gym": "gym_building", "cinema_hall": "cinema", "warehouse": "warehouse_building", "operating_room": "hospital",
    "production_hall": "factory", "restaurant": "restaurant_building", "dorm_room": "student_dormitory",
    "reading_room": "library_building", "book_stacks": "library_building", "master_bedroom": "house",
    "parking": "parking_garage", "workshop": "factory", "coworking_area": "coworking", "auditorium": "theater",
    "courtroom": "courthouse",
    "cafe": "cafe_building", "sports_hall": "sports_center", "lecture_hall": "university", "kitchen": "house",
    "studio_apartment": "apartment_building", "bathroom": "house", "dining_room": "house",
    "kindergarten_classroom": "kindergarten", "dental_room": "dental_clinic", "apparatus_bay": "fire_station",
}  # fmt: skip


_PEOPLE_HINTS = {"pupil": "school", "student": "university", "patient": "hospital", "bed": "hospital",
                 "employee": "office", "guest": "hotel", "resident": "apartment_building", "worker": "office",
                 "family": "house", "kid": "kindergarten", "child": "kindergarten", "developer": "office",
                 "diner": "restaurant_building", "firefighter": "fire_station",
                 "tenant": "apartment_building"}  # fmt: skip


def infer_building(facts: BriefFacts) -> str:
    if len({use.building_type for use in facts.uses}) > 1:
        return "mixed_use"
    if facts.uses:
        return facts.uses[0].building_type
    votes: dict[str, float] = {}
    for room in facts.rooms:
        hint = _HINTS.get(room.room_type)
        if hint:
            votes[hint] = votes.get(hint, 0.0) + min(room.count or 2, 4)
    for occupants in facts.occupants:
        hint = _PEOPLE_HINTS.get(occupants.noun)
        if hint:
            votes[hint] = votes.get(hint, 0.0) + 3.0
    if votes:
        return max(votes, key=lambda name: (votes[name], name))
    if any(word == "high_rise" for word, _ in facts.size) or any(q.value >= 4 for q in facts.floors):
        return "office"
    return "house" if not any(q.value > 300 for q in facts.area) else "office"


def infer_floors(
    facts: BriefFacts, building: BuildingType, needed: int, trace: list[TraceEntry], generator: np.random.Generator
) -> int:
    usual, most = building.floors
    count, reason = usual, f"{with_article(building.name)} usually has {usual}"
    sized = next(((word, span) for word, span in facts.size if word in _SIZES), None)
    if sized is not None:
        count, reason = _SIZES[sized[0]][0], f'"{sized[1].words}"'
        if building.name == "penthouse" or (sized[0] == "high_rise" and building.family == "home"):
            count = usual
    elif facts.area and facts.floor_area:
        ratio = facts.area[0].value / facts.floor_area[0].value
        count = max(1, min(round(ratio), MOST_FLOORS))
        reason = "total area over area of a storey"
    elif facts.area and facts.area[0].value > 1.25 * building.floor_area[1]:
        count = min(max(-(-int(facts.area[0].value) // int(max(building.floor_area[1], 150))), 1), max(most, 1))
        reason = "the stated area"
    elif any(word == "small" for word, _ in facts.size):
        count = max(1, usual - 1) if usual > 2 else usual
    elif usual > 2 and generator.random() < 0.3:
        count = usual + 1 if usual < most else usual
    if facts.uses and needed:
        tops = [ref.first for use in facts.uses for ref in use.floors if ref.kind == "top"]
        count, needed = needed + max(tops, default=0), needed + max(tops, default=0)
        reason = "the storeys that are given a use"
    named = {ref.kind for room in facts.rooms for ref in room.floors}
    if "upper" in named and named <= {"number", "upper", "basement"} and needed <= 1 and not sized and not facts.area:
        count, reason = 2, "a lower and an upper one are described"
    pinned = {ref.first for room in facts.rooms for ref in room.floors if ref.kind == "number"}
    if needed >= 2 and pinned >= set(range(1, needed + 1)) and not sized:
        count, reason = needed, "each of them is described"
    kinds = {ref.kind for room in facts.rooms for ref in room.floors}
    floor_least = 1
    if kinds & {"upper", "top"}:
        floor_least = 2
    if kinds & {"middle"}:
        floor_least = 3
    if sum(use.count or 0 for use in facts.uses):
        above = any(use.floors for use in facts.uses if use.count)
        floor_least = max(floor_least, sum(use.count or 0 for use in facts.uses) + above)
        count = floor_least
    result = max(count, needed, floor_least)
    if result > count:
        reason = "the highest storey that is named"
    note(trace, sized[1] if sized else None, f"{result} storeys: {reason}")
    return result
