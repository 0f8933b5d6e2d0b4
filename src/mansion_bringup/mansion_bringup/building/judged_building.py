"""A building as its wishes are judged: rooms with names and contents, what they lack, shared walls and doors."""

import math
import re
from collections import Counter, OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import TypeAlias

import msgspec
import networkx as nx
import numpy as np
import shapely
from shapely.geometry import Polygon

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.catalogue.piece_counts import pieces
from mansion_knowledge import is_class
from mansion_knowledge.essentials import Need, needs_of, pieces_there, still_wanted
from mansion_knowledge.furnished_as import furnished_as
from mansion_knowledge.object_kinds import added_for
from mansion_msgs_py.outside import Outside
from mansion_msgs_py.program import GROUND_FLOOR, BuildingProgram
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.topology import FloorTopology
from mansion_scene.structure.floor_structure import ceiling_height

__all__ = ["Equipment", "JudgedBuilding", "JudgedRoom", "Look", "equipment_of", "finished_building", "planned_building"]


@dataclass(frozen=True)
class Equipment:
    """What a finished room needs, and what it has of it.

    Attributes
    ----------
    needs : sequence of Need
    objects : sequence of (str, float)
        Category and width of each object, metres.
    reasons : mapping of str to str
        By name of a need, why the room was left without it.
    shut_in : bool
        Vehicles are to drive into the room, and no door leads there from outside.
    """

    needs: Sequence[Need] = ()
    objects: Sequence[tuple[str, float]] = ()
    reasons: Mapping[str, str] | None = None
    shut_in: bool = False

    def lack(self, unwanted: Iterable[str] = ()) -> str:
        """Say what the room cannot be used without and has not; empty where it has all.

        Parameters
        ----------
        unwanted : iterable of str
            Categories that the brief does not want in the room.
        """
        for need in still_wanted(self.needs, list(unwanted)):
            have = pieces_there(need, self.objects)
            if have < need.count:
                why = (self.reasons or {}).get(need.name, "")
                amount = f"{have} of {need.count} x {need.name}" if have else f"no {need.name}"
                return f"has {amount}" + (f": {why}" if why else "")
        return "has no door to the outside" if self.shut_in else ""


def equipment_of(scene: FloorScene, room: SceneRoom, objects: Iterable[SceneObject]) -> Equipment:
    """Return the equipment of a finished room from its objects and from what was left out of it."""
    beside = [other.room_type for other in scene.rooms if other.id != room.id]
    kind = furnished_as(room.room_type, scene.building_type, room.name, beside, scene.called or "")
    return Equipment(
        needs_of(kind, (room.name, *room.aliases)),
        [(thing.category, thing.size[0]) for thing in objects],
        {lost.name: lost.reason for lost in scene.discarded if lost.room == room.id},
        shut_in=scene.floor == GROUND_FLOOR
        and is_class(room.room_type, "vehicle")
        and (room.id, None) not in {door.rooms for door in scene.doors},
    )


_SHARED = 1.1
"""Metres of straight wall that neighbours share at least: a door and its frame, and a little."""


Look: TypeAlias = tuple[Sequence[float], str]
"""Size and main material of an object."""


@dataclass(frozen=True)
class JudgedRoom:
    """A room of a planned or finished floor.

    Attributes
    ----------
    objects : Counter of str
        Pieces by category; in a plan, those that are asked for.
    object_ids : mapping of str to sequence of str
        Ids by category; empty in a plan.
    looks : mapping of str to sequence of Look
        Looks of the objects by category; in a plan, of all that the catalogue has in the category.
    things, receptacles : float
        How many objects lie on or in its receptacles, and the square metres of floor that these stand on.
    """

    floor: int
    id: str
    type: str
    names: frozenset[str]
    area: float
    height: float = 0.0
    surfaces: Mapping[str, str] = field(default_factory=dict)
    objects: Counter[str] = field(default_factory=Counter)
    object_ids: Mapping[str, Sequence[str]] = field(default_factory=dict)
    looks: Mapping[str, Sequence[Look]] = field(default_factory=dict)
    equipment: Equipment = field(default_factory=Equipment)
    things: float = 0.0
    receptacles: float = 0.0

    @property
    def full_id(self) -> str:
        """Id of the room in its building."""
        return f"F{self.floor}/{self.id}"


