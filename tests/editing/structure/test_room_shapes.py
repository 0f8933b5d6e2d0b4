"""What rooms keep when their walls move."""

from shapely import box

from mansion_editing.structure.room_shapes import limits_of, tidied


def test_a_neighbour_keeps_half_its_area_and_the_least_of_its_type() -> None:
    assert limits_of(box(0, 0, 10, 10), "office").area == 50.0
    assert limits_of(box(0, 0, 3, 4), "bedroom").area == 8.0


def test_a_room_keeps_its_width_and_proportions() -> None:
    limits = limits_of(box(0, 0, 6, 6), "office")
    assert not limits.fault(box(0, 0, 6, 4))
    assert "width" in limits.fault(box(0, 0, 3, 6).union(box(3, 0, 6, 1)))
    assert "slender" in limits.fault(box(0, 0, 12, 3))


def test_a_shape_in_two_pieces_is_none() -> None:
    assert tidied(box(0, 0, 1, 1).union(box(3, 0, 4, 1))) is None


def test_points_on_straight_sides_go() -> None:
    joined = tidied(box(0, 0, 2, 2).union(box(2, 0, 4, 2)))
    assert joined is not None
    assert len(joined.exterior.coords) == 5
