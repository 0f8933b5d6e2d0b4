"""A brief for more than can be built is refused with the limit."""

from collections.abc import Iterator, Sequence

import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.program import home_orders
from mansion_planner.program.bands import Segment
from mansion_planner.solver.solve import solve_floor


@pytest.mark.parametrize(
    "request_",
    [
        BuildRequest(description="a warehouse of one floor, 1000000 m2"),
        BuildRequest(description="an office, 99999999999999999999 m2"),
        BuildRequest(description="a two-storey office, 60,000 m2 per floor"),
        BuildRequest(description="an office", floors=1, area=60_000.0),
    ],
    ids=lambda request: request.description[:30],
)
def test_a_storey_beyond_the_limit_is_refused(request_: BuildRequest) -> None:
    with pytest.raises(MansionError, match="at most 50000 m2") as caught:
        plan_building(request_)
    assert caught.value.code == ErrorCode.INFEASIBLE


def test_a_building_beyond_the_limit_is_refused() -> None:
    with pytest.raises(MansionError, match="at most 1000000 m2"):
        plan_building(BuildRequest(description="an office of 80 storeys", floor_area=15_000.0))


@pytest.mark.parametrize(
    "description",
    [
        "three bedrooms, a kitchen next to the living room, 9999999999 upstairs",
        "a three-storey hotel with 88888888 bedrooms",
        "an office with a meeting room, 77777777 of them",
        "three bedrooms, a kitchen, 1900 upstairs",
    ],
)
def test_more_rooms_than_storeys_can_have_take_no_memory(description: str) -> None:
    try:
        plan = plan_building(BuildRequest(description=description))
    except MansionError as error:
        assert error.code == ErrorCode.INFEASIBLE and "at most 400 on each of" in error.info.message
    else:
        assert sum(len(floor.rooms) for floor in plan.program.floors) < 100


def test_the_solver_refuses_an_outline_beyond_the_limit() -> None:
    side = 1_500.0
    outline = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
    problem = FloorProblem(boundary=outline, nodes=[ProblemNode(id="hall", type="main")])
    with pytest.raises(MansionError, match="at most 50000 m2"):
        solve_floor(problem)


def test_a_storey_longer_than_the_limit_is_refused() -> None:
    with pytest.raises(MansionError, match="at most 10000 m are built"):
        plan_building(BuildRequest(description="a warehouse of one floor", floor_area=45_000.0))


@pytest.mark.parametrize(
    ("options", "path", "accepted"), [({"area": 60.0}, "$.area", 84), ({"floor_area": 34.0}, "$.floor_area", 42)]
)
def test_an_area_that_no_outline_has_is_refused_with_one_that_is_built(
    options: dict[str, float], path: str, accepted: int
) -> None:
    description = "a two-storey starter home"
    with pytest.raises(MansionError, match=f"come to 2 storeys of {accepted} m2") as caught:
        plan_building(BuildRequest(description=description, **options))
    assert (caught.value.code, caught.value.info.path) == (ErrorCode.INFEASIBLE, path)
    name = path.removeprefix("$.")
    plan = plan_building(BuildRequest(description=description, **{name: float(accepted)}))
    floors = [floor.gross_floor_area for floor in plan.program.floors]
    assert (sum(floors) if name == "area" else floors[0]) == pytest.approx(accepted)


def test_the_rooms_of_a_large_home_change_places_no_more_often_than_those_of_a_small_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    drawn: list[list[Segment]] = []

    def counted(segments: Sequence[Segment]) -> Iterator[list[Segment]]:
        for order in exchanged(segments):
            drawn.append(order)
            yield order

    exchanged = home_orders._exchanged
    monkeypatch.setattr(home_orders, "_exchanged", counted)
    plan_building(BuildRequest(description="a house with 60 bedrooms"))
    assert len(drawn) < 1_000


def test_two_stairs_may_leave_no_wall_of_a_hall_between_them() -> None:
    text = "a seven-storey drug store with a 48 m2 icu. A wardrobe in every icu. The icu should be at least 60 m2"
    plan = plan_building(BuildRequest(description=text, floor_area=157.0, seed=308))
    assert len(plan.program.floors) == 7
