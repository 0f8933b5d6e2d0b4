"""Doors: in walls, clear, apart, hung to swing free, and every room reachable."""

import math
from types import ModuleType

import networkx as nx
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Point, Polygon

from mansion_msgs_py.errors import MansionError
from mansion_scene.structure import FloorStructure, build_structure
from mansion_scene.structure.dimensions import MIN_CLEAR_WIDTH


def check_doors(structure: FloorStructure) -> None:
    walls = {wall.id: wall for wall in structure.walls}
    for door in structure.doors:
        assert math.dist(*door.segment) == pytest.approx(door.width, abs=1e-3)
        assert door.width >= MIN_CLEAR_WIDTH - 1e-6
        if door.kind == "open":
            continue
        wall = walls[door.wall]
        assert {wall.left, wall.right} == set(door.rooms)
        assert LineString(wall.segment).buffer(1e-3).covers(LineString(door.segment))
        assert wall.height > door.height
    for index, door in enumerate(structure.doors):
        for other in structure.doors[:index]:
            one, two = LineString(door.segment), LineString(other.segment)
            if door.kind == other.kind == "open":  # two sides of a room that are open may share a corner
                assert one.intersection(two).length == 0.0
            else:
                assert one.distance(two) > 0.05


def reached(structure: FloorStructure) -> set[str]:
    graph = nx.Graph((a, b) for a, b in (door.rooms for door in structure.doors) if b)
    graph.add_node(structure.rooms[0].id)
    return set(nx.node_connected_component(graph, structure.rooms[0].id))


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000), st.sampled_from([1, 2]))
def test_any_floor_has_doors_in_its_walls_to_every_room(sample_floors: ModuleType, seed: int, floor: int) -> None:
    structure = build_structure(sample_floors.random_floor(seed, floor))
    check_doors(structure)
    assert reached(structure) == {room.id for room in structure.rooms}


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000))
def test_leaves_swing_inside_their_room_and_never_through_another_leaf(sample_floors: ModuleType, seed: int) -> None:
    structure = build_structure(sample_floors.random_floor(seed))
    nets = {room.id: Polygon(room.net_polygon, room.net_holes) for room in structure.rooms}
    leaves = []
    for door in structure.doors:
        if door.hinge == "none" or door.swing is None:
            continue
        tip = leaf_tip(structure, door, nets[door.swing])
        assert nets[door.swing].buffer(5e-3).covers(tip)
        leaves.append((door.swing, tip))
    for index, (room, leaf) in enumerate(leaves):
        for other_room, other in leaves[:index]:
            if room == other_room:
                assert not leaf.crosses(other)


def leaf_tip(structure: FloorStructure, door, net: Polygon) -> LineString:
    """Return the open leaf's outer half, as a line square to the wall."""
    (ax, ay), (bx, by) = door.segment
    dx, dy = (bx - ax) / door.width, (by - ay) / door.width
    x, y = (ax, ay) if door.hinge in ("start", "both") else (bx, by)
    wall = next(wall for wall in structure.walls if wall.id == door.wall)
    reach = door.width / (2 if door.hinge == "both" else 1)
    sides = [(-dy, dx), (dy, -dx)]
    nx_, ny_ = min(sides, key=lambda n: net.distance(Point(x + n[0] * reach, y + n[1] * reach)))
    near = wall.thickness / 2 + 0.02
    return LineString([(x + nx_ * near, y + ny_ * near), (x + nx_ * reach, y + ny_ * reach)])


def test_an_office_floor_gets_the_right_kinds(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office())
    check_doors(structure)
    kinds = {frozenset(map(str, door.rooms)): door.kind for door in structure.doors}
    assert kinds[frozenset(("F1/lobby", "F1/kitchenette"))] == "open"
    assert kinds[frozenset(("F1/lobby", "elevator_1"))] == "sliding"
    assert kinds[frozenset(("F1/lobby", "stair_1"))] == "frame"
    assert kinds[frozenset(("F1/lobby", "F1/meeting_room_1"))] == "glazed"
    assert kinds[frozenset(("F1/lobby", "F1/toilet_1"))] == "single"
    assert kinds[frozenset(("F1/lobby", "None"))] == "entrance"


def test_only_the_ground_floor_has_doors_into_the_open(sample_floors: ModuleType) -> None:
    # Its corridor is so long that one exit is not enough.
    for floor, count in ((1, 2), (2, 0), (0, 0)):
        structure = build_structure(sample_floors.office(floor, floors=(0, 1, 2)))
        assert sum(door.kind == "entrance" for door in structure.doors) == count
        assert all(None not in door.rooms or door.kind == "entrance" for door in structure.doors)


