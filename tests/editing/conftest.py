"""A small building made by hand: a hall and a kitchen, and above them an office and a corridor, joined by a stair."""

from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.state import SceneState
from mansion_editing.storage import BuildingStore, Validator
from mansion_editing.tools.furnishing import Furnisher
from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.program import AreaSummary, BuildingProgram, FloorProgram, RoomProgram, VerticalConnectivity
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import Door, FloorScene, SceneCore, SceneObject, SceneRoom, SpawnPose, Wall
from mansion_msgs_py.topology import FloorTopology, TopologyNode
from mansion_scene.decor.frames import scene_object
from mansion_scene.lighting import room_lights


def _rectangle(x0: float, y0: float, x1: float, y1: float) -> list[tuple[float, float]]:
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def _room(name: str, kind: str, box: tuple[float, float, float, float], role: str) -> SceneRoom:
    x0, y0, x1, y1 = box
    return SceneRoom(
        id=name,
        room_type=kind,
        kind=role,  # type: ignore[arg-type]
        polygon=_rectangle(*box),
        net_polygon=_rectangle(x0 + 0.06, y0 + 0.06, x1 - 0.06, y1 - 0.06),
        area=(x1 - x0) * (y1 - y0),
        name=name.partition("/")[2].replace("_", " ").capitalize(),
        floor_material="oak_hardwood",
        wall_material="white_drywall",
        ceiling_material="white_drywall",
    )


def _wall(name: str, a: tuple[float, float], b: tuple[float, float], left: str, right: str | None) -> Wall:
    return Wall(
        id=name, segment=(a, b), thickness=0.12 if right else 0.24, height=2.8, exterior=right is None, left=left,
        right=right, left_material="white_drywall", right_material="white_drywall" if right else "facade_render",
    )  # fmt: skip


def _node(room: SceneRoom) -> TopologyNode:
    return TopologyNode(id=room.id.partition("/")[2], type=room.kind, area=room.area, room_type=room.room_type)


def _door(name: str, a: tuple[float, float], b: tuple[float, float], *rooms: str | None) -> Door:
    return Door(id=name, kind="single", segment=(a, b), rooms=(rooms[0] or "", rooms[1]), width=0.9, height=2.1)


def _floor(number: int, rooms: list[SceneRoom], doors: list[Door], objects: list[SceneObject]) -> FloorScene:
    core = SceneCore(
        id="stair_1",
        type="stair",
        polygon=_rectangle(0, 6, 3, 12),
        door=f"F{number}/door_stair",
        entrance=(1.5, 5.4, 270.0),
        floors=[1, 2],
    )
    return FloorScene(
        building_id="house",
        floor=number,
        floors=2,
        label=str(number),
        elevation=3.2 * (number - 1),
        height=3.2,
        outline=_rectangle(0, 0, 12, 12),
        rooms=rooms,
        walls=[
            _wall(f"F{number}/wall_1", (6, 0), (6, 6), rooms[0].id, rooms[1].id),
            _wall(f"F{number}/wall_2", (12.12, 0), (12.12, 6), rooms[1].id, None),
        ],
        doors=doors,
        cores=[core],
        objects=objects,
        lights=[light for room in rooms for light in room_lights(room, objects)],
        spawn=SpawnPose(x=1.0, y=1.0, yaw=90.0, room=rooms[0].id),
    )


@pytest.fixture(scope="session")
def catalogue() -> Catalogue:
    """Return the shipped catalogue."""
    return load_catalogue()


