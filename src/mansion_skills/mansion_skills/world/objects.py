"""Where every object of a building is: in exactly one place, whatever happens to it."""

from collections.abc import Iterable, Iterator

import msgspec

from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.world import ObjectState

__all__ = ["ObjectTable", "scene_state"]


def scene_state(thing: SceneObject, floor: int) -> ObjectState:
    """Return the state in which the scene has an object."""
    states = dict(thing.states)
    if thing.openable:
        states.setdefault("open", False)
    if thing.toggleable:
        states.setdefault("on", False)
    return ObjectState(
        id=thing.id,
        floor=floor,
        room=thing.room,
        position=thing.position,
        rotation=thing.rotation,
        parent=thing.parent,
        mount=thing.mount,
        states=states,
    )


class ObjectTable:
    """The objects of all floors: what they are, and where they are now.

    There is one state for each object, so that none is lost or doubled; `put` is the only way to change one.

    Parameters
    ----------
    scenes : iterable of FloorScene

    Attributes
    ----------
    kinds : dict
        Id to the scene's description, which never changes.
    changed : dict
        Id to state, of the objects that are not as in their scene.
    """

    def __init__(self, scenes: Iterable[FloorScene]) -> None:
        self.kinds: dict[str, SceneObject] = {}
        self.changed: dict[str, ObjectState] = {}
        self._first: dict[str, ObjectState] = {}
        self._floors: dict[int, dict[str, None]] = {}
        self._children: dict[str, dict[str, None]] = {}
        self._hands: dict[str, str] = {}
        self._journal: list[ObjectState] = []
        for scene in scenes:
            for thing in scene.objects:
                self.kinds[thing.id] = thing
                self._first[thing.id] = scene_state(thing, scene.floor)
                self._index(self._first[thing.id])

    def __contains__(self, name: str) -> bool:
        return name in self._first

    def __iter__(self) -> Iterator[str]:
        return iter(self._first)

    def state(self, name: str) -> ObjectState:
        """Return where an object is now."""
        return self.changed.get(name) or self._first[name]

    def first(self, name: str) -> ObjectState:
        """Return where the scene has an object."""
        return self._first[name]

    def on_floor(self, floor: int) -> list[ObjectState]:
        """Return the objects of a floor; what is held is on none."""
        return [self.state(name) for name in self._floors.get(floor, {})]

    def children(self, name: str) -> list[str]:
        """Return what stands on, or lies in, an object."""
        return list(self._children.get(name, {}))

    def held_by(self, session: str) -> str | None:
        """Return what a session's robot holds in its hand."""
        return self._hands.get(session)

    def carried_with(self, name: str) -> list[str]:
        """Return an object and all that it carries, carriers first."""
        found = [name]
        for entry in found:
            found += self.children(entry)
        return found

    def put(self, state: ObjectState) -> None:
        """Replace an object's state."""
        before = self.state(state.id)
        self._journal.append(before)
        self._unindex(before)
        self._index(state)
        if state == self._first[state.id]:
            self.changed.pop(state.id, None)
        else:
            self.changed[state.id] = state

    def set_state(self, name: str, key: str, value: bool | float | str) -> None:
        """Change one property, ``open`` or ``on`` say."""
        state = self.state(name)
        self.put(msgspec.structs.replace(state, states={**state.states, key: value}))

    def commit(self) -> None:
        """Make the changes since the last commit final."""
        self._journal.clear()

    def roll_back(self) -> None:
        """Undo the changes since the last commit."""
        for state in reversed(self._journal.copy()):
            self.put(state)
        self._journal.clear()

    def _index(self, state: ObjectState) -> None:
        if state.floor is not None:
            self._floors.setdefault(state.floor, {})[state.id] = None
        if state.parent is not None:
            self._children.setdefault(state.parent, {})[state.id] = None
        elif state.held_by is not None:
            self._hands[state.held_by] = state.id

    def _unindex(self, state: ObjectState) -> None:
        if state.floor is not None:
            self._floors[state.floor].pop(state.id, None)
        if state.parent is not None:
            self._children[state.parent].pop(state.id, None)
        elif state.held_by is not None and self._hands.get(state.held_by) == state.id:
            del self._hands[state.held_by]
