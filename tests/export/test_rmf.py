"""The map and the lanes for Open-RMF, read back as Open-RMF's own readers do."""

import math
from collections import deque
from functools import cache
from itertools import pairwise
from typing import Any

import msgspec
import numpy as np
import pytest
import shapely
import shapely.affinity
import yaml
from shapely.geometry import LineString, Point, Polygon, box

from mansion_export.nav2 import OCCUPIED, UNKNOWN, occupancy
from mansion_export.rmf.lane_paths import FreeRegion
from mansion_export.rmf.maps import door_params, rmf_files, yaml_text
from mansion_msgs_py.scene import Door, FloorScene, SceneObject

RADIUS = 0.2
GAP = 0.05  # between cabin and shaft, in building_map/lift.py


def _named_alike(scene: FloorScene) -> FloorScene:
    """Give cores the same id on every floor, as the pipeline does."""
    prefix = f"F{scene.floor}/"
    cores = {core.id: core.id.removeprefix(prefix) for core in scene.cores}
    return msgspec.structs.replace(
        scene,
        cores=[msgspec.structs.replace(core, id=cores[core.id]) for core in scene.cores],
        doors=[
            msgspec.structs.replace(door, rooms=tuple(cores.get(key, key) for key in door.rooms))
            for door in scene.doors
        ],
    )


@pytest.fixture
def floors(building: list[FloorScene]) -> list[FloorScene]:
    """Two floors that a lift joins."""
    return [_named_alike(scene) for scene in building]


def _read(scenes: list[FloorScene], radius: float = RADIUS) -> tuple[dict[str, Any], dict[str, Any]]:
    files = _files(msgspec.json.encode(scenes), radius)
    return (yaml.safe_load(files["sample_house.building.yaml"]), yaml.safe_load(files["nav_graphs/0.yaml"]))


@cache
def _files(scenes: bytes, radius: float) -> dict[str, bytes]:
    return rmf_files(msgspec.json.decode(scenes, type=list[FloorScene]), radius)


class FleetGraph:
    """A navigation graph as ``rmf_fleet_adapter/agv/parse_graph.cpp`` reads it."""

    def __init__(self, graph: dict[str, Any]) -> None:
        self.places: list[tuple[str, Point, dict[str, Any]]] = []
        self.lanes: list[tuple[int, int, str]] = []
        self.keys: dict[str, int] = {}
        riding: dict[str, list[int]] = {}
        for level, content in graph["levels"].items():
            first = len(self.places)
            for x, y, options in content["vertices"]:
                if options.get("name"):
                    assert options["name"] not in self.keys, "Duplicated waypoint name"
                    self.keys[options["name"]] = len(self.places)
                if options.get("lift"):
                    assert options["lift"] in graph["lifts"], "Lift properties were not provided"
                    riding.setdefault(options["lift"], []).append(len(self.places))
                self.places.append((level, Point(float(x), float(y)), options))
            for start, end, options in content["lanes"]:
                a, b = first + start, first + end
                lifts = {self.places[i][2].get("lift") for i in (a, b)} - {None}
                assert len(lifts) <= 1, "two connected waypoints that are in different lifts"
                self.lanes.append((a, b, options.get("door_name", "")))
        self.rides = [pair for stops in riding.values() for pair in pairwise(stops)]
        for a, b in self.rides:
            assert self.places[a][1].distance(self.places[b][1]) <= 0.1, "Bad vertical alignment"

    def reached_from(self, start: int) -> set[int]:
        """Return where a robot can drive and ride to."""
        after: dict[int, list[int]] = {}
        for a, b, _ in [*self.lanes, *((a, b, "") for a, b in self.rides)]:
            after.setdefault(a, []).append(b)
        for a, b in self.rides:
            after.setdefault(b, []).append(a)
        seen, queue = {start}, deque([start])
        while queue:
            for other in after.get(queue.popleft(), []):
                if other not in seen:
                    seen.add(other)
                    queue.append(other)
        return seen

    def charger(self) -> int:
        """Return the first charger."""
        return next(i for i, (_, _, options) in enumerate(self.places) if options.get("is_charger"))


