"""Questions are answered from the static scene and the catalogue."""

import msgspec
import pytest

from mansion_editing.state import SceneState
from mansion_editing.tools.paths import blocked_doors, check_path
from mansion_editing.tools.perception import check_surface, list_objects, search_assets, search_contents
from mansion_msgs_py.editing.questions import (
    CheckPathArgs,
    CheckSurfaceArgs,
    ListObjectsArgs,
    SearchAssetsArgs,
    SearchContentsArgs,
)
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import SceneObject


def test_every_room_is_reached_from_the_entrance(state: SceneState) -> None:
    report = check_path(state, CheckPathArgs())
    assert report.reachable and report.start == "F1/hall" and not report.unreachable


def test_a_route_names_rooms_doors_and_the_stair(state: SceneState) -> None:
    report = check_path(state, CheckPathArgs(start="kitchen", end="private office on the second floor"))
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


def row_of_cabinets(state: SceneState, room: str, x: float, y: float, width: float) -> list[SceneObject]:
    """Stand four cabinets side by side from a point eastward."""
    _, sofa = state.get("F1/hall/sofa_1")
    row = []
    for number in range(4):
        row.append(
            msgspec.structs.replace(
                sofa,
                id=f"{room}/cabinet_{number + 1}",
                category="cabinet",
                room=room,
                position=(x + (number + 0.5) * width / 4, y, 0.5),
                size=(width / 4, 0.5, 1.0),
                rotation=0.0,
            )
        )
        state.add(1, row[-1])
    return row


def test_a_room_cut_in_two_by_cabinets_is_reported_with_them(state: SceneState) -> None:
    row = row_of_cabinets(state, "F1/hall", 0.06, 3.0, 5.88)
    report = check_path(state, CheckPathArgs())
    assert report.cut_rooms == ["F1/hall"] and not report.blocked_doors and not report.reachable
    assert report.unreachable == ["F1/kitchen", "F2/corridor", "F2/private_office_1"]
    assert all(item.id in report.message for item in row) and "sofa" not in report.message
    assert check_path(state, CheckPathArgs(start="kitchen", end="F2/corridor")).reachable


@pytest.mark.parametrize(("gap", "passes"), [(0.30, False), (0.36, False), (0.42, True)])
def test_a_robot_passes_a_gap_of_its_own_width(state: SceneState, gap: float, passes: bool) -> None:
    row_of_cabinets(state, "F1/hall", 0.06, 3.0, 5.88 - gap)
    report = check_path(state, CheckPathArgs(end="F1/kitchen"))
    assert report.reachable == passes and bool(report.cut_rooms) != passes


def test_a_room_of_one_door_is_reached_and_its_far_half_said_to_be_cut_off(state: SceneState) -> None:
    row_of_cabinets(state, "F1/kitchen", 6.06, 2.0, 5.88)
    report = check_path(state, CheckPathArgs())
    assert report.reachable and report.cut_rooms == ["F1/kitchen"]
    assert "F1/kitchen/cabinet_1" in report.message


def test_an_edit_opens_the_way_again(state: SceneState) -> None:
    row = row_of_cabinets(state, "F1/hall", 0.06, 3.0, 5.88)
    assert not check_path(state, CheckPathArgs()).reachable
    state.remove(1, row[1])
    report = check_path(state, CheckPathArgs())
    assert report.reachable and not report.cut_rooms


def test_furniture_near_a_door_that_leaves_no_place_to_stand_shuts_it(state: SceneState) -> None:
    _, sofa = state.get("F1/hall/sofa_1")
    wall = msgspec.structs.replace(sofa, position=(7.5, 4.0, 0.5), size=(2.3, 3.5, 1.0), rotation=0)
    state.add(1, msgspec.structs.replace(wall, id="F1/kitchen/wardrobe_1", room="F1/kitchen"))
    report = check_path(state, CheckPathArgs())
    assert report.unreachable == ["F1/kitchen"] and report.cut_rooms == ["F1/kitchen"]
    assert "F1/kitchen/wardrobe_1" in report.message and not report.blocked_doors


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
