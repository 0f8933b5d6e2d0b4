"""Garages that are the whole building, and rooms for the groups of a kindergarten."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize("words", ["for four cars", "with 20 parking spaces", "for 12 vehicles", "for six vans"])
def test_a_garage_for_cars_is_a_car_park(words: str) -> None:
    assert read(f"A garage {words}.").building[0][0] == "parking_garage"


@pytest.mark.parametrize("words", ["for repairing cars", "for car repair", "of a mechanic", "where cars are repaired"])
def test_a_garage_where_cars_are_repaired_is_a_workshop(words: str) -> None:
    assert read(f"Garage {words}, 500 m2").building[0][0] == "car_workshop_building"


def test_its_lifts_are_for_cars() -> None:
    facts = read("Garage for repairing cars, six lifts, 500 m2")
    assert [(wanted.category, wanted.count) for wanted in facts.objects] == [("car_lift", 6)]


def test_a_garage_of_a_house_is_a_room() -> None:
    facts = read("A house with a garage for two cars")
    assert facts.building[0][0] == "house"


@pytest.mark.parametrize("words", ["for 4 groups", "with four groups", "of 4 groups", "for 4 groups of children"])
@pytest.mark.parametrize("house", ["kindergarten", "nursery"])
def test_each_group_has_its_room(words: str, house: str) -> None:
    facts = read(f"A {house} {words}, one storey.")
    assert [(fact.room_type, fact.count) for fact in facts.rooms] == [("kindergarten_classroom", 4)]


def test_the_room_of_each_group_has_its_area() -> None:
    facts = read("A kindergarten for 4 groups. Each group has a room of 55 m2.")
    assert [(fact.count, fact.area) for fact in facts.rooms] == [(4, 55.0)]


def test_a_group_spends_its_day_in_its_playroom() -> None:
    facts = read("A nursery with three groups. Each group has a playroom of 45 m2, a nap room and its own washroom.")
    (group,) = facts.rooms
    assert (group.name, group.count, group.area) == ("playroom", 3, 45.0)
    assert [room.name for room in group.suite] == ["nap_room", "washroom"]
