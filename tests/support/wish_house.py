"""A small house of two storeys, drawn by hand: its program and its scenes, to judge wishes by."""

from collections.abc import Sequence

from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout, LayoutRoom
from mansion_msgs_py.program import (
    AreaSummary,
    BuildingProgram,
    CorePlan,
    FloorProgram,
    RoomProgram,
    VerticalConnectivity,
)
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene, SceneCore, SceneObject, SceneRoom
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.wishes import Scope, Wish, WishKind, WishValue

__all__ = ["DESCRIPTION", "L_OUTLINE", "box", "building", "layouts", "program", "scenes", "wish"]

DESCRIPTION = "a house that is described here in as many words as any test of its wishes needs"

Rooms = dict[str, tuple[str, tuple[float, float, float, float]]]
GROUND: Rooms = {
    "hallway": ("hallway", (0, 0, 2, 8)),
    "kitchen": ("kitchen", (2, 0, 6, 4)),
    "dining_room": ("dining_room", (6, 0, 10, 4)),
    "living_room": ("living_room", (2, 4, 10, 8)),
}
UPPER: Rooms = {
    "hallway": ("hallway", (0, 0, 2, 8)),
    "bedroom_1": ("bedroom", (2, 0, 6, 4)),
    "bedroom_2": ("bedroom", (6, 0, 10, 4)),
    "pottery": ("study_room", (2, 4, 10, 8)),
}
THINGS = {
    "F1/kitchen": ["stove", "sink"],
    "F1/living_room": ["sofa", "coffee_table"],
    "F2/pottery": ["office_desk", "office_desk", "office_chair", "office_chair"],
    "F2/bedroom_1": ["bed"],
    "F2/bedroom_2": ["bed", "bed"],
}
L_OUTLINE: Ring = [(0, 0), (10, 0), (10, 4), (5, 4), (5, 8), (0, 8)]


def box(x0: float, y0: float, x1: float, y1: float) -> Ring:
    """Return a rectangle, counter-clockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def wish(kind: WishKind, value: WishValue | None = None, scope: Scope | None = None, *, name: str = "wish_1") -> Wish:
    """Return a wish of the description's first words, without a status."""
    return Wish(id=name, text="a house", span=(0, 7), kind=kind, value=value or WishValue(), scope=scope or Scope())


def program(wishes: Sequence[Wish] = (), outline: Ring | None = None) -> BuildingProgram:
    """Return the program of the house."""
    floors = [
        FloorProgram(
            index=number,
            requirement=f"{'ground' if number == 1 else 'top'} storey of a house: kitchen",
            gross_floor_area=80.0,
            rooms=[
                RoomProgram(id=name, area_estimate=(x1 - x0) * (y1 - y0), room_type=kind)
                for name, (kind, (x0, y0, x1, y1)) in rooms.items()
            ],
            area_summary=AreaSummary(sum_rooms=80.0, reserve_ratio=0.0, fits_within_gfa=True),
            height=3.0,
            outline=outline or box(0, 0, 10, 8),
        )
        for number, rooms in ((1, GROUND), (2, UPPER))
    ]
    return BuildingProgram(
        building_id="house",
        reasoning="",
        vertical_connectivity=VerticalConnectivity(
            method="stair", cores=[CorePlan(id="stair_1", type="stair", x=(0, 2), y=(8, 12))]
        ),
        floors=floors,
        building_type="house",
        style="modern",
        wishes=list(wishes),
    )


def scenes(outline: Ring | None = None) -> list[FloorScene]:
    """Return the two floors of the house, furnished."""
    return [_scene(number, rooms, outline) for number, rooms in ((1, GROUND), (2, UPPER))]


def _scene(number: int, rooms: Rooms, outline: Ring | None) -> FloorScene:
    floor = f"F{number}"
    stair = SceneCore(
        id="stair_1", type="stair", polygon=box(0, 8, 2, 12), door=f"{floor}/door_1", entrance=(1, 7, 0), floors=[1, 2]
    )
    return FloorScene(
        building_id="house",
        floor=number,
        floors=2,
        label=str(number),
        elevation=3.0 * (number - 1),
        height=3.0,
        outline=outline or box(0, 0, 10, 8),
        rooms=[
            SceneRoom(
                id=f"{floor}/{name}",
                room_type=kind,
                kind="main" if name == "hallway" else "Entities",
                polygon=box(*corners),
                net_polygon=box(*corners),
                area=(corners[2] - corners[0]) * (corners[3] - corners[1]),
                floor_material="oak_hardwood",
                wall_material="white_drywall",
                ceiling_height=2.75,
                aliases=["pottery room"] if name == "pottery" else [],
            )
            for name, (kind, corners) in rooms.items()
        ],
        walls=[],
        doors=[],
        cores=[stair],
        objects=[
            SceneObject(
                id=f"{room}/{category}_{count}",
                room=room,
                category=category,
                asset=category,
                position=(0.0, 0.0, 0.5),
                rotation=0.0,
                size=(1.0, 1.0, 1.0),
            )
            for room, categories in THINGS.items()
            if room.startswith(floor)
            for count, category in enumerate(categories, 1)
        ],
        style="modern",
        building_type="house",
    )


def layouts(floors: Sequence[FloorScene]) -> list[FloorLayout]:
    """Return the layouts that the scenes were made from."""
    return [
        FloorLayout(
            rooms=[LayoutRoom(id=room.id.split("/")[1], polygon=room.polygon) for room in floor.rooms],
            topology_satisfied=True,
            floor=floor.floor,
        )
        for floor in floors
    ]


def building(plan: BuildingProgram, wishes: Sequence[Wish]) -> Building:
    """Return the index of the house, with its ledger as it was settled."""
    return Building(
        building_id="house",
        request=BuildRequest(description=DESCRIPTION),
        program=plan,
        floors=[],
        cores=plan.vertical_connectivity.cores,
        seed=0,
        wishes=list(wishes),
    )
