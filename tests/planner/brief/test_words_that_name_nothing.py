"""Nouns that name neither a room nor furniture where they stand."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    "brief",
    [
        "A house with a kitchen. No garage, they sold the car.",
        "An office with a kitchen, see table.",
        "A fire station with a kitchen. They slide down a pole.",
    ],
)
def test_an_aside_asks_for_no_furniture(brief: str) -> None:
    facts = read(brief)
    assert facts.objects == []
    assert [room.name for room in facts.rooms] == ["kitchen"]


def test_a_display_is_a_thing_and_on_display_is_not() -> None:
    assert [fact.category for fact in read("A shop with ten sofas on display.").objects] == ["sofa"]
    assert len(read("A shop with a sofa and a display.").objects) == 2


def test_book_stacks_that_are_counted_are_shelves() -> None:
    facts = read("A library with 30 book stacks.")
    assert [(fact.category, fact.count) for fact in facts.objects] == [("bookshelf", 30)]


def test_room_for_people_is_a_number_of_seats() -> None:
    facts = read("A school. A canteen with room for 150.")
    assert [room.name for room in facts.rooms] == ["canteen"]
    assert [(fact.noun, fact.count, fact.room) for fact in facts.objects] == [("seats", 150, "canteen")]


@pytest.mark.parametrize(
    "brief",
    [
        "A start-up. Nobody gets a private office.",
        "A start-up. We don't want any private offices.",
        "A start-up with a cafe. They do not want any private office.",
    ],
)
def test_what_nobody_gets_is_not_wanted(brief: str) -> None:
    facts = read(brief)
    assert [name for name, _ in facts.excluded] == ["private_office"]
    assert "private_office" not in [room.name for room in facts.rooms]


@pytest.mark.parametrize("brief", ["An office of two floors.", "An office of about 200 m2 with a cafe."])
def test_an_office_of_a_size_is_the_building(brief: str) -> None:
    assert [name for name, _ in read(brief).building] == ["office"]


def test_the_office_of_somebody_is_a_room() -> None:
    assert [room.name for room in read("A school with the office of the director.").rooms] == ["director_office"]


def test_a_relative_clause_may_stand_before_an_area() -> None:
    rooms = {room.name: room.area for room in read("A house. The kitchen where we all eat, about 25 m2.").rooms}
    assert rooms == {"kitchen": 25.0}


@pytest.mark.parametrize(
    ("brief", "rooms"),
    [
        ("A house with a kitchen with an island and four bar stools.", ["kitchen"]),
        ("A bed and breakfast. We, the owners, live downstairs in a bedroom.", ["bedroom"]),
        ("An apartment of Paris with 62 m2. It has a salon.", ["salon"]),
        ("A dental practice for three dentists. It needs a waiting room.", ["waiting_room"]),
        (
            "A house with an archive. The office is on the second floor right next to the archive.",
            ["archive", "office"],
        ),
        (
            "A restaurant with one office and two bathrooms, feminine and masculine.",
            ["office", "woman_bathroom", "man_bathroom"],
        ),
        ("A centre with a tools and pots shop and a bistro.", ["tool_and_pot_shop", "bistro"]),
    ],
)
def test_a_word_that_names_no_room_is_none(brief: str, rooms: list[str]) -> None:
    assert [room.name for room in read(brief).rooms] == rooms


@pytest.mark.parametrize(
    ("brief", "rooms"),
    [
        ("A library with a scriptorium and a kitchen.", ["scriptorium", "kitchen"]),
        ("A mall with a lobby, three hairdressers and two dentists.", ["lobby", "hairdresser", "dentist"]),
    ],
)
def test_a_word_that_names_a_room_stays_one(brief: str, rooms: list[str]) -> None:
    assert [room.name for room in read(brief).rooms] == rooms


@pytest.mark.parametrize(
    "brief",
    ["Map for a stealth game: a house with a kitchen.", "A house with a kitchen. One lift big enough for crates."],
)
def test_a_thing_in_passing_is_not_asked_for(brief: str) -> None:
    facts = read(brief)
    assert facts.objects == []
    assert [room.name for room in facts.rooms] == ["kitchen"]


def test_a_map_in_a_room_is_asked_for() -> None:
    facts = read("Map for a stealth game: a house with a study with a map.")
    assert [(thing.category, thing.room) for thing in facts.objects] == [("world_map", "study")]


def test_a_box_for_shoes_is_no_pair_of_boots() -> None:
    assert [thing.category for thing in read("A house. Please put a shoes box at the entrance.").objects] == [
        "shoe_rack"
    ]


def test_a_reserve_of_artworks_is_a_store() -> None:
    facts = read("A museum with the reserve of artworks, a workshop next to the reserve and three offices.")
    assert facts.objects == []
    assert (facts.rooms[0].name, facts.rooms[0].room_type) == ("artwork_reserve", "storage")
    assert [(fact.first_name, fact.second_name) for fact in facts.adjacent] == [("workshop", "artwork_reserve")]


def test_the_bar_of_a_taproom_is_its_counter() -> None:
    facts = read("A brewery with a cold store and the taproom with its long bar.")
    assert [room.name for room in facts.rooms] == ["cold_store", "taproom"]
    assert [(thing.category, thing.room) for thing in facts.objects] == [("bar_counter", "taproom")]
