"""Walls along the corridor that stand on every storey."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.program.model import Placement, PlannedRoom, Sketch
from mansion_planner.program.outline import Frame, bearing_walls

FRAME = Frame((0.0, 0.0, 20.0, 14.0))


def storey(front: tuple[float, float], bearing: tuple[float, float]) -> Sketch:
    room = PlannedRoom(id="room", kind=default_knowledge().room("storage"), area=10.0, least=5.0, most=20.0)
    place = Placement(room, [(front[0], 8.0, front[1], 14.0)], "corridor")
    return Sketch([], [place], bearing={8.0: [bearing]})


@pytest.mark.parametrize(("front", "low"), [((6.2, 8.0), 8.0), ((4.0, 8.0), 7.0), ((7.0, 9.0), 7.0)])
def test_a_wall_does_not_begin_where_a_short_front_needs_its_door(front: tuple[float, float], low: float) -> None:
    lower, upper = storey((10.0, 14.0), (7.0, 20.0)), storey(front, (4.0, 20.0))
    (wall,) = bearing_walls([lower, upper], FRAME)
    assert sorted(x for x, _ in wall) == [low, 20.0]


def test_a_single_storey_has_none() -> None:
    assert bearing_walls([storey((6.2, 8.0), (7.0, 20.0))], FRAME) == []