def test_leaves_open_into_rooms_not_into_the_corridor(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office())
    for door in structure.doors:
        if door.kind in ("single", "glazed", "double"):
            assert door.swing != "F1/lobby"


def test_doors_of_the_whole_floor_are_at_least_90_cm_clear(sample_floors: ModuleType) -> None:
    for floor in (1, 2):
        structure = build_structure(sample_floors.office(floor))
        assert min(door.width for door in structure.doors) >= 0.9
        assert structure.downgrades == []


def test_a_public_entrance_is_wider_than_a_house_door(sample_floors: ModuleType) -> None:
    def entrance(request):
        return next(d for d in build_structure(request).doors if d.kind == "entrance")

    assert entrance(sample_floors.office()).width == pytest.approx(1.8)
    assert entrance(sample_floors.flat()).width == pytest.approx(1.0)


def test_a_balcony_gets_a_balcony_door_and_a_parapet(sample_floors: ModuleType) -> None:
    rooms = {
        "living_room": ("living_room", sample_floors.box(0, 0, 6, 5)),
        "balcony": ("balcony", sample_floors.box(0, 5, 6, 7)),
    }
    structure = build_structure(
        sample_floors.request(rooms, [("living_room", "balcony")], open_rooms=["balcony"], floor=2)
    )
    assert [door.kind for door in structure.doors] == ["balcony"]
    rails = [wall for wall in structure.walls if wall.left == "F2/balcony" and wall.exterior]
    assert len(rails) == 3 and all(wall.height == pytest.approx(1.1) for wall in rails)


def test_a_missing_edge_becomes_a_recorded_detour(sample_floors: ModuleType) -> None:
    rooms = {
        "hall": ("hall", sample_floors.box(0, 0, 4, 4)),
        "office_1": ("office", sample_floors.box(4, 0, 8, 4)),
        "office_2": ("office", sample_floors.box(8, 0, 12, 4)),
    }
    structure = build_structure(sample_floors.request(rooms, [("hall", "office_1"), ("hall", "office_2")]))
    assert reached(structure) == {room.id for room in structure.rooms}
    (downgrade,) = structure.downgrades
    assert "hall" in downgrade.wish and "office_2" in downgrade.wish
    assert "F1/office_1" in downgrade.got
    assert downgrade.stage == "furnish_floor"


def test_a_room_that_no_door_can_reach_is_refused(sample_floors: ModuleType) -> None:
    rooms = {
        "hall": ("hall", sample_floors.box(0, 0, 4, 4)),
        "cell": ("office", [(4, 3.5), (8, 3.5), (8, 7), (4, 7)]),
        "other": ("office", sample_floors.box(4, 0, 8, 3)),
    }
    request = sample_floors.request(rooms, [("hall", "other"), ("hall", "cell")], floor=2)
    with pytest.raises(MansionError) as caught:
        build_structure(request)
    assert caught.value.code == "INFEASIBLE"
    assert caught.value.info.details["unreachable"] == ["F2/cell"]


def test_a_short_shared_wall_gives_a_narrow_door_and_a_note(sample_floors: ModuleType) -> None:
    rooms = {
        "hall": ("hall", sample_floors.box(0, 0, 4, 4)),
        "office": ("office", [(4, 3.05), (8, 3.05), (8, 7), (4, 7)]),
        "store": ("storage", sample_floors.box(4, 0, 8, 3.05)),
    }
    structure = build_structure(sample_floors.request(rooms, [("hall", "office"), ("hall", "store")], floor=2))
    door = next(door for door in structure.doors if "F2/office" in door.rooms)
    assert 0.7 <= door.width < 0.9
    assert any("clear" in downgrade.got for downgrade in structure.downgrades)
    check_doors(structure)


def test_a_zone_that_vanished_asks_for_no_door(sample_floors: ModuleType) -> None:
    from mansion_msgs_py.topology import Edge, TopologyNode

    rooms = {"hall": ("hall", sample_floors.box(0, 0, 4, 4)), "office_1": ("office", sample_floors.box(4, 0, 8, 4))}
    request = sample_floors.request(rooms, [])
    request.topology.nodes.append(TopologyNode(id="wing", type="area", area=16.0))
    request.topology.edges[:] = [Edge(source="hall", target="wing"), Edge(source="wing", target="office_1")]
    structure = build_structure(request)
    assert reached(structure) == {"F1/hall", "F1/office_1"}
    assert structure.downgrades == []
