"""A furnished office storey of 20 x 14 m and a flat of 10 x 8 m, with the documents that a building folder has."""

from collections.abc import Callable

import msgspec
import pytest

import sample_floors
from mansion_assets.catalogue import Catalogue
from mansion_bringup.check import check_floors
from mansion_editing.structure import Storey, Workshop
from mansion_msgs_py.program import BuildingProgram, RoomProgram
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.assembly import furnish_floor
from mansion_scene.refurnishing import furnish_room


def _storey(request: FurnishRequest) -> Storey:
    areas = {node.id: node.area for node in request.topology.nodes}
    rooms = [RoomProgram(id=room.id, area_estimate=areas[room.id]) for room in request.layout.rooms]
    floor = msgspec.structs.replace(request.floor, rooms=rooms, gross_floor_area=300.0)
    program = BuildingProgram(
        building_id=request.building_id,
        reasoning="made by hand",
        vertical_connectivity=request.connectivity,
        floors=[floor],
        building_type=request.building_type,
        seed=request.seed,
    )
    scene = furnish_floor(msgspec.structs.replace(request, floor=floor))
    return Storey(program, request.topology, request.layout, scene)


@pytest.fixture(scope="session")
def office() -> Storey:
    """Return the office."""
    return _storey(sample_floors.office(floors=(1,)))


@pytest.fixture(scope="session")
def flat() -> Storey:
    """Return the flat."""
    return _storey(sample_floors.flat())


@pytest.fixture(scope="session")
def workshop_of(catalogue: Catalogue) -> Callable[[Storey], Workshop]:
    """Return what makes the workshop of a storey: the placer, and the independent check as its judge."""

    def make(storey: Storey) -> Workshop:
        known = set(_faults(storey.scene, storey))
        return Workshop(catalogue, furnish_room, lambda scene: [f for f in _faults(scene, storey) if f not in known])

    return make


def _faults(scene: FloorScene, storey: Storey) -> list[str]:
    """Return the faults of a scene; which doors it should have is what a change may change."""
    found = check_floors(scene.building_id, [scene], [storey.topology])
    return [str(fault) for fault in found if fault.kind != "DOOR_MISSING"]
