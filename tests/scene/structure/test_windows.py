"""Windows in outer walls."""

import math
from types import ModuleType

import msgspec
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Polygon

from mansion_msgs_py.outside import Outside
from mansion_scene.structure import FloorStructure, build_structure


def windows_of(structure: FloorStructure, room: str):
    return [window for window in structure.windows if window.room == room]


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10_000))
def test_windows_stand_in_outer_walls_of_their_room_clear_of_doors_and_junctions(
    sample_floors: ModuleType, seed: int
) -> None:
    structure = build_structure(sample_floors.random_floor(seed))
    walls = {wall.id: wall for wall in structure.walls}
    openings = [LineString(door.segment) for door in structure.doors]
    for window in structure.windows:
        wall, line = walls[window.wall], LineString(window.segment)
        assert wall.exterior and wall.left == window.room and wall.right is None
        assert LineString(wall.segment).buffer(1e-3).covers(line)
        assert window.sill + window.height < wall.height
        assert all(line.distance(opening) > 0.25 for opening in openings)
        assert all(math.dist(p, q) > 0.25 for p in window.segment for q in wall.segment)
        openings.append(line)


def test_stores_and_lift_shafts_have_none_and_toilets_small_high_ones(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office())
    assert windows_of(structure, "F1/storage") == []
    assert windows_of(structure, "F1/server_room") == []
    assert windows_of(structure, "elevator_1") == []
    (toilet,) = windows_of(structure, "F1/toilet_1")
    assert toilet.sill >= 1.5 and toilet.height <= 0.6
    (office, *_) = windows_of(structure, "F1/office_2")
    assert 0.7 <= office.sill <= 1.0 and math.dist(*office.segment) > 1.2


def test_basements_have_no_windows(sample_floors: ModuleType) -> None:
    assert build_structure(sample_floors.office(0, floors=(0, 1))).windows == []
    assert build_structure(sample_floors.office(1, floors=(0, 1))).windows != []


def test_windows_stand_on_the_same_lines_on_storeys_with_other_rooms(sample_floors: ModuleType) -> None:
    def middles(wall_at: float) -> set[float]:
        rooms = {
            "left": ("office", sample_floors.box(0, 0, wall_at, 5)),
            "right": ("office", sample_floors.box(wall_at, 0, 16, 5)),
        }
        structure = build_structure(sample_floors.request(rooms, [("left", "right")]))
        south = [w.segment for w in structure.windows if max(w.segment[0][1], w.segment[1][1]) < 0.5]
        return {round((a[0] + b[0]) / 2, 3) for a, b in south}

    storeys = [middles(wall_at) for wall_at in (6.0, 7.3, 9.1)]
    for found in storeys:
        assert len(found) >= 4
        assert all(abs(middle / 0.6 - round(middle / 0.6)) < 1e-3 for middle in found)
    assert len(set.intersection(*storeys)) >= 2


def test_a_shop_shows_its_goods_in_large_windows_beside_the_entrance(sample_floors: ModuleType) -> None:
    def sills(kind: str) -> dict[str, float]:
        rooms = {"left": (kind, sample_floors.box(0, 0, 12, 9)), "right": ("office", sample_floors.box(12, 0, 16, 9))}
        structure = build_structure(sample_floors.request(rooms, [("left", "right")]))
        entrances = [door.segment for door in structure.doors if door.kind == "entrance"]
        front = max(entrances, key=lambda segment: math.dist(*segment))
        axis = 1 if front[0][1] == front[1][1] else 0
        return {
            "front" if w.segment[0][axis] == w.segment[1][axis] == front[0][axis] else "elsewhere": w.sill
            for w in structure.windows
            if w.room.endswith("left")
        }

    assert sills("shop")["front"] < 0.4 < sills("shop")["elsewhere"]
    assert sills("gym")["front"] > 0.4


def test_a_stair_at_an_outer_wall_has_windows_to_look_out_of(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office())
    (stair,) = [core for core in structure.cores if core.type == "stair"]
    outer = Polygon(stair.polygon).boundary.intersection(structure.floor.outline.boundary).length
    windows = windows_of(structure, "stair_1")
    assert bool(windows) == (outer > 1.5)
    assert all(0.9 <= window.sill <= 1.2 for window in windows)


def test_a_glass_facade_has_windows_from_floor_to_ceiling(sample_floors: ModuleType) -> None:
    plain = sample_floors.office()
    glazed = build_structure(msgspec.structs.replace(plain, outside=Outside(facade="glass_panels")))
    assert {wall.right_material for wall in glazed.walls if wall.exterior} == {"glass_panels"}
    high = [window for window in glazed.windows if window.sill < 0.3]
    assert len(high) > len(glazed.windows) / 2
    assert all(window.height > 2.0 for window in high)
    (toilet,) = windows_of(glazed, "F1/toilet_1")
    assert toilet.sill >= 1.5


def test_living_rooms_of_flats_have_windows_down_to_the_floor_upstairs_alone(sample_floors: ModuleType) -> None:
    def sills(floor: int) -> set[float]:
        rooms = {
            "flat": ("apartment", sample_floors.box(0, 0, 12, 9)),
            "bedroom": ("bedroom", sample_floors.box(12, 0, 16, 9)),
        }
        flats = sample_floors.request(
            rooms, [("flat", "bedroom")], floor=floor, floors=(1, 2), building_type="apartment_building"
        )
        structure = build_structure(flats)
        return {window.sill for window in structure.windows if window.room.endswith("flat")}

    assert max(sills(2)) < 0.3 < min(sills(1))