@dataclass(frozen=True)
class JudgedBuilding:
    """A building as far as its wishes go: rooms, and the pairs of their full ids that share a wall.

    Attributes
    ----------
    planned : bool
        Nothing of it is finished: its areas are those that its rooms are going to have.
    """

    program: BuildingProgram
    rooms: Sequence[JudgedRoom]
    touching: frozenset[tuple[str, str]]
    doors: frozenset[tuple[str, str]] = frozenset()
    hubs: frozenset[str] = frozenset()
    planned: bool = False

    def called(self, name: str, kind: str, floors: Sequence[int] = ()) -> list[JudgedRoom]:
        """Return the rooms of a name; where none has it, those of a type."""
        rooms = [room for room in self.rooms if not floors or room.floor in floors]
        own = [room for room in rooms if name in room.names]
        return own or [room for room in rooms if kind and room.type == kind]

    def has_own_name(self, room: JudgedRoom, name: str) -> bool:
        """Whether another wish calls a room by its own name: "classroom 2B" is none of "four classrooms"."""
        stem, _, number = room.id.rpartition("_")
        own = {room.id, stem if number.isdigit() else room.id} - {name}
        return any(wish.kind == "room" and wish.value.name in own for wish in self.program.wishes)

    def behind(self, owner: JudgedRoom) -> list[JudgedRoom]:
        """Return the rooms of a storey that are reached through a room alone."""
        here = {room.full_id for room in self.rooms if room.floor == owner.floor}
        graph = nx.Graph(pair for pair in self.doors if pair[0].startswith(f"F{owner.floor}/"))
        graph.remove_nodes_from([owner.full_id])
        hubs = [hub for hub in self.hubs if hub in graph]
        reached = set().union(*(nx.node_connected_component(graph, hub) for hub in hubs))
        if not hubs:
            return []
        return [room for room in self.rooms if room.full_id in here - reached and room is not owner]

    @property
    def outside(self) -> Outside:
        """What was decided of walls, roof and grounds; empty where the brief says nothing of them."""
        outside = self.program.outside
        return Outside() if isinstance(outside, msgspec.UnsetType) else outside

    @property
    def upright(self) -> bool:
        """Whether the highest storey has sides along the axes and no courtyard, so that any roof fits over it."""
        top = self.program.floors[-1]
        sides = pairwise([*top.outline, top.outline[0]])
        return not top.holes and all(min(abs(bx - ax), abs(by - ay)) < 1e-3 for (ax, ay), (bx, by) in sides)

    @cached_property
    def private(self) -> frozenset[str]:
        """The rooms that the units of the brief have for themselves."""
        scopes = [wish.scope for wish in self.program.wishes if wish.scope.unit]
        owners = [owner for scope in scopes for owner in self.called(scope.unit, scope.unit_type, scope.floors)]
        return frozenset(room.full_id for owner in owners for room in self.behind(owner))

    def near(self, first: JudgedRoom, second: JudgedRoom) -> bool:
        """Whether two rooms share a wall."""
        return first is not second and (
            (first.full_id, second.full_id) in self.touching or (second.full_id, first.full_id) in self.touching
        )

    def joined(self, first: JudgedRoom, second: JudgedRoom) -> bool:
        """Whether a door or an opening leads from one room into another."""
        return (first.full_id, second.full_id) in self.doors or (second.full_id, first.full_id) in self.doors


def finished_building(program: BuildingProgram, scenes: Sequence[FloorScene]) -> JudgedBuilding:
    """Return a building as its finished floors are."""
    catalogue = load_catalogue()
    rooms = [room for scene in scenes for room in _finished_rooms(scene, catalogue)]
    return JudgedBuilding(
        program,
        rooms,
        frozenset(pair for scene in scenes for pair in _touching(scene)),
        frozenset((door.rooms[0], door.rooms[1]) for scene in scenes for door in scene.doors if door.rooms[1]),
        frozenset(room.id for scene in scenes for room in scene.rooms if room.kind == "main"),
    )


def planned_building(program: BuildingProgram, topologies: Sequence[FloorTopology]) -> JudgedBuilding:
    """Return a building as it is going to be if every later stage keeps to its plan."""
    rooms = [
        JudgedRoom(
            floor.index,
            room.id,
            room.room_type,
            _names(room.id, room.name, room.aliases),
            room.area_estimate,
            ceiling_height(floor.height),
            {"floor": room.floor_material, "wall": room.wall_material},
            Counter({entry.category: entry.count for entry in room.objects}),
            looks={entry.category: _looks(entry.category) for entry in room.objects},
            things=_PLANNED_THINGS.get(room.clutter, 0.0),
            receptacles=1.0,
        )
        for floor in program.floors
        for room in floor.rooms
    ]
    edges = frozenset(
        (f"F{graph.floor}/{edge.source}", f"F{graph.floor}/{edge.target}")
        for graph in topologies
        for edge in graph.edges
    )
    doors = frozenset(
        (f"F{graph.floor}/{edge.source}", f"F{graph.floor}/{edge.target}")
        for graph in topologies
        for edge in graph.edges
        if edge.kind == "access"
    )
    hubs = frozenset(f"F{graph.floor}/{node.id}" for graph in topologies for node in graph.nodes if node.type == "main")
    return JudgedBuilding(program, rooms, edges, doors, hubs, planned=True)


def _looks(category: str) -> list[Look]:
    """Return what all assets look like that a room may get for a category."""
    return [(asset.size, asset.material) for asset in load_catalogue().by_category(added_for(category))]


