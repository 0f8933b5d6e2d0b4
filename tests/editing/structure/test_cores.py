"""A further stair or lift stands at one place on all storeys, on floor that one room of each gives."""

from collections.abc import Callable, Mapping, Sequence

import pytest
from shapely import Polygon

import sample_storeys
from mansion_assets.catalogue import Catalogue
from mansion_bringup.check import check_floors
from mansion_editing.structure import Reshaped, Storey, Workshop, add_core, updated_building
from mansion_editing.structure.cores import CoreKind
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_scene.refurnishing import furnish_room

OPEN_OFFICE = "F1/open_office_1"


@pytest.fixture(scope="module")
def storeys() -> list[Storey]:
    return sample_storeys.offices()


@pytest.fixture
def added(storeys: Sequence[Storey], catalogue: Catalogue) -> Callable[..., list[Reshaped]]:
    def judge(scenes: Mapping[int, FloorScene]) -> list[str]:
        found = check_floors("sample", list(scenes.values()), [storey.topology for storey in storeys])
        return [str(fault) for fault in found]

    def make(kind: CoreKind, room_id: str = "") -> list[Reshaped]:
        return add_core(storeys, kind, Workshop(catalogue, furnish_room, lambda scene: ()), judge, room_id=room_id)

    return make


@pytest.mark.parametrize("kind", ["elevator", "stair"])
def test_it_is_at_one_place_on_all_storeys_and_sound(
    storeys: Sequence[Storey], added: Callable[..., list[Reshaped]], kind: CoreKind
) -> None:
    done = added(kind, OPEN_OFFICE)
    scenes = [one.storey.scene for one in done]
    cores = [next(core for core in scene.cores if core.id == f"{kind}_2") for scene in scenes]
    assert cores[0].polygon == cores[1].polygon
    assert cores[0].floors == [1, 2]
    assert not list(check_floors("sample", scenes, [one.storey.topology for one in done]))
    for before, scene in zip(storeys, scenes, strict=True):
        room = f"F{scene.floor}/open_office_1"
        given = Polygon(cores[0].polygon).area
        areas = [{r.id: r.area for r in s.rooms} for s in (before.scene, scene)]
        assert areas[1].pop(room) == pytest.approx(areas[0].pop(room) - given)
        assert areas[0] == areas[1]


def test_program_and_index_know_it(storeys: Sequence[Storey], added: Callable[..., list[Reshaped]]) -> None:
    done = added("elevator", OPEN_OFFICE)
    changes = [(before, one.storey) for before, one in zip(storeys, done, strict=True)]
    index = updated_building(sample_storeys.index_of(storeys[0]), changes)
    assert [core.id for core in index.cores] == ["stair_1", "elevator_1", "elevator_2"]
    assert index.program.vertical_connectivity.cores == index.cores
    assert all("elevator_2" in {node.id for node in one.storey.topology.nodes} for one in done)


def test_a_room_that_has_no_place_for_it_is_refused_with_one_that_may(added: Callable[..., list[Reshaped]]) -> None:
    with pytest.raises(MansionError, match=r"no place in F1/server_room .* there may be one in .*F1/open_office_1"):
        added("stair", "F1/server_room")


def test_one_storey_needs_none(office: Storey, catalogue: Catalogue) -> None:
    workshop = Workshop(catalogue, furnish_room, lambda scene: ())
    with pytest.raises(MansionError, match="one storey needs no elevator"):
        add_core([office], "elevator", workshop, lambda scenes: ())