def _generated(building: dict[str, Any]) -> dict[str, Any]:
    """Return the levels' graphs that ``building_map/level.py`` makes of a building map in metres."""
    assert building["coordinate_system"] == "cartesian_meters"
    shafts = {name: _shaft(lift) for name, lift in building["lifts"].items()}
    found = {}
    for name, level in building["levels"].items():
        points = [(x, y) for x, y, *_ in level["vertices"]]
        doors = [(LineString([points[a], points[b]]), params["name"][1]) for a, b, params in level["doors"]]
        number: dict[int, int] = {}
        lanes = []
        for a, b, params in level["lanes"]:
            assert params["bidirectional"] == [4, True]
            assert params["graph_idx"] == [2, 0]
            i, j = (number.setdefault(k, len(number)) for k in (a, b))
            lane = LineString([points[a], points[b]])
            crossed = [door for line, door in doors if line.intersects(lane)]
            options = {"door_name": crossed[-1]} if crossed else {}
            lanes += [[i, j, options], [j, i, options]]
        vertices = []
        for k in number:
            x, y, _, label, marks = level["vertices"][k]
            options = {"name": label} | {key: value for key, (_, value) in marks.items()}
            lift = [key for key, shaft in shafts.items() if shaft.covers(Point(x, y))]
            vertices.append([x, y, options | ({"lift": lift[0]} if lift else {})])
        found[name] = {"vertices": vertices, "lanes": lanes}
    return found


def _shaft(lift: dict[str, Any]) -> Polygon:
    half_w, half_d = lift["width"] / 2 + GAP, lift["depth"] / 2 + GAP
    turned = shapely.affinity.rotate(
        box(-half_w, -half_d, half_w, half_d), lift["yaw"], origin=(0, 0), use_radians=True
    )
    return shapely.affinity.translate(turned, lift["x"], lift["y"])


def _opened(scene: FloorScene) -> FloorScene:
    doors = [msgspec.structs.replace(door, is_open=True) for door in scene.doors]
    return msgspec.structs.replace(scene, doors=doors)


def _lines(graph: dict[str, Any], level: str) -> list[LineString]:
    content = graph["levels"][level]
    return [LineString([content["vertices"][k][:2] for k in (a, b)]) for a, b, _ in content["lanes"]]


def test_the_fleet_adapter_joins_every_waypoint_to_the_charger(floors: list[FloorScene]) -> None:
    graph = FleetGraph(_read(floors)[1])
    assert graph.reached_from(graph.charger()) == set(range(len(graph.places)))
    assert {level for level, _, _ in graph.places} == {"F1", "F2"}
    assert len(graph.rides) == 1


def test_the_map_generates_the_same_lanes(floors: list[FloorScene]) -> None:
    building, graph = _read(floors)
    assert _generated(building) == graph["levels"]


def test_lanes_keep_the_radius_off_furniture(floors: list[FloorScene]) -> None:
    graph = _read(floors)[1]
    for scene in floors:
        lanes = shapely.union_all(_lines(graph, f"F{scene.floor}"))
        for item in scene.objects:
            if item.mount == "floor" and item.size[2] > 0.05:
                (x, y, _), (w, d, _) = item.position, item.size
                shape = shapely.affinity.rotate(box(x - w / 2, y - d / 2, x + w / 2, y + d / 2), item.rotation)
                assert shape.distance(lanes) >= RADIUS, item.id


