"""The rooms of the only flat of a building to work in."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "a flat above for the vet. Downstairs a waiting room; upstairs living room, kitchen, 2 bedrooms and a bath",
        "a flat upstairs. Ground floor: waiting room. Upper floor: living room, kitchen, 2 bedrooms, bath",
        "a flat on top (2 floors). Below: waiting room. The flat above: living room, kitchen, 2 bedrooms, bath",
    ],
)
def test_what_is_upstairs_is_the_flat_s(words: str) -> None:
    (flat,) = (fact for fact in read(f"A vet with {words}.").rooms if fact.unit)
    assert {child.room_type: child.count for child in flat.suite} == {
        "living_room": 1,
        "kitchen": 1,
        "bedroom": 2,
        "bathroom": 1,
    }


def test_a_house_keeps_its_bedrooms() -> None:
    facts = read("A house with a granny flat. Upstairs two bedrooms, bathroom, kitchen.")
    assert [fact.name for fact in facts.rooms] == ["granny_flat", "bedroom", "bathroom", "kitchen"]