@pytest.fixture
def scenes(catalogue: Catalogue) -> list[FloorScene]:
    """Return the two floors."""

    def stand(name: str, key: str, x: float, y: float, turn: float = 0.0) -> SceneObject:
        asset = catalogue.asset(key)
        room = name.rsplit("/", 1)[0]
        return scene_object(asset, name, room, (x, y, asset.size[2] / 2), turn)

    table = stand("F1/kitchen/dining_table_1", catalogue.by_category("dining_table")[0].key, 9, 3)
    mug = catalogue.by_category("mug")[0]
    on_table = scene_object(
        mug,
        "F1/kitchen/mug_1",
        "F1/kitchen",
        (9.0, 3.0, table.size[2] + mug.size[2] / 2),
        0.0,
        mount="surface",
        parent=table.id,
    )
    first = _floor(
        1,
        [_room("F1/hall", "hall", (0, 0, 6, 6), "main"), _room("F1/kitchen", "kitchen", (6, 0, 12, 6), "Entities")],
        [
            _door("F1/door_out", (1, 0), (1.9, 0), "F1/hall", None),
            _door("F1/door_1", (6, 4), (6, 4.9), "F1/hall", "F1/kitchen"),
            _door("F1/door_stair", (1, 6), (1.9, 6), "F1/hall", "stair_1"),
        ],
        [
            stand("F1/kitchen/fridge_1", "Fridge_1", 11.0, 0.5),
            table,
            on_table,
            stand("F1/hall/sofa_1", catalogue.by_category("sofa")[0].key, 4.0, 1.0),
            scene_object(
                catalogue.by_category("smoke_detector")[0], "F1/hall/smoke_detector_1", "F1/hall", (3.0, 3.0, 2.77), 0.0
            ),
        ],
    )
    second = _floor(
        2,
        [
            _room("F2/corridor", "corridor", (0, 0, 6, 6), "main"),
            _room("F2/private_office_1", "private_office", (6, 0, 12, 6), "Entities"),
        ],
        [
            _door("F2/door_1", (6, 4), (6, 4.9), "F2/corridor", "F2/private_office_1"),
            _door("F2/door_stair", (1, 6), (1.9, 6), "F2/corridor", "stair_1"),
        ],
        [
            stand("F2/private_office_1/office_desk_1", "office_desk_1", 9.0, 1.0),
            stand("F2/private_office_1/floor_lamp_1", catalogue.by_category("floor_lamp")[0].key, 11.5, 5.5),
        ],
    )
    return [decode(FloorScene, encode_bytes(floor)) for floor in (first, second)]


@pytest.fixture
def state(scenes: list[FloorScene], catalogue: Catalogue) -> SceneState:
    """Return the building in memory."""
    return SceneState(scenes, catalogue)


@pytest.fixture
def folder(scenes: list[FloorScene], tmp_path: Path) -> Path:
    """Return the building on disk."""
    entries = []
    for scene in scenes:
        name = f"floors/floor_{scene.floor}/scene.json"
        (tmp_path / name).parent.mkdir(parents=True)
        (tmp_path / name).write_bytes(encode_bytes(scene, indent=1))
        graph = FloorTopology(nodes=[_node(room) for room in scene.rooms], edges=[], floor=scene.floor)
        (tmp_path / floor_directory(scene.floor) / "topology.json").write_bytes(encode_bytes(graph, indent=1))
        entries.append(
            FloorEntry(
                floor=scene.floor,
                label=scene.label,
                elevation=scene.elevation,
                height=scene.height,
                area=144.0,
                rooms=len(scene.rooms),
                objects=len(scene.objects),
                files={"scene": name},
            )
        )
    area = AreaSummary(sum_rooms=108.0, reserve_ratio=0.25, fits_within_gfa=True)
    program = BuildingProgram(
        building_id="house",
        reasoning="made by hand",
        vertical_connectivity=VerticalConnectivity(method="stair"),
        floors=[
            FloorProgram(
                index=scene.floor,
                requirement="",
                gross_floor_area=144.0,
                rooms=[
                    RoomProgram(id=room.id.partition("/")[2], area_estimate=room.area, room_type=room.room_type)
                    for room in scene.rooms
                ],
                area_summary=area,
            )
            for scene in scenes
        ],
    )
    request = BuildRequest(description="a house of two floors")
    building = Building(building_id="house", request=request, program=program, floors=entries, cores=[], seed=0)
    (tmp_path / "building.json").write_bytes(encode_bytes(building, indent=1))
    return tmp_path


@pytest.fixture
def open_editor(folder: Path, catalogue: Catalogue) -> Callable[..., SceneEditor]:
    """Return what opens an editor of the folder."""

    def make(
        who: str = "ann",
        *,
        autosave: bool = True,
        validator: Validator | None = None,
        furnisher: Furnisher | None = None,
    ) -> SceneEditor:
        store = BuildingStore(folder, validator=validator, clock=lambda: "2026-01-01T00:00:00")
        return SceneEditor(store, catalogue, StaticEngine(), who=who, autosave=autosave, furnisher=furnisher)

    return make
