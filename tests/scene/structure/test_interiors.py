"""Net interiors and open boundaries."""

from types import ModuleType

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Polygon

from mansion_scene.structure import build_structure
from mansion_scene.structure.dimensions import CLEAR_WIDTH, INTERIOR_THICKNESS


def net(room) -> Polygon:
    return Polygon(room.net_polygon, room.net_holes)


def test_walls_take_half_their_thickness_on_inner_sides_only(sample_floors: ModuleType) -> None:
    rooms = {"a": ("office", sample_floors.box(0, 0, 4, 3)), "b": ("office", sample_floors.box(4, 0, 8, 3))}
    structure = build_structure(sample_floors.request(rooms, [("a", "b")]))
    assert net(structure.rooms[0]).bounds == (0.0, 0.0, 3.94, 3.0)
    assert net(structure.rooms[1]).bounds == (4.06, 0.0, 8.0, 3.0)


def test_corners_of_a_notched_room_are_mitred(sample_floors: ModuleType) -> None:
    rooms = {
        "hall": ("hall", [(0, 0), (6, 0), (6, 4), (4, 4), (4, 6), (0, 6)]),
        "bath": ("bathroom", sample_floors.box(4, 4, 6, 6)),
    }
    structure = build_structure(sample_floors.request(rooms, [("hall", "bath")]))
    half = INTERIOR_THICKNESS / 2
    assert net(structure.rooms[0]).area == pytest.approx(32 - 2 * 2 * half - half * half, abs=1e-6)
    assert net(structure.rooms[1]).bounds == (4.06, 4.06, 6.0, 6.0)


def test_open_rooms_meet_without_a_wall(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.flat())
    opening = next(door for door in structure.doors if door.kind == "open")
    living, kitchen = (next(r for r in structure.rooms if r.id == name) for name in opening.rooms)
    assert opening.wall == ""
    assert net(living).intersection(net(kitchen)).length == pytest.approx(opening.width, abs=0.01)
    line = LineString(opening.segment)
    for wall in structure.walls:
        assert LineString(wall.segment).intersection(line).length == pytest.approx(0.0, abs=1e-6)


def test_an_open_structural_wall_keeps_its_ends(sample_floors: ModuleType) -> None:
    rooms = {
        "living": ("living_room", sample_floors.box(0, 0, 5, 5)),
        "dining": ("dining_room", sample_floors.box(5, 0, 9, 5)),
    }
    request = sample_floors.request(
        rooms, [("living", "dining")], open_rooms=["dining"], structural_walls=[((5.0, 0.0), (5.0, 5.0))]
    )
    structure = build_structure(request)
    ends = [wall for wall in structure.walls if wall.structural]
    assert len(ends) == 2
    assert structure.doors[0].width == pytest.approx(5 - 2 * 0.3)


@pytest.mark.parametrize("front", [1.2, 1.3, 1.5, 1.62, 1.7, 2.2])
def test_an_open_structural_front_leaves_room_to_pass_however_short_it_is(
    sample_floors: ModuleType, front: float
) -> None:
    rooms = {
        "lobby": ("lobby", sample_floors.box(0, 0, 6, 2)),
        "desk": ("checkout_area", sample_floors.box(0, 2, front, 4)),
        "store": ("storage", sample_floors.box(front, 2, 6, 4)),
    }
    edges = [("lobby", "desk"), ("lobby", "store")]
    request = sample_floors.request(
        rooms, edges, open_rooms=["desk"], structural_walls=[((0.0, 2.0), (6.0, 2.0))]
    )  # fmt: skip
    (opening,) = [door for door in build_structure(request).doors if door.kind == "open"]
    assert opening.width >= CLEAR_WIDTH


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10_000))
def test_net_interiors_lie_in_their_rooms_and_off_the_walls(sample_floors: ModuleType, seed: int) -> None:
    structure = build_structure(sample_floors.random_floor(seed))
    nets = [net(room) for room in structure.rooms]
    walls = [LineString(wall.segment).buffer(wall.thickness / 2 - 1e-3, cap_style="flat") for wall in structure.walls]
    for room, inner in zip(structure.rooms, nets, strict=True):
        assert inner.is_valid and inner.area > 0
        assert Polygon(room.polygon).buffer(1e-6).covers(inner)
        assert all(inner.intersection(wall).area < 1e-3 for wall in walls)
        assert sum(inner.intersection(other).area for other in nets) == pytest.approx(inner.area)
