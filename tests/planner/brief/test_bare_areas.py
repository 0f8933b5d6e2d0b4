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
