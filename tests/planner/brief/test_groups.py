"""Groups of rooms that a building has several alike of."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def counts(text: str) -> dict[str, int | None]:
    """Return how many rooms of each name are told."""
    return {fact.name: fact.count for fact in read(text).rooms}


def held(text: str) -> dict[str, dict[str, int | None]]:
    """Return what each group holds, by its name."""
    return {fact.label: {room.room_type: room.count for room in fact.suite} for fact in read(text).rooms if fact.unit}


def test_groups_have_their_names() -> None:
    text = (
        "Care home. Three households called Rose, Oak and Lake with eight bedrooms each; every household has a kitchen."
    )
    each = {"bedroom": 8, "kitchen": 1}
    assert held(text) == {"Rose household": each, "Oak household": each, "Lake household": each}


def test_groups_are_placed_by_their_names() -> None:
    text = (
        "Care home on two storeys. Two households called Rose and Oak with eight bedrooms each. "
        "Rose is downstairs, Oak upstairs."
    )
    placed = {fact.name: [ref.kind for ref in fact.floors] for fact in read(text).rooms if fact.unit}
    assert placed == {"rose_household": ["number"], "oak_household": ["upper"]}


@pytest.mark.parametrize(
    "text",
    [
        "Medical centre: three practices, each with a reception, a waiting area and four consulting rooms.",
        "Medical centre with three practices. Each practice has a reception, a waiting area, four consulting rooms.",
    ],
)
def test_groups_hold_what_is_said_of_each(text: str) -> None:
    assert list(held(text).values()) == [{"reception": 1, "waiting_room": 1, "consultation_room": 4}]
    assert [fact.count for fact in read(text).rooms if fact.unit] == [3]


def test_what_a_cluster_consists_of_is_of_each() -> None:
    text = "Student housing: each storey has two clusters; a cluster consists of six single rooms and two showers."
    assert [list(rooms.values()) for rooms in held(text).values()] == [[6, 2]]


def test_each_of_the_rooms_within_has_its_own() -> None:
    text = "Care home. Two households with eight bedrooms each; every bedroom has its own shower room."
    assert [rooms["bathroom"] for rooms in held(text).values()] == [8]


def test_groups_of_people_hold_nothing() -> None:
    assert counts("Office with a lobby and desks for 36 students in three groups of twelve.") == {"lobby": 1}
