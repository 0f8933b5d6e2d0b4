"""The objects of a building: where each one is, what it carries, and the distance to its footprint."""

from collections.abc import Iterable, Iterator

import msgspec

from mansion_geometry.object_footprints import footprint_corners, footprint_distance
from mansion_geometry.plane import turned
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.shapes import Point, Point3
from mansion_msgs_py.world import ObjectState

__all__ = ["ObjectTable", "box_distance", "corners", "placed_at", "put_down", "scene_state", "take_up"]


def scene_state(item: SceneObject, floor: int) -> ObjectState:
    """Return the state in which the scene has an object."""
    states = dict(item.states)
    if item.openable:
        states.setdefault("open", False)
    if item.toggleable:
        states.setdefault("on", False)
    return ObjectState(
        id=item.id,
        floor=floor,
        room=item.room,
        position=item.position,
        rotation=item.rotation,
        parent=item.parent,
        mount=item.mount,
        states=states,
    )


class ObjectTable:
    """The objects of all floors: what they are, and where they are now.

    Each object has one state, so that none is lost or doubled; only `put` changes it.

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
            for item in scene.objects:
                self.kinds[item.id] = item
                self._first[item.id] = scene_state(item, scene.floor)
                self._index(self._first[item.id])

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
        """Change one property, such as ``open`` or ``on``."""
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


def take_up(table: ObjectTable, name: str, session: str) -> None:
    """Put an object into a robot's hand; what it carries goes with it, its place kept relative to the carrier."""
    states = {entry: table.state(entry) for entry in table.carried_with(name)}
    for entry, state in states.items():
        held = msgspec.structs.replace(state, floor=None, room=None, held_by=session, position=None)
        if entry == name:
            held = msgspec.structs.replace(held, parent=None, mount=None)
        else:
            assert state.parent is not None
            held = _relative(held, state, states[state.parent])
        table.put(held)


def put_down(
    table: ObjectTable,
    name: str,
    *,
    floor: int,
    room: str | None,
    position: Point3,
    rotation: float,
    parent: str | None,
    mount: str,
) -> None:
    """Put a held object somewhere, with what it carries."""
    state = msgspec.structs.replace(table.state(name), parent=parent, mount=mount)
    for entry in placed_at(table, state, floor=floor, room=room, position=position, rotation=rotation):
        table.put(entry)


def placed_at(
    table: ObjectTable, state: ObjectState, *, floor: int, room: str | None, position: Point3, rotation: float
) -> list[ObjectState]:
    """Return a held object and what it carries as they were at some place, carriers first; nothing is changed."""
    placed = {
        state.id: msgspec.structs.replace(
            state, floor=floor, room=room, position=position, rotation=rotation, held_by=None
        )
    }
    for entry in table.carried_with(state.id)[1:]:
        load = table.state(entry)
        assert load.parent is not None
        placed[entry] = _absolute(load, placed[load.parent])
    return list(placed.values())


def _relative(held: ObjectState, state: ObjectState, carrier: ObjectState) -> ObjectState:
    assert state.position is not None and carrier.position is not None
    offset = [a - b for a, b in zip(state.position, carrier.position)]
    x, y = turned(offset[0], offset[1], -carrier.rotation)
    turn = round((state.rotation - carrier.rotation) % 360.0, 6)
    position = (round(x, 6), round(y, 6), round(offset[2], 6))
    return msgspec.structs.replace(held, position=position, rotation=turn)


def _absolute(state: ObjectState, carrier: ObjectState) -> ObjectState:
    assert state.position is not None and carrier.position is not None
    x, y = turned(state.position[0], state.position[1], carrier.rotation)
    cx, cy, cz = carrier.position
    return msgspec.structs.replace(
        state,
        floor=carrier.floor,
        room=carrier.room,
        position=(round(cx + x, 6), round(cy + y, 6), round(cz + state.position[2], 6)),
        rotation=round((carrier.rotation + state.rotation) % 360.0, 6),
        held_by=None,
    )


def box_distance(point: Point, state: ObjectState, kind: SceneObject) -> float:
    """Return the plan distance from a point to an object's box, metres; 0 inside."""
    assert state.position is not None
    return footprint_distance(point, state.position, kind.size, state.rotation)


def corners(state: ObjectState, kind: SceneObject, scale: float = 1.0) -> list[Point]:
    """Return the corners of an object's box in plan, scaled about its centre."""
    assert state.position is not None
    return footprint_corners(state.position, kind.size, state.rotation, scale=scale)
