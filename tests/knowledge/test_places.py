"""Beds, seats and desks are for as many people as they hold."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_knowledge.places import _BEDS, _DESKS, _FOR_TWO, _SEATS, Use, places_of, use_of


def test_every_category_is_known() -> None:
    known = set(load_catalogue().categories)
    assert known >= (_BEDS | _FOR_TWO | _SEATS)
    assert _DESKS & known


@pytest.mark.parametrize(
    ("category", "width", "use", "places"),
    [
        ("bunk_bed", 1.0, "sleep", 2),
        ("bed", 1.2, "sleep", 1),
        ("student_chair", 0.5, "sit", 1),
        ("office_desk", 1.6, "work", 1),
        ("office_desk", 1.6, "sit", 0),
        ("wardrobe", 1.0, "sleep", 0),
    ],
)
def test_furniture_has_places(category: str, width: float, use: Use, places: int) -> None:
    assert places_of(category, width, use) == places


@pytest.mark.parametrize(
    ("noun", "family", "use"),
    [
        ("student", "home", "sleep"),
        ("student", "education", "sit"),
        ("employee", "office", "work"),
        ("member", "civic", ""),
    ],
)
def test_people_need_places_for_what_they_do(noun: str, family: str, use: Use) -> None:
    assert use_of(noun, family) == use
