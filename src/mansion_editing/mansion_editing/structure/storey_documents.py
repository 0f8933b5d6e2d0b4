"""The documents of one storey before and after a change of its structure, kept consistent with each other."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray
from shapely import Polygon, box

from mansion_assets.catalogue import Catalogue
from mansion_editing.structure.room_shapes import layout_room, polygon_of
from mansion_editing.tools.furnishing import Furnisher
from mansion_geometry.shared_walls import edge_array, longest_wall, shared_walls, total_length
from mansion_geometry.wall_sizes import ACCESS_WALL, ADJACENT_WALL
from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, RealisedEdge, UnmetEdge
from mansion_msgs_py.program import BuildingProgram, FloorProgram, RoomProgram
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.topology import Edge, FloorTopology

__all__ = [
    "Judge",
    "Reshaped",
    "Storey",
    "Workshop",
    "added_access",
    "node_of",
    "region_shapes",
    "storey_of",
    "updated_building",
    "with_floor",
    "with_shapes",
    "with_topology",
]

Judge = Callable[[FloorScene], Sequence[str]]
"""Returns the faults that a building would have with a storey, and has not now."""


@dataclass(frozen=True)
class Storey:
    """A storey as its documents describe it.

    Attributes
    ----------
    program : BuildingProgram
        The building's program: the storey's own part says what its rooms are, the rest where its cores are.
    """

    program: BuildingProgram
    topology: FloorTopology
    layout: FloorLayout
    scene: FloorScene

    @property
    def number(self) -> int:
        """Number of the floor."""
        return self.scene.floor

    @property
    def floor(self) -> FloorProgram:
        """The storey's own part of the program."""
        return next(floor for floor in self.program.floors if floor.index == self.number)

    def room(self, room_id: str, path: str = "$.room_id") -> SceneRoom:
        """Return a room by its id in the scene.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` with the rooms that there are.
        """
        for room in self.scene.rooms:
            if room.id == room_id:
                return room
        known = ", ".join(room.id for room in self.scene.rooms)
        raise MansionError(
            ErrorCode.NOT_FOUND, f"no room {room_id[:120]!r} on floor {self.number}; there are {known}", path=path
        )


@dataclass(frozen=True)
class Workshop:
    """What a change of structure needs beside the documents.

    Attributes
    ----------
    catalogue : Catalogue
        Furniture for rooms that are furnished again.
    furnisher : Furnisher
        The placer, which furnishes them.
    judge : callable
        Says what would be wrong with a finished storey; a change that adds a fault is not made.
    go_on : callable
        Asked before each way to make a change; raises where nobody wants it any more.
    """

    catalogue: Catalogue
    furnisher: Furnisher
    judge: Judge
    go_on: Callable[[], None] = lambda: None


@dataclass(frozen=True)
class Reshaped:
    """A storey after a change.

    Attributes
    ----------
    storey : Storey
    moved : list of str
        A plain sentence for each thing that is not as it was.
    """

    storey: Storey
    moved: list[str]


def storey_of(folder: BuildingFolder, floor: int) -> Storey:
    """Return the documents of a storey from a building folder."""
    return Storey(folder.building.program, folder.topology(floor), folder.layout(floor), folder.scene(floor))


def node_of(room: SceneRoom | str) -> str:
    """Return the name of a room in its storey's program, room graph and layout.

    Examples
    --------
    >>> node_of("F2/office_1"), node_of("stair_1")
    ('office_1', 'stair_1')
    """
    name = room if isinstance(room, str) else room.id
    return name.partition("/")[2] or name


def updated_building(building: Building, changes: Sequence[tuple[Storey, Storey]]) -> Building:
    """Return ``building.json`` after a change of storeys: its program, areas and counts, not yet its wishes.

    Where one storey changes, another that was to repeat it, or that it was to repeat, stands for itself from then on;
    what changes all storeys changes copies alike.

    Parameters
    ----------
    building : Building
        As it was.
    changes : sequence of (Storey, Storey)
        Each changed storey before and after; the last has the new program.
    """
    after = {new.number: new for _, new in changes}
    entries = [_entry(entry, after[entry.floor]) if entry.floor in after else entry for entry in building.floors]
    checks = dict(building.checks)
    for before, now in ((old.scene, new.scene) for old, new in changes):
        grown = {
            "rooms": len(now.rooms) - len(before.rooms),
            "doors": len(now.doors) - len(before.doors),
            "objects": len(now.objects) - len(before.objects),
        }
        checks = {name: count + grown.get(name, 0) for name, count in checks.items()}
    program = changes[-1][1].program
    if len(changes) == 1:
        program = msgspec.structs.replace(program, floors=_independent(program.floors, changes[0][1].number))
    cores = program.vertical_connectivity.cores
    return msgspec.structs.replace(building, program=program, floors=entries, checks=checks, cores=cores)


def _entry(entry: FloorEntry, storey: Storey) -> FloorEntry:
    scene = storey.scene
    area = round(sum(room.area for room in scene.rooms), 3)
    return msgspec.structs.replace(entry, area=area, objects=len(scene.objects), rooms=len(scene.rooms))


