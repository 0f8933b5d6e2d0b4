"""The floor solver: from a room graph and a free region to room polygons (Algorithms 2 and 3, section C.2)."""

from mansion_planner.solver.options import EnergyWeights, SearchWeights, SolverOptions
from mansion_planner.solver.solve import solve_floor, warm

__all__ = ["EnergyWeights", "SearchWeights", "SolverOptions", "solve_floor", "warm"]
