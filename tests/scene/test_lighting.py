"""Lamps by room and the sky of a building."""

from types import ModuleType

import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.scene import SceneObject
from mansion_scene.lighting import choose_sky, room_lights, sun
from mansion_scene.structure import build_structure


def test_every_indoor_room_is_lit_from_inside_below_its_ceiling(sample_floors: ModuleType) -> None:
    for seed in range(10):
        structure = build_structure(sample_floors.random_floor(seed))
        for room in structure.rooms:
            lights = room_lights(room, [])
            assert lights
            net = Polygon(room.net_polygon, room.net_holes)
            for light in lights:
                assert shapely.contains_xy(net, *light.position[:2])
                assert 2.0 < light.position[2] < room.ceiling_height
                assert light.room == room.id


def test_large_rooms_have_more_lights_than_small_ones(sample_floors: ModuleType) -> None:
    rooms = {room.id: room for room in build_structure(sample_floors.office()).rooms}
    assert len(room_lights(rooms["F1/open_office_1"], [])) > len(room_lights(rooms["F1/storage"], []))


def test_a_lamp_glows_where_it_stands(sample_floors: ModuleType) -> None:
    room = build_structure(sample_floors.flat()).rooms[0]
    lamp = SceneObject(
        id=f"{room.id}/floor_lamp_1",
        room=room.id,
        category="floor_lamp",
        asset="x",
        position=(1.0, 1.0, 0.8),
        rotation=0.0,
        size=(0.4, 0.4, 1.6),
    )
    extra = room_lights(room, [lamp])[-1]
    assert extra.position[:2] == (1.0, 1.0) and extra.position[2] < 1.6


def test_the_sky_depends_on_the_seed_alone() -> None:
    skies = [choose_sky(seed) for seed in range(40)]
    assert skies == [choose_sky(seed) for seed in range(40)]
    assert len({sky.name for sky in skies}) > 5
    assert all(-5.0 <= sky.sun_elevation <= 90.0 and 0 <= sky.hour < 24 for sky in skies)


def test_the_sun_stands_where_the_sky_says() -> None:
    for seed in range(20):
        sky = choose_sky(seed)
        light = sun(sky, 1, (0.0, 0.0))
        assert light.kind == "directional" and light.position[2] > 0.0
        # Morning sun from the east (+x), evening sun from the west.
        if sky.hour < 11.5:
            assert light.position[0] > 0
        if sky.hour > 12.5:
            assert light.position[0] < 0
