"""Moves of walls between plain rectangles: how far, in which order, and what stays."""

import pytest
from shapely import box

from mansion_editing.structure.room_shapes import limits_of
from mansion_editing.structure.wall_moves import most_area, plans

SHAPES = {"a": box(0, 0, 4, 5), "b": box(4, 0, 10, 5), "c": box(0, 5, 4, 9)}
LIMITS = {name: limits_of(shape, "office", gives=name != "a") for name, shape in SHAPES.items()}


def test_the_whole_wall_moves_by_the_area_over_its_length() -> None:
    plan = next(plans("a", 5.0, ["b", "c"], SHAPES, LIMITS))
    assert [(move.giver, move.shift) for move in plan.moves] == [("b", pytest.approx((1.0, 0.0), abs=1e-3))]
    assert plan.shapes["a"].equals(box(0, 0, 5, 5))
    assert plan.shapes["c"] is SHAPES["c"]


def test_a_room_that_shrinks_gives_to_a_neighbour() -> None:
    plan = next(plans("a", -5.0, ["b", "c"], SHAPES, LIMITS))
    (move,) = plan.moves
    assert (move.gainer, plan.shapes["a"].area) == (move.gainer, pytest.approx(15.0))
    assert plan.shapes[move.gainer].area == pytest.approx(SHAPES[move.gainer].area + 5.0)


def test_several_walls_move_where_one_is_not_enough() -> None:
    plan = next(plans("a", 20.0, ["b", "c"], SHAPES, LIMITS))
    assert {move.giver for move in plan.moves} == {"b", "c"}
    assert plan.shapes["a"].area == pytest.approx(40.0, rel=0.01)


def test_no_plan_takes_more_than_neighbours_can_give() -> None:
    assert not list(plans("a", 40.0, ["b", "c"], SHAPES, LIMITS))
    assert most_area("a", ["b", "c"], SHAPES, LIMITS, grow=True) <= 20.0 + 15.0 + 8.0 + 1e-6


def test_a_wall_does_not_move_past_a_structural_one() -> None:
    limits = LIMITS | {"a": limits_of(SHAPES["a"], "office", [((4.5, 0.0), (4.5, 5.0))], gives=False)}
    assert not list(plans("a", 5.0, ["b"], SHAPES, limits))
    assert list(plans("a", 2.0, ["b"], SHAPES, limits))
