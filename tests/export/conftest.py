"""A small hand-made building of two floors that every exporter is tried on."""

from collections.abc import Callable

import msgspec
import pytest
from shapely.geometry import Polygon

from mansion_export.thor.walls import stretches
from mansion_msgs_py.scene import Door, FloorScene, Light, SceneCore, SceneObject, SceneRoom, SpawnPose, Wall, Window

HEIGHT = 3.2
CORNERS = ((0, 0), (14, 0), (14, 10), (0, 10))
ROOMS = {
    "bedroom_1": ("bedroom", [(0, 6), (5, 6), (5, 10), (0, 10)]),
    "kitchen_1": ("kitchen", [(5, 6), (9, 6), (9, 10), (5, 10)]),
    "storage_1": ("storage", [(9, 8), (11, 8), (11, 10), (9, 10)]),
    "living_room_1": ("living_room", [(0, 0), (8, 0), (8, 4), (0, 4)]),
    "office_1": ("open_office", [(8, 0), (14, 0), (14, 4), (8, 4)]),
    "hub": ("corridor", [(0, 4), (11, 4), (11, 6), (0, 6)]),
}
CORES = {"stair": [(11, 4), (14, 4), (14, 10), (11, 10)], "lift": [(9, 6), (11, 6), (11, 8), (9, 8)]}
DOORS = (
    ("bedroom_1", "hub", "single", ((2.0, 6.0), (2.9, 6.0)), "start"),
    ("kitchen_1", "hub", "glazed", ((6.0, 6.0), (7.0, 6.0)), "end"),
    ("storage_1", "kitchen_1", "single", ((9.0, 8.5), (9.0, 9.4)), "end"),
    ("living_room_1", "hub", "open", ((1.0, 4.0), (7.0, 4.0)), "none"),
    ("office_1", "hub", "double", ((8.6, 4.0), (10.2, 4.0)), "both"),
    ("stair", "hub", "frame", ((11.0, 4.5), (11.0, 5.5)), "none"),
    ("lift", "hub", "sliding", ((9.5, 6.0), (10.5, 6.0)), "none"),
)
OBJECTS = (
    ("bedroom_1", "bed", (1.0, 9.0, 0.3), 180.0, (1.6, 2.0, 0.6), "Bed_1"),
    ("bedroom_1", "nightstand", (2.1, 9.75, 0.25), 180.0, (0.45, 0.4, 0.5), None),
    ("bedroom_1", "wardrobe", (4.65, 8.0, 1.0), 90.0, (1.6, 0.6, 2.0), None),
    ("kitchen_1", "counter", (6.5, 9.7, 0.45), 180.0, (2.4, 0.6, 0.9), None),
    ("kitchen_1", "stove", (8.1, 9.7, 0.45), 180.0, (0.6, 0.6, 0.9), None),
    ("kitchen_1", "dining_table", (6.8, 7.9, 0.375), 0.0, (1.2, 0.8, 0.75), "Dining_Table_1"),
    ("living_room_1", "sofa", (3.0, 0.5, 0.4), 0.0, (2.1, 0.9, 0.8), "Sofa_1"),
    ("living_room_1", "coffee_table", (3.0, 1.6, 0.2), 0.0, (1.1, 0.6, 0.4), None),
    ("living_room_1", "rug", (3.0, 1.4, 0.01), 0.0, (2.6, 2.0, 0.02), None),
    ("living_room_1", "house_plant", (7.5, 0.5, 0.5), 30.0, (0.5, 0.5, 1.0), "HousePlant_1"),
    ("office_1", "desk", (9.2, 0.5, 0.37), 0.0, (1.4, 0.7, 0.74), None),
    ("office_1", "office_chair", (9.2, 1.15, 0.45), 180.0, (0.6, 0.6, 0.9), None),
    ("office_1", "bookshelf", (13.8, 2.0, 0.9), 90.0, (1.2, 0.35, 1.8), None),
)


