"""A small building on disk, made by hand: a hall, an office and a kitchen on each floor, a lift and a stair."""

from itertools import pairwise
from pathlib import Path

import msgspec

from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.program import AreaSummary, BuildingProgram, CorePlan, FloorProgram, VerticalConnectivity
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import Door, FloorScene, SceneCore, SceneObject, SceneRoom, SpawnPose, Wall

HEIGHT = 3.2


def box(x0: float, y0: float, x1: float, y1: float) -> list[tuple[float, float]]:
    """Return a rectangle, counter-clockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def room(name: str, kind: str, x0: float, y0: float, x1: float, y1: float) -> SceneRoom:
    """Return a rectangular room."""
    return SceneRoom(
        id=name,
        room_type=kind,
        kind="main" if kind == "hall" else "Entities",
        polygon=box(x0, y0, x1, y1),
        net_polygon=box(x0 + 0.06, y0 + 0.06, x1 - 0.06, y1 - 0.06),
        area=(x1 - x0) * (y1 - y0),
    )


def thing(
    name: str, room_id: str, position: tuple[float, float, float], size: tuple[float, float, float], **more: object
) -> SceneObject:
    """Return an object; `position` is the middle of its lower side."""
    x, y, z = position
    return SceneObject(
        id=f"{room_id}/{name}",
        room=room_id,
        category=name.rsplit("_", 1)[0],
        asset=name,
        position=(x, y, z + size[2] / 2),
        rotation=float(more.pop("rotation", 0.0)),
        size=size,
        **more,
    )


def objects(floor: int) -> list[SceneObject]:
    """Return what stands on a floor."""
    office, kitchen = f"F{floor}/office", f"F{floor}/kitchen"
    desk, fridge, crate = f"{office}/desk_1", f"{kitchen}/fridge_1", f"{office}/box_1"
    return [
        thing("desk_1", office, (3.0, 7.4, 0.0), (1.6, 0.8, 0.74), receptacle=True, rotation=180.0),
        thing("mug_1", office, (3.0, 7.3, 0.74), (0.08, 0.08, 0.1), mount="surface", parent=desk,
              pickupable=True),
        thing("lamp_1", office, (3.5, 7.3, 0.74), (0.2, 0.2, 0.4), mount="surface", parent=desk,
              toggleable=True),
        thing("box_1", office, (0.6, 3.6, 0.0), (0.4, 0.4, 0.3), pickupable=True, receptacle=True,
              openable=True, states={"open": True}),
        thing("ball_1", office, (0.6, 3.6, 0.02), (0.15, 0.15, 0.15), mount="inside", parent=crate,
              pickupable=True),
        thing("shelf_1", office, (5.6, 5.0, 0.0), (0.9, 0.35, 1.9), receptacle=True, rotation=90.0),
        thing("fridge_1", kitchen, (11.5, 7.5, 0.0), (0.7, 0.7, 1.8), receptacle=True, openable=True,
              rotation=180.0),
        thing("apple_1", kitchen, (11.5, 7.5, 0.8), (0.08, 0.08, 0.08), mount="inside", parent=fridge,
              pickupable=True),
        thing("table_1", kitchen, (9.0, 5.5, 0.0), (1.2, 0.8, 0.75), receptacle=True),
        thing("ceiling_light_1", kitchen, (9.0, 5.5, 2.7), (0.4, 0.4, 0.1), mount="ceiling",
              toggleable=True),
    ]  # fmt: skip


WALLS = (
    ("w1", ((0.0, 3.0), (12.0, 3.0))),
    ("w2", ((0.0, 0.0), (0.0, 3.0))),
    ("w3", ((12.0, 0.0), (12.0, 3.0))),
    ("w4", ((6.0, 3.0), (6.0, 8.0))),
)


def cores(floor: int, floors: list[int]) -> list[SceneCore]:
    """Return the lift and the stair, which all floors have."""
    return [
        SceneCore(
            id="elevator_1",
            type="elevator",
            polygon=box(-2, 0, 0, 2),
            door=f"F{floor}/door_3",
            entrance=(0.66, 1.0, 0.0),
            floors=floors,
        ),
        SceneCore(
            id="stair_1",
            type="stair",
            polygon=box(12, 0, 15, 3),
            door=f"F{floor}/door_4",
            entrance=(11.34, 1.5, 180.0),
            floors=floors,
        ),
    ]


def doors(floor: int) -> list[Door]:
    """Return the doors of the hall, and one between office and kitchen."""
    hall, office, kitchen = f"F{floor}/hall", f"F{floor}/office", f"F{floor}/kitchen"
    rows = [
        ("door_1", "single", ((2.0, 3.0), (2.9, 3.0)), (hall, office), "w1"),
        ("door_2", "glazed", ((8.0, 3.0), (8.9, 3.0)), (hall, kitchen), "w1"),
        ("door_3", "sliding", ((0.0, 0.6), (0.0, 1.4)), (hall, "elevator_1"), "w2"),
        ("door_4", "frame", ((12.0, 1.0), (12.0, 2.0)), (hall, "stair_1"), "w3"),
        ("door_5", "doorway", ((6.0, 4.0), (6.0, 4.9)), (office, kitchen), "w4"),
    ]
    return [
        Door(
            id=f"F{floor}/{name}",
            kind=kind,
            segment=segment,
            rooms=rooms,
            width=0.9,
            height=2.1,
            wall=wall,
            is_open=kind != "sliding",
        )
        for name, kind, segment, rooms, wall in rows
    ]


def scene(floor: int, floors: list[int]) -> FloorScene:
    """Return one floor."""
    hall, office, kitchen = f"F{floor}/hall", f"F{floor}/office", f"F{floor}/kitchen"
    return FloorScene(
        building_id="sample",
        floor=floor,
        floors=len(floors),
        label="G" if floor == 1 else str(floor),
        elevation=(floor - 1) * HEIGHT,
        height=HEIGHT,
        outline=[(-2, 0), (15, 0), (15, 3), (12, 3), (12, 8), (0, 8), (0, 2), (-2, 2)],
        rooms=[
            room(hall, "hall", 0, 0, 12, 3),
            room(office, "office", 0, 3, 6, 8),
            room(kitchen, "kitchen", 6, 3, 12, 8),
        ],
        walls=[Wall(id=n, segment=s, thickness=0.12, height=2.8) for n, s in WALLS],
        doors=doors(floor),
        cores=cores(floor, floors),
        objects=objects(floor),
        spawn=SpawnPose(x=6.0, y=1.5, yaw=0.0, room=hall) if floor == 1 else None,
    )


def with_outer_walls(made: FloorScene) -> FloorScene:
    """Return a floor with walls all around, as the exporters expect."""
    corners = [*made.outline, made.outline[0]]
    outer = [
        Wall(id=f"outer_{i}", segment=segment, thickness=0.12, height=2.8)
        for i, segment in enumerate(pairwise(corners))
    ]
    return msgspec.structs.replace(made, walls=[*made.walls, *outer])


def write_building(folder: Path, floors: list[int] | None = None) -> Path:
    """Write the building and return its folder."""
    numbers = floors or [1, 2, 3]
    plans = [
        CorePlan(id="elevator_1", type="elevator", x=(-2, 0), y=(0, 2)),
        CorePlan(id="stair_1", type="stair", x=(12, 15), y=(0, 3)),
    ]
    entries, programs = [], []
    for floor in numbers:
        made = scene(floor, numbers)
        path = Path("floors") / f"floor_{floor}" / "scene.json"
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(encode_bytes(made))
        entries.append(
            FloorEntry(
                floor=floor,
                label=made.label,
                elevation=made.elevation,
                height=HEIGHT,
                area=106.0,
                rooms=3,
                objects=len(made.objects),
                files={"scene": str(path)},
            )
        )
        programs.append(
            FloorProgram(
                index=floor,
                requirement="",
                gross_floor_area=106.0,
                rooms=[],
                area_summary=AreaSummary(sum_rooms=96.0, reserve_ratio=0.1, fits_within_gfa=True),
            )
        )
    building = Building(
        building_id="sample",
        request=BuildRequest(description="a sample"),
        program=BuildingProgram(
            building_id="sample",
            reasoning="",
            vertical_connectivity=VerticalConnectivity(method="stair_and_elevator", cores=plans),
            floors=programs,
        ),
        floors=entries,
        cores=plans,
        seed=0,
    )
    (folder / "building.json").write_bytes(encode_bytes(building))
    return folder
