"""What is wrong with a home as such: long halls, a kitchen on its own, rooms too slender for furniture."""

from dataclasses import replace

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.program.building import plan_program
from mansion_planner.program.home_quality import home_faults
from mansion_planner.program.model import Box, Corridor, Placement, Sketch, Storey
from mansion_planner.program.planned_rooms import planned_room

KNOWLEDGE = default_knowledge()


def storey() -> Storey:
    request = BuildRequest(description="a bungalow")
    facts = read_brief(request.description, KNOWLEDGE)
    return plan_program(request, facts, KNOWLEDGE, "b", item_generator(0, "program")).storeys[0]


def faults(rooms: dict[str, Box], hall: Box = (0.0, 4.0, 10.0, 5.0), area: float = 90.0) -> float:
    placed = [Placement(planned_room(KNOWLEDGE.room(name), KNOWLEDGE), [box], "hallway") for name, box in rooms.items()]
    sketch = Sketch([Corridor("hallway", [hall], "")], placed, {})
    return home_faults([(replace(storey(), rooms=()), sketch, area)])


def test_a_kitchen_by_the_living_room_is_no_fault_and_one_apart_is() -> None:
    together = {"kitchen": (0.0, 0.0, 4.0, 4.0), "living_room": (4.0, 0.0, 10.0, 4.0)}
    apart = {"kitchen": (0.0, 0.0, 4.0, 4.0), "bedroom": (4.0, 0.0, 7.5, 4.0), "living_room": (0.0, 5.0, 6.0, 9.0)}
    assert faults(together) == 0.0
    assert faults(apart) > 0.0


def test_a_hall_above_its_share_and_a_slender_bedroom_are_faults() -> None:
    assert faults({"bedroom": (0.0, 0.0, 4.0, 4.0)}, hall=(0.0, 4.0, 10.0, 6.0)) > 0.0
    assert faults({"bedroom": (0.0, 0.0, 2.0, 5.0)}) > faults({"bedroom": (0.0, 0.0, 3.0, 4.0)}) == 0.0


def test_a_long_living_room_that_other_rooms_line_is_a_fault() -> None:
    def lined(hub: Box) -> float:
        living = replace(storey(), rooms=(), hub=KNOWLEDGE.room("living_room"))
        return home_faults([(living, Sketch([Corridor("living_room", [hub], "")], [], {}), 80.0)])

    assert lined((0.0, 0.0, 16.0, 2.3)) > lined((0.0, 0.0, 9.0, 3.5)) > lined((0.0, 0.0, 6.0, 4.0)) == 0.0
