"""Rooms that are to be apart."""

import itertools
from collections.abc import Sequence

import msgspec
import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.program.bands import Block, Segment
from mansion_planner.program.model import PlannedRoom
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.separation import keep_apart, parted


def block(name: str, area: float = 12.0) -> Block:
    room: PlannedRoom = planned_room(default_knowledge().room(name), default_knowledge(), area=area)
    return Block(room)


def row(*names: str) -> Segment:
    return Segment("main", True, 0.0, 4.0 * len(names), 0.0, 3.0, blocks=tuple(block(name) for name in names))


def names(segments: Sequence[Segment]) -> list[str]:
    return [entry.host.id for segment in segments for entry in segment.blocks]


def test_neighbours_are_parted_within_their_row() -> None:
    segments = keep_apart([row("kitchen", "bedroom", "toilet", "home_office")], [("kitchen", "bedroom")], [])
    pairs = [{a, b} for a, b in itertools.pairwise(names(segments))]
    assert {"kitchen", "bedroom"} not in pairs and sorted(names(segments)) == [
        "bedroom",
        "home_office",
        "kitchen",
        "toilet",
    ]


def test_rooms_that_are_to_be_together_stay_so() -> None:
    segment = row("dining_room", "kitchen", "bedroom", "home_office", "toilet")
    segments = keep_apart([segment], [("kitchen", "bedroom")], [("dining_room", "kitchen")])
    pairs = [{a, b} for a, b in itertools.pairwise(names(segments))]
    assert {"kitchen", "bedroom"} not in pairs and {"dining_room", "kitchen"} in pairs


@pytest.mark.parametrize("apart", [[], [("gym", "sauna")]])
def test_nothing_moves_where_nothing_is_wrong(apart: list[tuple[str, str]]) -> None:
    segment = row("kitchen", "bedroom", "toilet")
    assert names(keep_apart([segment], apart, [])) == ["kitchen", "bedroom", "toilet"]


def test_a_small_room_in_a_block_counts() -> None:
    first, second = msgspec.structs.replace(block("kitchen"), smalls=(block("toilet").host,)), block("bedroom")
    assert parted(first, second, [("kitchen", "toilet")]) and not parted(first, second, [("toilet", "bedroom")])
