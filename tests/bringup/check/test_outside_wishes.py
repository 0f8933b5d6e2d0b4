"""Wishes for the outside are met in the finished building, and the check finds what was made untrue of them."""

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from mansion_bringup.check.wishes import check_wishes
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.outside import Outside
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene

BRIEF = "A white one-storey house of 80 m2 with a slate hip roof, a garden with a pool, a fence and parking for 3 cars"

Built = tuple[Building, list[FloorLayout], FloorScene]


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Built:
    folder = tmp_path_factory.mktemp("outside") / "house"
    build_building(BuildRequest(description=BRIEF), folder)
    read = BuildingFolder(Path(folder))
    return read.building, [read.layout(1)], read.scene(1)


def faults(house: Built, change: Callable[[FloorScene], FloorScene]) -> list[str]:
    building, layouts, scene = house
    found = check_wishes(building, building.wishes, layouts, [change(scene)])
    wrong = [fault.where for fault in found]
    return [wish.kind for wish in building.wishes if wish.id in wrong]


def test_all_of_them_are_met(house: Built) -> None:
    outside = [wish for wish in house[0].wishes if wish.kind in ("facade", "roof", "grounds")]
    assert [wish.status for wish in outside] == ["met"] * 6
    assert faults(house, lambda scene: scene) == []


def test_walls_of_another_material_are_found(house: Built) -> None:
    def repainted(scene: FloorScene) -> FloorScene:
        walls = [
            msgspec.structs.replace(wall, right_material="red_brick") if wall.exterior else wall for wall in scene.walls
        ]
        return msgspec.structs.replace(scene, walls=walls)

    assert faults(house, repainted) == ["facade"]


def test_another_roof_is_found(house: Built) -> None:
    def flattened(scene: FloorScene) -> FloorScene:
        assert isinstance(scene.outside, Outside)
        return msgspec.structs.replace(scene, outside=msgspec.structs.replace(scene.outside, roof="flat"))

    assert faults(house, flattened) == ["roof"]


def test_a_pool_under_the_house_and_a_car_park_that_is_too_small_are_found(house: Built) -> None:
    def misplaced(scene: FloorScene) -> FloorScene:
        assert isinstance(scene.grounds, list)
        x, y = scene.outline[0]
        small = [(x - 9, y), (x - 8, y), (x - 8, y + 1), (x - 9, y + 1)]
        moved = {"pool": list(scene.outline), "parking": small}
        grounds = [msgspec.structs.replace(area, polygon=moved.get(area.use, area.polygon)) for area in scene.grounds]
        return msgspec.structs.replace(scene, grounds=grounds)

    building = house[0]
    wrong = faults(house, misplaced)
    assert wrong == ["grounds", "grounds"]
    assert {wish.value.name for wish in building.wishes if wish.kind == "grounds"} == {
        "garden", "pool", "fence", "parking",
    }  # fmt: skip


def test_grounds_that_are_gone_are_found(house: Built) -> None:
    gone = faults(house, lambda scene: msgspec.structs.replace(scene, grounds=msgspec.UNSET))
    assert gone == ["grounds"] * 3  # the fence is no area
