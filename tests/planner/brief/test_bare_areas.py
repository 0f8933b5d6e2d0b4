"""Numbers after the rooms of a list are areas where they fit the rooms."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize(
    ("text", "areas"),
    [
        ("Flat. Kitchen 10, living room 22, bedroom 14, bath 5.", [10, 22, 14, 5]),
        ("A cottage, kitchen: 10, living room: 20, two bedrooms: 12 each.", [10, 20, 12]),
        ("A house with bedroom 1, bedroom 2, bathroom 1", [None, None, None]),
        ("Clinic: office 4, toilet 3, consulting room 6.", [None, None, None]),
        ("A house with a kitchen, 14, and a bedroom", [None, None]),
    ],
)
def test_bare_numbers_are_areas_where_all_fit(text: str, areas: list[float | None]) -> None:
    assert [room.area for room in read_brief(text, default_knowledge()).rooms] == areas


LIST = (
    "Community centre. Main hall 150 (clear 4.5 m) with stage 30 attached, chair store 20 off the hall, foyer 50, "
    "office 12."
)


@pytest.mark.parametrize(
    ("text", "areas"),
    [
        (LIST, [150, 30, 20, 50, 12]),
        ("Clinic: waiting room 25 with a desk, office 14, two meeting rooms (25 + 18).", [25, 14, 25, 18]),
        ("House. Kitchen 14 next to the bath 6, study 9, pantry 5.", [14, 6, 9, 5]),
    ],
)
def test_an_entry_may_go_on_after_its_area(text: str, areas: list[float]) -> None:
    assert [room.area for room in read_brief(text, default_knowledge()).rooms] == areas


@pytest.mark.parametrize(
    "text", ["A house with a kitchen 2 with island, a bedroom 3.", "A club. Store 12 off the hall."]
)
def test_numbers_that_are_no_list_of_areas_are_none(text: str) -> None:
    assert not [room.area for room in read_brief(text, default_knowledge()).rooms if room.area]
