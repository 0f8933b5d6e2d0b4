"""Numbered lists of shops and rooms."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def test_numbered_units_are_shops_by_their_goods() -> None:
    brief = "Mall. Ground floor units: 1 = perfumery, 2 = shoes, 3 = bakery. Upper floor units: 4 = toys, 5 = books."
    facts = read_brief(brief, default_knowledge())
    assert [(room.label, room.room_type, room.count) for room in facts.rooms] == [
        ("perfumery", "shop", 1),
        ("shoes", "shop", 1),
        ("bakery", "bakery", 1),
        ("toys", "shop", 1),
        ("books", "shop", 1),
    ]
    assert not facts.unread


def test_numbered_rooms_keep_their_names() -> None:
    facts = read_brief("Clinic. Rooms: 1 = reception, 2 = laboratory, 3 = pharmacy.", default_knowledge())
    assert [room.room_type for room in facts.rooms] == ["reception", "laboratory", "pharmacy"]


def test_a_series_of_numbers_counts_rooms() -> None:
    facts = read_brief("Clinic: reception, exam room 1-4, lab.", default_knowledge())
    assert [(room.room_type, room.count) for room in facts.rooms] == [
        ("reception", 1),
        ("consultation_room", 4),
        ("laboratory", 1),
    ]
