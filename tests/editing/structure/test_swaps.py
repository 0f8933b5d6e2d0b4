"""Two rooms change places: polygons and ways in go to the other, name and type stay with the room."""

from collections.abc import Callable

import pytest

from mansion_bringup.check import check_floors
from mansion_editing.structure import Storey, Workshop, swap_rooms
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene, SceneRoom

WorkshopOf = Callable[[Storey], Workshop]
PAIRS = [("F1/meeting_room_1", "F1/office_2"), ("F1/toilet_1", "F1/storage"), ("F1/office_1", "F1/storage")]


def room(scene: FloorScene, name: str) -> SceneRoom:
    return next(entry for entry in scene.rooms if entry.id == name)


@pytest.mark.parametrize(("one", "other"), PAIRS)
def test_each_room_is_furnished_in_the_place_of_the_other(
    office: Storey, workshop_of: WorkshopOf, one: str, other: str
) -> None:
    done = swap_rooms(office, one, other, workshop_of(office))
    scene = done.storey.scene
    assert room(scene, one).polygon == room(office.scene, other).polygon
    assert room(scene, other).polygon == room(office.scene, one).polygon
    assert room(scene, one).room_type == room(office.scene, one).room_type
    assert not list(check_floors(scene.building_id, [scene], [done.storey.topology]))
    held = [[o for o in s.objects if o.room not in (one, other)] for s in (scene, office.scene)]
    assert held[0] == held[1]


def test_what_is_reached_through_a_room_is_reached_through_the_other_afterwards(
    office: Storey, workshop_of: WorkshopOf
) -> None:
    after = swap_rooms(office, "F1/office_1", "F1/storage", workshop_of(office)).storey
    joined = {frozenset(door.rooms) for door in after.scene.doors}
    assert frozenset(("F1/storage", "F1/server_room")) in joined
    assert ("storage", "server_room") in {(edge.source, edge.target) for edge in after.topology.edges}


def test_areas_that_differ_much_are_mentioned(office: Storey, workshop_of: WorkshopOf) -> None:
    moved = swap_rooms(office, "F1/meeting_room_1", "F1/office_2", workshop_of(office)).moved
    assert "The place that F1/office_2 now has is 20% larger than the one that F1/meeting_room_1 now has." in moved
    alike = swap_rooms(office, "F1/toilet_1", "F1/storage", workshop_of(office)).moved
    assert not [sentence for sentence in alike if "larger" in sentence]


def test_what_other_rooms_are_reached_through_does_not_change_places(office: Storey, workshop_of: WorkshopOf) -> None:
    with pytest.raises(MansionError, match="what other rooms are reached through"):
        swap_rooms(office, "F1/lobby", "F1/storage", workshop_of(office))


def test_a_room_does_not_change_places_with_itself(office: Storey, workshop_of: WorkshopOf) -> None:
    with pytest.raises(MansionError, match="with itself"):
        swap_rooms(office, "F1/storage", "F1/storage", workshop_of(office))
