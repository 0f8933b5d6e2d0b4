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
