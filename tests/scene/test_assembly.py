"""A furnished floor as a whole."""

from types import ModuleType

import pytest
import shapely
from shapely.geometry import LineString, Point, Polygon

from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_scene.assembly import furnish_floor
from mansion_scene.room_contents import room_openings
from mansion_scene.spawn import free_region
from mansion_scene.structure import build_structure


@pytest.fixture(scope="module")
def office(sample_floors: ModuleType) -> FloorScene:
    return furnish_floor(sample_floors.office(2))


def test_the_same_request_gives_the_same_bytes(sample_floors: ModuleType, office: FloorScene) -> None:
    assert encode(furnish_floor(sample_floors.office(2))) == encode(office)


def test_another_seed_gives_another_floor(sample_floors: ModuleType) -> None:
    first, second = (furnish_floor(sample_floors.flat(seed)) for seed in (1, 2))
    assert [o.position for o in first.objects] != [o.position for o in second.objects]


def test_a_scene_survives_the_wire(office: FloorScene) -> None:
    assert decode(FloorScene, encode(office)) == office


def test_every_room_gets_furniture_with_readable_ids(office: FloorScene) -> None:
    for room in office.rooms:
        own = [item for item in office.objects if item.room == room.id]
        assert own, room.id
        assert all(item.id.startswith(f"{room.id}/") for item in own)
    ids = [item.id for group in (office.objects, office.walls, office.doors, office.lights) for item in group]
    assert len(set(ids)) == len(ids)


def test_floor_objects_stand_on_the_floor_inside_their_room_apart(office: FloorScene) -> None:
    nets = {room.id: Polygon(room.net_polygon, room.net_holes) for room in office.rooms}
    standing = [item for item in office.objects if item.mount == "floor" and item.category != "rug"]
    boxes = [footprint(item) for item in standing if item.size[2] > 0.05]
    standing = [item for item in standing if item.size[2] > 0.05]
    for item, ground in zip(standing, boxes, strict=True):
        assert item.position[2] == pytest.approx(item.size[2] / 2, abs=0.01)
        assert ground.difference(nets[item.room]).area < 0.01 * ground.area
    tree = shapely.STRtree(boxes)
    for i, j in tree.query(boxes, predicate="intersects").T.tolist():
        if i < j:
            assert boxes[i].intersection(boxes[j]).area < 1e-4, (standing[i].id, standing[j].id)


def test_doors_stay_clear_of_furniture(office: FloorScene) -> None:
    for door in office.doors:
        middle = LineString(door.segment).interpolate(0.5, normalized=True)
        for room in office.rooms:
            if room.id in door.rooms:
                assert any(part.distance(middle) < 0.5 for part in free_region(room, office.objects))


def test_nothing_hangs_low_beside_a_door(office: FloorScene) -> None:
    hung = [o for o in office.objects if o.mount == "wall" and o.position[2] - o.size[2] / 2 < 1.9]
    assert hung
    for door in office.doors:
        way = LineString(door.segment).buffer(0.6, cap_style="flat")
        for item in hung:
            if item.room in door.rooms:
                assert footprint(item).intersection(way).area < 1e-3, (item.id, door.id)


def test_core_poses_are_free(office: FloorScene) -> None:
    blocks = [footprint(item) for item in office.objects if item.mount == "floor"]
    for core in office.cores:
        here = Point(core.entrance[:2])
        assert min(block.distance(here) for block in blocks) >= 0.2


def test_the_robot_starts_in_the_hub(office: FloorScene) -> None:
    assert office.spawn is not None and office.spawn.room == "F2/lobby"


def test_openings_of_a_room_lie_on_the_boundary_of_its_net_interior(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office())
    for room in structure.rooms:
        boundary = Polygon(room.net_polygon, room.net_holes).boundary
        doors, windows = room_openings(structure, room)
        for opening in (*doors, *windows):
            assert boundary.buffer(2e-3).covers(LineString(opening.segment)), opening.id


def test_progress_is_told_for_every_room_and_ends_at_one(sample_floors: ModuleType) -> None:
    heard: list[tuple[str, float]] = []
    scene = furnish_floor(sample_floors.flat(), progress=lambda what, share: heard.append((what, share)))
    assert [share for _, share in heard] == sorted(share for _, share in heard)
    assert heard[-1][1] == 1.0
    assert {room.id for room in scene.rooms} <= {what for what, _ in heard}


def test_a_failure_names_the_stage(sample_floors: ModuleType) -> None:
    request = sample_floors.flat()
    request.layout.rooms.clear()
    with pytest.raises(MansionError) as caught:
        furnish_floor(request)
    assert caught.value.stage == "furnish_floor" and caught.value.code == "INVALID_PAYLOAD"


def test_overlapping_rooms_are_refused_by_name(sample_floors: ModuleType) -> None:
    rooms = {"a": ("office", sample_floors.box(0, 0, 4, 3)), "b": ("office", sample_floors.box(3, 0, 8, 3))}
    with pytest.raises(MansionError, match="F1/a and F1/b overlap"):
        furnish_floor(sample_floors.request(rooms, [("a", "b")]))
