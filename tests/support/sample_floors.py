"""Small floors to build scenes from, without a planner or a solver."""

from collections.abc import Sequence

import numpy as np
from shapely.geometry import Polygon

from mansion_msgs_py.layout import FloorLayout, LayoutRoom
from mansion_msgs_py.program import AreaSummary, CorePlan, FloorProgram, VerticalConnectivity
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode


def box(x0: float, y0: float, x1: float, y1: float) -> list[tuple[float, float]]:
    """Return a rectangle, counter-clockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def request(
    rooms: dict[str, tuple[str, list[tuple[float, float]]]],
    edges: Sequence[tuple[str, str]],
    *,
    cores: Sequence[CorePlan] = (),
    outline: list[tuple[float, float]] | None = None,
    floor: int = 1,
    floors: Sequence[int] = (1,),
    open_rooms: Sequence[str] = (),
    building_type: str = "office",
    height: float = 3.2,
    seed: int = 0,
    **program: object,
) -> FurnishRequest:
    """Return a request for rooms (id -> type, polygon; the hub first) joined by access edges."""
    hub = next(iter(rooms))
    nodes = [
        TopologyNode(
            id=name,
            type="main" if name == hub else "Entities",
            area=Polygon(polygon).area,
            room_type=kind,
            open_relation="open" if name in open_rooms else "door",
        )
        for name, (kind, polygon) in rooms.items()
    ]
    nodes += [TopologyNode(id=core.id, type=core.type, area=6.0) for core in cores]
    return FurnishRequest(
        building_id="sample",
        floor=FloorProgram(
            index=floor,
            requirement="",
            gross_floor_area=100.0,
            rooms=[],
            area_summary=AreaSummary(sum_rooms=1.0, reserve_ratio=0.2, fits_within_gfa=True),
            label=str(floor),
            elevation=(floor - 1) * height,
            height=height,
            outline=outline or [],
            **program,
        ),
        floors=list(floors),
        labels=[str(number) for number in floors],
        connectivity=VerticalConnectivity(method="stair_and_elevator" if cores else "none", cores=list(cores)),
        topology=FloorTopology(nodes=nodes, edges=[Edge(source=a, target=b) for a, b in edges]),
        layout=FloorLayout(
            rooms=[LayoutRoom(id=name, polygon=polygon) for name, (_, polygon) in rooms.items()],
            topology_satisfied=True,
            hub=hub,
        ),
        building_type=building_type,
        seed=seed,
    )


def office(floor: int = 1, floors: Sequence[int] = (1, 2, 3), seed: int = 0, **more: object) -> FurnishRequest:
    """Return an office floor of 20 x 14 m with a stair and a lift beside its corridor."""
    rooms = {
        "lobby": ("lobby", [(0, 5.5), (6, 5.5), (6, 6), (20, 6), (20, 8), (6, 8), (6, 14), (3, 14), (3, 8), (0, 8)]),
        "open_office_1": ("open_office", box(6, 8, 14, 14)),
        "meeting_room_1": ("meeting_room", box(14, 8, 20, 14)),
        "office_1": ("office", [(2, 0), (6, 0), (6, 5.5), (2, 5.5)]),
        "kitchenette": ("kitchenette", box(6, 0, 10, 6)),
        "toilet_1": ("toilet", box(10, 0, 12.5, 6)),
        "storage": ("storage", box(12.5, 0, 15, 6)),
        "office_2": ("office", box(15, 0, 20, 6)),
        "server_room": ("server_room", box(0, 0, 2, 3.5)),
    }
    cores = [
        CorePlan(id="stair_1", type="stair", x=(0, 3), y=(8, 14), door_side="south"),
        CorePlan(id="elevator_1", type="elevator", x=(0, 2), y=(3.5, 5.5), door_side="north"),
    ]
    edges = [("lobby", name) for name in list(rooms)[1:] if name != "server_room"]
    edges += [("office_1", "server_room"), ("lobby", "stair_1"), ("lobby", "elevator_1")]
    return request(
        rooms,
        edges,
        cores=cores,
        outline=box(0, 0, 20, 14),
        floor=floor,
        floors=floors,
        open_rooms=["lobby", "kitchenette"],
        seed=seed,
        **more,
    )


def flat(seed: int = 0) -> FurnishRequest:
    """Return a flat of 10 x 8 m on one storey."""
    rooms = {
        "living_room": ("living_room", [(0, 0), (6, 0), (6, 4), (4, 4), (4, 8), (0, 8)]),
        "bedroom": ("bedroom", box(6, 3.6, 10, 8)),
        "bathroom": ("bathroom", box(4, 4, 6, 8)),
        "kitchen": ("kitchen", box(6, 0, 10, 3.6)),
    }
    edges = [("living_room", "kitchen"), ("living_room", "bathroom"), ("bathroom", "bedroom")]
    return request(rooms, edges, open_rooms=["kitchen"], building_type="flat", seed=seed)


def random_floor(seed: int, floor: int = 1) -> FurnishRequest:
    """Return a rectilinear floor cut into rooms by random guillotine cuts, joined by a random tree of access edges.

    The outline is an L or a rectangle; walls are at least 1.2 m, so that every neighbour could have a door.
    """
    generator = np.random.default_rng(seed)
    width, depth = (float(v) for v in generator.integers(8, 22, 2))
    boxes = [(0.0, 0.0, width, depth)]
    if generator.random() < 0.5:
        boxes = [(0.0, 0.0, width, depth / 2), (0.0, depth / 2, width / 2, depth)]
    for _ in range(int(generator.integers(2, 14))):
        index = int(np.argmax([(b[2] - b[0]) * (b[3] - b[1]) for b in boxes]))
        boxes[index : index + 1] = _cut(boxes[index], generator)
    polygons = [Polygon(box(*b)) for b in boxes]
    pairs = [(i, j) for i in range(len(boxes)) for j in range(i) if polygons[i].intersection(polygons[j]).length >= 1.3]
    kinds = ["office", "storage", "toilet", "meeting_room", "corridor", "bedroom", "cafeteria"]
    names = [f"room_{i}" for i in range(len(boxes))]
    rooms = {name: (str(generator.choice(kinds)), box(*b)) for name, b in zip(names, boxes, strict=True)}
    order = [pairs[i] for i in generator.permutation(len(pairs))]
    joined = {0}
    edges = []
    while True:
        step = next((p for p in order if (p[0] in joined) != (p[1] in joined)), None)
        if step is None:
            break
        joined.update(step)
        edges.append((names[step[0]], names[step[1]]))
    opened = [name for name in names if generator.random() < 0.2]
    return request(rooms, edges, open_rooms=opened, floor=floor, seed=seed)


def _cut(
    region: tuple[float, float, float, float], generator: np.random.Generator
) -> list[tuple[float, float, float, float]]:
    x0, y0, x1, y1 = region
    wide = x1 - x0 >= y1 - y0
    low, high = (x0, x1) if wide else (y0, y1)
    if high - low < 3.2:
        return [region]
    at = round(float(generator.uniform(low + 1.5, high - 1.5)) * 5) / 5
    if wide:
        return [(x0, y0, at, y1), (at, y0, x1, y1)]
    return [(x0, y0, x1, at), (x0, at, x1, y1)]
