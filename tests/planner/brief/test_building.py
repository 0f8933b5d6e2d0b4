"""What the brief calls the building."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize("kind", ["bakery", "theatre", "farm shop", "hostel"])
def test_building_after_a_kind_of_building_says_nothing_more(kind: str) -> None:
    facts = read(f"A {kind} building of 300 m2.")
    assert facts.building and not facts.unread


@pytest.mark.parametrize(("brief", "like"), [("A canteen building with a kitchen.", "restaurant_building"),
                                             ("An agency building with a print room.", "office")])  # fmt: skip
def test_an_unknown_kind_is_like_its_last_noun_but_building(brief: str, like: str) -> None:
    assert read(brief).building_like == like


@pytest.mark.parametrize("name", ["Ramen bar", "Tapas bar", "Wine bar"])
def test_a_bar_that_opens_the_brief_is_the_building(name: str) -> None:
    facts = read(f"{name}, 85 m2 on one floor, with an open kitchen and two toilets.")
    assert facts.building[0][0] == "bar_building"
    assert [fact.room_type for fact in facts.rooms] == ["open_kitchen", "toilet"]


def test_a_bar_of_a_hotel_is_a_room() -> None:
    facts = read("A hotel with a sushi bar on the top floor")
    assert (facts.building[0][0], [fact.room_type for fact in facts.rooms]) == ("hotel", ["bar"])


@pytest.mark.parametrize("words", ["1970s motel", "motel in seventies style", "60s motel"])
def test_a_decade_is_a_style(words: str) -> None:
    assert [name for name, _ in read(f"A {words} with ten rooms").styles] == ["retro"]


@pytest.mark.parametrize("words", ["from the 1960s", "of the fifties"])
def test_when_something_was_built_is_no_style(words: str) -> None:
    assert read(f"A school beside an old hall {words}, with a gym").styles == []


@pytest.mark.parametrize(
    ("brief", "building"),
    [
        ("We want to evaluate a caring robot in a care home. It has three floors.", "nursing_home"),
        ("Our robot must serve coffee to guests in an arabic villa, two floors, with four bedrooms.", "villa"),
        ("To test a courier in a hotel of four storeys with twenty guest rooms.", "hotel"),
    ],
)
def test_where_something_is_to_be_done_is_the_building(brief: str, building: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [name for name, _ in facts.building] == [building]


@pytest.mark.parametrize(
    ("brief", "building"),
    [
        ("We live in a flat in town and want a house with four bedrooms.", "house"),
        ("To train nurses in an old clinic we need a school with six classrooms.", "school"),
        ("A gym in a hotel with a sauna.", "gym_building"),
    ],
)
def test_where_one_is_already_is_not_the_building(brief: str, building: str) -> None:
    assert read_brief(brief, default_knowledge()).building[0][0] == building


@pytest.mark.parametrize(
    ("brief", "building"),
    [
        ("We live in a townhouse of 3 floors with a laundry room.", "townhouse"),
        ("I live in a villa of two floors with a pool.", "villa"),
        ("Two families live in our house of three storeys.", "house"),
        ("We work in an office with two meeting rooms.", "office"),
    ],
)
def test_where_somebody_lives_or_works_is_the_building_where_no_other_is_named(brief: str, building: str) -> None:
    assert [name for name, _ in read(brief).building] == [building]


def test_where_somebody_lives_is_not_the_building_that_they_want() -> None:
    assert [name for name, _ in read("We live in a flat. We want a house with three bedrooms.").building] == ["house"]


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("We are a small theatre company. Please plan a theatre of 800 m2 with a foyer.", "theater"),
        ("We are a bank. We need an office building with 3 floors and a canteen.", "office"),
        ("We are a volunteer fire brigade. Please plan a two-storey fire station of 960 m2.", "fire_station"),
        ("We are a hotel. We need a restaurant with a kitchen.", "restaurant_building"),
        ("Our library is too small. Draw a new library of 900 m2.", "library_building"),
    ],
)
def test_who_asks_for_a_building_is_not_another_one_and_no_room(brief: str, kind: str) -> None:
    facts = read(brief)
    assert facts.building[0][0] == kind
    assert {room.room_type for room in facts.rooms} <= {"lobby", "cafeteria", "kitchen"}


def test_who_writes_is_the_building_where_no_other_is_asked_for() -> None:
    assert read("We are a hotel. Two storeys, with a restaurant.").building[0][0] == "hotel"
