"""Rooms side by side or apart, in clauses of many forms, and what is not wanted."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    ("brief", "pairs"),
    [
        (
            "A metal workshop, a wood workshop, a tool store in between the metal and the wood workshop.",
            {("tool_store", "metal_workshop"), ("tool_store", "wood_workshop")},
        ),
        ("A house: kitchen that the lounge opens onto, two bedrooms.", {("lounge", "kitchen")}),
        ("A villa with a pantry which the kitchen leads to.", {("kitchen", "pantry")}),
        ("A school with a canteen with its kitchen next door.", {("canteen", "kitchen")}),
        ("The kitchen with a scullery at its side is on the lower floor.", {("kitchen", "scullery")}),
        ("An office: archive and server room, the two should touch.", {("archive", "server_room")}),
        ("The archive and the gym adjoin each other.", {("archive", "gym")}),
        (
            "A school: recital room with a stage, the instrument store next door to it, a foyer.",
            {("instrument_store", "recital_room")},
        ),
        (
            "A house: snug at the front, kitchen at the back, and the dining room between the two.",
            {("dining_room", "snug"), ("dining_room", "kitchen")},
        ),
        (
            "A laboratory: a microbiology lab of 50 m2 entered through an airlock, a weighing room.",
            {("microbiology_lab", "airlock")},
        ),
        ("A villa. The study is on the second floor right next to the archive.", {("study", "archive")}),
        ("A department with 5 offices. The mayor's office beside its secretariat.", {("mayor_office", "secretariat")}),
        (
            "A clinic with 5 treatment rooms. The store has to be beside of one treatment room.",
            {("store", "treatment_room")},
        ),
        ("A clinic. The nurse station should share one wall with a lab.", {("nurse_station", "lab")}),
    ],
)
def test_rooms_side_by_side(brief: str, pairs: set[tuple[str, str]]) -> None:
    assert {(fact.first_name, fact.second_name) for fact in read(brief).adjacent} == pairs


@pytest.mark.parametrize(
    ("brief", "pairs"),
    [
        (
            "A hall, a vault. Nobody may walk from the hall into the vault, so these two don't touch.",
            {("hall", "vault")},
        ),
        (
            "A chapel. The archive and the cold store have no common wall with the chapel.",
            {("archive", "chapel"), ("cold_store", "chapel")},
        ),
        (
            "A radio station: three studios, a plant room. None of the studios should be adjacent to the plant room.",
            {("studio", "plant_room")},
        ),
        ("A sauna, a library. The sauna should lie well clear of the library.", {("sauna", "library")}),
    ],
)
def test_rooms_apart(brief: str, pairs: set[tuple[str, str]]) -> None:
    facts = read(brief)
    assert {(fact.first_name, fact.second_name) for fact in facts.apart} == pairs
    assert facts.adjacent == []


@pytest.mark.parametrize(
    ("brief", "unwanted"),
    [
        ("A spa. Nothing like a bar or a restaurant.", ["bar", "restaurant"]),
        ("A kindergarten, nothing dangerous like a workshop", ["workshop"]),
        ("A hotel with a spa, nothing in the way of a gym", ["gym"]),
        ("A hotel. Leave the bar out.", ["bar"]),
        ("A hotel. We don't want any gym or sauna.", ["gym", "sauna"]),
    ],
)
def test_what_a_brief_rules_out_is_unwanted(brief: str, unwanted: list[str]) -> None:
    facts = read(brief)
    assert [room for room, _ in facts.excluded] == unwanted
    assert not {room.room_type for room in facts.rooms} & set(unwanted)


@pytest.mark.parametrize(
    "text", ["Stairs suffice, leave the elevator out.", "The stairs are enough.", "Stairs will do."]
)
def test_where_stairs_suffice_no_lift_is_wanted(text: str) -> None:
    assert "no_elevator" in [core for core, _ in read(f"An office of three floors. {text}").vertical]


def test_the_same_besides_means_in_addition_after_a_comma() -> None:
    assert read("Two lounges, besides a pantry and a gym.").adjacent == []


def test_a_count_of_five_with_one_of_them_stays_five() -> None:
    rooms = read("A clinic with 5 treatment rooms. The store is beside one treatment room.").rooms
    assert [(room.name, room.count) for room in rooms] == [("treatment_room", 5), ("store", 1)]


def test_people_and_compounds_are_no_buildings() -> None:
    facts = read("A lodging for wind farm technicians with 12 cabins")
    assert facts.building == []
    assert [(room.name, room.room_type, room.count) for room in facts.rooms] == [("cabin", "bedroom", 12)]


def test_those_who_leave_a_home_are_no_rooms() -> None:
    assert [room.name for room in read("A refuge for families leaving violent homes, with a playroom").rooms] == [
        "playroom"
    ]


def _pairs(brief: str) -> set[tuple[str, str]]:
    return {(fact.first_name, fact.second_name) for fact in read_brief(brief, default_knowledge()).adjacent}


@pytest.mark.parametrize(
    ("brief", "first", "others"),
    [
        ("A restaurant; from the kitchen one enters also in the cold room and in the pantry.",
         "kitchen", {"cold_room", "pantry"}),
        ("A flat. In the middle is a corridor and from it go all the rooms away: kitchen, bath and a study.",
         "corridor", {"kitchen", "bath", "study"}),
        ("A villa with a hall from which open a kitchen, a bath and a study.", "hall", {"kitchen", "bath", "study"}),
        ("A clinic: from the lab you reach the sluice room.", "lab", {"sluice_room"}),
        ("A club with a main hall and a kitchen with a serving hatch to the main hall.", "kitchen", {"main_hall"}),
    ],
)  # fmt: skip
def test_rooms_that_are_entered_from_another_lie_beside_it(brief: str, first: str, others: set[str]) -> None:
    assert _pairs(brief) == {(first, other) for other in others}


@pytest.mark.parametrize(
    "brief",
    [
        "A clinic: from the lab one cannot reach the office.",
        "A villa; from the kitchen you look at the lake, and there is a study.",
        "A hotel where guests come from the station and enter a lobby and a bar.",
    ],
)
def test_rooms_that_are_only_spoken_of_with_from_are_no_neighbours(brief: str) -> None:
    assert not _pairs(brief)
