"""Rooms of the scene: polygons, net interiors, names and materials."""

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.topology import TopologyNode
from mansion_scene.structure.interiors import Partition
from mansion_scene.structure.materials import match_material
from mansion_scene.structure.regions import FloorRegions, Region, ring_points
from mansion_scene.structure.room_classes import is_class

__all__ = ["scene_rooms"]

_FLOORS = (
    ("wet", "grey ceramic tile"),
    ("outdoor", "timber deck"),
    ("store", "sealed polished concrete"),
    ("office", "neutral gray carpet"),
    ("clinical", "hygienic hospital vinyl"),
    ("teaching", "beige vinyl"),
    ("welcome", "terrazzo"),
    ("sleeping", "light hardwood"),
)
_WALLS = (("wet", "white ceramic tiles"), ("clinical", "hygienic washable panels"))
_ACOUSTIC = ("office", "teaching", "clinical", "assembly")


def scene_rooms(request: FurnishRequest, floor: FloorRegions, partition: Partition, ceiling: float) -> list[SceneRoom]:
    """Return the floor's rooms in the order of its layout.

    Materials come from the room graph's descriptions, else from the program's, else from the room's type.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when walls leave nothing of a room.
    """
    nodes = {node.id: node for node in request.topology.nodes}
    programs = {room.id: room for room in request.floor.rooms}
    return [
        _room(region, nodes.get(region.node), programs.get(region.node), partition, ceiling)
        for region in floor.regions
        if region.is_room
    ]


def _room(
    region: Region, node: TopologyNode | None, program: RoomProgram | None, partition: Partition, ceiling: float
) -> SceneRoom:
    net = partition.nets[region.id]
    if net.is_empty or net.area < 0.05:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"nothing of {region.id} is left between its walls; a room must be wider than 0.12 m",
            path="$.layout.rooms",
        )
    floor_words = (node.floor_material if node else "") or (program.floor_material if program else "")
    wall_words = (node.wall_material if node else "") or (program.wall_material if program else "")
    return SceneRoom(
        id=region.id,
        room_type=region.room_type,
        kind=region.node_kind,
        polygon=ring_points(region.polygon.exterior),
        holes=[ring_points(hole) for hole in region.polygon.interiors],
        net_polygon=ring_points(net.exterior),
        net_holes=[ring_points(hole) for hole in net.interiors],
        area=round(region.polygon.area, 4),
        name=region.node.replace("_", " ").capitalize(),
        floor_material=match_material(floor_words or _by_type(region, _FLOORS), "floor").name,
        wall_material=match_material(wall_words or _by_type(region, _WALLS), "wall").name,
        ceiling_material=match_material(_ceiling(region), "ceiling").name,
        ceiling_height=ceiling,
        open_relation=region.open_relation,
    )


def _by_type(region: Region, table: tuple[tuple[str, str], ...]) -> str:
    return next((words for name, words in table if is_class(region.room_type, name)), "")


def _ceiling(region: Region) -> str:
    acoustic = any(is_class(region.room_type, name) for name in _ACOUSTIC)
    return "suspended acoustic ceiling tile" if acoustic else "smooth white plaster"
