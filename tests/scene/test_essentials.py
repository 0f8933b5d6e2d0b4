"""Rooms have what they cannot be used without, or the scene tells what is missing; bedrooms are for one or two."""

import msgspec
import pytest

import sample_floors as floors
from mansion_assets.catalogue import load_catalogue
from mansion_geometry.object_footprints import footprint
from mansion_knowledge import default_knowledge
from mansion_knowledge.essentials import needs_of, pieces_there
from mansion_knowledge.furnished_as import furnished_as
from mansion_msgs_py.program import RequestedObject, RoomProgram
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_scene.assembly import furnish_floor
from mansion_scene.essentials import slept_in_as

NOT_IN_THE_CATALOGUE = {"bowling_alley"}


def furnished(
    room_type: str, width: float, depth: float, *, seed: int = 0, name: str = "", unwanted: tuple[str, ...] = ()
) -> FloorScene:
    rooms = {
        "corridor": ("corridor", floors.box(0, depth, width, depth + 2.4)),
        "room": (room_type, floors.box(0, 0, width, depth)),
    }
    made = floors.request(rooms, [("corridor", "room")], seed=seed)
    asked = [RequestedObject(category=category, count=0) for category in unwanted]
    room = RoomProgram(id="room", area_estimate=width * depth, room_type=room_type, name=name, objects=asked)
    return furnish_floor(msgspec.structs.replace(made, floor=msgspec.structs.replace(made.floor, rooms=[room])))


def own(scene: FloorScene) -> list[SceneObject]:
    return [item for item in scene.objects if item.room == "F1/room"]


def missing(scene: FloorScene, room_type: str, name: str = "") -> list[str]:
    room_type = furnished_as(room_type, scene.building_type, name, ())
    things = [(item.category, item.size[0]) for item in own(scene)]
    return [need.name for need in needs_of(room_type, [name]) if pieces_there(need, things) < need.count]


@pytest.mark.parametrize("room_type", sorted(set(default_knowledge().rooms) - NOT_IN_THE_CATALOGUE))
def test_a_room_of_usual_area_can_be_used(room_type: str) -> None:
    area = default_knowledge().rooms[room_type].usual
    depth = (area / 1.3) ** 0.5
    assert missing(furnished(room_type, 1.3 * depth, depth), room_type) == []


@pytest.mark.parametrize(
    ("room_type", "area"),
    [("bathroom", 3.2), ("ensuite_bathroom", 3.1), ("toilet", 2.0), ("sauna", 4.8), ("server_room", 4.0)],
)
@pytest.mark.parametrize("aspect", [1.0, 1.35, 1.8])
def test_a_small_room_can_be_used(room_type: str, area: float, aspect: float) -> None:
    depth = (area / aspect) ** 0.5
    for seed in range(2):
        scene = furnished(room_type, aspect * depth, depth, seed=seed)
        assert missing(scene, room_type) == []
        shapes = [footprint(item) for item in own(scene) if item.mount == "floor" and item.size[2] > 0.05]
        assert all(a.intersection(b).area < 1e-4 for n, a in enumerate(shapes) for b in shapes[:n])


@pytest.mark.parametrize(
    ("room_type", "name", "count"), [("bedroom", "Double Bedroom", 2), ("bathroom", "Shower Room", 1)]
)
def test_a_room_has_what_its_name_says(room_type: str, name: str, count: int) -> None:
    (need,) = needs_of(room_type, [name])
    assert need.count == count
    for seed in range(4):
        assert missing(furnished(room_type, 4.0, 3.2, seed=seed, name=name), room_type, name) == []


def test_what_has_no_place_is_told_with_its_size() -> None:
    told = [lost for lost in furnished("bathroom", 1.3, 1.2).discarded if lost.name == "shower or bathtub"]
    assert [(lost.room, lost.count, lost.reason) for lost in told] == [
        ("F1/room", 1, "no place of 0.8 x 0.8 m that can be reached is free")
    ]
    (lost,) = [lost for lost in furnished("bowling_alley", 12.0, 9.0).discarded if lost.name == "bowling lane"]
    assert lost.reason == "the catalogue has none"


def test_what_a_brief_does_not_want_is_not_put_there_for_its_use() -> None:
    scene = furnished("bathroom", 3.0, 2.4, unwanted=("toilet",))
    assert missing(scene, "bathroom") == ["toilet"]
    assert not any(lost.name == "toilet" for lost in scene.discarded)


def test_needs_are_met_by_things_of_the_catalogue() -> None:
    catalogue = load_catalogue()
    unmet = {
        name
        for name in default_knowledge().rooms
        for need in needs_of(name)
        if not any(catalogue.by_category(category) for category in need.categories)
    }
    assert unmet == NOT_IN_THE_CATALOGUE


def bedroom(number: int, area: float, *, room_type: str = "bedroom", name: str = "") -> SceneRoom:
    side = area**0.5
    square = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
    return SceneRoom(
        id=f"F1/{room_type}_{number}",
        room_type=room_type,
        name=name or f"Bedroom {number}",
        polygon=square,
        net_polygon=square,
        area=area,
        kind="area",
    )


@pytest.mark.parametrize("building", ["house", "flat", "some_new_kind_of_home"])
def test_the_largest_bedroom_of_a_home_is_for_two(building: str) -> None:
    rooms = [bedroom(1, 10.0), bedroom(2, 14.0), bedroom(3, 9.0)]
    assert [slept_in_as(room, rooms, building) for room in rooms] == [
        "smaller_bedroom",
        "master_bedroom",
        "smaller_bedroom",
    ]


def test_a_home_with_a_master_bedroom_has_no_other() -> None:
    rooms = [bedroom(1, 12.0), bedroom(2, 11.0, room_type="master_bedroom")]
    assert [slept_in_as(room, rooms, "house") for room in rooms] == ["smaller_bedroom", "master_bedroom"]


def test_names_that_say_who_sleeps_there_and_other_buildings_are_left_alone() -> None:
    rooms = [bedroom(1, 10.0, name="Double bedroom"), bedroom(2, 14.0)]
    assert slept_in_as(rooms[0], rooms, "house") == "bedroom"
    assert slept_in_as(rooms[1], rooms, "hostel") == "bedroom"


def test_bedrooms_of_several_homes_on_a_floor_stay_as_they_are() -> None:
    rooms = [bedroom(1, 10.0), *(bedroom(n, 8.0, room_type="kitchen") for n in (2, 3))]
    assert slept_in_as(rooms[0], rooms, "apartment_building") == "bedroom"
