"""The floor grid: where cells lie, and what is drawn into them."""

import subprocess
import sys
from math import cos, radians, sin

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon, box

from mansion_geometry.boxes import box_corners, unit_vector
from mansion_geometry.disc_cells import region_of
from mansion_geometry.floor_grid import MARGIN, RESOLUTION, GridFrame, fill_box, fill_rings, fill_strip, map_frame
from mansion_geometry.free_space import FreeGrid
from mansion_msgs_py.errors import MansionError
from sample_building import scene

FRAME = GridFrame(-1.0, 2.0, 0.1, 30, 40)

coordinate = st.floats(-50.0, 50.0, allow_nan=False)
inside_x, inside_y = st.floats(-0.9, 2.9), st.floats(2.1, 4.9)


def centers(frame: GridFrame = FRAME) -> shapely.Geometry:
    """Return the centres of all cells, shape (rows, columns)."""
    return shapely.points(*np.meshgrid(*frame.centers()))


def drawn(frame: GridFrame = FRAME) -> np.ndarray:
    return np.zeros(frame.shape, dtype=np.int16)


def assert_holds(cells: np.ndarray, shape: shapely.Geometry, slack: float) -> None:
    """Check that the cells are those with their centre in a shape, but for centres on its edge."""
    points = centers()
    clear = shapely.distance(shape.boundary, points) > slack
    assert np.array_equal(cells[clear], shapely.contains(shape, points)[clear])


@given(st.lists(st.tuples(coordinate, coordinate), min_size=1, max_size=8), st.sampled_from([0.05, 0.1, 0.25]))
def test_a_frame_around_points_holds_them_and_its_corner_is_on_the_lattice(points, resolution) -> None:
    frame = GridFrame.around(points, 0.5, resolution)
    assert all(frame.holds(*frame.cell(x, y)) for x, y in points)
    for corner in (frame.x0, frame.y0):
        assert corner / resolution == pytest.approx(round(corner / resolution), abs=1e-6)


@given(st.integers(0, FRAME.rows - 1), st.integers(0, FRAME.columns - 1))
def test_a_cells_centre_is_in_the_cell(row: int, column: int) -> None:
    assert FRAME.cell(*FRAME.center(row, column)) == (row, column)
    assert FRAME.coordinates(*FRAME.center(row, column)) == pytest.approx((row + 0.5, column + 0.5))
    x, y = FRAME.centers()
    assert (x[column], y[row]) == pytest.approx(FRAME.center(row, column))


@given(st.tuples(coordinate, coordinate), st.lists(st.tuples(coordinate, coordinate), min_size=1, max_size=5))
def test_a_frame_through_a_point_has_centres_at_whole_steps_from_it(point, points) -> None:
    frame = GridFrame.through(point, points, 0.25)
    x, y = frame.centers()
    steps = np.concatenate([x - point[0], y - point[1]]) / 0.25
    assert steps == pytest.approx(np.round(steps), abs=1e-6)
    corners = np.array(points)
    assert x[0] <= corners[:, 0].min() + 1e-9 and y[0] <= corners[:, 1].min() + 1e-9
    assert x[-1] >= corners[:, 0].max() - 1e-9 and y[-1] >= corners[:, 1].max() - 1e-9


@given(st.integers(1, 6))
def test_a_finer_frame_has_all_centres_of_the_coarser(parts: int) -> None:
    finer = FRAME.refined(parts)
    for coarse, fine in zip(FRAME.centers(), finer.centers()):
        assert fine[::parts] == pytest.approx(coarse)


def test_a_window_has_the_cells_around_a_point_that_exist() -> None:
    rows, columns = FRAME.window(-0.95, 3.0, 0.2)
    assert (columns.start, columns.stop) == (0, 4)
    assert (rows.start, rows.stop) == (7, 14)


def test_a_storeys_maps_lie_around_all_that_is_built() -> None:
    floor = scene(1, [1])
    frame = map_frame(floor)
    x0, y0, x1, y1 = shapely.MultiPoint([p for room in floor.rooms for p in room.polygon]).bounds
    x, y = frame.centers()
    assert x[0] < x0 - MARGIN + frame.resolution and y[0] < y0 - MARGIN + frame.resolution
    assert x[-1] > x1 + MARGIN - frame.resolution and y[-1] > y1 + MARGIN - frame.resolution


