"""Furnished storeys with the documents that a building folder has, in memory and on disk."""

from dataclasses import replace
from pathlib import Path

import msgspec

import sample_floors
from mansion_editing.structure import Storey
from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.building_folder import INDEX, floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.program import BuildingProgram, RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.assembly import furnish_floor


def office() -> Storey:
    """Return a storey of 20 x 14 m with a stair and a lift beside its corridor."""
    return _storey(sample_floors.office(floors=(1,)))


def offices() -> list[Storey]:
    """Return two such storeys of one building."""
    made = [_storey(sample_floors.office(floor, floors=(1, 2))) for floor in (1, 2)]
    program = msgspec.structs.replace(made[0].program, floors=[storey.floor for storey in made])
    return [replace(storey, program=program) for storey in made]


def flat() -> Storey:
    """Return a flat of 10 x 8 m."""
    return _storey(sample_floors.flat())


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


def index_of(storey: Storey) -> Building:
    """Return the index of a building of this one storey."""
    scene = storey.scene
    names = ("topology", "layout", "scene")
    entry = FloorEntry(
        floor=scene.floor,
        label=scene.label,
        elevation=scene.elevation,
        height=scene.height,
        area=round(sum(room.area for room in scene.rooms), 3),
        rooms=len(scene.rooms),
        objects=len(scene.objects),
        files={name: f"{floor_directory(scene.floor)}/{name}.json" for name in names},
    )
    return Building(
        building_id=scene.building_id,
        request=BuildRequest(description="a sample"),
        program=storey.program,
        floors=[entry],
        cores=storey.program.vertical_connectivity.cores,
        seed=scene.seed,
        checks={"rooms": len(scene.rooms), "doors": len(scene.doors), "objects": len(scene.objects)},
    )


def write_building(storey: Storey, folder: Path) -> Path:
    """Write a building of this one storey and return its folder."""
    place = folder / floor_directory(storey.number)
    place.mkdir(parents=True)
    for name, payload in (("topology", storey.topology), ("layout", storey.layout), ("scene", storey.scene)):
        (place / f"{name}.json").write_bytes(encode_bytes(payload, indent=1))
    (folder / INDEX).write_bytes(encode_bytes(index_of(storey), indent=1))
    return folder
