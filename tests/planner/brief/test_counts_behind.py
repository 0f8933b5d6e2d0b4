"""Counts that stand right behind their noun, behind its storey, or that are shared out over the storeys."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("School: training rooms four, a chapel.", 4),
        ("Court: training rooms, five, and a library.", 5),
        ("School on two floors, training rooms two on each floor.", 2),
        ("Office on two floors. Training rooms on each floor, at least two.", 2),
        ("Lab with four identical training rooms.", 4),
    ],
)
def test_rooms_are_counted(text: str, count: int) -> None:
    assert next(fact.count for fact in read(text).rooms if fact.name == "training_room") == count


def test_rooms_are_shared_out_evenly() -> None:
    room = read("School, two floors: 12 classrooms split evenly over the floors.").rooms[0]
    assert (room.count, room.each, [ref.kind for ref in room.floors]) == (6, True, ["every"])


def test_one_beside_each_of_several() -> None:
    facts = read("Court with two courtrooms and a deliberation room next to each courtroom.")
    assert {fact.name: fact.count for fact in facts.rooms} == {"courtroom": 2, "deliberation_room": 2}


def test_flats_on_each_floor_are_parted_by_a_colon() -> None:
    facts = read("Flats, 5 floors, 4 flats on every floor: two 2-bedroom flats and two studios.")
    assert [fact.count for fact in facts.rooms if fact.unit or "studio" in fact.name] == [2, 2]


@pytest.mark.parametrize("words", ["5 bedrooms of which 1 downstairs", "5 bedrooms, 1 of which downstairs"])
def test_which_is_of_the_rooms_before(words: str) -> None:
    rooms = read_brief(f"A farmhouse of two floors with {words}.", default_knowledge()).rooms
    assert [(room.count, bool(room.floors)) for room in rooms] == [(4, False), (1, True)]