@given(st.lists(st.floats(0.2, 1.4), min_size=5, max_size=12), inside_x, inside_y)
@settings(deadline=None)
def test_a_ring_has_the_cells_whose_centres_it_holds(radii: list[float], x: float, y: float) -> None:
    angles = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    star = [(x + r * cos(a), y + r * sin(a)) for r, a in zip(radii, angles)]
    hole = [(x + 0.4 * r * cos(a), y + 0.4 * r * sin(a)) for r, a in zip(radii, angles)]
    whole, pierced = drawn(), drawn()
    fill_rings(whole, FRAME, [star], 1)
    fill_rings(pierced, FRAME, [star, hole], 1)
    assert_holds(whole > 0, Polygon(star), 1e-9)
    assert_holds(pierced > 0, Polygon(star, [hole]), 1e-9)


def test_two_rooms_with_a_common_wall_share_no_cell_and_leave_none_out() -> None:
    left, right = drawn(), drawn()
    fill_rings(left, FRAME, [[(-1, 2), (0.25, 2), (0.25, 5), (-1, 5)]], 1)
    fill_rings(right, FRAME, [[(0.25, 2), (3, 2), (3, 5), (0.25, 5)]], 1)
    assert ((left + right) == 1).all()


@given(inside_x, inside_y, st.floats(0.15, 1.5), st.floats(0.15, 1.5), st.floats(-360, 360))
@settings(deadline=None)
def test_a_box_has_the_cells_whose_centres_it_holds(x, y, width, depth, turn) -> None:
    cells = drawn()
    fill_box(cells, FRAME, (x, y), (width, depth), turn, 1)
    corners = box_corners(np.array([x, y, *unit_vector(turn), width / 2, depth / 2]))
    assert_holds(cells > 0, Polygon(corners), 2e-6)


@pytest.mark.parametrize("turn", [0.0, 17.0, 45.0, 90.0])
def test_no_step_leads_through_a_thin_wall(turn: float) -> None:
    cells = drawn()
    ux, uy = cos(radians(turn)), sin(radians(turn))
    fill_strip(cells, FRAME, ((1.0 - 4 * ux, 3.5 - 4 * uy), (1.0 + 4 * ux, 3.5 + 4 * uy)), 0.01, 1)
    left, right = FRAME.cell(1.0 - uy, 3.5 + ux), FRAME.cell(1.0 + uy, 3.5 - ux)
    assert region_of(cells > 0, *left).any()
    assert not region_of(cells > 0, *left)[right]


def test_a_strip_may_be_longer_than_its_segment() -> None:
    cells = drawn()
    fill_strip(cells, FRAME, ((0.0, 3.0), (1.0, 3.0)), 0.2, 1, longer=0.2)
    assert_holds(cells > 0, box(-0.1, 2.9, 1.1, 3.1), 2e-6)


def test_cells_of_other_values_stay() -> None:
    cells = drawn()
    cells[:, :20] = -1
    fill_box(cells, FRAME, (1.0, 3.5), (2.0, 1.0), 0.0, 5, only=-1)
    assert (cells[:, 20:] == 0).all()
    assert (cells[10:20, 10:20] == 5).all()


@given(
    st.lists(st.tuples(st.floats(-2.5, 4.5), st.floats(0.5, 6.5)), min_size=3, max_size=9),
    st.sampled_from([None, 0, 7]),
)
@settings(deadline=None)
def test_without_numba_the_same_cells_are_drawn(ring, only) -> None:
    by_kernel, by_numpy = drawn(), drawn()
    by_kernel[:, 15:] = by_numpy[:, 15:] = 7
    fill_rings(by_kernel, FRAME, [ring], 3, only)
    with pytest.MonkeyPatch.context() as patch:
        patch.delitem(sys.modules, "numba")
        fill_rings(by_numpy, FRAME, [ring], 3, only)
    assert np.array_equal(by_kernel, by_numpy)


def test_drawing_a_map_loads_no_numba() -> None:
    code = """
import sys
import numpy as np
from mansion_geometry.floor_grid import GridFrame, fill_box
cells = np.zeros((10, 10), dtype=np.int16)
fill_box(cells, GridFrame(0.0, 0.0, 0.1, 10, 10), (0.5, 0.5), (0.4, 0.4), 30.0, 1)
assert cells.any() and "numba" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


def test_a_grid_beyond_the_limit_is_refused() -> None:
    corners = [(0.0, 0.0), (2_000.0, 2_000.0)]
    with pytest.raises(MansionError, match="64000000"):
        GridFrame.around(corners, 0.5, RESOLUTION)
    edges = np.array([[0.0, 0.0, 2_000.0, 0.0], [2_000.0, 0.0, 2_000.0, 2_000.0], [2_000.0, 2_000.0, 0.0, 0.0]])
    with pytest.raises(MansionError, match="64000000"):
        FreeGrid(edges, edges, [])