def make_floor(floor: int, floors: int = 2) -> FloorScene:
    """Make one storey; the ground floor has an entrance door."""
    name = f"F{floor}"
    rings = {f"{name}/{key}": [list(ring)] for key, (_, ring) in ROOMS.items()}
    rings |= {f"{name}/{key}": [list(ring)] for key, ring in CORES.items()}
    doors = _doors(name)
    if floor == 1:
        doors.append(_entrance(name))
    walls = _walls(name, rings, doors)
    doors = [_in_wall(door, walls) for door in doors]
    return FloorScene(
        building_id="sample_house",
        floor=floor,
        floors=floors,
        label=str(floor),
        elevation=(floor - 1) * 3.4,
        height=3.4,
        outline=[(0, 0), (14, 0), (14, 10), (0, 10)],
        rooms=[_room(name, key, kind, ring) for key, (kind, ring) in ROOMS.items()],
        walls=walls,
        doors=doors,
        windows=_windows(name, walls),
        cores=[_core(name, key, ring, floors) for key, ring in CORES.items()],
        objects=[*(_object(name, i, *item) for i, item in enumerate(OBJECTS)), _cup(name)],
        spawn=SpawnPose(x=5.0, y=5.0, yaw=0.0, room=f"{name}/hub"),
        lights=[
            Light(
                id=f"{name}/{key}/light",
                kind="point",
                position=(*Polygon(ring).centroid.coords[0], 2.9),
                room=f"{name}/{key}",
            )
            for key, (_, ring) in ROOMS.items()
        ],
    )


def _doors(floor: str) -> list[Door]:
    return [
        Door(
            id=f"{floor}/door_{i + 1}",
            kind=kind,
            segment=segment,
            rooms=(f"{floor}/{a}", f"{floor}/{b}"),
            width=abs(segment[1][0] - segment[0][0]) + abs(segment[1][1] - segment[0][1]),
            height=HEIGHT - 0.3 if kind == "open" else 2.1,
            hinge=hinge,
            swing=f"{floor}/{a}",
            is_open=kind != "sliding",
        )
        for i, (a, b, kind, segment, hinge) in enumerate(DOORS)
    ]


def _entrance(floor: str) -> Door:
    return Door(
        id=f"{floor}/entrance",
        kind="entrance",
        segment=((-0.1, 4.6), (-0.1, 5.6)),
        rooms=(f"{floor}/hub", None),
        width=1.0,
        height=2.1,
        hinge="start",
        swing=f"{floor}/hub",
        is_open=False,
    )


def _core(floor: str, key: str, ring: list[tuple[float, float]], floors: int) -> SceneCore:
    stair = key == "stair"
    return SceneCore(
        id=f"{floor}/{key}",
        type="stair" if stair else "elevator",
        polygon=ring,
        door=f"{floor}/door_{6 if stair else 7}",
        entrance=(10.4, 5.0, 180.0) if stair else (10.0, 5.4, 270.0),
        floors=list(range(1, floors + 1)),
    )


def _cup(floor: str) -> SceneObject:
    return SceneObject(
        id=f"{floor}/kitchen_1/cup_1",
        room=f"{floor}/kitchen_1",
        category="cup",
        asset="cup",
        asset_id="Cup_1",
        position=(6.8, 7.9, 0.8),
        rotation=0.0,
        size=(0.08, 0.08, 0.1),
        mount="surface",
        parent=f"{floor}/kitchen_1/dining_table_6",
        pickupable=True,
    )


def _room(floor: str, key: str, kind: str, ring: list[tuple[float, float]]) -> SceneRoom:
    polygon = Polygon(ring)
    net = polygon.buffer(-0.06, join_style=2)
    return SceneRoom(
        id=f"{floor}/{key}",
        room_type=kind,
        kind="main" if key == "hub" else "area",
        polygon=[(float(x), float(y)) for x, y in ring],
        net_polygon=list(net.exterior.coords)[:-1][::-1],
        area=polygon.area,
        floor_material="oak",
        wall_material="white paint",
        ceiling_material="white paint",
    )


