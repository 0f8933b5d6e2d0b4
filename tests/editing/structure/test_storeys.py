"""What the building's index says of a storey that changed, and of storeys that repeated it."""

import msgspec
import pytest

import sample_storeys
from mansion_editing.structure import Storey, updated_building
from mansion_editing.structure.storey_documents import node_of
from mansion_msgs_py.errors import MansionError


def test_counts_and_areas_follow_the_scene(office: Storey) -> None:
    building = sample_storeys.index_of(office)
    scene = msgspec.structs.replace(office.scene, objects=office.scene.objects[:5], doors=office.scene.doors[:4])
    after = Storey(office.program, office.topology, office.layout, scene)
    index = updated_building(building, [(office, after)])
    assert index.floors[0].objects == index.checks["objects"] == 5
    assert index.checks["doors"] == 4
    assert index.floors[0].area == building.floors[0].area


@pytest.mark.parametrize(("changed", "copies"), [(1, [None, None, 2]), (2, [None, None, 1]), (3, [None, 1, None])])
def test_copies_of_a_changed_storey_stand_for_themselves(
    office: Storey, changed: int, copies: list[int | None]
) -> None:
    floors = [msgspec.structs.replace(office.floor, index=n, copy=None if n == 1 else 1) for n in (1, 2, 3)]
    program = msgspec.structs.replace(office.program, floors=floors)
    scene = msgspec.structs.replace(office.scene, floor=changed)
    storey = Storey(program, office.topology, office.layout, scene)
    index = updated_building(sample_storeys.index_of(office), [(storey, storey)])
    assert [floor.copy for floor in index.program.floors] == copies


def test_an_unknown_room_is_refused_with_those_that_are_there(office: Storey) -> None:
    with pytest.raises(MansionError, match="F1/storage"):
        office.room("F1/cellar")


def test_rooms_have_short_names_in_the_room_graph(office: Storey) -> None:
    assert {node_of(room) for room in office.scene.rooms} == {room.id for room in office.layout.rooms}
