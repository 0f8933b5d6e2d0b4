"""The energy that the wall search lowers: areas, seeds, shapes and, weighted most, topology."""

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel
from mansion_planner.solver.partition import CORNERS, MX, MY, PERIMETER, SIZE, State
from mansion_planner.solver.problem import (
    ACCESS,
    CORNER_WEIGHT,
    DETOUR,
    FACADE,
    SEED_WEIGHT,
    SEED_X,
    SEED_Y,
    SHAPE_WEIGHT,
    TARGET,
    WALL_WEIGHT,
    Goal,
)
from mansion_planner.solver.walls import LARGE

__all__ = ["W_THIN", "edge_energy", "room_cost", "room_costs", "room_energy", "thin_energy", "total_energy"]


(W_AREA, W_SEED, W_CORNER, W_COMPACT, W_ACCESS, W_ADJACENT, W_THIN, W_APART, W_STRADDLE, W_WALL, W_NARROW) = range(11)
"""Indices into `Goal.weights`, in the order of the fields of `SearchWeights`."""

NARROW = 1e-3
"""Area, m2, of narrow places from which on a room has any."""


@kernel
def room_cost(rooms: Floats, w: Floats, stats: Floats, contact: Floats, outside: int, r: int) -> float:
    """Return what area, seed, proportions and envelope of room `r` cost, which is all but its corners."""
    a = stats[r, SIZE]
    t = rooms[r, TARGET]
    if a <= 1e-9:
        return 100.0
    energy = w[W_AREA] * abs(a - t) / t
    weight = rooms[r, SEED_WEIGHT]
    if weight > 0.0:
        dx = stats[r, MX] / a - rooms[r, SEED_X]
        dy = stats[r, MY] / a - rooms[r, SEED_Y]
        energy += w[W_SEED] * weight * np.sqrt((dx * dx + dy * dy) / t)
    shape = stats[r, PERIMETER] / (4.0 * np.sqrt(a))
    energy += w[W_COMPACT] * rooms[r, SHAPE_WEIGHT] * max(0.0, shape - rooms[r, DETOUR])
    weight = rooms[r, WALL_WEIGHT]
    if weight > 0.0:
        energy += w[W_WALL] * weight * max(0.0, 1.0 - contact[r, outside] / (rooms[r, FACADE] * np.sqrt(t)))
    return float(energy)


@kernel
def room_energy(rooms: Floats, w: Floats, stats: Floats, straddle: Floats, costs: Floats) -> float:
    """Return the part of the energy that areas, seeds and shapes cause; `costs` holds each room's `room_cost`."""
    energy = w[W_STRADDLE] * straddle[0]
    for r in range(rooms.shape[0]):
        corners = max(0.0, stats[r, CORNERS] - 4.0)
        energy += costs[r] + w[W_CORNER] * rooms[r, CORNER_WEIGHT] * corners
    return float(energy)


@kernel
def edge_energy(
    links: Ints, need: Floats, apart: Ints, w: Floats, stats: Floats, contact: Floats, straight: Floats, exact: bool
) -> float:
    """Return the part of the energy that the room graph causes.

    With `exact` false the straight runs are not known and whole contacts stand in for them, which gives a lower bound.
    """
    energy = 0.0
    for e in range(links.shape[0]):
        a, b = links[e, 0], links[e, 1]
        length = contact[a, b]
        access = links[e, 2] == ACCESS
        if exact and access:
            length = straight[a, b]
        if length >= need[e] - 1e-9:
            continue
        miss = 0.35 + 0.45 * (need[e] - length) / need[e]
        if length <= 1e-9 and stats[a, SIZE] > 0.0 and stats[b, SIZE] > 0.0:
            dx = stats[a, MX] / stats[a, SIZE] - stats[b, MX] / stats[b, SIZE]
            dy = stats[a, MY] / stats[a, SIZE] - stats[b, MY] / stats[b, SIZE]
            size = np.sqrt(stats[a, SIZE]) + np.sqrt(stats[b, SIZE])
            miss += 0.2 * min(4.0, np.sqrt(dx * dx + dy * dy) / size)
        energy += miss * (w[W_ACCESS] if access else w[W_ADJACENT])
    for k in range(apart.shape[0]):
        s = contact[apart[k, 0], apart[k, 1]]
        if s > 1e-9:
            energy += w[W_APART] * min(1.0, s)
    return energy


@kernel
def thin_energy(rooms: Floats, w: Floats, thin: Floats) -> float:
    """Return the part of the energy that places narrower than the minimum width cause."""
    energy = 0.0
    for r in range(rooms.shape[0]):
        if thin[r] > NARROW:
            energy += w[W_NARROW] + w[W_THIN] * thin[r] / min(LARGE, rooms[r, TARGET])
    return energy


@kernel
def total_energy(goal: Goal, state: State) -> float:
    """Return the whole energy of a state."""
    rooms, weights = goal.rooms, goal.weights
    costs = room_costs(goal, state)
    energy = room_energy(rooms, weights, state.stats, state.straddle, costs)
    energy += edge_energy(
        goal.links, goal.need, goal.apart, weights, state.stats, state.contact, state.straight, exact=True
    )
    return energy + thin_energy(rooms, weights, state.thin)


@kernel
def room_costs(goal: Goal, state: State) -> Floats:
    """Return each room's `room_cost`."""
    costs = np.empty(goal.rooms.shape[0])
    outside = state.stats.shape[0] - 1
    for r in range(costs.size):
        costs[r] = room_cost(goal.rooms, goal.weights, state.stats, state.contact, outside, r)
    return costs
