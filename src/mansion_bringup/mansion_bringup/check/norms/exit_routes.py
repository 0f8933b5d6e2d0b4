"""Rules on the rooms that exit routes, and ways to toilets, may lead through."""

from collections.abc import Iterator

from mansion_bringup.check.norms.door_graph import Doors, behind, door_graph, exit_route, gets_out
from mansion_bringup.check.norms.premises import Deviation, Premises, rooms_of
from mansion_knowledge.norms import Norm
from mansion_msgs_py.scene import FloorScene, SceneRoom

__all__ = ["exit_route_deviations"]


def exit_route_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield rooms whose every exit route leads through a room that none may lead through."""
    for scene in premises.scenes:
        doors = door_graph(scene)
        for name in ("way_out_through_sleeping", "way_out_through_stores"):
            norm = premises.norm(name)
            if norm is not None:
                yield from _blocked_exits(premises, norm, scene, doors)
    yield from _toilet_through_bedroom(premises)


def _blocked_exits(premises: Premises, norm: Norm, scene: FloorScene, doors: Doors) -> Iterator[Deviation]:
    barred = {room.id for room in rooms_of(scene) if premises.is_one_of(room, norm.others)}
    for room in _concerned(premises, norm, scene, doors):
        if room.id in doors and not gets_out(doors, room.id, barred):
            through = " and ".join(name for name in exit_route(doors, room.id) if name in barred)
            if through:
                yield premises.deviation(norm, room.id, f"its only way out leads through {through}", "another way")


def _concerned(premises: Premises, norm: Norm, scene: FloorScene, doors: Doors) -> list[SceneRoom]:
    """Return the rooms of a rule; without a list those where people stay, but for the inner rooms of dwellings."""
    if norm.rooms:
        return [room for room in rooms_of(scene) if premises.is_one_of(room, norm.rooms)]
    units = [room.id for room in rooms_of(scene) if premises.is_sleeping_unit(room)]
    inner = set().union(*(behind(doors, unit) for unit in units))
    return [
        room
        for room in rooms_of(scene)
        if premises.knowledge.room(room.room_type).zone in ("public", "private")
        and room.id not in inner
        and not premises.is_one_of(room, norm.others)
    ]


def _toilet_through_bedroom(premises: Premises) -> Iterator[Deviation]:
    """Yield a dwelling whose toilets are all reached through rooms that are slept in."""
    norm = premises.norm("toilet_through_bedroom")
    if norm is None:
        return
    toilets = premises.of_types(norm.rooms)
    for scene in premises.scenes:
        doors = door_graph(scene)
        barred = {room.id for room in rooms_of(scene) if premises.is_one_of(room, norm.others)}
        if any(room.id in doors and gets_out(doors, room.id, barred) for room in toilets):
            return
    for room in toilets[:1]:
        yield premises.deviation(norm, room.id, "every toilet is reached through a bedroom", "one that is not")
