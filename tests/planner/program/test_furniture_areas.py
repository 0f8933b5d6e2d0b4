"""Rooms are planned as large as the furniture that is asked for in them needs."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.program import BuildingProgram, RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.furniture_areas import furniture_areas, usually_has


def areas(brief: str) -> dict[str, float]:
    facts = read_brief(brief, default_knowledge())
    return furniture_areas(facts.rooms, facts.objects)


def planned(brief: str) -> BuildingProgram:
    return plan_building(BuildRequest(description=brief)).program


def rooms(program: BuildingProgram, base: str) -> list[RoomProgram]:
    return [room for floor in program.floors for room in floor.rooms if room.id.startswith(base)]


def test_a_hall_of_seats_needs_about_a_square_metre_for_each() -> None:
    assert areas("A theatre with an auditorium with 150 seats")["auditorium"] == pytest.approx(199.0)


def test_a_car_needs_about_sixteen_square_metres() -> None:
    two, three = (areas(f"A house with a garage for {n} cars")["garage"] for n in (2, 3))
    assert 14.0 < three - two < 18.0


def test_what_hangs_or_lies_needs_no_floor() -> None:
    assert areas("A flat with a living room with two paintings and a microphone") == {}


def test_a_room_grows_for_its_furniture_and_a_stated_area_stays() -> None:
    brief = "A community hall with a recital hall{} with 150 seats, a foyer and toilets"
    free, stated = (rooms(planned(brief.format(area)), "recital_hall") for area in ("", " of 90 m2"))
    assert free[0].area_estimate > 120.0
    assert stated[0].area_estimate == pytest.approx(90.0, rel=0.1)


def test_storeys_that_repeat_another_have_as_much_furniture() -> None:
    program = planned(
        "A factory with three storeys of 800 m2. The second floor has a sewing hall with 40 sewing machines and an "
        "office. The third floor is the same as the second floor."
    )
    counts = [item.count for room in rooms(program, "sewing_hall") for item in room.objects]
    assert counts == [40, 40]


def test_the_main_room_of_a_storey_gets_what_is_asked_for_in_it() -> None:
    program = planned("A cinema with a foyer with a popcorn machine and two ticket machines, and an auditorium")
    hub = program.floors[0].rooms[0]
    assert hub.name == "foyer"
    assert {item.category: item.count for item in hub.objects} == {"popcorn_machine": 1, "ticket_machine": 2}


def test_rooms_have_what_their_type_usually_has() -> None:
    assert usually_has("open_office", "desk") and not usually_has("toilet", "desk")


def test_many_pieces_without_a_room_get_one_that_usually_has_many() -> None:
    program = planned("A call centre of two identical floors with 40 workstations on each and one supervisor office")
    holders = {room.id for floor in program.floors for room in floor.rooms if room.objects}
    assert holders == {"open_office"}
    assert rooms(program, "open_office")[0].area_estimate > 80.0


def test_a_room_of_the_brief_that_usually_has_many_gets_them() -> None:
    program = planned("An office with a drawing office, an open office of 200 m2 and 20 desks")
    assert [(r.id, [o.count for o in r.objects]) for f in program.floors for r in f.rooms if r.objects] == [
        ("open_office", [20])
    ]


def test_a_number_for_several_rooms_is_shared_out_without_a_rest() -> None:
    program = planned("A mountain hut, one storey: 4 dormitories, 10 bunk beds in the dormitories, a kitchen")
    beds = [o.count for f in program.floors for r in f.rooms for o in r.objects if o.category == "bunk_bed"]
    assert sorted(beds) == [2, 2, 3, 3]
