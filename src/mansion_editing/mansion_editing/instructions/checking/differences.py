"""What differs between two states of a building: objects that came, left, moved or changed, and rooms."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import msgspec

from mansion_editing.state import SceneState
from mansion_msgs_py.scene import Door, FloorScene, SceneObject

__all__ = ["Differences", "carried_below", "differences"]


@dataclass(frozen=True)
class Differences:
    """Objects by id; an object that moved and changed is in both.

    Attributes
    ----------
    added, removed : dict
        Objects that are in only one of the states.
    moved, changed : dict
        Objects before and after: with another pose, room or carrier; with anything else that differs.
    doors : set of str
        Ids of doors that opened or closed.
    rooms : set of str
        Ids of rooms that came, left or are not as they were, and of floors whose structure is not.
    """

    added: dict[str, SceneObject] = field(default_factory=dict)
    removed: dict[str, SceneObject] = field(default_factory=dict)
    moved: dict[str, tuple[SceneObject, SceneObject]] = field(default_factory=dict)
    changed: dict[str, tuple[SceneObject, SceneObject]] = field(default_factory=dict)
    doors: frozenset[str] = frozenset()
    rooms: frozenset[str] = frozenset()

    @property
    def ids(self) -> set[str]:
        """Ids of all objects that differ, and of doors that opened or closed."""
        return {*self.added, *self.removed, *self.moved, *self.changed, *self.doors}

    def relocated(self) -> dict[str, SceneObject]:
        """Return where each object went that moved, or that left one storey and came to another, by its id before."""
        out = {name: after for name, (_, after) in self.moved.items()}
        # What came from another storey may have the id that another thing left.
        anew = {name: pair for name, pair in self.changed.items() if pair[0].asset != pair[1].asset}
        free = [*self.added.values(), *(new for _, new in anew.values())]
        for name, old in {**self.removed, **{name: old for name, (old, _) in anew.items()}}.items():
            alike = [new for new in free if (new.asset, new.material, new.size) == (old.asset, old.material, old.size)]
            alike.sort(key=lambda new: new.room == old.room)  # it left: two alike that changed places are not the same
            if alike:
                out[name] = alike[0]
                free.remove(alike[0])
        return out


def differences(before: SceneState, after: SceneState) -> Differences:
    """Return what differs between two states."""
    old = {item.id: item for _, item in before.objects()}
    new = {item.id: item for _, item in after.objects()}
    both = [(name, old[name], new[name]) for name in old if name in new and old[name] != new[name]]
    return Differences(
        added={name: item for name, item in new.items() if name not in old},
        removed={name: item for name, item in old.items() if name not in new},
        moved={name: (one, other) for name, one, other in both if _pose(one) != _pose(other)},
        changed={name: (one, other) for name, one, other in both if _look(one) != _look(other)},
        doors=_doors_that_swung(before, after),
        rooms=_rooms_that_differ(before, after),
    )


def _doors_that_swung(before: SceneState, after: SceneState) -> frozenset[str]:
    stood = {door.id: door for scene in before.scenes.values() for door in scene.doors}
    now = [door for scene in after.scenes.values() for door in scene.doors]
    return frozenset(door.id for door in now if door.id in stood and door.is_open != stood[door.id].is_open)


def _pose(item: SceneObject) -> tuple[object, ...]:
    return item.room, item.position, item.rotation, item.parent, item.mount


def _look(item: SceneObject) -> SceneObject:
    """Return an object without its pose, and without its temperature, which follows from where it lies."""
    states = {name: value for name, value in item.states.items() if name != "temperature"}
    return msgspec.structs.replace(
        item, room="", position=(0.0, 0.0, 0.0), rotation=0.0, parent=None, mount="floor", states=states
    )


def _rooms_that_differ(before: SceneState, after: SceneState) -> frozenset[str]:
    out: set[str] = set()
    for floor in sorted({*before.floors, *after.floors}):
        one, other = before.scenes.get(floor), after.scenes.get(floor)
        if one is None or other is None:
            out.add(f"floor {floor}")
            continue
        olds, news = ({room.id: room for room in scene.rooms} for scene in (one, other))
        out |= {name for name in {*olds, *news} if olds.get(name) != news.get(name)}
        structure = [(scene.walls, _as_closed(scene), scene.windows, scene.cores) for scene in (one, other)]
        if structure[0] != structure[1]:
            out.add(f"floor {floor}")
    return frozenset(out)


def _as_closed(scene: FloorScene) -> list[Door]:
    """Return the doors of a storey as they are whether or not they stand open."""
    return [msgspec.structs.replace(door, is_open=False) for door in scene.doors]


def carried_below(state: SceneState, ids: Iterable[str]) -> set[str]:
    """Return the ids of what objects carry, and of what that carries."""
    found = [state.find(name) for name in ids]
    return {member.id for pair in found if pair is not None for member in state.subtree(*pair)[1:]}
