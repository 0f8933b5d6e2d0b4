"""Rooms that are told one by one after their number, or by kinds after a colon, are listed."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "2 bedrooms - master 17 m2, guest 12 m2",
        "two bedrooms: master 17 m2 and guest 12 m2",
        "two bedrooms (master 17 m2, guest 12 m2)",
    ],
)
def test_labels_with_areas_are_rooms(words: str) -> None:
    facts = read(f"A bungalow of 130 m2 with a kitchen. It has {words}. Living room 30 m2.")
    assert [(room.name, room.count, room.area) for room in facts.rooms] == [
        ("kitchen", 1, None), ("master_bedroom", 1, 17.0), ("guest_bedroom", 1, 12.0), ("living_room", 1, 30.0),
    ]  # fmt: skip
    assert facts.unread == []


def test_fewer_labels_than_rooms_are_no_list() -> None:
    facts = read("A bungalow of 130 m2. Three bedrooms: master 17 m2.")
    assert ("bedroom", 3) in [(room.name, room.count) for room in facts.rooms]


def test_a_later_mention_in_a_storey_tells_the_area() -> None:
    facts = read("A house with a sauna, two floors, 150 m2. Ground floor: living room 30 m2; sauna 8 m2.")
    assert [(room.name, room.area) for room in facts.rooms] == [("sauna", 8.0), ("living_room", 30.0)]


@pytest.mark.parametrize(
    "text",
    [
        "A bungalow, everything on one level, no steps!",
        "A two-storey house, 150 m2 over all, stairs only.",
        "Supermarket, one level. Flat, no stairs!",
        "Headquarters for a maritime consultancy: four floors.",
        "The study must not be next to the living room, I need quiet. A villa.",
    ],
)
def test_words_that_say_no_more_are_not_left_over(text: str) -> None:
    facts = read(text)
    assert facts.unread == []
    assert "flat" not in [room.name for room in facts.rooms]


def test_a_wing_is_of_the_kind_of_its_building() -> None:
    assert read("Secondary school wing, three storeys, 1,900 m2.").building_like == "school"


def test_a_lift_of_each_bay_raises_cars() -> None:
    facts = read("A car workshop of 400 m2, single storey, with 4 bays, each with a lift.")
    assert ([(thing.category, thing.each) for thing in facts.objects], facts.vertical) == ([("car_lift", True)], [])


def test_a_hall_for_many_is_one_to_meet_in() -> None:
    assert read("A community centre with a hall for 120 people.").rooms[0].room_type == "assembly_hall"


@pytest.mark.parametrize(
    "words",
    [
        "3 bedrooms (master 18 m2, other two 12 m2)",
        "3 bedrooms: master 18 m2, the others 12 m2",
        "3 bedrooms - master 18 m2, two others 12 m2",
    ],
)
def test_the_others_have_the_last_area(words: str) -> None:
    rooms = read_brief(f"A house with {words}.", default_knowledge()).rooms
    assert [(fact.name, fact.count, fact.area) for fact in rooms] == [("master_bedroom", 1, 18.0), ("bedroom", 2, 12.0)]


def counts(text: str) -> dict[str, int | None]:
    """Return how many rooms of each name are told."""
    return {fact.name: fact.count for fact in read(text).rooms}


def test_a_colon_shares_out_the_rooms_before_it() -> None:
    facts = read("A club with changing rooms: two for home teams, two for guests, one for referees.")
    assert [(fact.room_type, fact.count) for fact in facts.rooms] == [
        ("changing_room", 2), ("changing_room", 2), ("changing_room", 1)
    ]  # fmt: skip


@pytest.mark.parametrize("joint", ["and one for 4", ", another for 4"])
def test_a_second_one_for_others_is_a_second_room(joint: str) -> None:
    facts = read(f"Office with one meeting room for 8 {joint} and a kitchen.")
    assert [fact.room_type for fact in facts.rooms].count("meeting_room") == 2
