"""How much lies about is read for the building and for single rooms, and kept by the plan."""

import msgspec
import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_msgs_py.program import BuildingProgram, Clutter
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def _plan(text: str, clutter: Clutter | None = None) -> BuildingProgram:
    asked = msgspec.UNSET if clutter is None else clutter
    reply = plan_building(BuildRequest(description=text, clutter=asked))
    return msgspec.structs.replace(reply.program, wishes=list(receipt_of_plan(reply.program, reply.topologies)))


def _rooms(program: BuildingProgram, kind: str = "") -> set[object]:
    return {room.clutter for floor in program.floors for room in floor.rooms if kind in ("", room.room_type)}


@pytest.mark.parametrize(
    ("text", "clutter"),
    [
        ("a studio flat of 66 m2, one bathroom, crammed with stuff", "dense"),
        ("a flat packed with all sorts of things", "dense"),
        ("a cluttered flat", "dense"),
        ("a flat with lots of small objects", "dense"),
        ("a flat. The place is littered with odds and ends", "dense"),
        ("a flat with a lot of stuff lying about", "dense"),
        ("a clutter-free flat", "sparse"),
        ("a flat without clutter", "sparse"),
        ("a flat. Keep it tidy", "sparse"),
        ("a flat. It should not be messy", "sparse"),
        ("a flat with hardly any knick-knacks", "sparse"),
    ],
)
def test_what_is_said_of_the_building_holds_in_all_rooms(text: str, clutter: str) -> None:
    program = _plan(text)
    assert _rooms(program) == {clutter}
    told = [wish for wish in program.wishes if wish.kind == "clutter"]
    assert [(wish.status, wish.value.name) for wish in told] == [("met", clutter)]
    assert not [wish for wish in program.wishes if wish.kind == "unread" or wish.value.unheeded]


@pytest.mark.parametrize(
    "text",
    ["a house with a messy kitchen", "a house with a kitchen full of stuff", "a house. The kitchen is cluttered"],
)
def test_what_is_said_of_a_room_holds_there_alone(text: str) -> None:
    program = _plan(text)
    assert _rooms(program, "kitchen") == {"dense"}
    assert _rooms(program, "living_room") == {msgspec.UNSET}


def test_a_room_may_differ_from_the_building() -> None:
    program = _plan("a house with lots of small objects in the kitchen and hardly any knick-knacks elsewhere")
    assert _rooms(program, "kitchen") == {"dense"}
    assert _rooms(program, "living_room") == {"sparse"}
    assert all(wish.status == "met" for wish in program.wishes)


def test_the_request_wins_over_the_text_and_the_receipt_says_so() -> None:
    program = _plan("a cluttered flat", "sparse")
    assert _rooms(program) == {"sparse"}
    assert [wish.status for wish in program.wishes if wish.kind == "clutter"] == ["partly"]


@pytest.mark.parametrize(
    "text", ["a warehouse full of boxes", "a house with a room for a few things", "a library packed with books"]
)
def test_other_nouns_say_nothing_of_it(text: str) -> None:
    assert "clutter" not in {wish.kind for wish in _plan(text).wishes}
