"""The scene of a storey whose structure was built again: objects, lights and the robot's start."""

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

import msgspec
from shapely import Point as ShapelyPoint

from mansion_editing.robot_passages import passages_of
from mansion_editing.structure.displaced_objects import Settled, settle
from mansion_editing.structure.rebuilding import Rebuilt
from mansion_editing.structure.standing_checks import RoomSpace
from mansion_editing.structure.storey_documents import Storey, Workshop, node_of
from mansion_editing.structure.wall_moves import MovedWall
from mansion_msgs_py.scene import Discard, FloorScene, Light, SceneObject, SceneRoom
from mansion_scene.lighting import room_lights
from mansion_scene.spawn import free_region, place_spawn

__all__ = ["Finished", "finish"]

_MOST_UNSETTLED = 0.35
"""Share of a room's furniture from which it is furnished again rather than piece by piece."""

_MOST_LOST = 0.1
"""Share of a room's furniture that may be lost without that."""


@dataclass(frozen=True)
class Finished:
    """A finished scene.

    Attributes
    ----------
    settled : dict of str to Settled
        By room, what became of its objects.
    refurnished : dict of str to Counter
        For each room that was refurnished, what it lost, by category.
    """

    scene: FloorScene
    settled: dict[str, Settled] = field(default_factory=dict)
    refurnished: dict[str, Counter[str]] = field(default_factory=dict)

    @property
    def losses(self) -> int:
        """How many objects are no longer there."""
        return sum(len(settled.lost) for settled in self.settled.values()) + sum(
            n.total() for n in self.refurnished.values()
        )


def finish(
    storey: Storey,
    rebuilt: Rebuilt,
    workshop: Workshop,
    *,
    moves: Sequence[MovedWall] = (),
    refurnished: Collection[str] = (),
) -> Finished:
    """Return the scene of a storey on its new structure.

    Parameters
    ----------
    storey : Storey
        With the documents after the change and the scene before it.
    rebuilt : Rebuilt
    workshop : Workshop
    moves : sequence of MovedWall
        By the rooms' ids in the scene.
    refurnished : collection of str
        Rooms to furnish again; others are where their furniture cannot stay, or would leave a robot no way.
    """
    structure = rebuilt.structure
    scene = msgspec.structs.replace(
        storey.scene,
        rooms=structure.rooms,
        walls=structure.walls,
        doors=structure.doors,
        windows=structure.windows,
        cores=structure.cores,
        downgrades=structure.downgrades,
    )
    work = _Work(storey, rebuilt, workshop, scene)
    for room in structure.rooms:
        if room.id in refurnished:
            work.furnish(room)
        elif room.id in rebuilt.touched:
            work.settle(room, [move for move in moves if room.id in (move.gainer, move.giver)])
    shut = passages_of(work.scene).cuts.keys() - passages_of(storey.scene).cuts.keys()
    for room in structure.rooms:
        if room.id in shut and room.id in work.settled:
            work.furnish(room)
    return Finished(
        _lit(work.scene, storey.scene, rebuilt.touched | set(work.refurnished)), work.settled, work.refurnished
    )


