"""What a bathroom is told to hold stands in it; what is told beside it is a room."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "a bathroom with shower and toilet",
        "a bathroom with a shower and a toilet",
        "bathroom of 6 m2: shower, toilet",
        "a bathroom (shower, toilet)",
        "a bathroom that has a walk-in shower and a loo",
    ],
)
def test_fittings_of_a_bathroom_are_furniture(words: str) -> None:
    facts = read(f"A flat with {words}.")
    assert [room.name for room in facts.rooms] == ["bathroom"]
    assert [(thing.category, thing.room) for thing in facts.objects] == [
        ("shower_cabin", "bathroom"), ("toilet", "bathroom"),
    ]  # fmt: skip


def test_rooms_beside_a_bathroom_stay_rooms() -> None:
    facts = read("A house with a bathroom with a shower, a toilet and a kitchen. Upstairs: bathroom, toilet, bedroom.")
    assert [room.name for room in facts.rooms][:3] == ["bathroom", "toilet", "kitchen"]
    assert [thing.category for thing in facts.objects] == ["shower_cabin"]


def test_every_bathroom_of_several_has_them() -> None:
    facts = read("A bungalow with two bathrooms with bath and toilet and a guest toilet.")
    assert [(thing.category, thing.each) for thing in facts.objects] == [("bathtub", True), ("toilet", True)]
    assert [room.name for room in facts.rooms] == ["bathroom", "guest_toilet"]
