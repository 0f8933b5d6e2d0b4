"""CPU seconds that walls, openings and cores of a floor take, by number of rooms.

    python benchmarks/scene/structure_time.py [--rooms 10 20 30 60] [--repeat 5]

Floors are a corridor of 2 m with rooms on both sides, 14 m deep, every room with a door to the corridor.
"""

import argparse
import time

from mansion_msgs_py.layout import FloorLayout, LayoutRoom
from mansion_msgs_py.program import AreaSummary, FloorProgram, VerticalConnectivity
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode
from mansion_scene.structure import build_structure

WIDTH, DEPTH = 2.4, 6.0
KINDS = ("office", "meeting_room", "storage", "toilet", "classroom")


def comb(count: int) -> FurnishRequest:
    """Return a floor of `count` rooms along a corridor."""
    columns = (count + 1) // 2
    length = WIDTH * columns
    rooms = {"corridor": [(0, DEPTH), (length, DEPTH), (length, DEPTH + 2), (0, DEPTH + 2)]}
    for index in range(count):
        column, upper = divmod(index, 2)
        x0, x1 = WIDTH * column, WIDTH * (column + 1)
        y0, y1 = (DEPTH + 2, 2 * DEPTH + 2) if upper else (0.0, DEPTH)
        rooms[f"room_{index}"] = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    nodes = [
        TopologyNode(
            id=name,
            type="main" if name == "corridor" else "Entities",
            area=14.0,
            room_type="corridor" if name == "corridor" else KINDS[index % len(KINDS)],
        )
        for index, name in enumerate(rooms)
    ]
    edges = [Edge(source="corridor", target=name) for name in rooms if name != "corridor"]
    return FurnishRequest(
        building_id="comb",
        floor=FloorProgram(
            index=1,
            requirement="",
            gross_floor_area=length * 14,
            rooms=[],
            area_summary=AreaSummary(sum_rooms=1.0, reserve_ratio=0.2, fits_within_gfa=True),
        ),
        floors=[1],
        labels=["1"],
        connectivity=VerticalConnectivity(method="none"),
        topology=FloorTopology(nodes=nodes, edges=edges),
        layout=FloorLayout(
            rooms=[LayoutRoom(id=name, polygon=polygon) for name, polygon in rooms.items()],
            topology_satisfied=True,
            hub="corridor",
        ),
    )


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rooms", type=int, nargs="+", default=[10, 20, 30, 60])
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    print("rooms  area m2  walls  doors  windows  CPU s")
    for count in arguments.rooms:
        request = comb(count)
        structure = build_structure(request)
        seconds = []
        for _ in range(arguments.repeat):
            start = time.process_time()
            build_structure(request)
            seconds.append(time.process_time() - start)
        print(
            f"{count:5d}  {request.floor.gross_floor_area:7.0f}  {len(structure.walls):5d}  "
            f"{len(structure.doors):5d}  {len(structure.windows):7d}  {min(seconds):5.3f}"
        )


if __name__ == "__main__":
    main()