_PLANNED_THINGS: Mapping[object, float] = {"dense": math.inf, "sparse": 0.0}
"""How many things are to lie on a square metre of a planned room's receptacles."""


def _names(identifier: str, name: str, aliases: Iterable[str]) -> frozenset[str]:
    stem, _, number = identifier.rpartition("_")
    plain = [identifier, *([stem] if number.isdigit() else []), name, *aliases]
    return frozenset(word.lower().replace(" ", "_") for word in plain if word)


def _finished_names(short: str, room: SceneRoom) -> frozenset[str]:
    """Return what a finished room is called: its id too, unless an edit has made it a room of another kind."""
    own, spoken = _names(short, "", ()), _names("", room.name, room.aliases)
    told = {_letters(word) for word in (*spoken, room.room_type)}
    if room.name and told.isdisjoint(map(_letters, own)):
        return spoken
    return own | spoken


def _letters(word: str) -> str:
    return re.sub(r"[\W_]+", "", word)


_MOST_REMEMBERED = 32
_remembered_rooms: OrderedDict[tuple[int, int], tuple[FloorScene, Catalogue, list[JudgedRoom]]] = OrderedDict()
"""Rooms of the scenes that were judged last: an edit changes one floor, and the wishes of all are judged."""


def _finished_rooms(scene: FloorScene, catalogue: Catalogue) -> list[JudgedRoom]:
    """Return the rooms of a floor; scenes and catalogues are not written to, so that the same ones have the same."""
    key = (id(scene), id(catalogue))  # both are kept with the rooms, so that no other object can get their ids
    known = _remembered_rooms.pop(key, None)
    if known is None:
        inside: dict[str, list[SceneObject]] = {}
        for item in scene.objects:
            inside.setdefault(item.room, []).append(item)
        known = (scene, catalogue, [_finished_room(scene, r, inside.get(r.id, []), catalogue) for r in scene.rooms])
    _remembered_rooms[key] = known
    while len(_remembered_rooms) > _MOST_REMEMBERED:
        _remembered_rooms.popitem(last=False)
    return known[2]


def _finished_room(
    scene: FloorScene, room: SceneRoom, objects: Sequence[SceneObject], catalogue: Catalogue
) -> JudgedRoom:
    short = room.id.removeprefix(f"F{scene.floor}/")
    things: dict[str, list[str]] = {}
    looks: dict[str, list[Look]] = {}
    numbers: Counter[str] = Counter()
    for entry in objects:
        things.setdefault(entry.category, []).append(entry.id)
        looks.setdefault(entry.category, []).append((entry.size, entry.material))
        asset = catalogue.assets.get(entry.asset)
        numbers[entry.category] += pieces(asset.category, asset) if asset is not None else 1  # seats of a row of seats
    return JudgedRoom(
        scene.floor,
        short,
        room.room_type,
        _finished_names(short, room),
        room.area,
        room.ceiling_height,
        {"floor": room.floor_material, "wall": room.wall_material},
        numbers,
        things,
        looks,
        equipment_of(scene, room, objects),
        sum(entry.parent is not None for entry in objects),
        sum(entry.size[0] * entry.size[1] for entry in objects if entry.receptacle and entry.parent is None),
    )


def _touching(scene: FloorScene) -> tuple[tuple[str, str], ...]:
    """Return the rooms that share enough straight wall for a door."""
    return _touching_outlines(
        tuple((room.id, _ring(room.polygon), tuple(map(_ring, room.holes))) for room in scene.rooms)
    )


_Ring: TypeAlias = tuple[tuple[float, float], ...]


def _ring(points: Iterable[Sequence[float]]) -> _Ring:
    return tuple((point[0], point[1]) for point in points)


@lru_cache(maxsize=128)
def _touching_outlines(outlines: tuple[tuple[str, _Ring, tuple[_Ring, ...]], ...]) -> tuple[tuple[str, str], ...]:
    shapes = [Polygon(ring, holes) for _, ring, holes in outlines]
    first, second = shapely.STRtree(shapes).query(shapes, predicate="dwithin", distance=0.05)
    pairs = sorted((int(one), int(other)) for one, other in zip(first, second, strict=True) if one < other)
    return tuple(
        (outlines[one][0], outlines[other][0])
        for one, other in pairs
        if _straight(shapes[one], shapes[other]) > _SHARED
    )


def _straight(shape: Polygon, other: Polygon) -> float:
    """Return the length of the longest straight piece of a room's boundary that lies on another room."""
    beside = other.buffer(0.02, join_style="mitre")
    edges = [
        shapely.linestrings(list(pairwise(ring.simplify(0.001).coords))) for ring in (shape.exterior, *shape.interiors)
    ]
    pieces = shapely.get_parts(shapely.intersection(np.concatenate(edges), beside))
    return float(shapely.length(pieces).max(initial=0.0))
