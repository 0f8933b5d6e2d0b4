"""The structure of a floor, built from its layout: rooms, walls, doors, windows and cores."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import msgspec
from shapely.geometry import Polygon

from mansion_geometry.robot_body import PASSAGE_WIDTH
from mansion_knowledge import default_knowledge
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.openings import GivenOpenings
from mansion_msgs_py.program import GROUND_FLOOR, Downgrade
from mansion_msgs_py.scene import Door, SceneCore, SceneRoom, Wall, Window
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.structure.access import AccessPlan, Pair, pair_key, plan_access, shared_boundaries
from mansion_scene.structure.boundaries import BoundarySegment, boundary_segments
from mansion_scene.structure.cores import scene_cores
from mansion_scene.structure.dimensions import SLAB_THICKNESS
from mansion_scene.structure.door_positions import Frontage
from mansion_scene.structure.door_swings import hang_doors
from mansion_scene.structure.exits import place_further_exits
from mansion_scene.structure.given_openings import (
    as_planned,
    given_access,
    given_doors,
    given_windows,
    narrow_doors,
    stated_entrance,
    stated_kinds,
)
from mansion_scene.structure.held_openings import HeldAccess, held_openings, with_furniture, without_held
from mansion_scene.structure.interiors import Partition, partition_floor, usable_boundaries, walkable_parts
from mansion_scene.structure.materials import GLASS_FACADE, facade_material
from mansion_scene.structure.openings import (
    Opening,
    make_frontages,
    open_passages,
    other_places,
    place_doors,
    with_doors,
)
from mansion_scene.structure.outer_doors import entrance_room, place_entrance, place_garage_doors
from mansion_scene.structure.regions import FloorRegions, Region, floor_regions
from mansion_scene.structure.scene_parts import number_doors, number_walls, number_windows, scene_rooms
from mansion_scene.structure.second_doors import place_second_doors
from mansion_scene.structure.street_doors import place_street_doors
from mansion_scene.structure.windows import place_windows
from mansion_scene.structure.working_doors import place_working_doors

__all__ = ["FloorStructure", "build_structure", "ceiling_height"]

_NOTABLE = 1.0  # square metres of unusable floor that the scene reports


@dataclass(frozen=True)
class FloorStructure:
    """The parts of a floor before it is furnished; `downgrades` lists where they differ from the room graph."""

    floor: FloorRegions
    rooms: list[SceneRoom]
    walls: list[Wall]
    doors: list[Door]
    windows: list[Window]
    cores: list[SceneCore]
    downgrades: list[Downgrade]
    ceiling: float


def ceiling_height(storey: float) -> float:
    """Return the clear height of a storey, metres: what the slab leaves.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` below 2.2 m.
    """
    ceiling = round(storey - SLAB_THICKNESS, 4)
    if not math.isfinite(ceiling) or ceiling < 2.2:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"a storey of {storey:.2f} m is too low; at least {2.2 + SLAB_THICKNESS:.2f} m are needed",
            path="$.floor.height",
        )
    return ceiling


def build_structure(request: FurnishRequest, held: HeldAccess | None = None) -> FloorStructure:
    """Build walls, openings and cores from a layout (Algorithm 1, lines 9 and 10).

    Parameters
    ----------
    request : FurnishRequest
    held : HeldAccess, optional
        Passages and doors of the floor as it was built before, to keep; chosen anew from the room graph when absent.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a layout that is not a partition, ``INFEASIBLE`` where a room would be unreachable, a
        stair does not fit, or there is no place for the entrance.
    """
    ceiling = ceiling_height(request.floor.height)
    floor = floor_regions(request)
    boundaries = boundary_segments(floor, request.floor.structural_walls)
    usable = usable_boundaries(boundaries, _walkable_rooms(floor, boundaries))
    shared = shared_boundaries(usable)
    given = request.floor.openings
    plan, kept = _kept_access(floor, boundaries, held, given)
    root = _entered(floor, usable, kept, given)
    plan = plan or plan_access(floor, request.topology, request.layout, shared, root)
    open_pairs = frozenset(passage.pair for passage in plan.passages if passage.is_open)
    partition = partition_floor(floor, boundaries, open_pairs)
    frontages = make_frontages(floor, partition)
    if held is not None:
        frontages = with_furniture(frontages, held.standing)
    sites = _DoorSites(request, floor, usable, shared, partition)
    openings, changed = _all_openings(sites, plan, kept, root, frontages, rebuilt=held is not None)
    rooms = scene_rooms(request, floor, partition, ceiling)
    wanted = "" if isinstance(request.outside, msgspec.UnsetType) else request.outside.facade
    facade = facade_material(request.building_type, request.seed, request.style, wanted)
    walls = number_walls(floor, partition.walls, {room.id: room for room in rooms}, ceiling, facade)
    if given is not None and given.windows is not None:
        windows = given_windows(floor, given.windows, partition.walls, openings, ceiling)
    else:
        french = "french_balconies" in default_knowledge().groups.shown_outside(request.building_type)
        glazed = facade == GLASS_FACADE
        windows = place_windows(floor, partition.walls, openings, ceiling, glazed=glazed, french=french)
    doors = number_doors(floor, walls, openings, ceiling)
    return FloorStructure(
        floor=floor,
        rooms=rooms,
        walls=[wall for _, wall in walls],
        doors=doors,
        windows=number_windows(floor, walls, windows),
        cores=scene_cores(request, floor, partition, openings, doors),
        downgrades=[*plan.downgrades, *_cut_off(floor, partition), *changed],
        ceiling=ceiling,
    )


@dataclass(frozen=True)
class _DoorSites:
    """What doors are placed in: the rooms, the boundaries of rooms that a robot can enter, and the net rooms."""

    request: FurnishRequest
    floor: FloorRegions
    usable: list[BoundarySegment]
    shared: Mapping[Pair, list[BoundarySegment]]
    partition: Partition

    @property
    def free(self) -> bool:
        """Whether doors may be added to those that a plan of the user's has."""
        given = self.request.floor.openings
        return given is None or given.further_doors


def _all_openings(
    sites: _DoorSites,
    plan: AccessPlan,
    kept: Sequence[Opening],
    root: Region,
    frontages: dict[str, Frontage],
    *,
    rebuilt: bool,
) -> tuple[list[Opening], list[Downgrade]]:
    """Return open passages and doors, with `kept` doors where they are, and where they differ from the room graph."""
    floor, nets, given = sites.floor, sites.partition.nets, sites.request.floor.openings
    openings = [*open_passages(sites.partition), *kept]
    if floor.floor == GROUND_FLOOR and not any(opening.kind.kind == "entrance" for opening in kept):
        openings += _outer_doors(sites, root, openings, frontages)
    frontages = with_doors(frontages, openings)
    driven = {opening.regions[0] for opening in kept if opening.kind.kind == "garage"}
    wide, blocked = place_garage_doors(floor, sites.usable, frontages, nets, driven) if sites.free else ([], [])
    frontages = with_doors(frontages, wide)
    access = without_held(plan, kept)
    placed, narrowed, frontages = _inner_doors(sites, access, openings, wide, frontages, rebuilt=rebuilt)
    fixed = {opening.segment for opening in kept} if given is not None else set()
    openings, leafless = hang_doors(
        floor,
        nets,
        [*openings, *wide, *placed],
        lambda opening: () if opening.segment in fixed else other_places(opening, sites.shared, frontages),
    )
    if given is not None:
        narrowed = [*as_planned(narrowed), *narrow_doors(floor, given, openings)]
    return openings, [*blocked, *narrowed, *leafless]


def _outer_doors(
    sites: _DoorSites, root: Region, known: Sequence[Opening], frontages: Mapping[str, Frontage]
) -> list[Opening]:
    """Return the entrance, further exits, and doors of rooms that open to the street; `known` are other openings."""
    floor, nets, kind = sites.floor, sites.partition.nets, sites.request.building_type
    residential = default_knowledge().is_dwelling(kind)
    entrance = place_entrance(floor, sites.usable, root, frontages, nets, residential=residential)
    doors = [entrance]
    if not sites.free or residential:
        return doors
    doors += place_further_exits(floor, sites.usable, entrance, with_doors(frontages, doors), nets, kind)
    if sites.request.floor.openings is None:
        openings = [*known, *doors]
        doors += place_street_doors(floor, sites.usable, openings, with_doors(frontages, openings), nets, kind)
    return doors


def _inner_doors(
    sites: _DoorSites,
    plan: AccessPlan,
    openings: Sequence[Opening],
    wide: Sequence[Opening],
    frontages: dict[str, Frontage],
    *,
    rebuilt: bool,
) -> tuple[list[Opening], list[Downgrade], dict[str, Frontage]]:
    """Place the doors between rooms, beside other `openings` and `wide` doors for vehicles.

    Returns
    -------
    doors : list of Opening
    narrowed : list of Downgrade
        Doors that are narrower than wanted.
    frontages : dict of str to Frontage
        The frontages with these doors.
    """
    floor, shared = sites.floor, sites.shared
    given, kind = sites.request.floor.openings, sites.request.building_type
    kinds = stated_kinds(floor, given) if given is not None else {}
    doors, narrowed = place_doors(floor, plan, shared, frontages, kinds)
    frontages = with_doors(frontages, doors)
    if sites.free and not rebuilt:
        known = [*openings, *wide, *doors]
        second = place_second_doors(floor, sites.usable, shared, known, frontages, sites.partition.nets, kind)
        doors += second
        frontages = with_doors(frontages, second)
    if given is None and not rebuilt:
        pairs = _wished_pairs(floor, sites.request)
        working = place_working_doors(floor, shared, [*openings, *doors], frontages, kind, pairs)
        doors += working
        frontages = with_doors(frontages, working)
    return doors, narrowed, frontages


def _wished_pairs(floor: FloorRegions, request: FurnishRequest) -> set[Pair]:
    """Return the rooms that the brief wants side by side."""
    return {
        pair_key(floor.by_node[room.id].id, floor.by_node[other].id)
        for room in request.floor.rooms
        for other in room.adjacent_to
        if room.id in floor.by_node and other in floor.by_node
    }


def _kept_access(
    floor: FloorRegions, boundaries: Sequence[BoundarySegment], held: HeldAccess | None, given: GivenOpenings | None
) -> tuple[AccessPlan | None, list[Opening]]:
    """Return the passages that are known and the doors whose place is: those of before an edit, else of a plan."""
    if held is not None:
        return held.plan, held_openings(held, boundaries)
    if given is not None:
        return given_access(floor, given), given_doors(floor, given, boundaries)
    return None, []


def _entered(
    floor: FloorRegions, usable: Sequence[BoundarySegment], kept: Sequence[Opening], given: GivenOpenings | None
) -> Region:
    """Return the room through which the floor is entered."""
    entered = next((floor.by_id[opening.regions[0]] for opening in kept if opening.kind.kind == "entrance"), None)
    if entered is None and given is not None:
        entered = stated_entrance(floor, given)
    return entered or (entrance_room(floor, usable) if floor.floor == GROUND_FLOOR else floor.hub)


def _walkable_rooms(floor: FloorRegions, boundaries: Sequence[BoundarySegment]) -> dict[str, Polygon]:
    """Return the walkable part of each room with all walls standing.

    Rooms that are narrower than a passage everywhere are left out: a robot can enter none of them.
    """
    closed = partition_floor(floor, boundaries, frozenset())
    nets = {r.id: closed.nets[r.id] for r in floor.regions if r.is_room}
    return {name: part for name, part in walkable_parts(nets).items() if not part.is_empty}


def _cut_off(floor: FloorRegions, partition: Partition) -> list[Downgrade]:
    """Record the floor that rooms lose where they are pinched to less than a passage."""
    nets = {r.id: partition.nets[r.id] for r in floor.regions if r.is_room}
    parts = walkable_parts(nets)
    lost = {name: net.area - parts[name].area + partition.cut_off.get(name, 0.0) for name, net in nets.items()}
    return [
        Downgrade(
            wish=f"all of {region} in one piece",
            got=f"{area:.2f} m2 less",
            reason=f"a part of the room is reached only by a way narrower than {PASSAGE_WIDTH} m",
            stage="furnish_floor",
            floor=floor.floor,
        )
        for region, area in lost.items()
        if area > _NOTABLE
    ]
