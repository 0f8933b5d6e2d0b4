"""Lists of storeys that go up or down."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def storeys(text: str) -> dict[str, list[tuple[int, int]]]:
    """Return where rooms are, by name: first and last storey of each reference."""
    return {fact.name: [(ref.first, ref.last) for ref in fact.floors] for fact in read(text).rooms}


@pytest.mark.parametrize(
    "opening",
    [
        "From bottom to top:",
        "From the bottom up:",
        "Listed from the street upwards:",
        "Starting at the bottom:",
        "Going up:",
        "Floor by floor:",
        "From the ground floor up:",
    ],
)
@pytest.mark.parametrize("mark", [";", ",", " /"])
def test_a_list_goes_up(opening: str, mark: str) -> None:
    found = storeys(f"A building of three storeys. {opening} a bakery{mark} two offices{mark} a library.")
    assert found == {"bakery": [(1, 1)], "office": [(2, 2)], "library": [(3, 3)]}


@pytest.mark.parametrize("opening", ["From top to bottom:", "Top down:", "From the top down:"])
def test_a_list_goes_down(opening: str) -> None:
    found = storeys(f"A three-storey building. {opening} a library; two offices; a bakery.")
    assert found == {"bakery": [(1, 1)], "office": [(2, 2)], "library": [(3, 3)]}


def test_the_lowest_entry_may_be_the_cellar() -> None:
    facts = read("A house on two levels over a cellar. From bottom to top: wine cellar; kitchen; two bedrooms.")
    where = {fact.name: [(ref.kind, ref.first) for ref in fact.floors] for fact in facts.rooms}
    assert where == {"wine_cellar": [("basement", 0)], "kitchen": [("number", 1)], "bedroom": [("number", 2)]}


def test_an_entry_may_go_over_several_storeys() -> None:
    found = storeys("Four floors. From bottom to top: a shop; two floors of meeting rooms; a restaurant.")
    assert (found["meeting_room"], found["restaurant"]) == ([(2, 3)], [(4, 4)])


def test_an_entry_may_repeat_the_one_below() -> None:
    facts = read("Three storeys. From bottom to top: a shop; two labs; labs again, identical to the one below.")
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(2, 3)]


def test_storeys_are_called_by_what_their_list_has_there() -> None:
    text = (
        "Four storeys. From bottom to top: shop; editorial; editorial; canteen. On each editorial storey one archive."
    )
    assert storeys(text)["archive"] == [(2, 2), (3, 3)]


@pytest.mark.parametrize(
    "text",
    [
        "Three storeys. Top floor: a gym, a sauna, a pool.",
        "Three storeys. Ground floor: a shop, a cafe, a store.",
        "Four storeys. From bottom to top: a shop; an office.",
    ],
)
def test_other_lists_stay_as_they_are(text: str) -> None:
    assert len({tuple((ref.kind, ref.first) for ref in fact.floors) for fact in read(text).rooms}) == 1
