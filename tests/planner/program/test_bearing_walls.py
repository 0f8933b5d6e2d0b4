"""Walls along the corridor that stand on every storey."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.program.corridor_sketch import sketch_storey
from mansion_planner.program.model import Corridor, Massing, Placement, PlannedRoom, Sketch, Storey
from mansion_planner.program.outline import Frame, bearing_walls

FRAME = Frame((0.0, 0.0, 20.0, 14.0))


def storey(front: tuple[float, float], bearing: tuple[float, float], corridor: tuple[float, float] = (0, 20)) -> Sketch:
    room = PlannedRoom(id="room", kind=default_knowledge().room("storage"), area=10.0, least=5.0, most=20.0)
    place = Placement(room, [(front[0], 8.0, front[1], 14.0)], "corridor")
    passage = Corridor("corridor", [(corridor[0], 6.0, corridor[1], 8.0)])
    return Sketch([passage], [place], bearing={8.0: [bearing]})


@pytest.mark.parametrize(("front", "low"), [((6.2, 8.0), 8.0), ((4.0, 8.0), 7.0), ((7.0, 9.0), 7.0)])
def test_a_wall_does_not_begin_where_a_short_front_needs_its_door(front: tuple[float, float], low: float) -> None:
    lower, upper = storey((10.0, 14.0), (7.0, 20.0)), storey(front, (4.0, 20.0))
    (wall,) = bearing_walls([lower, upper], FRAME)
    assert sorted(x for x, _ in wall) == [low, 20.0]


@pytest.mark.parametrize(("end", "low"), [(8.6, 8.6), (8.9, 7.6), (12.0, 7.6)])
def test_a_front_counts_as_far_as_the_corridor_that_it_is_reached_from_goes(end: float, low: float) -> None:
    lower, upper = storey((10.0, 14.0), (7.6, 20.0)), storey((6.6, 10.0), (4.0, 20.0), corridor=(0.0, end))
    (wall,) = bearing_walls([lower, upper], FRAME)
    assert sorted(x for x, _ in wall) == [low, 20.0]


def test_a_single_storey_has_none() -> None:
    assert bearing_walls([storey((6.2, 8.0), (7.0, 20.0))], FRAME) == []


def test_no_wall_bears_where_the_corridor_takes_a_band_without_rooms() -> None:
    knowledge = default_knowledge()
    use = knowledge.buildings["apartment_building"]
    flat = PlannedRoom(id="flat", kind=knowledge.room("apartment"), area=60.0, least=40.0, most=80.0)
    storey = Storey(index=2, role="upper", use=use, hub=knowledge.room("corridor"), rooms=(flat,))
    sketch = sketch_storey(Massing(length=12.0, north=6.0, corridor=2.0, south=5.0), storey, "corridor", [])
    (place,) = sketch.rooms
    empty = 5.0 if place.boxes[0][1] >= 7.0 else 7.0
    assert sketch.bearing[empty] == [] and sketch.bearing[12.0 - empty] == [(0.0, 12.0)]
