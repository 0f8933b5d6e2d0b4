"""What a brief only speaks of is no room of the building."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


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
