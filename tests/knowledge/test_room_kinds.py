"""What a brief does not want by the name of a kind."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_knowledge.room_kinds import _FURTHER, is_one_of


@pytest.mark.parametrize(
    ("room_type", "refused", "expected"),
    [
        ("private_office", "private_office", True),
        ("home_office", "private_office", True),
        ("master_bedroom", "bedroom", True),
        ("double_garage", "garage", True),
        ("meeting_room", "private_office", False),
        ("garage", "double_garage", False),
    ],
)
def test_rooms_are_of_a_kind_that_is_refused(room_type: str, refused: str, expected: bool) -> None:
    assert is_one_of(room_type, refused) is expected


def test_all_types_are_known() -> None:
    assert set(_FURTHER).union(*_FURTHER.values()) <= set(default_knowledge().rooms)
