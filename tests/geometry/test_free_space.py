"""Free space of a disc robot: inflation, doors, what can be approached, and incremental updates."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_geometry.free_space import FreeGrid, connected_components, flood_fill

EDGES = np.array([(0, 0, 10, 0), (10, 0, 10, 6), (10, 6, 0, 6), (0, 6, 0, 0)], dtype=float)
DOOR_A, DOOR_B = np.array([1.0, 0, 2, 0]), np.array([10, 4.0, 10, 5])
OPEN = np.array([(0, 0, 1, 0), (2, 0, 10, 0), (10, 0, 10, 4), (10, 5, 10, 6), (10, 6, 0, 6), (0, 6, 0, 0)], dtype=float)


def grid() -> FreeGrid:
    return FreeGrid(EDGES, OPEN, [DOOR_A, DOOR_B])


def wall_of_shelves(gap: float) -> np.ndarray:
    """A shelf across the room that leaves a gap at the far wall."""
    return np.array([[5.0, (6 - gap) / 2, 0.0, 1.0, (6 - gap) / 2, 0.2]])


def test_an_empty_room_is_one_region_as_wide_as_the_robot_leaves_it() -> None:
    space = grid()
    assert space.reached_cells == space.free_cells
    # The centre keeps 0.2 m from walls: 9.6 m by 5.6 m, and the two thresholds reach to the doors.
    assert space.free_cells * 0.05**2 == pytest.approx(9.6 * 5.6 + 2 * 0.2 * 0.6, rel=0.01)


@pytest.mark.parametrize(("gap", "passes"), [(0.38, False), (0.50, True)])
def test_a_gap_wider_than_the_robot_joins_the_doors(gap: float, passes: bool) -> None:
    assert grid().add(wall_of_shelves(gap)) is passes


def test_undo_restores_everything() -> None:
    space = grid()
    counts, reached = space.counts.copy(), space.reached.copy()
    space.add(wall_of_shelves(0.38))
    space.undo()
    assert (space.counts == counts).all()
    assert (space.reached == reached).all()
    assert space.reached_cells == space.free_cells


def test_a_box_behind_a_barrier_cannot_be_approached() -> None:
    space = FreeGrid(EDGES, OPEN, [DOOR_A])
    boxes = np.concatenate([wall_of_shelves(0.38), [[8.0, 3.0, 1.0, 0.0, 0.3, 0.3]]])
    space.add(boxes)
    front, partner = np.zeros(2, dtype=bool), np.full(2, -1, dtype=np.int32)
    assert space.first_unreachable(boxes, front, partner) == 1


def test_a_place_beside_the_front_is_not_before_it() -> None:
    space = grid()
    # A cupboard, and a chest that fills the floor before it and leaves the floor to the left and right.
    boxes = np.array([[5.0, 2.0, 1.0, 0.0, 0.3, 0.3], [5.0, 2.7, 1.0, 0.0, 0.35, 0.35]])
    space.add(boxes)
    partner = np.full(2, -1, dtype=np.int32)
    assert space.first_unreachable(boxes, np.array([False, False]), partner) == -1
    assert space.first_unreachable(boxes, np.array([True, False]), partner) == 0


def test_a_front_at_a_wall_cannot_be_used_unless_a_partner_stands_for_it() -> None:
    space = grid()
    # A desk whose front looks at the wall 0.1 m away, and a chair beside it.
    boxes = np.array([[5.0, 5.65, 1.0, 0.0, 0.5, 0.25], [6.0, 5.0, 1.0, 0.0, 0.2, 0.2]])
    space.add(boxes)
    front = np.array([True, False])
    assert space.first_unreachable(boxes, front, np.array([-1, -1], dtype=np.int32)) == 0
    assert space.first_unreachable(boxes, front, np.array([1, -1], dtype=np.int32)) == -1


def test_a_room_without_doors_counts_its_largest_region() -> None:
    space = FreeGrid(EDGES, EDGES, [])
    assert space.reached_cells == space.free_cells > 0


coordinates = st.tuples(st.floats(0.5, 9.5), st.floats(0.5, 5.5), st.floats(0.1, 1.2))


@given(st.lists(coordinates, max_size=12))
@settings(deadline=None, max_examples=40)
def test_incremental_updates_equal_a_flood_from_scratch(spots: list[tuple[float, float, float]]) -> None:
    space = grid()
    for x, y, half in spots:
        if not space.add(np.array([[x, y, 1.0, 0.0, half, 0.3]])):
            space.undo()
    fresh = np.zeros_like(space.reached)
    total = flood_fill(space.counts, space.seeds, fresh)
    assert total == space.reached_cells
    assert (fresh == space.reached).all()
    assert space.free_cells == int((space.counts == 0).sum())


def test_components_are_four_connected() -> None:
    counts = np.array([[0, 1, 0], [0, 0, 0], [1, 1, 1], [1, 0, 1]], dtype=np.int16)
    labels, sizes = connected_components(counts)
    assert sorted(sizes.tolist()) == [1, 5]
    assert labels[0, 0] == labels[0, 2] != labels[3, 1]


def test_looking_only_where_something_changed_finds_what_was_walled_in() -> None:
    room = np.array([(0, 0, 8, 0), (8, 0, 8, 8), (8, 8, 0, 8), (0, 8, 0, 0)], dtype=float)
    space = FreeGrid(room, room, [])
    cell = np.array([[1.0, 1.0, 1.0, 0.0, 0.2, 0.2]])
    far = np.array([[6.0, 6.0, 1.0, 0.0, 0.2, 0.2]])
    near = np.array([[1.6, 1.0, 1.0, 0.0, 0.2, 0.2]])
    alone = np.array([-1], dtype=np.int32)
    facing = np.array([False])
    assert space.add(cell)
    before = space.reached.copy()
    assert space.add(far)
    assert space.first_unreachable(cell, facing, alone, changed=True) == -1
    space.undo()
    assert (space.reached == before).all()
    above = near + np.array([-0.6, 0.6, 0, 0, 0, 0])
    ring = np.concatenate([near, above])
    space.add(ring)
    unreachable = space.first_unreachable(cell, facing, alone)
    assert space.first_unreachable(cell, facing, alone, changed=True) == unreachable
