"""The regions of a floor: its rooms and its cores, as clean rings with a common id space."""

from dataclasses import dataclass
from typing import Literal

import shapely
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.shapes import Point, Ring
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.topology import NodeKind, TopologyNode

__all__ = ["FloorRegions", "Region", "floor_regions", "ring_points", "room_id"]

_OVERLAP = 0.02  # square metres of two rooms' overlap that rounding explains


@dataclass(frozen=True)
class Region:
    """A room or a core: its plan on wall centre lines.

    Attributes
    ----------
    id : str
        ``F2/office_1`` of a room, ``stair_1`` of a core.
    node : str
        Id in the floor's room graph.
    name : str
        What people call it; empty where they do not name it.
    polygon : Polygon
        Counter-clockwise, holes clockwise.
    """

    id: str
    node: str
    kind: Literal["room", "stair", "elevator"]
    polygon: Polygon
    room_type: str = ""
    node_kind: NodeKind = "Entities"
    open_relation: Literal["open", "door"] = "door"
    core: CorePlan | None = None
    name: str = ""

    @property
    def is_room(self) -> bool:
        """Whether it is a room rather than a core."""
        return self.kind == "room"


@dataclass(frozen=True)
class FloorRegions:
    """All regions of a floor in the order of its layout, cores last; `by_node` finds them by their node's id."""

    floor: int
    regions: tuple[Region, ...]
    outline: Polygon
    by_node: dict[str, Region]
    by_id: dict[str, Region]
    hub: Region


def room_id(floor: int, node: str) -> str:
    """Return the scene's id of a room.

    Examples
    --------
    >>> room_id(2, "office_1"), room_id(2, "F2/office_1")
    ('F2/office_1', 'F2/office_1')
    """
    prefix = f"F{floor}/"
    return node if node.startswith(prefix) else prefix + node


def ring_points(ring: shapely.LinearRing) -> Ring:
    """Return a ring's points, the first not repeated, without points on straight runs; 0.1 mm."""
    points = [(round(float(x), 4) + 0.0, round(float(y), 4) + 0.0) for x, y in ring.coords[:-1]]
    points = [p for i, p in enumerate(points) if p != points[i - 1]]
    return [p for i, p in enumerate(points) if not _is_between(points[i - 1], p, points[(i + 1) % len(points)])]


def _is_between(a: Point, p: Point, b: Point) -> bool:
    cross = (p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])
    length = max(abs(b[0] - a[0]), abs(b[1] - a[1]), 1e-9)
    return abs(cross) / length < 2e-4


def _polygon(ring: Ring, holes: list[Ring], path: str) -> Polygon:
    polygon = Polygon(ring, holes) if len(ring) >= 3 else Polygon()
    if polygon.is_empty or not polygon.is_valid or polygon.area < 0.05:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, "a simple polygon of at least 0.05 m2 is needed, with holes inside it", path=path
        )
    return orient(polygon)


def _rooms(request: FurnishRequest, nodes: dict[str, TopologyNode]) -> list[Region]:
    programs = {room.id: room for room in request.floor.rooms}
    rooms = []
    for index, room in enumerate(request.layout.rooms):
        node = nodes.get(room.id)
        program = programs.get(room.id)
        room_type = (node.room_type if node else "") or (program.room_type if program else "")
        rooms.append(
            Region(
                id=room_id(request.floor.index, room.id),
                node=room.id,
                kind="room",
                polygon=_polygon(room.polygon, room.holes, f"$.layout.rooms[{index}].polygon"),
                room_type=room_type or _type_of_id(room.id),
                node_kind=node.type if node else "Entities",
                open_relation=node.open_relation if node else "door",
                name=program.name if program else "",
            )
        )
    return rooms


def _type_of_id(name: str) -> str:
    head, _, tail = name.rpartition("_")
    return head if head and tail.isdigit() else name


def _cores(request: FurnishRequest) -> list[Region]:
    cores = []
    for index, core in enumerate(request.connectivity.cores):
        (x0, x1), (y0, y1) = sorted(core.x), sorted(core.y)
        box = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        polygon = _polygon(box, [], f"$.connectivity.cores[{index}]")
        cores.append(Region(core.id, core.id, core.type, polygon, core.type, core.type, core=core))
    return cores


def floor_regions(request: FurnishRequest) -> FloorRegions:
    """Read the regions of a furnish request.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` when there is no room, an id occurs twice, a polygon is not simple, or two regions overlap.
    """
    nodes = {node.id: node for node in request.topology.nodes}
    rooms = _rooms(request, nodes)
    if not rooms:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "the layout has no room", path="$.layout.rooms")
    regions = tuple(rooms + _cores(request))
    by_node = {region.node: region for region in regions}
    if len(by_node) < len(regions):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "room and core ids must be unique", path="$.layout")
    _refuse_overlaps(regions)
    hub = by_node.get(request.layout.hub) or next((r for r in rooms if r.node_kind == "main"), rooms[0])
    outline = (
        _polygon(request.floor.outline, request.floor.holes, "$.floor.outline")
        if request.floor.outline
        else _outline_of(regions)
    )
    return FloorRegions(request.floor.index, regions, outline, by_node, {r.id: r for r in regions}, hub)


def _outline_of(regions: tuple[Region, ...]) -> Polygon:
    union = shapely.union_all([region.polygon for region in regions], grid_size=1e-4)
    if union.geom_type != "Polygon":
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, "the rooms of a floor must touch each other", path="$.layout.rooms"
        )
    return orient(union)


def _refuse_overlaps(regions: tuple[Region, ...]) -> None:
    polygons = [region.polygon for region in regions]
    tree = shapely.STRtree(polygons)
    first, second = tree.query(polygons, predicate="intersects")
    for i, j in sorted(zip(first.tolist(), second.tolist())):
        if i < j and polygons[i].intersection(polygons[j]).area > _OVERLAP:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"{regions[i].id} and {regions[j].id} overlap; regions may only share their boundary",
                path="$.layout.rooms",
            )
