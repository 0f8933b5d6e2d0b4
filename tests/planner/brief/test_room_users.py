"""Rooms of a kind that differ in who uses them are rooms of their own."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


def rooms(brief: str) -> list[tuple[str, str, int | None]]:
    return [(fact.name, fact.room_type, fact.count) for fact in read_brief(brief, default_knowledge()).rooms]


TWO = [("man_toilet", "toilet", 1), ("woman_toilet", "toilet", 1)]


@pytest.mark.parametrize(
    "toilets",
    [
        "toilets for men and women",
        "toilets (men and women)",
        "toilets: men, women",
        "toilets men/women",
        "toilets, male and female",
        "toilets masculine and feminine",
        "two toilets, one for men and one for women",
        "two toilets (one for men, another for women)",
    ],
)
def test_men_and_women_have_toilets_of_their_own(toilets: str) -> None:
    assert rooms(f"An office with {toilets}.") == TWO
    assert not read_brief(f"An office with {toilets}.", default_knowledge()).unread


@pytest.mark.parametrize("people", ["disabled", "disabled people", "handicapped", "wheelchair users"])
def test_a_toilet_for_the_disabled_is_an_accessible_one(people: str) -> None:
    accessible = ("accessible_toilet", "accessible_toilet", 1)
    assert rooms(f"An office with toilets for men, women and {people}.") == [*TWO, accessible]
    assert rooms(f"An office with one toilet for {people}.") == [accessible]


def test_what_follows_the_users_is_not_lost() -> None:
    found = rooms("A gym with changing rooms, male and female, an office.")
    assert [name for name, _, _ in found] == ["man_changing_room", "woman_changing_room", "office"]


def test_users_before_another_room_are_of_that_room() -> None:
    found = rooms("A gym with two changing rooms, men and women saunas.")
    assert [(kind, count) for _, kind, count in found] == [("changing_room", 2), ("sauna", 1), ("sauna", 1)]


def test_more_rooms_than_users_stay_together() -> None:
    assert rooms("An office with four toilets for men and women.") == [("toilet", "toilet", 4)]


def test_a_relation_of_all_of_them_is_told_of_each() -> None:
    facts = read_brief(
        "A restaurant with a kitchen and toilets for ladies and gents. Toilets away from the kitchen, please.",
        default_knowledge(),
    )
    pairs = {(fact.first_name, fact.second_name) for fact in facts.apart}
    assert pairs == {("lady_toilet", "kitchen"), ("gentleman_toilet", "kitchen")}


@pytest.mark.parametrize(
    ("brief", "names"),
    [
        ("A clinic. Dogs and cats recover in wards of their own.", ["dog_ward", "cat_ward"]),
        ("A clubhouse; boys and girls get changing rooms of their own.", ["boy_changing_room", "girl_changing_room"]),
        ("A hotel. The cooks and the waiters have lounges of their own.", ["cook_lounge", "waiter_lounge"]),
        ("A school with toilets for girls and toilets for boys.", ["girl_toilet", "boy_toilet"]),
        (
            "A gym with changing rooms for women and changing rooms for men.",
            ["woman_changing_room", "man_changing_room"],
        ),
    ],
)
def test_two_that_have_rooms_of_their_own_have_one_each(brief: str, names: list[str]) -> None:
    assert [(name, count) for name, _, count in rooms(brief)] == [(name, 1) for name in names]


def test_the_wards_of_animals_are_kennels() -> None:
    assert {kind for _, kind, _ in rooms("A clinic. Dogs and cats recover in wards of their own.")} == {"kennel"}


@pytest.mark.parametrize(
    "brief",
    [
        "A hostel with bedrooms for women and bedrooms for men.",
        "A hotel where the guests have bathrooms of their own.",
        "A house. We and the children have bedrooms of our own.",
    ],
)
def test_rooms_of_many_are_not_one_for_each_kind_of_user(brief: str) -> None:
    assert all(count != 1 for _, _, count in rooms(brief))


def test_furniture_of_a_room_ends_before_what_is_added_to_the_building() -> None:
    brief = "A school with four classrooms, each fitted with 16 desks and a board, plus toilets for girls and boys."
    assert {"girl_toilet", "boy_toilet"} <= {name for name, _, _ in rooms(brief)}


@pytest.mark.parametrize(
    ("brief", "labels"),
    [
        ("A restaurant with toilets for men and women.", {"men's toilet", "women's toilet"}),
        ("A school with boys' and girls' toilets.", {"boys' toilet", "girls' toilet"}),
    ],
)
def test_a_room_is_called_after_all_who_use_it(brief: str, labels: set[str]) -> None:
    assert {room.label for room in read_brief(brief, default_knowledge()).rooms} == labels
