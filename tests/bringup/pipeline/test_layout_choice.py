"""Which of several layouts of a floor is taken."""

import msgspec
import pytest

from mansion_bringup.pipeline.layout_choice import reseeded, shortfall
from mansion_msgs_py.layout import FloorLayout, FloorProblem, LayoutRoom, ProblemNode, UnmetEdge
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.topology import Edge
from mansion_planner.plan import plan_building

BRIEF = "A one-storey house of 100 m2: a kitchen, a study, a bedroom. The study must not be next to the kitchen."


def box(x0: float, y0: float, x1: float, y1: float) -> Ring:
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


@pytest.fixture(scope="module")
def plan() -> PlanReply:
    """Return the plan of a house, its problem replaced by one of three rooms of 20 m2."""
    reply = plan_building(BuildRequest(description=BRIEF))
    names = [room.id for room in reply.program.floors[0].rooms if room.id in ("kitchen", "study", "bedroom")]
    assert len(names) == 3
    nodes = [ProblemNode(id=name, type="Entities", area=20.0) for name in names]
    edges = [Edge(source="kitchen", target="bedroom", kind="adjacent")]
    return msgspec.structs.replace(reply, problems=[FloorProblem(boundary=box(0, 0, 12, 5), nodes=nodes, edges=edges)])


def layout(**rooms: Ring) -> FloorLayout:
    placed = [LayoutRoom(id=name, polygon=ring) for name, ring in rooms.items()]
    return FloorLayout(rooms=placed, topology_satisfied=True, unmet_edges=[])


GOOD = layout(kitchen=box(0, 0, 4, 5), bedroom=box(4, 0, 8, 5), study=box(8, 0, 12, 5))


def test_a_layout_that_gives_everything_lacks_nothing(plan: PlanReply) -> None:
    assert shortfall(plan, 0, GOOD) == (False, 0.0)


@pytest.mark.parametrize(
    ("other", "square_metres"),
    [
        (layout(kitchen=box(0, 0, 5, 5), bedroom=box(5, 0, 8, 5), study=box(8, 0, 12, 5)), 10.0),
        (layout(kitchen=box(0, 0, 4, 5), bedroom=box(8, 0, 12, 5), study=box(4, 0, 8, 5)), 12.0),
        (layout(kitchen=box(4, 0, 8, 5), bedroom=box(0, 0, 4, 5), study=box(8, 0, 12, 5)), 6.0),
    ],
)
def test_areas_neighbours_and_rooms_to_be_apart_count(
    plan: PlanReply, other: FloorLayout, square_metres: float
) -> None:
    assert shortfall(plan, 0, other) == (False, pytest.approx(square_metres))


@pytest.mark.parametrize(
    ("note", "broken"),
    [("study: places narrower than 1.2 m cut it into 2 parts", True), ("node areas were scaled by 0.9", False)],
)
def test_a_room_of_no_usable_shape_counts_as_cut_off_and_a_note_on_areas_does_not(
    plan: PlanReply, note: str, broken: bool
) -> None:
    assert shortfall(plan, 0, msgspec.structs.replace(GOOD, messages=[note])) == (broken, 0.0)


def test_a_room_that_is_cut_off_is_worse_than_all_else(plan: PlanReply) -> None:
    unmet = [UnmetEdge(source="kitchen", target="study", kind="access", reason="they do not touch")]
    cut_off = msgspec.structs.replace(GOOD, unmet_edges=unmet)
    assert shortfall(plan, 0, cut_off) > shortfall(plan, 0, layout(kitchen=box(0, 0, 1, 1)))


def test_a_problem_is_drawn_anew_the_same_way_every_time(plan: PlanReply) -> None:
    problem = plan.problems[0]
    seeds = [again.seed for again in reseeded(problem)]
    assert len({problem.seed, *seeds}) == len(seeds) + 1
    assert seeds == [again.seed for again in reseeded(problem)]


def test_floors_of_many_rooms_are_not_drawn_anew() -> None:
    nodes = [ProblemNode(id=f"room_{number}", type="Entities", area=1.0) for number in range(60)]
    assert list(reseeded(FloorProblem(boundary=box(0, 0, 12, 5), nodes=nodes))) == []
