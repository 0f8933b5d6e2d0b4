"""What a brief only speaks of, and what stands around a building, is no part of it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def rooms(brief: str) -> set[str]:
    return {fact.name for fact in read_brief(brief, default_knowledge()).rooms}


@pytest.mark.parametrize(
    "brief",
    [
        "I am a vet. The clinic needs a reception and a kennel.",
        "We move out of our old villa. The clinic needs a reception and a kennel.",
        "A clinic with a reception and a kennel, as the waiting room is too small.",
        "A clinic with a reception and a kennel. It will stand between the church and the inn.",
    ],
)
def test_who_writes_and_what_is_around_or_left_behind_is_no_room(brief: str) -> None:
    assert rooms(brief) == {"reception", "kennel"}


def test_a_storey_that_houses_rooms_is_no_storey_of_houses() -> None:
    facts = read_brief("A town hall of two storeys. The upper storey houses the archive.", default_knowledge())
    assert not facts.uses
    assert [(fact.name, fact.floors[0].kind) for fact in facts.rooms] == [("archive", "upper")]


def test_rooms_between_others_are_still_read() -> None:
    assert {"kitchen", "pantry"} <= rooms(
        "A house with a kitchen and a pantry beside it, between the hall and the garage"
    )


@pytest.mark.parametrize(
    ("brief", "building"),
    [
        ("We want to swap our flat for a narrow terraced house with two bedrooms.", "townhouse"),
        ("To replace our old villa, a bungalow with two bedrooms.", "bungalow"),
        ("We are selling our house. A penthouse with two bedrooms, please.", "penthouse"),
        ("We have outgrown our flat and want a villa with two bedrooms.", "villa"),
    ],
)
def test_what_one_parts_with_is_not_the_building(brief: str, building: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [name for name, _ in facts.building] == [building]
    assert rooms(brief) == {"bedroom"}


@pytest.mark.parametrize(
    ("brief", "building"),
    [
        ("Our veterinary practice needs a new home with three consulting rooms.", "veterinary_clinic"),
        ("The village library is looking for a new home of two storeys with a reading room.", "library_building"),
        ("A new home for our kindergarten, one storey, with four group rooms.", "kindergarten"),
    ],
)
def test_a_new_home_of_an_organisation_is_where_it_is_to_be(brief: str, building: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert facts.building[0][0] == building
    assert "apartment" not in {fact.room_type for fact in facts.rooms}


def test_a_home_for_somebody_is_a_dwelling() -> None:
    assert "home" in rooms("A library with a home for the caretaker and a reading room.")
    facts = read_brief("We need a new home with three bedrooms.", default_knowledge())
    assert facts.building[0][0] == "house"


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
