"""Buildings that cost nothing, for tests of what makes many of them; workers in other processes import this module."""

import os
import shutil
import signal
import time
from pathlib import Path

import msgspec

from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.request import BuildRequest, building_id_of
from mansion_msgs_py.topology import FloorTopology, TopologyNode
from mansion_world.mixture import load_mixture
from mansion_world.sampling import sample
from sample_building import write_building

__all__ = ["build_killed", "build_slowly", "build_stand_in", "no_faults"]


def build_stand_in(request: BuildRequest, folder: Path) -> None:
    """Write a made-up building of one floor, its rooms further apart the higher the seed is."""
    partial = folder.with_name(f".{folder.name}.partial")
    shutil.rmtree(partial, ignore_errors=True)
    write_building(partial, [1])
    read = BuildingFolder(partial)
    index = msgspec.structs.replace(read.building, building_id=building_id_of(request))
    (partial / "building.json").write_bytes(encode_bytes(index))
    scene, share = read.scene(1), 1.0 + request.seed % 8009 / 10.0
    rooms = [
        msgspec.structs.replace(room, polygon=[(x * share, y * share) for x, y in room.polygon]) for room in scene.rooms
    ]
    floor = partial / "floors" / "floor_1"
    (floor / "scene.json").write_bytes(encode_bytes(msgspec.structs.replace(scene, rooms=rooms)))
    nodes = [TopologyNode(id=room.id, type="main", area=room.area, room_type=room.room_type) for room in scene.rooms]
    (floor / "topology.json").write_bytes(encode_bytes(FloorTopology(nodes=nodes, edges=[])))
    partial.rename(folder)


def build_slowly(request: BuildRequest, folder: Path) -> None:
    """Take half a second over a building."""
    time.sleep(0.5)
    build_stand_in(request, folder)


def build_killed(index: int, times: int, marks: Path, request: BuildRequest, folder: Path) -> None:
    """Build, but kill this process at one building of the world of seed 7, the first times that it is begun."""
    if request.building_id == sample(index, 7, load_mixture()).request.building_id:
        begun = len(list(marks.iterdir()))
        if begun < times:
            (marks / str(begun)).touch()
            os.kill(os.getpid(), signal.SIGKILL)
    build_stand_in(request, folder)


def no_faults(folder: Path) -> list[str]:
    """Find nothing wrong."""
    return []
