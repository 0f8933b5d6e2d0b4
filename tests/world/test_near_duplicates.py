"""Near-duplicates: names do not matter; types, doors, places and areas do."""

import msgspec
import numpy as np
import pytest

from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode
from mansion_world.building_measures import difficulty_of
from mansion_world.near_duplicates import graph_fingerprint, likeness_cells, nearly_the_same
from mansion_world.records import RoomLikeness

ROOMS = [
    RoomLikeness(floor=1, type="bedroom", x=2.0, y=2.0, area=12.0),
    RoomLikeness(floor=1, type="bedroom", x=2.0, y=6.0, area=12.0),
    RoomLikeness(floor=1, type="kitchen", x=6.0, y=2.0, area=9.0),
]


def floor(
    names: tuple[str, str, str], doors: list[tuple[int, int]], types: str = "hall bedroom bedroom"
) -> FloorTopology:
    nodes = [
        TopologyNode(id=name, type="main" if not place else "Entities", area=10.0, room_type=room_type)
        for place, (name, room_type) in enumerate(zip(names, types.split(), strict=True))
    ]
    edges = [Edge(source=names[one], target=names[other]) for one, other in doors]
    return FloorTopology(nodes=nodes, edges=edges)


def test_the_fingerprint_tells_graphs_apart_but_not_names() -> None:
    star = floor(("a", "b", "c"), [(0, 1), (0, 2)])
    assert graph_fingerprint([star]) == graph_fingerprint([floor(("x", "z", "y"), [(2, 0), (1, 0)])])
    others = [
        floor(("a", "b", "c"), [(0, 1), (1, 2)]),
        floor(("a", "b", "c"), [(0, 1), (0, 2), (1, 2)]),
        floor(("a", "b", "c"), [(0, 1), (0, 2)], "hall bedroom kitchen"),
    ]
    assert graph_fingerprint([star]) not in {graph_fingerprint([other]) for other in others}
    assert graph_fingerprint([star, star]) != graph_fingerprint([star])


def test_rooms_that_are_a_little_moved_are_nearly_the_same() -> None:
    moved = [msgspec.structs.replace(room, x=room.x + 0.3, area=room.area * 1.05) for room in reversed(ROOMS)]
    assert nearly_the_same(ROOMS, moved)


@pytest.mark.parametrize("change", [{"x": 2.6}, {"area": 14.0}, {"floor": 2}, {"type": "study"}])
def test_one_room_that_differs_makes_another_building(change: dict[str, float | str]) -> None:
    other = [msgspec.structs.replace(ROOMS[0], **change), *ROOMS[1:]]
    assert not nearly_the_same(ROOMS, other)
    assert not nearly_the_same(ROOMS, ROOMS[:2])


def test_near_duplicates_lie_in_cells_around_each_other() -> None:
    generator = np.random.default_rng(7)
    for shift in generator.uniform(-20.0, 20.0, (200, 2)):
        place = [msgspec.structs.replace(room, x=room.x + shift[0], y=room.y + shift[1]) for room in ROOMS]
        moves = generator.uniform(-0.35, 0.35, (len(ROOMS), 2))
        other = [msgspec.structs.replace(room, x=room.x + x, y=room.y + y) for room, (x, y) in zip(place, moves)]
        assert nearly_the_same(place, other)
        assert likeness_cells(other)[0] in likeness_cells(place)
    assert len(set(likeness_cells(ROOMS))) == 9


def test_difficulty_grows_with_floors_rooms_objects_and_ways() -> None:
    assert difficulty_of(1, 5, 120) == "easy"
    assert difficulty_of(2, 12, 400) == "medium"
    assert difficulty_of(4, 30, 1200) == "hard"
    assert difficulty_of(8, 90, 3000) == "expert"
    assert difficulty_of(1, 5, 120, metres=60.0) == "medium"
