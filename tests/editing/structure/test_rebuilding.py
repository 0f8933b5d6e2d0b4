"""A storey that is built again from an unchanged layout is the same to the last digit."""

import msgspec
import pytest

from mansion_editing.structure import Storey
from mansion_editing.structure.rebuilding import passages_of_scene, rebuild


@pytest.mark.parametrize("name", ["office", "flat"])
def test_nothing_changes_without_a_change(name: str, request: pytest.FixtureRequest) -> None:
    storey: Storey = request.getfixturevalue(name)
    rebuilt = rebuild(storey, storey, passages_of_scene(storey.scene))
    structure, scene = rebuilt.structure, storey.scene
    assert not rebuilt.touched
    assert not rebuilt.new_doors
    assert not rebuilt.lost_doors
    assert (structure.rooms, structure.walls, structure.windows) == (scene.rooms, scene.walls, scene.windows)
    assert sorted(door.id for door in structure.doors) == sorted(door.id for door in scene.doors)
    assert structure.cores == scene.cores


def test_finishes_and_names_that_were_edited_stay(office: Storey) -> None:
    rooms = [msgspec.structs.replace(room, name="Den", wall_material="raw_concrete") for room in office.scene.rooms]
    edited = Storey(office.program, office.topology, office.layout, msgspec.structs.replace(office.scene, rooms=rooms))
    structure = rebuild(edited, edited, passages_of_scene(edited.scene)).structure
    assert {(room.name, room.wall_material) for room in structure.rooms} == {("Den", "raw_concrete")}
    inner = [wall for wall in structure.walls if not wall.exterior]
    assert {wall.left_material for wall in inner} | {wall.right_material for wall in inner} == {"raw_concrete"}
