"""What is said of all rooms of a kind: their storey, what each has, and how many of a thing there are at most."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "storeys"),
    [
        ("A school with six classrooms, all on the ground floor. A library upstairs.", []),
        ("A two-storey house with six bedrooms, all on the ground floor, and a library", [2]),
        ("A house with a kitchen and three bedrooms, all on the ground floor", [1]),
        ("A two-storey clinic. Six consulting rooms on the ground floor, and none upstairs.", [2]),
    ],
)
def test_all_on_the_ground_floor_is_one_storey_where_nothing_is_said_of_others(text: str, storeys: list[int]) -> None:
    assert [quantity.value for quantity in _facts(text).floors] == storeys


@pytest.mark.parametrize(
    "text",
    [
        "A two-storey house with three bedrooms, all of them upstairs",
        "A two-storey house. All bedrooms are upstairs, three of them, each with its own bathroom.",
    ],
)
def test_all_of_them_upstairs_places_the_rooms(text: str) -> None:
    (bedroom,) = (fact for fact in _facts(text).rooms if fact.name == "bedroom")
    assert (bedroom.count, [ref.kind for ref in bedroom.floors]) == (3, ["upper"])


@pytest.mark.parametrize(
    ("text", "own"),
    [
        ("A house. All bedrooms are upstairs, four of them, each with its own bathroom.", "bathroom"),
        ("A hotel with eight double rooms, each room with a double bed, a desk and a balcony", "balcony"),
        ("A hotel with eight double rooms, each with a double bed, a desk and a balcony", "balcony"),
    ],
)
def test_each_room_has_what_ends_the_list_of_its_furniture(text: str, own: str) -> None:
    assert own in {child.name for fact in _facts(text).rooms for child in fact.suite}


@pytest.mark.parametrize(
    "text",
    [
        "A house with our bedroom, a second bedroom for guests and a bathroom",
        "A house with a bedroom for her, and our own bedroom at the other end",
    ],
)
def test_a_second_bedroom_is_another_one(text: str) -> None:
    facts = _facts(text)
    assert sum(fact.count or 0 for fact in facts.rooms if fact.name == "bedroom") == 2


def test_only_one_sofa_in_the_whole_flat_is_no_further_flat() -> None:
    facts = _facts("A flat with two bedrooms. Only one sofa in the whole flat.")
    assert [fact.name for fact in facts.rooms] == ["bedroom"]
    assert [(thing.count, thing.most) for thing in facts.objects] == [(1, True)]


def test_a_place_without_windows_in_the_basement_lies_there_and_leaves_the_basement() -> None:
    facts = _facts("A clinic with a server room without windows in the basement")
    assert not facts.excluded
    assert [ref.kind for fact in facts.rooms for ref in fact.floors] == ["basement"]


def test_seats_are_read_behind_a_storey() -> None:
    (seats,) = _facts("An office with an open plan office upstairs for 15 people").objects
    assert (seats.count, seats.category, seats.room) == (15, "chair", "open_plan_office")


@pytest.mark.parametrize(
    "text",
    ["A house: three floors above ground of 300 m2 each", "An office with four floors above ground, each 300 m2"],
)
def test_each_storey_above_ground_has_the_area(text: str) -> None:
    assert [quantity.value for quantity in _facts(text).floor_area] == [300]


def test_please_design_asks_for_what_follows() -> None:
    assert [name for name, _ in _facts("Please design office of 3 floors for 24 employees.").building] == ["office"]


def test_what_a_list_counts_behind_a_relation_stands_anywhere() -> None:
    (racks,) = _facts("A warehouse with two docks, a cold store next to the docks, 20 pallet racks, one office").objects
    assert (racks.count, racks.room) == (20, "")
