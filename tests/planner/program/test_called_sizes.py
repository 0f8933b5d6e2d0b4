"""What a brief calls a small or a large building is smaller or larger than usual, and its receipt says so."""

import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wishes import Wish
from mansion_planner.plan import plan_building


def _plan(text: str, floors: int | None = None, floor_area: float | None = None) -> PlanReply:
    return plan_building(BuildRequest(description=text, floors=floors, floor_area=floor_area))


def _kind(reply: PlanReply) -> Wish:
    return next(w for w in receipt_of_plan(reply.program, reply.topologies) if w.kind == "building_type")


def _area(reply: PlanReply) -> float:
    return sum(floor.gross_floor_area for floor in reply.program.floors)


@pytest.mark.parametrize("kind", ["house", "bungalow", "office", "school", "hospital", "supermarket", "library"])
def test_small_and_large_buildings_differ_from_usual_ones(kind: str) -> None:
    small, usual, large = (_plan(f"A {size}{kind}") for size in ("small ", "", "large "))
    assert _area(small) < _area(usual) < _area(large)
    assert (_kind(small).status, _kind(small).value.limit) == ("met", "most")
    assert (_kind(large).status, _kind(large).value.limit) == ("met", "least")


def test_an_area_of_the_request_says_itself_what_is_meant() -> None:
    wish = _kind(_plan("A big office", floors=1, floor_area=390))
    assert (wish.status, wish.value.limit) == ("met", "")


@pytest.mark.parametrize("text", ["A small flat of 110 m2", "A house with small rooms", "A not too small house"])
def test_numbers_and_sizes_of_rooms_bound_no_building(text: str) -> None:
    assert _kind(_plan(text)).value.limit == ""


def test_a_look_before_the_kind_of_building_is_its_style() -> None:
    assert _plan("A warm family flat").program.style == "warm"
    assert _plan("A house with a warm living room").program.style != "warm"


def test_a_receipt_is_the_same_after_it_went_over_the_wire() -> None:
    program = plan_building(BuildRequest(description="a small flat for two")).program
    assert encode(decode(BuildingProgram, encode(program))) == encode(program)
