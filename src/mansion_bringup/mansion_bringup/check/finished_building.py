"""A finished building as its wishes are checked: its rooms by name, and the wishes of its ledger."""

import re
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.wishes import Wish

__all__ = ["FinishedBuilding", "Judge", "is_on", "labels_of", "written"]


@dataclass(frozen=True)
class FinishedBuilding:
    """A finished building, and what its ledger asked for."""

    building: Building
    layouts: Mapping[int, FloorLayout]
    scenes: Sequence[FloorScene]

    @property
    def above(self) -> list[FloorScene]:
        """The storeys from the ground up."""
        return [scene for scene in self.scenes if scene.floor >= 1]

    @property
    def ledger(self) -> list[Wish]:
        """The wishes of the program."""
        return self.building.program.wishes

    def rooms(self, floors: Sequence[int] = ()) -> list[tuple[int, SceneRoom]]:
        """Return the rooms of some floors, or of all, each with its floor."""
        return [(scene.floor, room) for scene in self.scenes if is_on(scene.floor, floors) for room in scene.rooms]

    def on(self, floor: int) -> FloorScene:
        """Return the scene of a storey."""
        return next(scene for scene in self.scenes if scene.floor == floor)

    def suite(self, floor: int, owner: SceneRoom) -> list[SceneRoom]:
        """Return a room of a floor with the rooms that nobody enters without passing through it."""
        scene = self.on(floor)
        beside: dict[str, list[str]] = defaultdict(list)
        for door in scene.doors:
            first, second = door.rooms
            if second is not None:
                beside[first].append(second)
                beside[second].append(first)
        entrances = [core.id for core in scene.cores]
        entrances += [door.rooms[0] for door in scene.doors if door.kind == "entrance"]
        waiting = [name for name in entrances if name != owner.id]
        passed = {owner.id, *waiting}
        while waiting:
            further = [name for name in beside[waiting.pop()] if name not in passed]
            passed.update(further)
            waiting += further
        return [owner, *(room for room in scene.rooms if room.id not in passed)]

    @cached_property
    def owned(self) -> set[str]:
        """The rooms inside the units that the ledger names."""
        units = {(wish.scope.unit, wish.scope.unit_type, tuple(wish.scope.floors)) for wish in self.ledger}
        return {
            room.id
            for unit, kind, floors in units
            if unit
            for floor, owner in self.meant(unit, kind, floors)
            for room in self.suite(floor, owner)[1:]
        }

    def meant(self, name: str, kind: str, floors: Sequence[int] = ()) -> list[tuple[int, SceneRoom]]:
        """Return the rooms that people call so; where there are none, those of the type."""
        there = self.rooms(floors)
        called = [(floor, room) for floor, room in there if name in labels_of(room)]
        return called or [(floor, room) for floor, room in there if kind and room.room_type == kind]

    def wanted_in(self, wish: Wish) -> list[tuple[int, SceneRoom]]:
        """Return the rooms that furniture is wanted in, but for those that another wish has a name of its own for."""
        scope = wish.scope
        rooms = self.meant(scope.room, scope.room_type, scope.floors)
        others = {entry.value.name for entry in self.ledger if entry.kind == "room"} - {scope.room}
        return [entry for entry in rooms if others.isdisjoint(written(entry[1].id))] or rooms

    def things_in(self, room: SceneRoom) -> list[SceneObject]:
        """Return the objects of a room."""
        return [thing for scene in self.scenes for thing in scene.objects if thing.room == room.id]


Judge = Callable[[Wish, FinishedBuilding], str]
"""Says what the building has instead of what a wish asks for; empty when it is met."""


def labels_of(room: SceneRoom) -> set[str]:
    """Return what a room is called: its id, the same without a number, its name, its other names.

    The id of a room that is of another kind by now, and called otherwise, says nothing of it.
    """
    short = room.id.partition("/")[2]
    by_id = {short, re.sub(r"_\d+$", "", short)}
    spoken = {text.lower().replace(" ", "_") for text in (room.name, *room.aliases) if text}
    plain = {re.sub(r"[^a-z0-9]", "", text) for text in (*spoken, room.room_type)}
    apt = not room.name or any(re.sub(r"[^a-z0-9]", "", text) in plain for text in by_id)
    return spoken | by_id if apt else spoken


def written(room_id: str) -> tuple[str, str]:
    """Return the name that a room's id was made from, with and without a number at its end."""
    name = room_id.partition("/")[2]
    return name, re.sub(r"_\d+$", "", name)


def is_on(floor: int, floors: Sequence[int]) -> bool:
    """Whether a floor is one of some; any is where none is named."""
    return not floors or floor in floors
