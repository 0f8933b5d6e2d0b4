"""Room types by their words."""

import pytest

from mansion_knowledge import is_class


@pytest.mark.parametrize(
    ("room_type", "name", "expected"),
    [
        ("lobby", "circulation", True),
        ("entrance_hall", "circulation", True),
        ("hall", "circulation", True),
        ("dining_hall", "circulation", False),
        ("dining_hall", "assembly", True),
        ("lecture_hall", "teaching", True),
        ("staff_toilet", "wet", True),
        ("book_store", "store", False),
        ("store_room", "store", True),
        ("Meeting Room", "office", True),
        ("patient_room_2", "clinical", True),
    ],
)
def test_words_decide(room_type: str, name: str, expected: bool) -> None:
    assert is_class(room_type, name) is expected