def _walls(floor: str, rings: dict, doors: list[Door]) -> list[Wall]:
    """One wall for each stretch of boundary, without the stretches that `open` doors leave open."""
    walls = []
    for stretch in stretches(rings):
        if stretch.neighbour is not None and stretch.neighbour < stretch.owner:
            continue
        (ax, ay), (bx, by) = stretch.start, stretch.end
        horizontal = ay == by
        outside = stretch.neighbour is None
        if outside:
            ux, uy = (bx - ax) / stretch.length * 0.1, (by - ay) / stretch.length * 0.1
            ax, ay, bx, by = ax + uy, ay - ux, bx + uy, by - ux
            if stretch.start in CORNERS:
                ax, ay = ax - ux, ay - uy
            if stretch.end in CORNERS:
                bx, by = bx + ux, by + uy
        gaps = [
            sorted(p[0] if horizontal else p[1] for p in door.segment)
            for door in doors
            if door.kind == "open" and set(door.rooms) == {stretch.owner, stretch.neighbour}
        ]
        low, high = sorted((ax, bx) if horizontal else (ay, by))
        cuts = [low, *(value for gap in gaps for value in gap), high]
        for start, end in zip(cuts[::2], cuts[1::2]):
            forward = (bx > ax) if horizontal else (by > ay)
            p, q = (start, end) if forward else (end, start)
            walls.append(
                Wall(
                    id=f"{floor}/wall_{len(walls) + 1}",
                    segment=((p, ay), (q, by)) if horizontal else ((ax, p), (bx, q)),
                    thickness=0.2 if outside else 0.12,
                    height=HEIGHT,
                    exterior=outside,
                    left=stretch.owner,
                    right=stretch.neighbour,
                )
            )
    return walls


def _in_wall(door: Door, walls: list[Wall]) -> Door:
    if door.kind == "open":
        return door
    return msgspec.structs.replace(door, wall=next(wall.id for wall in walls if _holds(wall, door)))


def _holds(wall: Wall, door: Door) -> bool:
    (ax, ay), (bx, by) = wall.segment
    return all(
        min(ax, bx) - 1e-6 <= x <= max(ax, bx) + 1e-6 and min(ay, by) - 1e-6 <= y <= max(ay, by) + 1e-6
        for x, y in door.segment
    )


def _windows(floor: str, walls: list[Wall]) -> list[Window]:
    """A window in the middle of each long outer wall of a room."""
    windows = []
    for wall in walls:
        (ax, ay), (bx, by) = wall.segment
        length = abs(bx - ax) + abs(by - ay)
        if not wall.exterior or length < 3 or wall.left.endswith(("stair", "hub")):
            continue
        ux, uy = (bx - ax) / length, (by - ay) / length
        mx, my = (ax + bx) / 2, (ay + by) / 2
        windows.append(
            Window(
                id=f"{floor}/window_{len(windows) + 1}",
                wall=wall.id,
                room=wall.left,
                segment=((mx - 0.8 * ux, my - 0.8 * uy), (mx + 0.8 * ux, my + 0.8 * uy)),
                sill=0.9,
                height=1.3,
            )
        )
    return windows


def _object(
    floor: str,
    index: int,
    room: str,
    category: str,
    position: tuple[float, float, float],
    rotation: float,
    size: tuple[float, float, float],
    asset_id: str | None,
) -> SceneObject:
    return SceneObject(
        id=f"{floor}/{room}/{category}_{index + 1}",
        room=f"{floor}/{room}",
        category=category,
        asset=category,
        asset_id=asset_id,
        position=position,
        rotation=rotation,
        size=size,
        receptacle="table" in category,
        color="#b08968",
    )


@pytest.fixture
def floor_of() -> Callable[[int], FloorScene]:
    """Return the maker of floors, for tests that change what they get."""
    return make_floor


@pytest.fixture
def ground() -> FloorScene:
    """The sample's ground floor."""
    return make_floor(1)


@pytest.fixture
def building() -> list[FloorScene]:
    """Both floors of the sample."""
    return [make_floor(1), make_floor(2)]
