"""Move an object together with what stands on it or lies in it."""

from math import cos, radians, sin

import msgspec

from mansion_msgs_py.shapes import Point3
from mansion_msgs_py.world import ObjectState
from mansion_skills.world.objects import ObjectTable

__all__ = ["placed_at", "put_down", "take_up"]


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
    x, y = _turned(offset[0], offset[1], -carrier.rotation)
    turn = round((state.rotation - carrier.rotation) % 360.0, 6)
    position = (round(x, 6), round(y, 6), round(offset[2], 6))
    return msgspec.structs.replace(held, position=position, rotation=turn)


def _absolute(state: ObjectState, carrier: ObjectState) -> ObjectState:
    assert state.position is not None and carrier.position is not None
    x, y = _turned(state.position[0], state.position[1], carrier.rotation)
    cx, cy, cz = carrier.position
    return msgspec.structs.replace(
        state,
        floor=carrier.floor,
        room=carrier.room,
        position=(round(cx + x, 6), round(cy + y, 6), round(cz + state.position[2], 6)),
        rotation=round((carrier.rotation + state.rotation) % 360.0, 6),
        held_by=None,
    )


def _turned(x: float, y: float, degrees: float) -> tuple[float, float]:
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return c * x - s * y, s * x + c * y
