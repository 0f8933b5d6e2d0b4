"""Words of a model become ids, descriptions and materials, or are refused."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_knowledge import default_knowledge
from mansion_planner.llm.cleaning import clean_id, clean_text, is_core_name, material_fault, room_kind


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Meeting Room 1", "meeting_room_1"),
        ("kitchen", "kitchen"),
        ("../x", ""),
        ("", ""),
        ("a" * 80, ""),
        ("küche", ""),
    ],
)
def test_ids(text: str, name: str) -> None:
    assert clean_id(text) == name


@settings(deadline=None, max_examples=100)
@given(st.text(max_size=600))
def test_descriptions_are_one_short_line(text: str) -> None:
    clean = clean_text(text)
    assert len(clean) <= 400 and clean == " ".join(clean.split())
    assert not any(ord(char) < 32 for char in clean)


def test_wet_rooms_take_no_wood() -> None:
    bathroom = default_knowledge().room("bathroom")
    assert material_fault("oak hardwood, matte", bathroom, floor=True)
    assert not material_fault("oak-look porcelain tile", bathroom, floor=True)
    assert not material_fault("oak hardwood, matte", default_knowledge().room("bedroom"), floor=True)
    assert material_fault("<script>", None, floor=False)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("bedroom_2", "bedroom"),
        ("east_corridor", "corridor"),
        ("pottery_workshop", "workshop"),
        ("pottery_room_1", "art_room"),
    ],
)
def test_types_follow_from_ids(name: str, kind: str) -> None:
    assert room_kind(name, default_knowledge(), {"pottery_room": "art_room"}).name == kind


def test_cores_are_told_from_rooms() -> None:
    assert is_core_name("stair_1") and is_core_name("elevator") and not is_core_name("starlight_room")
