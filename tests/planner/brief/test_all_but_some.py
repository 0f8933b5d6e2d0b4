"""Where all rooms are but some."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def storeys(text: str) -> dict[str, list[tuple[str, int]]]:
    """Return the storeys of rooms, by name."""
    return {fact.name: [(ref.kind, ref.first) for ref in fact.floors] for fact in read(text).rooms}


@pytest.mark.parametrize(
    "words",
    [
        "Everything on the ground floor except the bedrooms.",
        "Everything on the ground floor except for the bedrooms, which are upstairs.",
        "Everything downstairs apart from the bedrooms.",
        "All rooms are downstairs but for the bedrooms.",
        "All the rooms should go on the ground floor other than the bedrooms.",
    ],
)
def test_the_others_are_on_the_ground_floor(words: str) -> None:
    found = storeys(f"A house of two floors with a kitchen, a study and three bedrooms. {words}")
    assert found == {"kitchen": [("number", 1)], "study": [("number", 1)], "bedroom": [("upper", 0)]}


def test_the_building_keeps_its_storeys() -> None:
    facts = read("A house of two floors with three bedrooms. Everything on the ground floor except the bedrooms.")
    assert [quantity.value for quantity in facts.floors] == [2.0]


def test_the_upper_storey_has_the_rest_alone() -> None:
    facts = read("A cottage. Everything on the ground floor except a guest bedroom and a small bathroom upstairs.")
    assert [[ref.kind for ref in refs] for _, refs in facts.only_on] == [["upper"]]


@pytest.mark.parametrize(
    "words",
    [
        "Bedrooms upstairs, all else on the ground floor.",
        "Bedrooms upstairs, the rest downstairs.",
        "Only the bedrooms are upstairs, everything else is downstairs.",
    ],
)
def test_what_is_said_of_all_others_leaves_those_placed_before(words: str) -> None:
    found = storeys(f"A house of two floors with a kitchen, a study and three bedrooms. {words}")
    assert found["kitchen"] == found["study"] == [("number", 1)]
    assert [kind for kind, _ in found["bedroom"]] == ["upper"]


def test_the_way_in_stays_downstairs_when_all_else_is_upstairs() -> None:
    found = storeys(
        "A library of two floors with a lobby, a cafe and a reading room. Cafe downstairs, the rest upstairs."
    )
    assert found == {"lobby": [], "cafe": [("number", 1)], "reading_room": [("upper", 0)]}
