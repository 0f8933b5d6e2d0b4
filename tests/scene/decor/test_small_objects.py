"""Small rectangles on a surface lie apart and below what hangs over it; clutter tells how many there are."""

from itertools import pairwise

from mansion_assets.catalogue import Surface, load_catalogue
from mansion_scene.decor.small_objects import Shelf, spot_of, with_clutter


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


def test_what_is_always_there_and_place_settings_stay() -> None:
    for arrangement in load_catalogue().arrangements.values():
        for clutter in ("sparse", "dense"):
            (other,) = with_clutter([arrangement], clutter)
            assert other.seats == arrangement.seats
            sure = [slot for slot in arrangement.slots if slot.p == 1.0]
            assert all(slot in other.slots for slot in sure)


def test_scattered_things_are_fewer_usual_and_more() -> None:
    for arrangement in load_catalogue().arrangements.values():
        levels = [with_clutter([arrangement], "sparse")[0], arrangement, with_clutter([arrangement], "dense")[0]]
        amounts = [sum(s.p * (s.min + s.max) / 2 for s in level.scatter) for level in levels]
        assert all(few <= more for few, more in pairwise(amounts)), arrangement.name
