"""What only stands around a building, or whom it is for, is no part of it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def counts(text: str) -> dict[str, int | None]:
    """Return how many rooms of each name are told."""
    return {fact.name: fact.count for fact in read(text).rooms}


@pytest.mark.parametrize(
    "text",
    [
        "A house with two bedrooms, nine minutes from the station.",
        "A house with two bedrooms. It is a home that photographs well.",
        "A refuge with two bedrooms that stay open for emergencies.",
        "A hostel with two bedrooms, with a view over the hall.",
        "A motel with two bedrooms and parking outside.",
        "A motel with two bedrooms and parking spaces in front.",
        "A motel with two bedrooms and outdoor parking.",
    ],
)
def test_they_build_nothing(text: str) -> None:
    assert counts(text) == {"bedroom": 2}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Office for a law chambers. A library and a kitchen.", "office"),
        ("Clinic for physiotherapy - 200 m2 - 1 floor - a library and a kitchen.", "clinic"),
    ],
)
def test_clients_are_no_rooms(text: str, kind: str) -> None:
    assert counts(text) == {"library": 1, "kitchen": 1}
    assert read(text).building[0][0] == kind


def test_a_storey_of_another_building_is_no_number_of_storeys() -> None:
    facts = read("Dental practice. Second floor of a shopping arcade, 320 sqm all on that level. A library.")
    assert [quantity.value for quantity in facts.floors] == [1.0]
    assert [fact.name for fact in facts.rooms] == ["library"]


def test_relations_keep_what_they_name() -> None:
    assert "office" in counts("A warehouse with a charging room that must be away from the office.")


def test_parking_that_is_not_outside_is_a_room() -> None:
    assert "parking" in counts("A hotel with two bedrooms and parking in the basement.")