def test_lanes_keep_the_radius_off_what_the_nav2_map_blocks(floors: list[FloorScene]) -> None:
    graph = _read(floors)[1]
    for scene in floors:
        grid = occupancy(_opened(scene))
        rows, columns = np.nonzero(grid.data == OCCUPIED)
        blocked = np.stack([columns, rows], axis=1) * grid.resolution + grid.origin + 0.025
        for line in _lines(graph, f"F{scene.floor}"):
            for step in np.linspace(0.0, 1.0, max(2, int(line.length / 0.05))):
                point = line.interpolate(float(step), normalized=True)
                row, column = grid.cell(point.x, point.y)
                assert grid.data[row, column] not in (OCCUPIED, UNKNOWN)
                nearest = np.hypot(*(blocked - (point.x, point.y)).T).min()
                assert nearest >= RADIUS - grid.resolution / 2 - 1e-6


def test_every_room_that_the_nav2_map_reaches_is_named(floors: list[FloorScene]) -> None:
    graph = FleetGraph(_read(floors)[1])
    for scene in floors:
        grid = occupancy(_opened(scene))
        cells = _reached(grid.data == 0, grid.cell(scene.spawn.x, scene.spawn.y), round(0.25 / 0.05))
        rooms = [room for room in scene.rooms if _holds_any(room.polygon, cells, grid)]
        assert len(rooms) == 6
        assert [room.id for room in rooms if room.id not in graph.keys] == []


def _reached(free: np.ndarray, start: tuple[int, int], radius: int) -> set[tuple[int, int]]:
    wide = free.copy()
    for dy in range(-radius, radius + 1):
        for dx in range(-radius, radius + 1):
            if dx * dx + dy * dy <= radius * radius:
                wide &= np.roll(free, (dy, dx), axis=(0, 1))
    seen, queue = {start}, deque([start])
    while queue:
        i, j = queue.popleft()
        for cell in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            if wide[cell] and cell not in seen:
                seen.add(cell)
                queue.append(cell)
    return seen


def _holds_any(ring: Any, cells: set[tuple[int, int]], grid: Any) -> bool:
    places = np.array(sorted(cells))[:, ::-1] * grid.resolution + grid.origin + 0.025
    return bool(shapely.contains_xy(Polygon(ring).buffer(-0.3), places[:, 0], places[:, 1]).any())


def test_lanes_name_the_doors_that_must_open(floors: list[FloorScene]) -> None:
    building, graph = _read(floors)
    content = graph["levels"]["F1"]
    named = {options["door_name"] for _, _, options in content["lanes"] if options}
    assert named == {"F1/door_1", "F1/door_2", "F1/door_3", "F1/door_5"}
    assert named < {params["name"][1] for _, _, params in building["levels"]["F1"]["doors"]}
    assert named < set(graph["doors"])
    assert graph["doors"]["F1/entrance"]["map"] == "F1"


def test_walls_are_open_where_lanes_lead(floors: list[FloorScene]) -> None:
    building, graph = _read(floors)
    for name, level in building["levels"].items():
        places = [point[:2] for point in level["vertices"]]
        walls = shapely.union_all([LineString([places[a], places[b]]) for a, b, _ in level["walls"]])
        assert walls.length > 60
        assert walls.distance(shapely.union_all(_lines(graph, name))) >= RADIUS


def test_furniture_before_a_door_leaves_its_room_out(floors: list[FloorScene]) -> None:
    chest = SceneObject(
        id="F1/bedroom_1/chest",
        room="F1/bedroom_1",
        category="chest",
        asset="chest",
        position=(2.45, 6.5, 0.3),
        rotation=0.0,
        size=(2.0, 0.6, 0.6),
    )
    blocked = msgspec.structs.replace(floors[0], objects=[*floors[0].objects, chest])
    graph = FleetGraph(_read([blocked, floors[1]])[1])
    assert "F1/bedroom_1" not in graph.keys
    assert {"F1/kitchen_1", "F2/bedroom_1"} <= set(graph.keys)


def test_a_wide_robot_leaves_narrow_doors_out(floors: list[FloorScene]) -> None:
    graph = FleetGraph(_read(floors, radius=0.47)[1])
    assert "F1/door_1" not in {door for _, _, door in graph.lanes}
    assert "F1/door_5" in {door for _, _, door in graph.lanes}


