"""Grids over shapes."""

import numpy as np
from shapely.geometry import Polygon, box

from mansion_geometry.plane import inside_ring
from mansion_geometry.rasters import cells_in, raster_over, ring_mask


def test_the_raster_starts_at_the_box_and_its_cells_are_square() -> None:
    raster = raster_over(box(1, 2, 9, 6), cells=8)
    assert (raster.x0, raster.y0, raster.resolution) == (1, 2, 1.0)
    x, y = raster.centers()
    assert (x[0], y[0]) == (1.5, 2.5)


def test_a_cell_belongs_to_the_shape_that_holds_its_centre() -> None:
    raster = raster_over(box(0, 0, 4, 4), cells=4)
    assert cells_in(box(0, 0, 2.4, 1), raster).sum() == 2
    assert cells_in(box(0, 0, 2.6, 1), raster).sum() == 3


def test_an_empty_shape_has_no_cells() -> None:
    assert not cells_in(Polygon(), raster_over(box(0, 0, 4, 4))).any()


def test_a_mask_of_a_ring_marks_the_points_inside() -> None:
    ring = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)]
    axis = np.arange(-0.25, 5.5, 0.5)
    mask = ring_mask(np.array(ring), axis, axis)
    assert mask.tolist() == [[inside_ring(ring, x, y) for x in axis.tolist()] for y in axis.tolist()]
