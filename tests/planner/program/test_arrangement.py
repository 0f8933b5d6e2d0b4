"""The arrangement that a building gets of several attempts."""

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.building import plan_program

BRIEF = (
    "Data centre, 2 floors. Each floor contains two data halls of 250 m², forty server racks per hall. "
    "Ground floor additionally: security desk at the entrance, generator room adjoining the switchgear "
    "room, and a battery room. Upper floor additionally: network control room, which must not sit next to "
    "a data hall. Stairs and a goods lift; no cafeteria."
)


def test_the_rooms_of_a_storey_are_those_of_its_sketch() -> None:
    request, knowledge = BuildRequest(description=BRIEF, seed=7), default_knowledge()
    facts = read_brief(BRIEF, knowledge)
    planned = plan_program(request, facts, knowledge, "b", item_generator(7, "program"))
    for storey in planned.storeys:
        rooms = [room.id for top in storey.rooms for room in top.each()]
        assert sorted(rooms) == sorted(placement.room.id for placement in planned.sketches[storey.index].rooms)


def test_furniture_without_a_room_goes_to_one_that_is_built() -> None:
    program = plan_building(BuildRequest(description=BRIEF, seed=7)).program
    wanted = [wanted.category for floor in program.floors for room in floor.rooms for wanted in room.objects]
    assert "control_desk" in wanted
