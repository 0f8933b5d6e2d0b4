"""Kinds of a room whose noun stands once."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def counts(text: str) -> dict[str, int | None]:
    """Return how many rooms of each name are told."""
    return {fact.name: fact.count for fact in read(text).rooms}


def test_a_colon_shares_out_the_rooms_before_it() -> None:
    facts = read("A club with changing rooms: two for home teams, two for guests, one for referees.")
    assert [(fact.room_type, fact.count) for fact in facts.rooms] == [
        ("changing_room", 2), ("changing_room", 2), ("changing_room", 1)
    ]  # fmt: skip


@pytest.mark.parametrize("joint", ["and one for 4", ", another for 4"])
def test_a_second_one_for_others_is_a_second_room(joint: str) -> None:
    facts = read(f"Office with one meeting room for 8 {joint} and a kitchen.")
    assert [fact.room_type for fact in facts.rooms].count("meeting_room") == 2
