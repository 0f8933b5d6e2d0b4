"""A finished building as the rules see it: its family, rooms and occupants, and which doors lead where."""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import msgspec

from mansion_knowledge import KnowledgeBase, default_knowledge, is_class, kin_of
from mansion_knowledge.norms import Norm, Norms, Severity, load_norms
from mansion_msgs_py.building import Building
from mansion_msgs_py.scene import FloorScene, SceneRoom

__all__ = ["ROUNDING", "Deviation", "Premises", "premises_of", "rooms_of"]

ROUNDING = 0.02
"""Metres, or square metres, by which a figure may miss a rule from rounding."""


class Deviation(msgspec.Struct, frozen=True, order=True):
    """A rule that does not hold: its id, the place, what was found, what is asked, and who says so.

    Attributes
    ----------
    severity : {"deviation", "advice"}
        Whether a code asks for it or practice does; advice does not count.
    floor : int, optional
        The storey; ``None`` for what concerns the whole building.
    room : str
        The room, or the first of two; empty for what concerns a storey, a door or the building.
    caused_by : str
        Words of the brief that ask for it explicitly; such a deviation does not count.
    """

    rule: str
    where: str
    found: str
    asked: str
    source: str
    severity: Severity = "deviation"
    floor: int | None = None
    room: str = ""
    caused_by: str = ""

    @property
    def counts(self) -> bool:
        """Whether a code asks for it and the brief does not ask for the contrary."""
        return self.severity == "deviation" and not self.caused_by

    def __str__(self) -> str:
        cause = f'; the brief asks for it: "{self.caused_by}"' if self.caused_by else ""
        kind = "advice: " if self.severity == "advice" else ""
        return f"{kind}{self.rule} {self.where}: {self.found}; asked: {self.asked} ({self.source}){cause}"


@dataclass(frozen=True)
class Premises:
    """What the rules are measured on.

    Attributes
    ----------
    kind, family : str
        The building type of the knowledge base and its family; a type that is not known has the family ``mixed``.
    beside : dict of str to tuple of str
        Rooms and cores that each room has a door or an opening to.
    """

    building: Building
    scenes: tuple[FloorScene, ...]
    kind: str
    family: str
    norms: Norms
    knowledge: KnowledgeBase
    beside: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def norm(self, name: str) -> Norm | None:
        """Return a rule, where it is asked of such a building."""
        norm = self.norms.rules[name]
        return norm if norm.holds_for(self.family) else None

    def limit(self, norm: Norm, room_type: str = "") -> float:
        """Return a rule's figure here: for the room type, the building type, the family, or in general."""
        return norm.limit(room_type, kin_of(room_type), self.kind, self.family)

    def rooms(self) -> Iterator[SceneRoom]:
        """Yield the rooms of all storeys, without stairs and lifts."""
        for scene in self.scenes:
            yield from rooms_of(scene)

    def of_types(self, names: Sequence[str]) -> list[SceneRoom]:
        """Return the rooms whose type is one of `names`, or treated or counted as one."""
        return [room for room in self.rooms() if self.is_one_of(room, names)]

    def is_one_of(self, room: SceneRoom, names: Sequence[str]) -> bool:
        """Whether a room's type is one of `names`, or treated or counted as one."""
        kinds = {room.room_type, kin_of(room.room_type)}
        if room.room_type in self.knowledge.rooms:
            kinds.add(self.knowledge.rooms[room.room_type].counts_as)
        return not kinds.isdisjoint(names)

    def people(self, scene: FloorScene) -> int:
        """Return the occupants of a storey."""
        return round(sum(self.norms.people(room.room_type, room.area, self.knowledge) for room in rooms_of(scene)))

    def pieces(self, norm: Norm, rooms: Iterable[SceneRoom]) -> int:
        """Return how many objects that answer a rule are in some rooms."""
        ids = {room.id for room in rooms}
        return sum(item.room in ids and item.category in norm.things for scene in self.scenes for item in scene.objects)

    def is_sleeping_unit(self, room: SceneRoom) -> bool:
        """Whether people live or sleep in a room, so that a bathroom behind it is theirs."""
        kind = self.knowledge.room(room.room_type)
        return kind.sleeping or kind.unit or bool(kind.suite) or is_class(room.room_type, "sleeping")

    def serves_unit(self, room: SceneRoom) -> bool:
        """Whether a room is reached through sleeping units or dwellings alone."""
        by_id = {other.id: other for other in self.rooms()}
        reached = [by_id[name] for name in self.beside.get(room.id, ()) if name in by_id]
        return bool(reached) and all(self.is_sleeping_unit(other) for other in reached)

    def deviation(self, norm: Norm, where: str, found: str, asked: str) -> Deviation:
        """Return a deviation with the rule's id and source."""
        floor = _FLOOR.match(where)
        named = where.split(" and ")[0]
        return Deviation(
            rule=norm.id,
            where=where,
            found=found,
            asked=asked,
            source=norm.source,
            severity=norm.severity,
            floor=int(floor[1]) if floor else None,
            room=named if any(room.id == named for room in self.rooms()) else "",
        )


_FLOOR = re.compile(r"(?:F|floor )(-?\d+)\b")
"""The storey in the id of a room or a door, or in the name of a storey."""


def rooms_of(scene: FloorScene) -> list[SceneRoom]:
    """Return the rooms of a storey, without stairs and lifts."""
    return [room for room in scene.rooms if room.kind not in ("stair", "elevator")]


def premises_of(building: Building, scenes: Sequence[FloorScene]) -> Premises:
    """Return a finished building as the rules look at it."""
    knowledge = default_knowledge()
    known = knowledge.buildings.get(building.program.kind)
    beside: dict[str, list[str]] = {}
    for scene in scenes:
        for door in scene.doors:
            first, second = door.rooms
            if second is not None:
                beside.setdefault(first, []).append(second)
                beside.setdefault(second, []).append(first)
    return Premises(
        building=building,
        scenes=tuple(scenes),
        kind=building.program.kind,
        family=known.family if known is not None else "mixed",
        norms=load_norms(),
        knowledge=knowledge,
        beside={name: tuple(dict.fromkeys(others)) for name, others in beside.items()},
    )
