"""Rugs, wall and ceiling objects and small objects of furnished rooms."""

import math

import pytest
from shapely import Polygon

from mansion_assets.catalogue import RoomFurnishing, furnish_request, load_catalogue
from mansion_geometry.object_footprints import footprint, footprint_at
from mansion_msgs_py.codec import encode
from mansion_msgs_py.scene import Door, SceneObject, Wall, Window
from mansion_scene.decor import decorate_room, scene_object
from mansion_scene.decor.frames import to_floor, to_local, wall_edges
from mansion_scene.decor.wall_objects import WallSpace

CATALOGUE = load_catalogue()
RING = [(0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0)]
ROOM = "F1/test_1"
DOOR = Door(
    id="d", kind="single", segment=((2.0, 0.0), (2.9, 0.0)), rooms=(ROOM, None), width=0.9, height=2.1, hinge="start"
)
WINDOW = Window(id="w", wall="", room=ROOM, segment=((2.0, 5.0), (4.0, 5.0)), sill=0.9, height=1.4)


def _stand(wishes: RoomFurnishing) -> list[SceneObject]:
    """Stand one copy of each floor object along three walls, backs to them, as far as they fit."""
    placed: list[SceneObject] = []
    x = 0.1
    for entry in wishes.floor:
        asset = wishes.floor_assets[entry.name]
        w, d, h = asset.size
        if x + w < 5.9 and asset.surfaces:
            number = len(placed) + 1
            placed.append(
                scene_object(
                    asset, f"{ROOM}/{asset.category}_{number}", ROOM, (x + w / 2, 5.0 - d / 2 - 0.01, h / 2), 180.0
                )
            )
            x += w + 0.05
    return placed


def _decorated(
    room_type: str, seed: int, ring: list[tuple[float, float]] = RING
) -> tuple[list[SceneObject], list[SceneObject]]:
    wishes = furnish_request(CATALOGUE, room_type, 30.0, seed=seed, room_id=ROOM, extent=(6.0, 5.0))
    placed = _stand(wishes)
    extra = decorate_room(
        CATALOGUE,
        wishes,
        room_id=ROOM,
        net_polygon=ring,
        ceiling_height=2.7,
        doors=[DOOR],
        windows=[WINDOW],
        placed=placed,
        seed=seed,
    )
    return placed, extra


TYPES = ["meeting_room", "living_room", "kitchen", "bathroom", "reading_room", "laboratory", "workshop", "bar"]


@pytest.mark.parametrize("room_type", TYPES)
@pytest.mark.parametrize("seed", [1, 2])
def test_ids_are_unique_and_everything_is_in_the_room(room_type: str, seed: int) -> None:
    placed, extra = _decorated(room_type, seed)
    ids = [o.id for o in placed + extra]
    assert len(set(ids)) == len(ids)
    room = Polygon(RING).buffer(0.01)
    for o in extra:
        assert all(math.isfinite(v) for v in (*o.position, o.rotation))
        if o.mount != "inside":
            assert room.contains(footprint(o)), o.id
        assert o.position[2] - o.size[2] / 2 >= -1e-6
        assert o.position[2] + o.size[2] / 2 <= 2.7 + 1e-6


@pytest.mark.parametrize("room_type", TYPES)
@pytest.mark.parametrize("seed", [1, 2])
def test_small_objects_rest_on_or_in_their_receptacle_without_overlap(room_type: str, seed: int) -> None:
    placed, extra = _decorated(room_type, seed)
    by_id = {o.id: o for o in placed + extra}
    carried = [o for o in extra if o.parent]
    for o in carried:
        parent = by_id[o.parent or ""]
        asset = CATALOGUE.asset(parent.asset)
        bottom = o.position[2] - o.size[2] / 2 - parent.position[2]
        levels = [s.z for s in asset.surfaces] if o.mount == "surface" else [v.z - v.h / 2 for v in asset.volumes]
        assert min(abs(bottom - z) for z in levels) < 1e-3, o.id
        x, y = to_local(parent, o.position)
        assert abs(x) < parent.size[0] / 2 and abs(y) < parent.size[1] / 2
    for i, a in enumerate(carried):
        for b in carried[i + 1 :]:
            apart = abs(a.position[2] - b.position[2]) > (a.size[2] + b.size[2]) / 2 - 1e-3
            if a.parent == b.parent and not apart:
                shared = footprint(a).intersection(footprint(b))
                assert shared.area < 1e-6, (a.id, b.id)


@pytest.mark.parametrize("room_type", TYPES)
def test_wall_objects_keep_off_doors_windows_and_tall_furniture(room_type: str) -> None:
    placed, extra = _decorated(room_type, 3)
    for o in (o for o in extra if o.mount == "wall" and not o.parent):
        low, high = o.position[2] - o.size[2] / 2, o.position[2] + o.size[2] / 2
        x0, y0, x1, y1 = footprint(o).bounds
        assert not (y0 < 0.05 and x0 < 2.9 and x1 > 2.0), o.id
        assert not (y1 > 4.95 and x0 < 4.0 and x1 > 2.0 and low < 2.3 and high > 0.9), o.id
        assert min(x0, y0, 6.0 - x1, 5.0 - y1) < 0.01, o.id
        for f in placed:
            if low < f.size[2] and high > 0.0:
                assert not footprint(o).intersects(footprint(f)), (o.id, f.id)


