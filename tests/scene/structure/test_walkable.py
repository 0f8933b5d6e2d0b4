"""Doors only where a robot can walk."""

from types import ModuleType

import pytest
from shapely.geometry import Polygon, box

from mansion_scene.structure import build_structure
from mansion_scene.structure.interiors import walkable_parts


def dumbbell(neck: float) -> Polygon:
    return Polygon(
        [
            (0, 0), (4, 0), (4, 2), (6, 2), (6, 0), (9, 0), (9, 4),
            (6, 4), (6, 2 + neck), (4, 2 + neck), (4, 4), (0, 4),
        ]
    )  # fmt: skip


def test_a_room_without_pinch_is_walkable_as_a_whole() -> None:
    parts = walkable_parts({"a": box(0, 0, 3, 4), "b": dumbbell(0.9)})
    assert parts["a"].area == pytest.approx(12.0)
    assert parts["b"].area == pytest.approx(dumbbell(0.9).area)


def test_the_larger_side_of_a_narrow_neck_counts() -> None:
    (part,) = walkable_parts({"a": dumbbell(0.4)}).values()
    assert part.area == pytest.approx(16.0, abs=0.01)
    assert part.bounds[2] == pytest.approx(4.0, abs=1e-3)


def test_a_room_narrower_than_a_passage_has_no_part() -> None:
    assert walkable_parts({"a": box(0, 0, 0.5, 4)})["a"].is_empty


def test_what_only_touches_the_far_side_of_a_neck_is_reached_another_way(sample_floors: ModuleType) -> None:
    rooms = {
        "corridor": ("corridor", list(dumbbell(0.5).exterior.coords[:-1])),
        "near": ("office", sample_floors.box(0, 4, 4, 8)),
        "far": ("office", [(4, 4), (9, 4), (9, 8), (4, 8)]),
        "fill_1": ("storage", [(4, 2.5), (6, 2.5), (6, 4), (4, 4)]),
        "fill_2": ("storage", sample_floors.box(4, 0, 6, 2)),
    }
    edges = [("corridor", "near"), ("corridor", "far"), ("corridor", "fill_1"), ("corridor", "fill_2")]
    structure = build_structure(sample_floors.request(rooms, edges, floor=2))
    pairs = {frozenset(door.rooms) for door in structure.doors}
    assert frozenset(("F2/corridor", "F2/near")) in pairs
    assert frozenset(("F2/corridor", "F2/far")) not in pairs
    assert any("F2/far" in pair for pair in pairs)
    wishes = [downgrade.wish for downgrade in structure.downgrades]
    assert "corridor access far" in wishes
    assert "all of F2/corridor in one piece" in wishes


def test_no_door_opens_into_a_sliver_that_walls_fill(sample_floors: ModuleType) -> None:
    rooms = {
        "flat": ("living_room", [(0, 0), (6, 0), (6, 1.2), (1.5, 1.2), (1.5, 0.03), (0, 0.03)]),
        "bath": ("bathroom", [(0, 0.03), (1.5, 0.03), (1.5, 1.2), (6, 1.2), (6, 4), (0, 4)]),
    }
    structure = build_structure(sample_floors.request(rooms, [("flat", "bath")], floor=2))
    (door,) = structure.doors
    assert all(x >= 1.5 for x, _ in door.segment)


def test_a_wall_that_ends_at_the_wall_of_a_step_holds_a_door_of_full_width(sample_floors: ModuleType) -> None:
    # Of the 1.22 m that both rooms share the wall of the step leaves 0.96 m between its faces.
    rooms = {
        "hall": ("hallway", [(0, 0), (6, 0), (6, 2.3), (6.2, 2.3), (6.2, 2.4), (0, 2.4)]),
        "closet": ("storage", [(6, 0), (8, 0), (8, 2.3), (6, 2.3)]),
        "office": ("office", [(0, 2.4), (4.98, 2.4), (4.98, 6), (0, 6)]),
        "bath": ("bathroom", [(4.98, 2.4), (6.2, 2.4), (6.2, 2.3), (8, 2.3), (8, 6), (4.98, 6)]),
    }
    edges = [("hall", "closet"), ("hall", "office"), ("hall", "bath")]
    structure = build_structure(sample_floors.request(rooms, edges, floor=2))
    (door,) = (door for door in structure.doors if "F2/bath" in door.rooms)
    assert door.width == pytest.approx(0.9)
    assert not [downgrade for downgrade in structure.downgrades if "F2/bath" in downgrade.wish]
