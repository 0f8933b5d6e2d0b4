"""Stretches pair the edges of polygons that tile a floor."""

import itertools

from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_export.thor.walls import stretches


@settings(deadline=None, max_examples=40)
@given(
    xs=st.lists(st.integers(1, 40), min_size=1, max_size=5, unique=True),
    ys=st.lists(st.integers(1, 40), min_size=1, max_size=5, unique=True),
)
def test_a_grid_of_rooms_has_twins_inside_and_single_stretches_outside(xs, ys):
    xs, ys = sorted([0, *xs]), sorted([0, *ys])
    rooms = {
        f"{i}-{j}": [[(x0, y0), (x1, y0), (x1, y1), (x0, y1)]]
        for i, (x0, x1) in enumerate(itertools.pairwise(xs))
        for j, (y0, y1) in enumerate(itertools.pairwise(ys))
    }
    found = stretches(rooms)
    inner = {(s.start, s.end, s.owner, s.neighbour) for s in found if s.neighbour is not None}
    for start, end, owner, neighbour in inner:
        assert (end, start, neighbour, owner) in inner
    outer = sum(s.length for s in found if s.neighbour is None)
    assert abs(outer - 2 * (xs[-1] + ys[-1])) < 1e-6


def test_a_long_wall_is_cut_where_its_neighbour_changes():
    rooms = {
        "hall": [[(0, 0), (10, 0), (10, 2), (0, 2)]],
        "a": [[(0, 2), (4, 2), (4, 5), (0, 5)]],
        "b": [[(4, 2), (8, 2), (8, 5), (4, 5)]],
    }
    top = [s for s in stretches(rooms) if s.owner == "hall" and s.start[1] == s.end[1] == 2]
    assert [(s.start[0], s.end[0], s.neighbour) for s in top] == [(10, 8, None), (8, 4, "b"), (4, 0, "a")]


def test_a_hole_is_bounded_by_what_lies_in_it():
    ring = [(0, 0), (6, 0), (6, 6), (0, 6)]
    hole = [(2, 2), (4, 2), (4, 4), (2, 4)]
    found = stretches({"hall": [ring, hole], "core": [hole]})
    assert sorted(s.neighbour for s in found if s.neighbour) == ["core"] * 4 + ["hall"] * 4