def _independent(floors: Sequence[FloorProgram], changed: int) -> list[FloorProgram]:
    """Return the floors with no copy of the changed one; its copies repeat the first of them instead."""
    copies = [floor.index for floor in floors if floor.copy == changed]
    source = {index: copies[0] if index != copies[0] else None for index in copies} | {changed: None}
    return [
        msgspec.structs.replace(floor, copy=source[floor.index]) if floor.index in source else floor for floor in floors
    ]


_GAP = 1e-3


def region_shapes(storey: Storey, layout: FloorLayout) -> dict[str, Polygon]:
    """Return the rooms and the cores of a storey by their names in the room graph."""
    shapes = {room.id: polygon_of(room) for room in layout.rooms}
    for core in storey.program.vertical_connectivity.cores:
        shapes[core.id] = box(min(core.x), min(core.y), max(core.x), max(core.y))
    return shapes


def with_shapes(storey: Storey, shapes: Mapping[str, Polygon]) -> Storey:
    """Return a storey whose documents give some rooms other shapes; its scene is not changed.

    Parameters
    ----------
    shapes : mapping of str to Polygon
        By name in the room graph, only rooms that change.
    """
    old = {room.id: polygon_of(room).area for room in storey.layout.rooms}
    rooms = [layout_room(room.id, shapes[room.id]) if room.id in shapes else room for room in storey.layout.rooms]
    layout = msgspec.structs.replace(storey.layout, rooms=rooms)
    scale = storey.layout.area_scale
    nodes = [
        msgspec.structs.replace(node, area=round(shapes[node.id].area / scale, 3)) if node.id in shapes else node
        for node in storey.topology.nodes
    ]
    growth = {name: float(shape.area) - old[name] for name, shape in shapes.items()}
    return with_topology(
        Storey(
            program=_program(storey, growth),
            topology=msgspec.structs.replace(storey.topology, nodes=nodes),
            layout=layout,
            scene=storey.scene,
        )
    )


def _program(storey: Storey, growth: Mapping[str, float]) -> BuildingProgram:
    floor = storey.floor
    rooms = [_with_area(room, growth[room.id]) if room.id in growth else room for room in floor.rooms]
    more = sum(room.area_estimate for room in rooms) - sum(room.area_estimate for room in floor.rooms)
    summary = msgspec.structs.replace(floor.area_summary, sum_rooms=round(floor.area_summary.sum_rooms + more, 3))
    changed = msgspec.structs.replace(floor, rooms=rooms, area_summary=summary)
    return with_floor(storey.program, changed)


def with_floor(program: BuildingProgram, floor: FloorProgram) -> BuildingProgram:
    """Return a program with another part for one storey."""
    floors = [floor if entry.index == floor.index else entry for entry in program.floors]
    return msgspec.structs.replace(program, floors=floors)


def _with_area(room: RoomProgram, growth: float) -> RoomProgram:
    return msgspec.structs.replace(room, area_estimate=round(max(room.area_estimate + growth, 0.1), 3))


def with_topology(storey: Storey) -> Storey:
    """Return a storey whose layout states which edges of its room graph hold on its polygons."""
    shapes = {name: edge_array(shape) for name, shape in region_shapes(storey, storey.layout).items()}
    known = {(edge.source, edge.target, edge.kind): edge for edge in storey.layout.edges}
    reasons = {(edge.source, edge.target, edge.kind): edge.reason for edge in storey.layout.unmet_edges}
    edges = [_realised(edge, shapes) for edge in storey.topology.edges if {edge.source, edge.target} <= shapes.keys()]
    # What is measured alike keeps the solver's own figures, to the last digit.
    edges = [_unless_alike(edge, known.get((edge.source, edge.target, edge.kind))) for edge in edges]
    unmet = [
        UnmetEdge(
            source=edge.source,
            target=edge.target,
            kind=edge.kind,
            reason=reasons.get(
                (edge.source, edge.target, edge.kind), "the rooms were changed after the building was made"
            ),
        )
        for edge in edges
        if not edge.satisfied
    ]
    layout = msgspec.structs.replace(storey.layout, edges=edges, unmet_edges=unmet, topology_satisfied=not unmet)
    return Storey(storey.program, storey.topology, layout, storey.scene)


def _realised(edge: Edge, shapes: Mapping[str, NDArray[np.float64]]) -> RealisedEdge:
    walls = shared_walls(shapes[edge.source], shapes[edge.target], _GAP)
    longest = longest_wall(walls)
    access = edge.kind == "access"
    length = (longest.length if longest else 0.0) if access else total_length(walls)
    return RealisedEdge(
        source=edge.source,
        target=edge.target,
        kind=edge.kind,
        satisfied=length >= (ACCESS_WALL if access else ADJACENT_WALL) - _GAP,
        wall=None if longest is None else (longest.start, longest.end),
        length=length,
    )


def _unless_alike(edge: RealisedEdge, known: RealisedEdge | None) -> RealisedEdge:
    if known is not None and known.satisfied == edge.satisfied and abs(known.length - edge.length) < 5e-3:
        return known
    return edge


def added_access(topology: FloorTopology, source: str, target: str) -> FloorTopology:
    """Return a room graph with one more access edge, unless it is there."""
    pair = {source, target}
    if any({edge.source, edge.target} == pair and edge.kind == "access" for edge in topology.edges):
        return topology
    kept: Sequence[Edge] = [edge for edge in topology.edges if {edge.source, edge.target} != pair]
    return msgspec.structs.replace(topology, edges=[*kept, Edge(source=source, target=target, kind="access")])
