"""Small rectangles on a surface: apart from each other, and below what hangs over it."""

from mansion_assets.catalogue import Surface
from mansion_scene.decor.small_objects import Shelf, spot_of


def shelf() -> Shelf:
    return Shelf(Surface(kind="top", x=0.0, y=0.0, z=0.8, w=1.0, d=0.5, clearance=1.0), 1.0)


def test_neighbours_keep_a_gap() -> None:
    board = shelf()
    assert board.place_at((0.2, 0.2, 0.1), 0.0, 0.0, 0.0) is not None
    assert board.place_at((0.2, 0.2, 0.1), 0.205, 0.0, 0.0) is None
    assert board.place_at((0.2, 0.2, 0.1), 0.21, 0.0, 0.0) is not None


def test_only_low_things_stand_below_what_hangs_over() -> None:
    board = shelf()
    board.note_overhead(spot_of((0.4, 0.4, 0.5), -0.3, 0.0, 0.0), 0.3)
    assert board.place_at((0.1, 0.1, 0.4), -0.3, 0.0, 0.0) is None
    assert board.place_at((0.1, 0.1, 0.4), 0.3, 0.0, 0.0) is not None
    assert board.place_at((0.1, 0.1, 0.2), -0.3, 0.0, 0.0) is not None


def test_nothing_reaches_beyond_the_edge_or_the_clearance() -> None:
    board = shelf()
    assert board.place_at((0.2, 0.2, 0.1), 0.41, 0.0, 0.0) is None
    assert board.place_at((0.2, 0.2, 1.0), 0.0, 0.0, 0.0) is None
    assert board.place_at((0.2, 0.2, 0.1), 0.4, 0.0, 0.0) is not None
