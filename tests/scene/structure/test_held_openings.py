"""Doors that are held stay where they are, as long as a wall between their two sides stands there."""

import msgspec
import pytest
from shapely import LineString

from mansion_scene.structure import build_structure
from mansion_scene.structure.access import AccessPlan, Passage, pair_key
from mansion_scene.structure.held_openings import HeldAccess


def held(doors):
    pairs = {pair_key(*door.rooms): door.kind == "open" for door in doors if door.rooms[1] is not None}
    return HeldAccess(AccessPlan(tuple(Passage(pair, is_open) for pair, is_open in pairs.items()), ()), tuple(doors))


def with_wall_at(request, x):
    """Return the office with the wall between its open office and its meeting room at another place."""
    boxes = {"open_office_1": (6, 8, x, 14), "meeting_room_1": (x, 8, 20, 14)}
    rooms = [
        msgspec.structs.replace(room, polygon=[(a, b), (c, b), (c, d), (a, d)])
        for room in request.layout.rooms
        for a, b, c, d in [boxes.get(room.id, (0, 0, 0, 0))]
        if room.id in boxes
    ]
    others = [room for room in request.layout.rooms if room.id not in boxes]
    return msgspec.structs.replace(request, layout=msgspec.structs.replace(request.layout, rooms=[*others, *rooms]))


@pytest.mark.parametrize("seed", range(6))
def test_the_same_layout_with_its_own_doors_is_the_same_structure(sample_floors, seed):
    request = sample_floors.random_floor(seed)
    first = build_structure(request)
    again = build_structure(request, held(first.doors))
    assert {door.segment: (door.kind, door.hinge) for door in again.doors} == {
        door.segment: (door.kind, door.hinge) for door in first.doors
    }
    assert (again.rooms, again.walls, again.windows) == (first.rooms, first.walls, first.windows)


def test_a_wall_that_moves_moves_only_the_doors_in_its_way(sample_floors):
    request = sample_floors.office(floors=(1,))
    first = build_structure(request)
    own = next(door for door in first.doors if "F1/meeting_room_1" in door.rooms)
    past = max(point[0] for point in own.segment) + 0.5
    moved = build_structure(with_wall_at(request, past), held(first.doors))
    kept = [door.segment for door in first.doors if door is not own]
    assert set(kept) <= {door.segment for door in moved.doors}
    (new,) = [door for door in moved.doors if "F1/meeting_room_1" in door.rooms]
    assert min(point[0] for point in new.segment) > past


def test_a_new_door_avoids_furniture_that_stands_already(sample_floors):
    request = sample_floors.office(floors=(1,))
    first = build_structure(request)
    pair = pair_key("F1/open_office_1", "F1/meeting_room_1")
    access = held(first.doors)
    plan = AccessPlan((*access.plan.passages, Passage(pair)), ())
    free = build_structure(request, HeldAccess(plan, access.doors))
    at = next(door.segment for door in free.doors if set(door.rooms) == set(pair))
    cupboard = LineString(at).buffer(0.4)
    crowded = HeldAccess(plan, access.doors, {"F1/meeting_room_1": [cupboard]})
    there = build_structure(request, crowded)
    other = next(door.segment for door in there.doors if set(door.rooms) == set(pair))
    assert not LineString(other).buffer(0.3, cap_style="flat").intersects(cupboard)
