"""Storeys that a brief implies."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def kinds(brief: str) -> dict[str, list[str]]:
    """Return the kinds of the storeys of each room by its type."""
    facts = read_brief(brief, default_knowledge())
    return {room.room_type: [f"{ref.kind}{ref.first or ''}" for ref in room.floors] for room in facts.rooms}


def test_a_low_tower_has_the_storeys_that_are_named() -> None:
    brief = "Tower with a dome room on the 3rd floor, control room on the 2nd floor, exhibition on the ground floor."
    facts = read_brief(brief, default_knowledge())
    assert [quantity.value for quantity in facts.floors] == [3.0]


def test_rooms_are_below_what_is_upstairs() -> None:
    storeys = kinds("Veterinary clinic. Reception, pharmacy, laboratory, waiting room. Upstairs: a staff room.")
    assert storeys["reception"] == storeys["laboratory"] == ["number1"]
    assert storeys["break_room"] == ["upper"]


def test_the_rooms_of_a_home_are_left_to_the_planner() -> None:
    storeys = kinds("A house with three bedrooms, a kitchen, a living room. Upstairs: a study.")
    assert storeys["bedroom"] == []


def test_a_business_under_a_flat_is_on_the_ground_floor() -> None:
    storeys = kinds(
        "Bookbinder's: workshop, paper store, small shop, wc. Above the shop: her apartment, bedroom, bath."
    )
    assert storeys["workshop"] == storeys["toilet"] == ["number1"]


def test_only_the_last_of_a_list_is_upstairs_behind_a_bare_comma() -> None:
    storeys = kinds("Baths. A pool and a cafe, changing rooms, a laundry, a sauna upstairs.")
    assert storeys["sauna"] == ["upper"]
    assert storeys["indoor_pool"] != ["upper"]


def test_above_leads_a_list_of_numbers() -> None:
    assert kinds("House of two storeys. Kitchen, living room; above 3 bed 1 bath.")["bedroom"] == ["upper"]
