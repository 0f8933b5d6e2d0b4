"""Counts of some of the rooms, of each set of furniture and of each group; relations that every room is to have."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "room", "count"),
    [
        ("A guesthouse with six rooms, three of which have a private bathroom", "ensuite_bathroom", 3),
        ("An office with 8 consulting rooms, two of them with a kitchen", "kitchen", 2),
        ("A kindergarten for 60 children in 3 groups, each with its own toilet", "toilet", 3),
        ("Semi-detached home for sale! 3 beds, 2 baths", "bedroom", 3),
        ("A house. A desk in each bedroom; there are three bedrooms", "bedroom", 3),
    ],
)
def test_rooms_of_some_are_counted_by_those(text: str, room: str, count: int) -> None:
    assert [fact.count for fact in _facts(text).rooms if fact.room_type == room] == [count]


@pytest.mark.parametrize(
    ("text", "category", "count"),
    [
        ("A cafe with 10 tables of four chairs", "chair", 40),
        ("A canteen with six tables, each with 8 chairs", "chair", 48),
        ("A lounge with two sofas and four chairs", "chair", 4),
    ],
)
def test_furniture_of_furniture_is_counted_in_sets(text: str, category: str, count: int) -> None:
    assert [fact.count for fact in _facts(text).objects if fact.category == category] == [count]


def test_rooms_per_storey_say_how_many_storeys_there_are() -> None:
    program = plan_building(BuildRequest(description="A block of 6 flats, two per floor")).program
    assert len(program.floors) == 3


@pytest.mark.parametrize(
    ("text", "noun", "count"),
    [
        ("A fire station with a dormitory for 8", "beds", 8),
        ("A village school with a canteen that seats 60", "seats", 60),
        ("A hotel with a lobby and a restaurant (60 seats)", "seats", 60),
    ],
)
def test_how_many_a_room_is_for_is_how_many_beds_or_seats_it_has(text: str, noun: str, count: int) -> None:
    assert [(fact.noun, fact.count) for fact in _facts(text).objects] == [(noun, count)]


def test_storeys_of_a_use_lie_above_what_they_are_said_to_lie_above() -> None:
    program = plan_building(BuildRequest(description="Three floors of offices above a shop")).program
    assert len(program.floors) == 4
    assert any("shop" in room.name for room in program.floors[0].rooms)
    assert not any("shop" in room.name for floor in program.floors[1:] for room in floor.rooms)


def test_each_of_several_rooms_is_to_lie_beside_the_other() -> None:
    several = _facts("A theatre with a stage, two dressing rooms behind the stage and a foyer").adjacent
    one = _facts("A theatre with a stage and a dressing room behind the stage").adjacent
    assert [fact.each for fact in (*several, *one)] == [True, False]


@pytest.mark.parametrize(
    "text",
    [
        "A house where the bathroom is between the two bedrooms",
        "A practice with three treatment rooms and a sterilisation room between the treatment rooms",
    ],
)
def test_a_room_between_several_of_a_kind_lies_beside_two_of_them(text: str) -> None:
    (fact,) = _facts(text).adjacent
    assert fact.sides == 2


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Two sofas facing each other in the lounge", "facing"),
        ("A house with three bedrooms sharing a bathroom", "sharing"),
        ("An office on three floors; the third floor is like the second floor", "like"),
        ("A prison with 20 cells around a central hall", "around"),
        ("A house. The dining room can be reached only through the kitchen", "reached only"),
        ("A house for a couple, I use a wheelchair", "wheelchair"),
    ],
)
def test_words_of_places_and_ways_are_told(text: str, words: str) -> None:
    assert any(words in span.words for span in _facts(text).unread)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("All bedrooms en suite; four bedrooms", 4),
        ("A house with three bedrooms en suite and a kitchen", 3),
        ("A guest house with 6 double rooms ensuite", 6),
        ("Two of the three bedrooms en suite", 2),
    ],
)
def test_rooms_are_not_named_by_the_bathrooms_that_follow_them(text: str, count: int) -> None:
    program = plan_building(BuildRequest(description=text)).program
    assert [w.value.count for w in program.wishes if w.value.type == "ensuite_bathroom"] == [count]
    assert not [w for w in program.wishes if w.value.type == "kitchen" and w.scope.room]


def test_where_a_lift_goes_is_no_place_of_the_room_before() -> None:
    facts = _facts("An accessible toilet, and a lift to all floors, in a three-storey library")
    assert [room.each for room in facts.rooms] == [False]


def test_a_room_inside_another_is_told() -> None:
    facts = _facts("A house with an attic. A drying room in the attic")
    assert [span.words for span in facts.unread] == ["attic"]


@pytest.mark.parametrize(
    "text", ["An apartment building: 6 flats, 0 per floor.", "A block with 6 flats, 0 on each floor"]
)
def test_none_on_each_storey_tells_no_number_of_storeys(text: str) -> None:
    assert _facts(text).floors == []
