"""The rooms and the furniture that a building's brief asked for, which the words of its author mean first."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from mansion_assets.catalogue.vocabulary import stems
from mansion_msgs_py.program import BuildingProgram, RequestedObject
from mansion_msgs_py.scene import SceneObject

__all__ = ["Asked", "asked_of"]


@dataclass(frozen=True)
class Asked:
    """What a brief asked for; a planner adds rooms and furniture that it does not name.

    Attributes
    ----------
    rooms : mapping of str to sequence of RequestedObject
        Ids of the rooms that the brief names, with the furniture that it wants in each.
    """

    rooms: Mapping[str, Sequence[RequestedObject]] = field(default_factory=dict)

    def rooms_first(self, rooms: Sequence[str]) -> list[str]:
        """Return the rooms that the brief names where it names some of these, else all."""
        return [room for room in rooms if room in self.rooms] or list(rooms)

    def things_first(self, items: Sequence[SceneObject], noun: str) -> list[SceneObject]:
        """Return the objects in the one room for which the brief asks for such a thing, else all.

        Where it asks for them in several of the rooms, or in none, it does not tell which are meant.
        """
        rooms = list(dict.fromkeys(item.room for item in items))
        asking = [room for room in rooms if any(self._asks(item, noun) for item in items if item.room == room)]
        if len(asking) != 1:
            return list(items)
        return [item for item in items if item.room == asking[0]]

    def wants_one(self, items: Sequence[SceneObject], noun: str) -> bool:
        """Whether objects are of one kind, in one room for which the brief asks for just one of them."""
        if len({(item.room, item.category) for item in items}) != 1:
            return False
        counts = [entry.count for entry in self.rooms.get(items[0].room, ()) if _is_of(entry, items[0], noun)]
        return counts == [1]

    def _asks(self, item: SceneObject, noun: str) -> bool:
        return any(entry.count > 0 and _is_of(entry, item, noun) for entry in self.rooms.get(item.room, ()))


def _is_of(entry: RequestedObject, item: SceneObject, noun: str) -> bool:
    """Whether what a brief asks for is of an object's kind, or called so."""
    return entry.category == item.category or stems(noun) in (
        stems(entry.words),
        stems(entry.category.replace("_", " ")),
    )


def asked_of(program: BuildingProgram) -> Asked:
    """Return what the brief of a building asked for, as its program has it."""
    return Asked(
        {
            f"F{floor.index}/{room.id}": tuple(room.objects)
            for floor in program.floors
            for room in floor.rooms
            if room.name
        }
    )
