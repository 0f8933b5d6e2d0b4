"""The floor as exact polygons, and that its cells say the same."""

import math

import numpy as np
import shapely
import shapely.affinity
from hypothesis import example, given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon, box

from mansion_geometry.boxes import box_corners, unit_vector
from mansion_geometry.disc_cells import near_boxes, segment_boxes
from mansion_geometry.floor_grid import GridFrame
from mansion_geometry.floor_regions import disc_positions, disc_positions_among, largest_first, open_floor, strip

RADIUS = 0.2
ROOM = box(0.0, 0.0, 4.0, 3.0)
WALLS = [((0, 0), (4, 0)), ((4, 0), (4, 3)), ((4, 3), (0, 3)), ((0, 3), (0, 0))]


def test_a_strip_lies_on_both_sides_of_its_segment() -> None:
    found = strip(((0.0, 1.0), (2.0, 1.0)), 0.3)
    assert found.symmetric_difference(box(0.0, 0.85, 2.0, 1.15)).area < 1e-12


def test_a_doorway_joins_two_rooms_if_the_disc_fits_through() -> None:
    rooms = [box(0, 0, 2, 3), box(2.1, 0, 4, 3)]
    for width, parts in ((0.39, 2), (0.41, 1)):
        door = strip(((2.05, 1.0), (2.05, 1.0 + width)), 0.3)
        assert len(disc_positions(open_floor([*rooms, door], []), RADIUS, quad_segs=16)) == parts


def test_a_floor_that_is_covered_leaves_no_position() -> None:
    assert disc_positions(open_floor([ROOM], [ROOM]), RADIUS, quad_segs=8) == []
    assert disc_positions(box(0, 0, 5, 0.3), RADIUS, quad_segs=8) == []


def test_parts_are_ordered_by_area() -> None:
    small, large, same = box(0, 0, 1, 1), box(5, 5, 8, 8), box(-1, 0, 0, 1)
    assert largest_first([small, large, same]) == [large, same, small]


boxes = st.tuples(
    st.floats(0.3, 3.7), st.floats(0.3, 2.7), st.floats(0, 360), st.floats(0.05, 0.6), st.floats(0.05, 0.6)
)


@example([(1.0, 1.0, 0.0, 0.5, 0.25), (1.0, 1.0, 0.25, 0.5, 0.5)])
@given(st.lists(boxes, max_size=4))
@settings(max_examples=50, deadline=None)
def test_solids_may_be_grown_instead_of_the_floor_eroded(found) -> None:
    solid = [shapely.affinity.rotate(box(x - a, y - b, x + a, y + b), turn) for x, y, turn, a, b in found]
    eroded = shapely.union_all(disc_positions(open_floor([ROOM], solid), RADIUS, quad_segs=16))
    grown = shapely.union_all(disc_positions_among([ROOM], solid, RADIUS, quad_segs=16))
    # Before it offsets an outline, GEOS straightens dents of up to a hundredth of the distance, and it turns arcs into
    # chords; an outline of one solid has other dents and arcs than that of all of them together.
    sagitta = RADIUS * (1 - math.cos(math.pi / (4 * 16)))
    assert eroded.symmetric_difference(grown).buffer(-(0.01 * RADIUS + sagitta) / 2).is_empty


def test_thousands_of_solids_leave_the_floor_between_them() -> None:
    solid = [box(x, y, x + 0.02, y + 0.02) for x in np.arange(0, 40, 0.5) for y in np.arange(0, 40, 0.5)]
    (whole,) = disc_positions_among([box(0, 0, 40, 40)], solid, 0.2, quad_segs=16)
    assert len(solid) == 6_400 and whole.area > 600.0


@given(st.lists(boxes, max_size=4))
@settings(max_examples=50, deadline=None)
def test_cells_and_polygons_mean_the_same_positions(found) -> None:
    rows = np.array([(x, y, *unit_vector(turn), a, b) for x, y, turn, a, b in found]).reshape(-1, 6)
    frame = GridFrame(0.0, 0.0, 0.05, 60, 80)
    fits = ~near_boxes(frame, np.concatenate([rows, segment_boxes(WALLS)]), RADIUS)
    floor = open_floor([ROOM], [Polygon(box_corners(row)) for row in rows])
    positions = shapely.union_all(disc_positions(floor, RADIUS, quad_segs=16))
    points = shapely.points(*np.meshgrid(*frame.centers()))
    # Arcs of polygons are chords, 0.24 % of the radius off at most.
    clear = abs(shapely.distance(floor.boundary, points) - RADIUS) > 0.005 * RADIUS
    assert np.array_equal(fits[clear], shapely.contains(positions, points)[clear])