def test_a_rug_lies_below_the_coffee_table_and_can_be_walked_on() -> None:
    table = CATALOGUE.by_category("coffee_table")[0]
    stood = scene_object(table, f"{ROOM}/coffee_table_1", ROOM, (3.0, 2.5, table.size[2] / 2), 0.0)
    found = []
    for seed in range(8):
        wishes = furnish_request(CATALOGUE, "living_room", 30.0, seed=seed, room_id=ROOM)
        extra = decorate_room(
            CATALOGUE, wishes, room_id=ROOM, net_polygon=RING, ceiling_height=2.7, placed=[stood], seed=seed
        )
        found += [o for o in extra if o.mount == "floor"]
    assert len(found) >= 4
    for o in found:
        assert o.size[2] <= 0.02
        rug = footprint(o)
        assert rug.contains(footprint(stood))


def test_lamps_keep_headroom_and_ceiling_objects_do_not_overlap() -> None:
    _, extra = _decorated("meeting_room", 4)
    hung = [o for o in extra if o.mount == "ceiling"]
    assert hung
    for i, a in enumerate(hung):
        assert a.position[2] + a.size[2] / 2 == pytest.approx(2.7, abs=1e-3)
        for b in hung[i + 1 :]:
            assert not footprint(a).intersects(footprint(b))


def test_the_same_seed_decorates_alike_and_another_does_not() -> None:
    assert encode(_decorated("kitchen", 5)[1]) == encode(_decorated("kitchen", 5)[1])
    assert encode(_decorated("kitchen", 5)[1]) != encode(_decorated("kitchen", 6)[1])


def test_an_l_shaped_room_is_decorated_within_its_walls() -> None:
    ring = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (3.0, 2.0), (3.0, 5.0), (0.0, 5.0)]
    wishes = furnish_request(CATALOGUE, "lobby", 21.0, seed=1, room_id=ROOM)
    extra = decorate_room(CATALOGUE, wishes, room_id=ROOM, net_polygon=ring, ceiling_height=3.0, doors=[DOOR], seed=1)
    shape = Polygon(ring).buffer(0.01)
    assert any(o.mount == "ceiling" for o in extra) and any(o.mount == "wall" for o in extra)
    assert all(shape.contains(footprint(o)) for o in extra if not o.parent)


@pytest.mark.parametrize(
    "ring",
    [
        pytest.param([(0, 0), (4, 0), (4, 1.3), (5.5, 1.3), (5.5, 1.345), (0, 1.345)], id="a shallow tail"),
        pytest.param([(0, 0), (6, 0), (6, 1.4), (3.2, 1.4), (3.0, 0.04), (2.8, 1.4), (0, 1.4)], id="a pillar"),
    ],
)
def test_what_hangs_on_a_wall_is_no_deeper_than_the_room_before_it(ring: list[tuple[float, float]]) -> None:
    room = Polygon(ring).buffer(1e-3)
    hung = 0
    for seed in range(6):
        for room_type in ("living_room", "meeting_room"):
            wishes = furnish_request(CATALOGUE, room_type, 30.0, seed=seed, room_id=ROOM, extent=(6.0, 1.4))
            extra = decorate_room(
                CATALOGUE, wishes, room_id=ROOM, net_polygon=ring, ceiling_height=2.7, placed=[], seed=seed
            )
            walled = [o for o in extra if o.mount == "wall"]
            hung += len(walled)
            assert [o.id for o in walled if not room.contains(footprint(o))] == []
    assert hung > 20


@pytest.mark.parametrize("height", [0.5, 1.1, 4.0])
def test_what_hangs_keeps_off_a_pointed_corner(height: float) -> None:
    ring = [(0.0, 0.0), (4.0, 0.0), (0.0, height)]
    sides = wall_edges(ring)
    room, depth = Polygon(ring).buffer(1e-6), 0.09
    for wall in (WallSpace(side, sides) for side in sides):
        for along in (end for gap in wall.gaps(0.3, 1.0, 1.5, depth) for end in gap):
            shape = footprint_at(wall.edge.point(along, depth / 2), (0.3, depth, 0.5), wall.edge.rotation)
            assert room.covers(shape)


def test_a_receptacles_frame_turns_with_it() -> None:
    desk = scene_object(CATALOGUE.asset("office_desk_1"), f"{ROOM}/office_desk_1", ROOM, (2.0, 3.0, 0.37), 90.0)
    assert to_floor(desk, (0.0, 1.0)) == pytest.approx((1.0, 3.0))
    assert to_local(desk, (1.0, 3.0)) == pytest.approx((0.0, 1.0))


def test_nothing_hangs_over_a_parapet() -> None:
    walls = [WallSpace(edge) for edge in wall_edges(RING)]
    parapet = Wall(id="p", segment=((0.0, -0.12), (6.0, -0.12)), thickness=0.24, height=1.1, left=ROOM)
    for wall in walls:
        wall.block_above([parapet])
    over = [wall.gaps(0.4, 1.6, 2.0, 0.1) for wall in walls]
    assert sum(not gaps for gaps in over) == 1
    assert all(wall.gaps(0.4, 0.3, 0.7, 0.1) for wall in walls)


def test_mats_lie_in_a_block_of_rows() -> None:
    ring = [(0.0, 0.0), (9.0, 0.0), (9.0, 6.0), (0.0, 6.0)]
    wishes = furnish_request(CATALOGUE, "yoga_studio", 54.0, seed=1, room_id=ROOM, extent=(9.0, 6.0))
    extra = decorate_room(CATALOGUE, wishes, room_id=ROOM, net_polygon=ring, ceiling_height=2.8, seed=1)
    mats = [o for o in extra if o.category == "yoga_mat"]
    columns, rows = ({round(o.position[axis], 3) for o in mats} for axis in (0, 1))
    assert len(columns) * len(rows) == len(mats) == 8
