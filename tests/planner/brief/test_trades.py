"""What the writer of a brief makes or sells is no part of the building, and tells what it is for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("brief", "kind", "goods"),
    [
        ("I make fitted kitchens for a living and need a showroom and a timber store.", "factory", "kitchen"),
        ("We repair and sell bicycles. Downstairs a sales floor, upstairs two bedrooms.", "shop_building", "bicycle"),
        ("We build saunas and need an assembly room of 90 m2 and an office.", "factory", "sauna"),
        ("For a couple who sell old books: a sales floor and a bedroom.", "shop_building", "book"),
    ],
)
def test_a_trade_tells_the_kind_of_building(brief: str, kind: str, goods: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [name for name, _ in facts.trades] == [kind]
    assert goods not in {fact.room_type for fact in facts.rooms} | {fact.category for fact in facts.objects}
    assert plan_building(BuildRequest(description=brief)).program.building_type == kind


@pytest.mark.parametrize(
    "brief",
    [
        "We make two kitchens and a dining room on the ground floor of a house.",
        "I want to build kitchens and a bathroom for a house.",
        "We sell our villa and want a bungalow with two bedrooms.",
        "A house that we build with two kitchens and a workshop.",
    ],
)
def test_what_is_to_be_built_is_no_trade(brief: str) -> None:
    assert not read_brief(brief, default_knowledge()).trades


def test_a_named_building_keeps_its_kind_whatever_the_trade() -> None:
    brief = "We renovate bathrooms and make cabinets; we need a warehouse with an office."
    facts = read_brief(brief, default_knowledge())
    assert facts.building[0][0] == "warehouse_building"
    assert {fact.room_type for fact in facts.rooms} == {"private_office"}
    assert "for a living" not in {span.words for span in facts.unread}


def test_for_a_living_is_no_living_room() -> None:
    facts = read_brief("I stream for a living and need a house with a streaming room.", default_knowledge())
    assert {fact.name for fact in facts.rooms} == {"streaming_room"}
