"""Rooms of which no seeds tell where they lie get the shapes that rooms of their kind have in real flats."""

import statistics

import numpy as np
from shapely.geometry import Polygon

from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.topology import Edge
from mansion_planner.solver import SolverOptions, solve_floor
from mansion_planner.solver.options import ANY, shape_of
from mansion_planner.solver.problem import (
    CORNER_WEIGHT,
    DETOUR,
    FACADE,
    SHAPE_WEIGHT,
    WALL_WEIGHT,
    make_goal,
    make_model,
)

COLUMNS = [SHAPE_WEIGHT, CORNER_WEIGHT, WALL_WEIGHT, DETOUR, FACADE]


def flat(*, seeds: bool = False, typed: bool = True, seed: int = 0) -> FloorProblem:
    places = {"bed": (2.0, 2.0), "bath": (6.0, 1.5), "kitchen": (9.0, 2.0), "bed_2": (2.0, 6.5)}
    kinds = {"bed": "bedroom", "bath": "bathroom", "kitchen": "kitchen", "bed_2": "bedroom"}
    rooms = [
        ProblemNode(
            id=name,
            type="Entities",
            area={"bath": 6.0}.get(name, 15.0),
            room_type=kinds[name] if typed else "",
            seed=places[name] if seeds else None,
        )
        for name in places
    ]
    hub = ProblemNode(id="living", type="main", area=39.0, room_type="living_room")
    return FloorProblem(
        boundary=[(0, 0), (10, 0), (10, 9), (0, 9)],
        nodes=[hub, *rooms],
        edges=[Edge(source="living", target=name, kind="access") for name in places],
        seed=seed,
    )


def preferences(problem: FloorProblem) -> list[list[float]]:
    options = SolverOptions()
    return np.round(make_goal(make_model(problem, options), options).rooms[:, COLUMNS], 3).tolist()


def test_each_kind_has_its_own_preferences_and_the_hub_none() -> None:
    hub, bed, bath, *_ = preferences(flat())
    shape = shape_of("bedroom")
    assert hub[2] == 0.0 and hub[3:] == [ANY.detour, ANY.facade]
    assert bed == [shape.compact, shape.corner, shape.wall, shape.detour, shape.facade]
    assert bath == [ANY.compact, ANY.corner, ANY.wall, ANY.detour, ANY.facade]


def test_seeds_say_enough_of_where_rooms_lie() -> None:
    assert all(row[3:] == [ANY.detour, ANY.facade] for row in preferences(flat(seeds=True)))


def test_bedrooms_come_out_more_rectangular_than_rooms_of_no_kind() -> None:
    def fill(*, typed: bool) -> float:
        shares = []
        for seed in range(4):
            layout = solve_floor(flat(typed=typed, seed=seed))
            for room in layout.rooms:
                if room.id.startswith("bed"):
                    shape = Polygon(room.polygon)
                    shares.append(shape.area / shape.minimum_rotated_rectangle.area)
        return statistics.mean(shares)

    assert fill(typed=True) >= fill(typed=False) > 0.5
