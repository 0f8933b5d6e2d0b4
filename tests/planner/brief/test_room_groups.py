"""Desks that are counted as places to work are one area, and brackets name the rooms before them."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def test_hot_desks_are_furniture_of_one_area_on_each_storey() -> None:
    brief = (
        "A coworking with a cafe on the ground floor, 2 upper floors with 30 hot desks each and 4 private offices each"
    )
    facts = read_brief(brief, default_knowledge())
    rooms = {fact.name: (fact.count, fact.each, [ref.kind for ref in fact.floors]) for fact in facts.rooms}
    assert rooms["hot_desk_area"] == (1, True, ["upper"])
    assert rooms["private_office"] == (4, True, ["upper"])
    assert [(o.category, o.count, o.room, o.each) for o in facts.objects] == [("desk", 30, "hot_desk_area", True)]


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


def test_brackets_name_as_many_rooms_as_are_counted() -> None:
    facts = read("An escape room centre with 3 game rooms (tomb, submarine, haunted attic), each with a control booth.")
    named = {fact.name: [child.name for child in fact.suite] for fact in facts.rooms}
    assert named == {name: ["control_booth"] for name in ("tomb", "submarine", "haunted_attic")}
    assert {fact.room_type for fact in facts.rooms} == {"game_room"}


def test_brackets_with_another_number_of_names_name_no_rooms() -> None:
    facts = read("A centre with 5 game rooms (tomb, submarine) and a lobby")
    assert {fact.name: fact.count for fact in facts.rooms}["game_room"] == 5


def test_a_desk_beside_a_room_is_a_place_of_its_own() -> None:
    facts = read("A police station with six holding cells and the custody desk next to the cells")
    assert [(a.first_name, a.second_name) for a in facts.adjacent] == [("custody_desk", "holding_cell")]
    assert not facts.objects


def test_a_plain_desk_beside_a_room_stays_furniture() -> None:
    facts = read("An office with a desk next to the kitchen")
    assert [fact.category for fact in facts.objects] == ["desk"]
