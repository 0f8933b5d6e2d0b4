"""Rooms that have proper names, and rooms that a pronoun or a part of their name stands for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    ("brief", "kind", "names"),
    [
        (
            "A courthouse with Courtroom Alder (150 m2) and Courtroom Birch (90 m2).",
            "courtroom",
            {"courtroom_alder": 150.0, "courtroom_birch": 90.0},
        ),
        (
            "A cinema. Screen One of 200 m2 on the first storey; Screen Two and Screen Three, each 90 m2, above.",
            "cinema_hall",
            {"screen_one": 200.0, "screen_two": 90.0, "screen_three": 90.0},
        ),
        (
            "Three game rooms named Pharaoh's Tomb, Submarine and Moon Base, each 30 m2.",
            "game_room",
            {"pharaoh_s_tomb": 30.0, "submarine": 30.0, "moon_base": 30.0},
        ),
        ("Two game rooms named A and B, each 30 m2.", "game_room", {"a": 30.0, "b": 30.0}),
        (
            "An office with Meeting Room Paris (20 m2) and Meeting Room Rome (12 m2).",
            "meeting_room",
            {"meeting_room_paris": 20.0, "meeting_room_rome": 12.0},
        ),
    ],
)
def test_rooms_keep_their_proper_names(brief: str, kind: str, names: dict[str, float]) -> None:
    facts = read(brief)
    assert {room.name: room.area for room in facts.rooms if room.room_type == kind} == names
    assert facts.area == []


@pytest.mark.parametrize(
    ("brief", "pair"),
    [
        (
            "A school with two game rooms named Submarine and Moon Base. A shop away from Submarine.",
            ("shop", "submarine"),
        ),
        (
            "A clinic with a waiting area for dogs plus a second one for cats and a gym away from either waiting area.",
            ("gym", "cat_waiting_area"),
        ),
    ],
)
def test_a_name_alone_speaks_of_its_room(brief: str, pair: tuple[str, str]) -> None:
    assert pair in [(fact.first_name, fact.second_name) for fact in read(brief).apart]


@pytest.mark.parametrize(
    ("brief", "names"),
    [
        (
            "A clinic with a waiting area for dogs plus a second one just for cats",
            ["dog_waiting_area", "cat_waiting_area"],
        ),
        ("A house with a bathroom upstairs and a second one on the ground floor", ["bathroom", "bathroom"]),
    ],
)
def test_a_further_one_is_a_room(brief: str, names: list[str]) -> None:
    assert [room.name for room in read(brief).rooms] == names


def test_a_range_of_numbers_counts_rooms() -> None:
    rooms = read("A sports centre with team changing rooms numbered 1 to 4 and a gym").rooms
    assert [(room.name, room.count) for room in rooms] == [("team_changing_room", 4), ("gym", 1)]


def test_a_capital_in_a_title_is_no_proper_name() -> None:
    rooms = read("House With Master Bedroom Suite, Living Room Fireplace, Dining Room Balcony").rooms
    assert not any(room.name in ("living_room_fireplace", "room_balcony") for room in rooms)
