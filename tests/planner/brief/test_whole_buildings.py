"""Nouns of the whole building, and of what is flat, are no rooms of it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize(
    "brief",
    [
        "A café in a building of 170 m².",
        "A café with a kitchen, all in an L-shaped building of 170 m2.",
        "A clinic with a lab in a two-storey building with 170 m2.",
        "A bakery and its shop in a new property of 170 m2.",
    ],
)
def test_the_area_of_a_bare_building_is_that_of_all(brief: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [area.value for area in facts.area] == [170]
    assert not any(fact.area for fact in facts.rooms)
    assert "building" not in {span.words for span in facts.unread}


def test_a_building_for_one_room_is_told() -> None:
    facts = read_brief("A farm with a stable of 90 m2 and a sauna building of 20 m2.", default_knowledge())
    assert "building" in {span.words for span in facts.unread}


@pytest.mark.parametrize("flat", ["flat simple rectangular plan", "flat roof", "flat, wide site", "flat plot"])
def test_what_is_flat_is_no_flat(flat: str) -> None:
    facts = read_brief(f"A sports club with a hall on two storeys, with a {flat}.", default_knowledge())
    assert "apartment" not in {fact.room_type for fact in facts.rooms}


@pytest.mark.parametrize(
    "flat", ["flat above it; the plan is simple", "flat with a roof terrace", "flat for a caretaker"]
)
def test_a_flat_is_one_whatever_follows(flat: str) -> None:
    facts = read_brief(f"A sports club with a hall and a {flat}.", default_knowledge())
    assert "apartment" in {fact.room_type for fact in facts.rooms}


@pytest.mark.parametrize(
    "said", ["has a surface of 95 m²", "occupies 95 m2", "with a surface of 95 m2", "occupying 95 m2"]
)
def test_a_room_may_have_a_surface(said: str) -> None:
    facts = read_brief(f"A restaurant of 210 m2. The dining hall {said} and a bar.", default_knowledge())
    assert {fact.name: fact.area for fact in facts.rooms}["dining_hall"] == 95
    assert [area.value for area in facts.area] == [210]


@pytest.mark.parametrize("brief", ["A house, surface 150 m2 in total.", "A house with the surface 150 m2."])
def test_a_surface_of_the_building_is_its_area(brief: str) -> None:
    assert [area.value for area in read_brief(brief, default_knowledge()).area] == [150]