def test_each_floor_has_a_charger_where_no_lift_joins_them(floors: list[FloorScene]) -> None:
    apart = [
        msgspec.structs.replace(scene, cores=[core for core in scene.cores if core.type == "stair"]) for scene in floors
    ]
    graph = FleetGraph(_read(apart)[1])
    chargers = [level for level, _, options in graph.places if options.get("is_charger")]
    assert chargers == ["F1", "F2"]


def test_a_leaf_hangs_from_its_edge_and_turns_into_its_room(floors: list[FloorScene]) -> None:
    """In ``swing_door.py`` a leaf hangs from the start and turns to the left for a negative direction."""
    scene = floors[0]
    building = _read(floors)[0]
    level = building["levels"]["F1"]
    places = [point[:2] for point in level["vertices"]]
    rooms = {room.id: Polygon(room.polygon) for room in scene.rooms}
    edges = {params["name"][1]: (places[a], places[b], params) for a, b, params in level["doors"]}
    for door in scene.doors:
        if door.hinge not in ("start", "end"):
            continue
        (ax, ay), (bx, by), params = edges[door.id]
        hinge = door.segment[0] if door.hinge == "start" else door.segment[1]
        assert (ax, ay) == pytest.approx(hinge)
        turn = math.copysign(math.pi / 2, -params["motion_direction"][1])
        dx, dy = 0.8 * (bx - ax), 0.8 * (by - ay)
        tip = Point(ax - dy * math.sin(turn), ay + dx * math.sin(turn))
        assert rooms[door.swing].buffer(0.2).covers(tip), door.id


@pytest.mark.parametrize(
    ("hinge", "kind", "style"),
    [
        ("start", "single", "hinged"),
        ("both", "double", "double_hinged"),
        ("none", "glazed", "double_sliding"),
        ("none", "garage", "sliding"),
    ],
)
def test_doors_have_a_type_that_the_generator_knows(
    floors: list[FloorScene], hinge: Any, kind: Any, style: str
) -> None:
    door: Door = msgspec.structs.replace(floors[0].doors[0], hinge=hinge, kind=kind)
    assert door_params(door, *door.segment, floors[0])["type"] == [1, style]


def test_levels_and_lifts_stand_where_they_are(floors: list[FloorScene]) -> None:
    building = _read(floors)[0]
    assert [level["elevation"] for level in building["levels"].values()] == [0.0, 3.4]
    lift = building["lifts"]["lift"]
    assert (lift["x"], lift["y"]) == (10.0, 7.0)
    assert lift["level_doors"] == {"F1": ["door"], "F2": ["door"]}
    # The landing door is at y = 6, below the shaft: the lift's own y axis points there.
    assert (-math.sin(lift["yaw"]), math.cos(lift["yaw"])) == pytest.approx((0.0, -1.0), abs=1e-4)


def test_floors_in_any_order_make_the_same_bytes(floors: list[FloorScene]) -> None:
    assert rmf_files(floors) == rmf_files(floors[::-1])


def test_a_way_round_a_corner_branches_and_stays_on_the_floor() -> None:
    piece = FreeRegion(Polygon([(0, 0), (6, 0), (6, 1), (1, 1), (1, 5), (0, 5)]))
    goals = [(5.5, 0.5), (0.5, 4.5), (3.0, 0.2)]
    ways = piece.lane_tree((0.5, 2.0), goals)
    assert {point for way in ways for point in way} >= {(0.5, 2.0), *goals}
    assert all(piece.connects(a, b) for a, b in ways)
    assert len(ways) < 15


@pytest.mark.parametrize("name", ["yes", "1", "a: b", "Küche #2", "'", '"', "null", "~", "- x"])
def test_names_come_back_from_yaml(name: str) -> None:
    value: Any = {name: {"b": [[1.5, name, {name: True}]]}, "c": 2, "d": []}
    assert yaml.safe_load(yaml_text(value)) == value
