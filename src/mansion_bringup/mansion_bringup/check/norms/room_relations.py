"""Rules on rooms that must be near each other, and on rooms that no door may join."""

from collections.abc import Iterator

import networkx as nx

from mansion_bringup.check.norms.premises import Deviation, Premises

__all__ = ["relation_deviations"]

_DOOR_RULES = (
    "toilet_food_door",
    "toilet_dining_door",
    "service_door",
    "secure_door",
    "garage_bedroom_door",
    "sterile_door",
    "court_door",
)
_ANYWHERE = 9
"""Number of storeys from which on a rule asks for no companion at all."""

_COMPANION_RULES = ("sports_changing", "pool_showers", "operating_recovery")


def relation_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of neighbouring rooms."""
    yield from _kitchen_of_dining(premises)
    for name in _COMPANION_RULES:
        yield from _companions(premises, name)
    for name in _DOOR_RULES:
        yield from _forbidden_doors(premises, name)


def _kitchen_of_dining(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("kitchen_of_dining")
    if norm is None:
        return
    kitchens = [room.id for room in premises.of_types(norm.others)]
    graph: nx.Graph[str] = nx.Graph()
    for scene in premises.scenes:
        rooms = {room.id for room in scene.rooms}
        graph.add_nodes_from(rooms)
        graph.add_edges_from((d.rooms[0], d.rooms[1]) for d in scene.doors if rooms.issuperset(d.rooms))
    for room in premises.of_types(norm.rooms):
        steps = nx.single_source_shortest_path_length(graph, room.id)
        between = min((steps[name] - 1 for name in kitchens if name in steps), default=None)
        asked = f"a kitchen through {norm.figure:.0f} room at most"
        if between is None:
            yield premises.deviation(norm, room.id, "no kitchen on its storey", asked)
        elif between > norm.figure:
            yield premises.deviation(norm, room.id, f"its kitchen is {between} rooms away", asked)


def _companions(premises: Premises, name: str) -> Iterator[Deviation]:
    """Yield rooms whose companion is too many storeys away, or missing."""
    norm = premises.norm(name)
    if norm is None:
        return
    floors = {room.id: scene.floor for scene in premises.scenes for room in scene.rooms}
    others = [floors[room.id] for room in premises.of_types(norm.others)]
    named = " or ".join(kind.replace("_", " ") for kind in norm.others)
    for room in premises.of_types(norm.rooms):
        away = min((abs(floors[room.id] - floor) for floor in others), default=None)
        if away is None and premises.limit(norm) < _ANYWHERE:
            yield premises.deviation(norm, room.id, f"no {named}", "one")
        elif away is not None and away > premises.limit(norm):
            yield premises.deviation(norm, room.id, f"{away} storeys to the nearest {named}", f"{norm.figure:.0f}")


def _forbidden_doors(premises: Premises, name: str) -> Iterator[Deviation]:
    norm = premises.norm(name)
    if norm is None:
        return
    behind = {room.id: room for room in premises.of_types(norm.others)}
    for room in premises.of_types(norm.rooms):
        for other in premises.beside.get(room.id, ()):
            if other in behind:
                found = f"a door to {behind[other].room_type.replace('_', ' ')}"
                yield premises.deviation(norm, f"{room.id} and {other}", found, "none")