class _Work:
    """A scene while its rooms are filled."""

    def __init__(self, storey: Storey, rebuilt: Rebuilt, workshop: Workshop, scene: FloorScene) -> None:
        self.storey, self.rebuilt, self.workshop, self.scene = storey, rebuilt, workshop, scene
        self.settled: dict[str, Settled] = {}
        self.refurnished: dict[str, Counter[str]] = {}
        self._new_doors = {door.id for door in rebuilt.new_doors}

    def _before(self, room: SceneRoom) -> list[SceneObject]:
        return [item for item in self.storey.scene.objects if item.room == room.id]

    def settle(self, room: SceneRoom, moves: Sequence[MovedWall]) -> None:
        """Keep the objects of a room that still stand rightly and find places for the others."""
        space = RoomSpace(room, self.scene.doors, self.scene.windows, self._new_doors)
        before = self._before(room)
        result = settle(space, before, moves, self.scene, self.workshop.catalogue)
        if _too_much(before, result):
            self.furnish(room)
            return
        self.settled[room.id] = result
        self._put(room, result.objects)

    def furnish(self, room: SceneRoom) -> None:
        """Furnish a room again."""
        program = next((entry for entry in self.storey.floor.rooms if entry.id == node_of(room)), None)
        requested = program.objects if program is not None else []
        seed, catalogue = self.storey.program.seed, self.workshop.catalogue
        objects, discarded = self.workshop.furnisher(self.scene, room, [], requested, seed, catalogue)
        self.settled.pop(room.id, None)
        before = Counter(item.category for item in self._before(room))
        self.refurnished[room.id] = before - Counter(item.category for item in objects)
        elsewhere = {item.id for item in self.scene.objects if item.room != room.id}
        self._put(room, _under_free_names(objects, elsewhere))
        left = [entry for entry in self.scene.discarded if entry.room != room.id]
        self.scene = msgspec.structs.replace(self.scene, discarded=[*left, *discarded])

    def _put(self, room: SceneRoom, objects: Sequence[SceneObject]) -> None:
        """Put a room's objects in the place of those that it had."""
        everything = self.scene.objects
        at = next((n for n, item in enumerate(everything) if item.room == room.id), len(everything))
        before = [item for item in everything[:at] if item.room != room.id]
        after = [item for item in everything[at:] if item.room != room.id]
        lost = self.settled[room.id].lost if room.id in self.settled else []
        notes = [
            Discard(room=room.id, name=item.category, count=1, reason="the room was changed and has no place for it")
            for item in lost
        ]
        self.scene = msgspec.structs.replace(
            self.scene, objects=[*before, *objects, *after], discarded=[*self.scene.discarded, *notes]
        )


def _too_much(before: Sequence[SceneObject], result: Settled) -> bool:
    """Whether so much of a room's furniture was uprooted or lost that the room had better be furnished as a whole."""
    furniture = [item.id for item in before if item.mount == "floor" and item.parent is None]
    lost = sum(item.mount == "floor" for item in result.lost)
    uprooted = lost + len(set(furniture).intersection(result.placed))
    return uprooted > max(_MOST_UNSETTLED * len(furniture), 1) or lost > _MOST_LOST * len(furniture)


def _under_free_names(objects: Sequence[SceneObject], taken: Collection[str]) -> list[SceneObject]:
    """Return objects with new ids in place of those that others have."""
    used = {*taken, *(item.id for item in objects)}
    names: dict[str, str] = {}
    for item in objects:
        if item.id in taken:
            stem = item.id.rpartition("_")[0]
            number = next(n for n in range(1, len(used) + 2) if f"{stem}_{n}" not in used)
            names[item.id] = f"{stem}_{number}"
            used.add(names[item.id])
    return [
        msgspec.structs.replace(
            item, id=names.get(item.id, item.id), parent=names.get(item.parent or "", item.parent or "") or None
        )
        for item in objects
    ]


def _lit(scene: FloorScene, before: FloorScene, touched: Collection[str]) -> FloorScene:
    """Return a scene with the lights of touched rooms made again, and the robot's start where it can be."""
    lights: list[Light] = [light for light in before.lights if light.room is None]
    by_room: Mapping[str, list[Light]] = {
        room.id: room_lights(room, scene.objects)
        if room.id in touched
        else [light for light in before.lights if light.room == room.id]
        for room in scene.rooms
    }
    lights += [light for room in scene.rooms for light in by_room[room.id]]
    spawn = before.spawn
    hub = next((room for room in scene.rooms if spawn is not None and room.id == spawn.room), None)
    if spawn is not None and hub is not None and hub.id in touched:
        here = ShapelyPoint(spawn.x, spawn.y)
        if not any(part.covers(here) for part in free_region(hub, scene.objects)[:1]):
            spawn = place_spawn(hub, scene.doors, scene.objects)
    return msgspec.structs.replace(scene, lights=lights, spawn=spawn)
