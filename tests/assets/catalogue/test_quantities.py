"""Tables and the seats around them are chosen for each other."""

import math

import pytest

from mansion_assets.catalogue.furnish import furnish_request
from mansion_assets.catalogue.loading import load_catalogue
from mansion_assets.catalogue.quantities import seating_tables, seats_around

CATALOGUE = load_catalogue()
CHAIR = CATALOGUE.choose_from("meeting_chair")[0]
SEATED = ["meeting_room", "dining_room", "break_room", "restaurant", "reading_room", "classroom"]


@pytest.mark.parametrize("room_type", SEATED)
@pytest.mark.parametrize("area", [10.0, 20.0, 33.0, 60.0])
@pytest.mark.parametrize("seed", range(4))
def test_all_seats_that_belong_around_a_table_find_a_place_there(room_type, area, seed):
    side = math.sqrt(area)
    found = furnish_request(CATALOGUE, room_type, area, seed=seed, room_id="F1/room", extent=(1.1 * side, side / 1.1))
    for seat in found.floor:
        around = [r.target for r in seat.relative if r.kind == "around"]
        tables = [thing for thing in found.floor if thing.name in around]
        places = sum(
            table.quantity * seats_around(found.floor_assets[table.name], found.floor_assets[seat.name])
            for table in tables
        )
        if tables:
            assert seat.quantity <= places


@pytest.mark.parametrize("seed", range(8))
def test_a_boardroom_has_one_large_table(seed):
    found = furnish_request(CATALOGUE, "boardroom", 33.0, seed=seed, room_id="F4/boardroom", extent=(6.0, 5.5))
    table = next(thing for thing in found.floor if thing.name == "conference_table")
    chairs = next(thing for thing in found.floor if thing.name == "meeting_chair")
    assert table.size[0] >= 2.4
    assert chairs.quantity >= 8


def test_what_stands_in_for_a_table_seats_as_many():
    for seed in range(20):
        found = furnish_request(CATALOGUE, "meeting_room", 26.0, seed=seed, room_id="F1/m", extent=(5.6, 4.7))
        chairs = next(thing for thing in found.floor if thing.name == "meeting_chair")
        seat = found.floor_assets["meeting_chair"]
        for table in found.alternatives.get("conference_table", []):
            assert seats_around(table, seat) >= chairs.quantity


def test_a_table_leaves_room_behind_the_chairs_and_is_not_much_too_large():
    tables = CATALOGUE.choose_from(["conference_table", "training_table"])
    few, many = (seating_tables(tables, CHAIR, seats, (8.0, 6.0)) for seats in (4.0, 12.0))
    assert max(table.size[0] for table in few) < min(table.size[0] for table in many)
    narrow = seating_tables(tables, CHAIR, 12.0, (4.6, 3.2))
    assert all(table.size[0] <= 2.6 and table.size[1] <= 1.2 for table in narrow)
    assert seating_tables(tables, CHAIR, 8.0, (2.0, 1.5)), "a closet still gets the smallest"


@pytest.mark.parametrize("room_type", ["corridor", "shop", "generic_room"])
def test_no_rug_lies_alone_where_people_pass(room_type):
    for seed in range(30):
        found = furnish_request(CATALOGUE, room_type, 30.0, seed=seed, room_id="F1/room", extent=(12.0, 2.5))
        assert found.rugs == []


def test_a_hallway_at_home_has_no_public_safety_signs():
    for seed in range(10):
        found = furnish_request(CATALOGUE, "hallway", 14.0, seed=seed, room_id="F1/hallway", extent=(7.0, 2.0))
        hung = {wish.asset.category for wish in (*found.wall, *found.ceiling)}
        assert not hung & {"exit_sign", "exit_sign_ceiling", "security_camera", "fire_alarm", "sprinkler"}
