"""How much of the furniture that briefs ask for stands in the rooms: over category, number, room type and area.

python benchmarks/scene/requested_objects.py [--seeds 0 1] [--only treadmill ...]
"""

import argparse
import math
import time
from collections.abc import Sequence

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.piece_counts import pieces
from mansion_msgs_py.layout import FloorLayout, LayoutRoom
from mansion_msgs_py.program import AreaSummary, FloorProgram, RequestedObject, RoomProgram, VerticalConnectivity
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode
from mansion_scene.assembly import furnish_floor

CASES: list[tuple[str, int, str, float]] = [
    ("treadmill", 20, "cardio_room", 200.0), ("treadmill", 8, "gym", 60.0), ("exercise_bike", 12, "gym", 90.0),
    ("sofa", 3, "lounge", 40.0), ("fireplace", 1, "living_room", 24.0), ("piano", 1, "living_room", 28.0),
    ("grand_piano", 1, "living_room", 45.0), ("chair", 12, "meeting_room", 36.0),
    ("chair", 20, "conference_room", 60.0), ("conference_table", 2, "meeting_room", 50.0),
    ("desk", 24, "open_office", 170.0), ("office_desk", 10, "open_office", 70.0), ("desk", 4, "private_office", 36.0),
    ("chair", 60, "restaurant", 150.0), ("dining_table", 15, "restaurant", 150.0), ("chair", 160, "cinema", 220.0),
    ("chair", 100, "lecture_hall", 150.0), ("chair", 80, "ballroom", 160.0), ("chair", 40, "library", 160.0),
    ("telescope", 1, "observatory", 40.0), ("telescope", 1, "living_room", 30.0), ("bunk_bed", 8, "dorm", 70.0),
    ("single_bed", 6, "dormitory", 60.0), ("bed", 2, "bedroom", 28.0), ("hospital_bed", 12, "ward", 140.0),
    ("globe", 1, "library", 80.0), ("globe", 2, "study", 16.0), ("shelving_unit", 3, "storage", 8.0),
    ("shelving_unit", 20, "storage", 80.0), ("locker", 30, "locker_room", 90.0), ("microwave", 2, "break_room", 30.0),
    ("microwave", 1, "office", 40.0), ("kettle", 1, "bedroom", 16.0), ("television", 1, "living_room", 24.0),
    ("television", 2, "lounge", 50.0), ("whiteboard", 3, "classroom", 60.0), ("painting", 10, "gallery", 120.0),
    ("wall_clock", 1, "kitchen", 12.0), ("rug", 2, "living_room", 40.0), ("yoga_mat", 15, "yoga_studio", 80.0),
    ("chandelier", 2, "ballroom", 120.0), ("projector", 1, "classroom", 60.0), ("pool_table", 2, "lounge", 80.0),
    ("washing_machine", 6, "laundry_room", 36.0), ("student_desk", 30, "classroom", 90.0),
    ("toilet", 5, "restroom", 30.0), ("sink", 4, "restroom", 30.0), ("server_rack", 16, "server_room", 70.0),
    ("arcade_machine", 14, "arcade", 90.0), ("house_plant", 8, "lobby", 90.0), ("workbench", 6, "workshop", 80.0),
    ("computer_tower", 20, "computer_lab", 100.0), ("vending_machine", 2, "corridor", 40.0),
    ("aquarium", 1, "waiting_room", 30.0), ("bookshelf", 12, "library", 120.0), ("crib", 6, "nursery", 40.0),
    ("stage", 1, "ballroom", 160.0), ("printer", 2, "office", 60.0),
]  # fmt: skip
"""Category, pieces, room type and square metres of the room."""


def request_of(category: str, count: int, room_type: str, area: float, seed: int) -> FurnishRequest:
    """Return the request for a room of the given area that is to have some pieces of a category."""
    return room_request([RequestedObject(category=category, count=count)], room_type, area, seed)


def room_request(asked: Sequence[RequestedObject], room_type: str, area: float, seed: int) -> FurnishRequest:
    """Return the request for a floor with one room of the given area and a corridor before it."""
    depth = math.sqrt(area / 1.4)
    width = 1.4 * depth
    boxes = {"room": (0.0, 0.0, width, depth), "corridor": (0.0, depth, width, depth + 2.4)}
    rings = {name: [(x0, y0), (x1, y0), (x1, y1), (x0, y1)] for name, (x0, y0, x1, y1) in boxes.items()}
    return FurnishRequest(
        building_id="sample",
        floor=FloorProgram(
            index=1,
            requirement="",
            gross_floor_area=area,
            rooms=[RoomProgram(id="room", area_estimate=area, room_type=room_type, objects=list(asked))],
            area_summary=AreaSummary(sum_rooms=area, reserve_ratio=0.2, fits_within_gfa=True),
            label="1",
        ),
        floors=[1],
        labels=["1"],
        connectivity=VerticalConnectivity(method="none"),
        topology=FloorTopology(
            nodes=[
                TopologyNode(id="corridor", type="main", area=2.4 * width, room_type="corridor"),
                TopologyNode(id="room", type="Entities", area=area, room_type=room_type),
            ],
            edges=[Edge(source="corridor", target="room")],
        ),
        layout=FloorLayout(
            rooms=[LayoutRoom(id=name, polygon=ring) for name, ring in rings.items()],
            topology_satisfied=True,
            hub="corridor",
        ),
        building_type="building",
        seed=seed,
    )


def pieces_in(scene: FloorScene, category: str) -> int:
    """Return how many pieces that a request means stand in the room."""
    catalogue = load_catalogue()
    return sum(pieces(category, catalogue.asset(o.asset)) for o in scene.objects if o.room == "F1/room")


def main() -> None:
    """Print a line for each case, and the share of the pieces that stand."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[0])
    parser.add_argument("--only", nargs="*", default=[])
    options = parser.parse_args()
    asked = met = whole = 0
    shares: list[float] = []
    print(f"{'category':18}{'asked':>6}{'there':>7}  {'room':16}{'m2':>5}{'objects':>9}{'CPU s':>7}")
    for category, count, room_type, area in CASES:
        for seed in options.seeds if not options.only or category in options.only else ():
            begin = time.process_time()
            scene = furnish_floor(request_of(category, count, room_type, area, seed))
            spent = time.process_time() - begin
            there = pieces_in(scene, category)
            asked, met, whole = asked + count, met + min(there, count), whole + (there >= count)
            shares.append(min(there, count) / count)
            objects = sum(o.room == "F1/room" for o in scene.objects)
            why = "; ".join(f"{d.count} {d.name}: {d.reason}" for d in scene.discarded if d.room == "F1/room")
            mark = "" if there >= count else f"  ! {why}"
            print(
                f"{category:18}{count:6}{there:7}  {room_type:16}{area:5.0f}{objects:9}{spent:7.1f}{mark}", flush=True
            )
    mean = sum(shares) / len(shares)
    print(f"pieces {met} of {asked} ({met / asked:.1%}); cases met {whole} of {len(shares)}; mean share {mean:.1%}")


if __name__ == "__main__":
    main()
