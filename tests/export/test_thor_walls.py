"""Stretches pair the edges of polygons that tile a floor."""

import itertools

from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_export.thor.walls import build_structure, stretches
from mansion_msgs_py.scene import Door, FloorScene, SceneRoom


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


def test_each_of_two_walls_close_together_gets_its_own_opening():
    """The study has a strip of 3 cm around the end of the hall."""
    rings = {
        "F1/hall": [(0, 0), (9, 0), (9, 3), (6, 3), (6, 3.03), (8.97, 3.03), (8.97, 5), (0, 5)],
        "F1/study": [(6, 3), (9, 3), (9, 7), (0, 7), (0, 5), (8.97, 5), (8.97, 3.03), (6, 3.03)],
    }
    rooms = [
        SceneRoom(
            id=name,
            room_type="study",
            kind="Entities",
            polygon=ring,
            net_polygon=ring,
            area=20.0,
            floor_material="",
            wall_material="",
            ceiling_material="",
            ceiling_height=2.7,
        )
        for name, ring in rings.items()
    ]
    doors = [
        Door(
            id=f"F1/door_{number}",
            kind="open",
            segment=((6.3, y), (8.7, y)),
            rooms=("F1/hall", "F1/study"),
            width=2.4,
            height=2.7,
        )
        for number, y in enumerate((3.03, 3.0, 5.0), start=1)
    ]
    scene = FloorScene(
        building_id="b",
        floor=1,
        floors=1,
        label="Ground floor",
        elevation=0.0,
        height=3.0,
        outline=[(0, 0), (9, 0), (9, 7), (0, 7)],
        rooms=rooms,
        walls=[],
        doors=doors,
    )
    made = build_structure(scene, 2.7)
    bases = [tuple((corner["x"], corner["z"]) for corner in wall["polygon"][:2]) for wall in made.walls]
    assert len(set(bases)) == len(bases)
    empty = {wall["polygon"][0]["z"] for wall in made.walls if wall.get("empty")}
    assert empty == {3.0, 3.03, 5.0} and made.misplaced == []
