"""Buildings are as large as what their brief tells, counts or calls them, and hold hardly a room besides."""

import re

import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_knowledge import default_knowledge
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.program import BuildingProgram, RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wishes import Wish
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.building_size import size_of_program, tells_program

KNOWLEDGE = default_knowledge()


def storeys(brief: str) -> list[list[RoomProgram]]:
    return [list(floor.rooms) for floor in plan_building(BuildRequest(description=brief, seed=5)).program.floors]


def types(brief: str) -> set[str]:
    return {room.room_type for rooms in storeys(brief) for room in rooms}


@pytest.mark.parametrize(
    ("brief", "kind", "expected"),
    [
        ("A cinema with two screening rooms and a bar", "cinema", True),
        ("A gym with a weights area and a yoga studio", "gym_building", True),
        ("A hotel with twelve rooms", "hotel", True),
        ("A hotel with a restaurant and a bar", "hotel", False),
        ("A hospital with a waiting room and an operating room", "hospital", False),
        ("A house with three bedrooms and a study", "house", False),
        ("An office with a reception, a meeting room, a library, a print room and a kitchen", "office", True),
        ("An office of 900 m2 with a reception, meeting room, library, print room and kitchen", "office", False),
        ("An office with a reception, a meeting room and a kitchen", "office", False),
    ],
)
def test_a_brief_tells_a_program_that_names_what_the_building_is_there_for(
    brief: str, kind: str, *, expected: bool
) -> None:
    assert tells_program(read_brief(brief, KNOWLEDGE), KNOWLEDGE.buildings[kind], KNOWLEDGE) is expected


@pytest.mark.parametrize(
    ("brief", "absent"),
    [
        ("a hospital ward with eight patient rooms and a nurse station", "emergency_room"),
        ("a car repair workshop with three service bays and a waiting area", "production_hall"),
        ("a restaurant with seating for 40 people and a kitchen", "vip_room"),
        ("a kindergarten with two playrooms and a nap room", "playroom"),
        ("a small grocery store with a storage room at the back", "bakery"),
        ("a primary school with six classrooms and a gym hall", "commercial_kitchen"),
    ],
)
def test_no_large_rooms_that_nobody_asked_for(brief: str, absent: str) -> None:
    assert absent not in types(brief)


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("a dental clinic with a waiting room and three treatment rooms", "sterilization_room"),
        ("a three-storey hotel with ten rooms on each upper floor", "housekeeping_room"),
        ("a hospital ward with eight patient rooms", "sterilization_room"),
        ("a primary school with six classrooms and a gym hall", "school_office"),
    ],
)
def test_a_building_has_the_rooms_that_it_cannot_do_without(brief: str, kind: str) -> None:
    assert kind in types(brief)


def test_told_rooms_are_the_largest() -> None:
    rooms = [
        room for floor in storeys("a robotics lab with a large test area and a small meeting room") for room in floor
    ]
    test_area = max(rooms, key=lambda room: room.area_estimate)
    assert test_area.id == "test_area"
    assert all(2.0 * room.area_estimate <= test_area.area_estimate for room in rooms if room is not test_area)


def test_stores_in_a_basement_are_no_measure_for_those_above() -> None:
    (rooms,) = storeys("a hospital ward with eight patient rooms and a medicine storage room")
    assert next(room.area_estimate for room in rooms if room.id == "medicine_storage_room") < 20.0


def test_rooms_told_for_one_storey_do_not_fill_others() -> None:
    ground, upper = storeys(
        "a town hall with a council chamber, a public service counter and offices on the second floor"
    )
    assert any(room.room_type == "service_counter" for room in ground)
    assert sum(room.room_type == "private_office" for room in ground) == 0
    assert any(room.room_type in ("private_office", "open_office") for room in upper)


def test_beds_that_are_counted_size_the_rooms_that_they_stand_in() -> None:
    brief = "a fire station with a garage for two trucks and sleeping quarters for {} firefighters upstairs"
    eight, twenty = (
        sum(room.area_estimate for room in storeys(brief.format(number))[1] if room.room_type == "bunk_room")
        for number in ("eight", "twenty")
    )
    assert eight < 70.0 and eight + 20.0 < twenty


def test_a_corridor_that_is_told_is_the_one_along_which_the_rooms_lie() -> None:
    ground = storeys("a primary school with six classrooms along a corridor")[0]
    assert not any(room.id == "corridor_area" for room in ground)


def test_a_hall_for_sport_has_changing_rooms() -> None:
    ground = storeys("a primary school with six classrooms and a gym hall")[0]
    assert sum(room.room_type == "changing_room" for room in ground) == 2


def storeys_of_size(brief: str, kind: str) -> int | None:
    size = size_of_program(read_brief(brief, KNOWLEDGE), KNOWLEDGE.buildings[kind], KNOWLEDGE)
    return size and size.storeys


@pytest.mark.parametrize(
    ("brief", "kind", "expected"),
    [
        ("An office with three offices and a meeting room.", "office", 1),
        ("A school with four classrooms.", "school", 1),
        ("A hotel with 12 rooms and a restaurant.", "hotel", 2),
    ],
)
def test_a_few_rooms_make_a_small_building(brief: str, kind: str, expected: int) -> None:
    assert storeys_of_size(brief, kind) == expected


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A hotel with 60 rooms.", "hotel"),
        ("A hotel with a restaurant.", "hotel"),
        ("A high-rise hotel with 12 rooms.", "hotel"),
        ("A hotel with 12 rooms, 2000 m2 in all.", "hotel"),
        ("A hotel with 12 rooms on the third floor.", "hotel"),
        ("A house with three bedrooms.", "house"),
    ],
)
def test_other_briefs_keep_the_usual_size(brief: str, kind: str) -> None:
    assert storeys_of_size(brief, kind) is None


def test_rooms_that_are_counted_on_a_storey_have_none_above_them() -> None:
    brief = "An inn with a taproom and a kitchen on the ground floor and six guest rooms on the floor above."
    assert len(plan_building(BuildRequest(description=brief, seed=5)).program.floors) == 2


def test_a_storey_is_as_large_as_its_share() -> None:
    few, many = (
        size_of_program(read_brief(f"A hotel with {n} rooms.", KNOWLEDGE), KNOWLEDGE.buildings["hotel"], KNOWLEDGE)
        for n in (4, 16)
    )
    assert few is not None and many is not None
    assert few.storeys * few.area < many.storeys * many.area


@pytest.mark.parametrize("given", [{"area": 1500.0}, {"floor_area": 300.0}])
def test_a_size_in_the_request_leaves_the_usual_number_of_storeys(given: dict[str, float]) -> None:
    program = plan_building(BuildRequest(description="A hotel with 12 rooms", **given)).program
    assert len(program.floors) >= KNOWLEDGE.buildings["hotel"].floors[0]


@pytest.mark.parametrize(
    ("brief", "storeys"),
    [
        ("an office of 200 m2", 1),
        ("a garden annexe of 55 m2 for one person", 1),
        ("a house of 90 m2", 1),
        ("a house of 120 m2", 2),
        ("an office of 600 m2", 2),
        ("a townhouse of 90 m2", 2),
        ("a house of 90 m2 on two floors", 2),
    ],
)
def test_a_stated_area_is_divided_over_storeys_that_have_room_beside_a_stair(brief: str, storeys: int) -> None:
    program = plan_building(BuildRequest(description=brief)).program
    assert len(program.floors) == storeys
    stated = float(re.search(r"(\d+) m2", brief).group(1))  # type: ignore[union-attr]
    assert sum(floor.gross_floor_area for floor in program.floors) == pytest.approx(stated, rel=0.1)


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
