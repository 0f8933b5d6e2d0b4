"""Rooms that are large or small in words have an area that says so."""

import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wishes import Wish
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building


def _wishes(text: str) -> list[Wish]:
    plan = plan_building(BuildRequest(description=text))
    return list(receipt_of_plan(plan.program, plan.topologies))


def _room(text: str, name: str) -> Wish:
    return next(wish for wish in _wishes(text) if wish.kind == "room" and wish.value.type == name)


@pytest.mark.parametrize(
    ("text", "name", "limit"),
    [
        ("a house with a large kitchen", "kitchen", "least"),
        ("a house with a spacious living room", "living_room", "least"),
        ("a house with a tiny bathroom", "bathroom", "most"),
        ("a house whose kitchen should be very large", "kitchen", "least"),
        ("a house. The kitchen is to be large", "kitchen", "least"),
        ("a clinic with a pantry (small)", "pantry", "most"),
        ("a clinic with three generous consultation rooms", "consultation_room", "least"),
        ("a co-working floor with 3 small offices", "private_office", "most"),
    ],
)
def test_a_size_bounds_the_area_by_the_usual_one_of_the_kind(text: str, name: str, limit: str) -> None:
    wish, usual = _room(text, name), default_knowledge().room(name).usual
    assert (wish.status, wish.value.limit) == ("met", limit)
    assert wish.value.area is not None
    assert (wish.value.area > usual) == (limit == "least")


def test_a_size_that_finds_no_place_is_met_in_part() -> None:
    wish = _room("a flat of 45 m2 with a huge living room and three bedrooms", "living_room")
    assert wish.status == "partly"
    assert "instead of at least" in wish.reason


def test_an_area_in_numbers_holds_before_a_size_in_words() -> None:
    assert _room("a house with a large kitchen of 11 m2", "kitchen").value.area == 11.0


@pytest.mark.parametrize("text", ["a German flat", "a flat with a huge bed", "a house with a not too big kitchen"])
def test_a_size_of_which_nothing_is_made_is_told(text: str) -> None:
    assert any(wish.value.unheeded for wish in _wishes(text))


@pytest.mark.parametrize(
    "text", ["a small clinic of 200 m2", "a house with an Italian style", "a flat with a Finnish sauna"]
)
def test_words_that_something_else_answers_are_heeded(text: str) -> None:
    assert not any(wish.value.unheeded for wish in _wishes(text))


def test_a_size_without_a_room_is_told() -> None:
    unread = [wish.text for wish in _wishes("A house. The bedroom very small.") if wish.kind == "unread"]
    assert any("small" in text for text in unread)


@pytest.mark.parametrize(
    ("text", "whole", "each"),
    [
        ("office; storeys: 4; gross area: 2,200 m2", 2200, None),
        ("office; GFA: 2,200 m2; 4 storeys", 2200, None),
        ("An apartment of Paris with 62 m2, on one level", 62, None),
        ("A house in Berlin of 120 m2", 120, None),
        ("A faculty with four floors and a basement, 3600 m2 without the basement", 3600, None),
        ("A mall with 3 floors, total construction area is about 6,000 m2", 6000, None),
        ("A house, built area: 180 m2, two floors", 180, None),
        ("Office building. Gross floor area: 2,200 m2. Storeys: 4.", 2200, None),
        ("An office with 900 m2 GFA on 3 floors", 900, None),
        ("An office, 3 storeys, 300 m2 gross floor area each", None, 300),
        ("A clinic, GFA 350 m2 per floor, two floors", None, 350),
    ],
)
def test_gross_area_is_the_buildings_and_no_room(text: str, whole: float | None, each: float | None) -> None:
    facts = read_brief(text, default_knowledge())
    assert [fact.value for fact in facts.area] == ([whole] if whole else [])
    assert [fact.value for fact in facts.floor_area] == ([each] if each else [])
    assert facts.rooms == []
    assert not any(span.words.lower() in ("gfa", "area", "gross") for span in facts.unread)


def test_the_town_of_a_building_is_no_room() -> None:
    assert not read_brief("A school near Milan with 800 m2, two floors.", default_knowledge()).rooms


def test_an_area_without_the_basement_leaves_the_basement_wanted() -> None:
    text = "A faculty with four floors and a basement, 3600 m2 without the basement."
    facts = read_brief(text, default_knowledge())
    assert not facts.excluded
    assert [quantity.value for quantity in facts.basements] == [1]
