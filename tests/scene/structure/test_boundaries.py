"""Boundaries between regions."""

import math
from types import ModuleType

import pytest
import shapely

from mansion_scene.structure.boundaries import boundary_segments
from mansion_scene.structure.regions import floor_regions


def boundaries_of(request, structural=()):
    return boundary_segments(floor_regions(request), structural)


def test_two_boxes_share_one_wall(sample_floors: ModuleType) -> None:
    rooms = {"a": ("office", sample_floors.box(0, 0, 4, 3)), "b": ("office", sample_floors.box(4, 1, 8, 3))}
    inner = [s for s in boundaries_of(sample_floors.request(rooms, [("a", "b")])) if s.right]
    assert len(inner) == 1
    assert {inner[0].left, inner[0].right} == {"F1/a", "F1/b"}
    assert {inner[0].start, inner[0].end} == {(4.0, 1.0), (4.0, 3.0)}


def test_outer_boundaries_keep_their_room_on_the_left(sample_floors: ModuleType) -> None:
    request = sample_floors.office()
    floor = floor_regions(request)
    for boundary in boundary_segments(floor):
        dx, dy = boundary.direction
        x, y = boundary.at(boundary.length / 2)
        polygon = floor.by_id[boundary.left].polygon
        assert polygon.distance(shapely.Point(x - 0.01 * dy, y + 0.01 * dx)) == 0.0


def test_exterior_boundaries_add_up_to_the_outline(sample_floors: ModuleType) -> None:
    for request in (sample_floors.office(), sample_floors.flat(), sample_floors.random_floor(3)):
        floor = floor_regions(request)
        length = sum(s.length for s in boundary_segments(floor) if s.exterior)
        assert length == pytest.approx(floor.outline.length, abs=0.01)


def test_every_region_is_bounded_by_its_boundaries(sample_floors: ModuleType) -> None:
    floor = floor_regions(sample_floors.office())
    boundaries = boundary_segments(floor)
    for region in floor.regions:
        length = sum(s.length for s in boundaries if region.id in (s.left, s.right))
        assert length == pytest.approx(region.polygon.length, abs=0.01)


def test_a_slanted_wall_is_shared_although_its_points_are_rounded(sample_floors: ModuleType) -> None:
    third = round(10 / 3, 4)
    rooms = {
        "a": ("office", [(0, 0), (5, 0), (0, 10)]),
        "b": ("office", [(5, 0), (10, 0), (10, 10), (5 - third / 2, third)]),
        "c": ("office", [(5 - third / 2, third), (10, 10), (0, 10)]),
    }
    request = sample_floors.request(rooms, [("a", "b"), ("b", "c")])
    shared = {frozenset((s.left, s.right)): s.length for s in boundaries_of(request) if s.right is not None}
    assert shared[frozenset(("F1/a", "F1/b"))] == pytest.approx(math.hypot(third / 2, third), abs=1e-3)
    assert set(shared) == {frozenset(("F1/a", "F1/b")), frozenset(("F1/a", "F1/c")), frozenset(("F1/b", "F1/c"))}


def test_structural_walls_mark_exactly_the_boundaries_on_them(sample_floors: ModuleType) -> None:
    rooms = {"a": ("office", sample_floors.box(0, 0, 4, 6)), "b": ("office", sample_floors.box(4, 0, 8, 6))}
    request = sample_floors.request(rooms, [("a", "b")])
    inner = [s for s in boundaries_of(request, [((4, 0), (4, 2.5))]) if s.right is not None]
    assert [(round(s.length, 3), s.structural) for s in inner] == [(2.5, True), (3.5, False)] or [
        (round(s.length, 3), s.structural) for s in inner
    ] == [(3.5, False), (2.5, True)]


def test_a_structural_wall_that_ends_between_two_rooms_leaves_room_for_their_door(sample_floors: ModuleType) -> None:
    rooms = {"a": ("office", sample_floors.box(0, 0, 4, 1.8)), "b": ("office", sample_floors.box(4, 0, 8, 1.8))}
    request = sample_floors.request(rooms, [("a", "b")])
    (shared,) = [s for s in boundaries_of(request, [((4.0, 1.0), (4.0, 1.8))]) if s.right]
    assert (shared.length, shared.structural) == (1.8, True)


def test_a_courtyard_is_outside(sample_floors: ModuleType) -> None:
    ring = [
        ("south", sample_floors.box(0, 0, 9, 3)),
        ("east", sample_floors.box(6, 3, 9, 6)),
        ("north", sample_floors.box(0, 6, 9, 9)),
        ("west", sample_floors.box(0, 3, 3, 6)),
    ]
    request = sample_floors.request(
        {name: ("office", polygon) for name, polygon in ring},
        [("south", "east"), ("east", "north"), ("north", "west")],
        outline=sample_floors.box(0, 0, 9, 9),
        holes=[sample_floors.box(3, 3, 6, 6)],
    )
    outside = sum(s.length for s in boundaries_of(request) if s.exterior)
    assert outside == pytest.approx(36 + 12)
