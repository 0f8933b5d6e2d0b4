"""Storeys too deep for one corridor get parallel ones; others stay along one."""

import pytest

from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.plan import plan_building
from mansion_planner.solver import solve_floor


def planned(brief: str) -> PlanReply:
    return plan_building(BuildRequest(description=brief))


def proportions(layout: FloorLayout, passages: set[str]) -> list[float]:
    found = []
    for room in layout.rooms:
        if room.id not in passages:
            xs, ys = zip(*room.polygon)
            short, long = sorted((max(xs) - min(xs), max(ys) - min(ys)))
            found.append(long / short)
    return found


@pytest.mark.parametrize(
    "brief",
    [
        "an office with two floors of 1,600 m2 each on a square plan",
        "a two-storey school of 1,800 m2 per floor with a square footprint",
        "a department store, three storeys of 1,500 m2 each, square",
    ],
)
def test_the_rooms_of_a_deep_storey_are_no_strips_and_all_are_reached(brief: str) -> None:
    reply = planned(brief)
    nodes = {node.id: node.room_type for node in reply.topologies[1].nodes}
    passages = {name for name, kind in nodes.items() if kind in ("corridor", "lobby", "atrium")}
    layout = solve_floor(reply.problems[1])
    assert layout.topology_satisfied
    assert len(passages) > 2
    assert max(proportions(layout, passages)) <= 3.0


def test_a_storey_of_which_no_outline_is_said_is_no_bar_of_a_hundred_metres() -> None:
    outline = planned("a library of two floors, 1,200 m2 each").program.floors[0].outline
    xs, ys = zip(*outline)
    sides = sorted((max(xs) - min(xs), max(ys) - min(ys)))
    assert sides[1] / sides[0] < 6.0
    assert sides[0] * sides[1] == pytest.approx(1200, rel=0.05)


@pytest.mark.parametrize("brief", ["an office with 380 m2 per floor, two storeys", "a two-storey house of 180 m2"])
def test_a_storey_of_usual_depth_keeps_its_one_corridor(brief: str) -> None:
    kinds = [node.room_type for node in planned(brief).topologies[1].nodes]
    assert sum(kind in ("corridor", "hallway", "landing") for kind in kinds) <= 2


@pytest.mark.parametrize(
    "brief", ["an office of 900 m2 a storey, two storeys, square", "a square office of 900 m2 a floor, two floors"]
)
def test_square_may_stand_at_the_end_of_a_list(brief: str) -> None:
    xs, ys = zip(*planned(brief).program.floors[0].outline)
    assert max(xs) - min(xs) == pytest.approx(max(ys) - min(ys), abs=1.0)
