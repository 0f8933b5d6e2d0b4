"""A cellar is a storey, unless it is one of the rooms of another storey."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize(
    ("brief", "name"),
    [
        ("At the ground floor a kitchen, a cellar for the wine and the toilets.", "wine_cellar"),
        ("Ground floor: a shop, a cellar for cheese, a cold room.", "cheese_cellar"),
        ("A house. On the first floor there is a kitchen and a cellar of wine.", "wine_cellar"),
    ],
)
def test_a_cellar_for_goods_is_a_room_of_the_storey_that_lists_it(brief: str, name: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert name in {fact.name for fact in facts.rooms}
    assert not facts.basements
    assert all(ref.kind != "basement" for fact in facts.rooms for ref in fact.floors)


@pytest.mark.parametrize(
    "brief",
    [
        "On the ground floor a kitchen; in the cellar a laundry.",
        "On the ground floor a kitchen and in the cellar for the wine a tasting room.",
        "Ground floor: a kitchen. Cellar: a laundry.",
    ],
)
def test_a_cellar_that_holds_rooms_is_a_storey(brief: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert any(ref.kind == "basement" for fact in facts.rooms for ref in fact.floors)


@pytest.mark.parametrize("place", ["underneath", "beneath", "below"])
def test_what_tells_where_a_basement_lies_is_neither_a_room_nor_unread(place: str) -> None:
    brief = f"A plot in a terrace for a three-storey house, with a kitchen, and a basement {place}."
    facts = read_brief(brief, default_knowledge())
    assert facts.basements
    assert place not in {fact.name for fact in facts.rooms} | {span.words for span in facts.unread}


def test_what_lies_beneath_a_room_is_not_passed_over() -> None:
    facts = read_brief("A house with a kitchen and a bedroom. The kitchen is underneath.", default_knowledge())
    assert any("underneath" in span.words for span in facts.unread)
