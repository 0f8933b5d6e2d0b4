"""Questions are answered from the static scene and the catalogue."""

import msgspec
import pytest

from mansion_msgs_py.editing import (
    CheckPathArgs,
    CheckSurfaceArgs,
    ListObjectsArgs,
    SearchAssetsArgs,
    SearchContentsArgs,
)
from mansion_msgs_py.errors import MansionError
from mansion_scene.editing.state import SceneState
from mansion_scene.editing.tools.paths import blocked_doors, check_path
from mansion_scene.editing.tools.perception import (
    check_surface,
    list_objects,
    search_assets,
    search_contents,
)


def test_every_room_is_reached_from_the_entrance(state: SceneState) -> None:
    report = check_path(state, CheckPathArgs())
    assert report.reachable and report.start == "F1/hall" and not report.unreachable


def test_a_route_names_rooms_doors_and_the_stair(state: SceneState) -> None:
    report = check_path(
        state, CheckPathArgs(start="kitchen", end="private office on the second floor")
    )
    assert [step.place for step in report.route] == [
        "F1/kitchen", "F1/hall", "stair_1", "stair_1", "F2/corridor", "F2/private_office_1",
    ]  # fmt: skip
    assert report.route[1].door == "F1/door_1"


def test_no_way_leads_to_a_room_without_its_door(state: SceneState) -> None:
    scene = state.scenes[2]
    state.scenes[2] = msgspec.structs.replace(scene, doors=scene.doors[1:])
    report = check_path(state, CheckPathArgs(end="F2/private_office_1"))
    assert not report.reachable and report.unreachable == ["F2/private_office_1"]


def test_furniture_across_a_door_blocks_the_way(state: SceneState) -> None:
    floor, sofa = state.get("F1/hall/sofa_1")
    across = msgspec.structs.replace(sofa, position=(5.4, 4.45, sofa.position[2]), rotation=90.0)
    state.replace(floor, sofa, across)
    assert blocked_doors(state, 1) == ["F1/door_1"]
    assert check_path(state, CheckPathArgs()).unreachable == ["F1/kitchen"]


@pytest.mark.parametrize("end", ["the ballroom", "kitchen on the ninth floor", "../../etc"])
def test_unknown_places_are_refused_by_name(state: SceneState, end: str) -> None:
    with pytest.raises(MansionError) as error:
        check_path(state, CheckPathArgs(end=end))
    assert error.value.code == "NOT_FOUND"


def test_assets_are_found_by_words_and_properties(state: SceneState) -> None:
    hits = search_assets(state, SearchAssetsArgs(query="a cola", top_k=3, properties=["Pickable"]))
    assert hits.assets[0].asset_id == "cola_can_1"
    assert all("pickupable" in asset.properties for asset in hits.assets)


def test_objects_are_listed_by_room_keyword_and_id(state: SceneState) -> None:
    in_kitchen = list_objects(state, ListObjectsArgs(room="kitchen"))
    assert {item.id for item in in_kitchen.objects} == {
        "F1/kitchen/fridge_1", "F1/kitchen/dining_table_1", "F1/kitchen/mug_1",
    }  # fmt: skip
    assert list_objects(state, ListObjectsArgs(keyword="refrigerator")).total == 1
    found = list_objects(state, ListObjectsArgs(id="F1/kitchen/fridge_1")).objects[0]
    assert "openable" in found.properties and found.floor == 1


def test_what_lies_on_a_table_is_on_it_and_not_in_it(state: SceneState) -> None:
    on = check_surface(state, CheckSurfaceArgs(keyword="dining table")).receptacles[0]
    assert [item.id for item in on.objects] == ["F1/kitchen/mug_1"]
    inside = search_contents(state, SearchContentsArgs(id="F1/kitchen/dining_table_1"))
    assert inside.receptacles[0].objects == []


def test_geometry_decides_for_what_was_moved_by_hand(state: SceneState) -> None:
    floor, mug = state.get("F1/kitchen/mug_1")
    _, fridge = state.get("F1/kitchen/fridge_1")
    moved = msgspec.structs.replace(mug, position=(*fridge.position[:2], 0.9))
    state.replace(floor, mug, moved)
    assert moved.parent == "F1/kitchen/dining_table_1"
    on = check_surface(state, CheckSurfaceArgs(id="F1/kitchen/dining_table_1"))
    inside = search_contents(state, SearchContentsArgs(id="F1/kitchen/fridge_1"))
    assert on.receptacles[0].objects == []
    assert [item.id for item in inside.receptacles[0].objects] == ["F1/kitchen/mug_1"]


def test_what_floats_above_a_table_is_not_on_it(state: SceneState) -> None:
    floor, mug = state.get("F1/kitchen/mug_1")
    x, y, z = mug.position
    state.replace(floor, mug, msgspec.structs.replace(mug, position=(x, y, z + 0.3)))
    on = check_surface(state, CheckSurfaceArgs(id="F1/kitchen/dining_table_1"))
    assert on.receptacles[0].objects == []
