"""Flats and other units hold what the brief says of each, and their storey has no such rooms beside them."""

import json
from collections import Counter
from pathlib import Path

import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.building import plan_program
from mansion_planner.program.plan_quality import dark_rooms

CASES = json.loads(Path(__file__).with_name("households.json").read_text())


def counted(reply: PlanReply, floor: int) -> Counter[str]:
    """Return how many bedrooms, bathrooms and kitchens a storey has."""
    knowledge, counts = default_knowledge(), Counter[str]()
    for room in next(entry for entry in reply.program.floors if entry.index == floor).rooms:
        counts["bedrooms"] += knowledge.room(room.room_type).counts_as == "bedroom"
        counts["bathrooms"] += room.room_type in ("bathroom", "ensuite_bathroom")
        counts["kitchens"] += "kitchen" in room.room_type
    return counts


def planned(brief: str) -> PlanReply:
    return plan_building(BuildRequest(description=brief))


@pytest.mark.parametrize("case", CASES, ids=[case["brief"][:60] for case in CASES])
def test_a_storey_has_the_rooms_of_its_units_and_no_more(case: dict[str, object]) -> None:
    counts = counted(planned(str(case["brief"])), int(str(case["floor"])))
    for name in ("bedrooms", "bathrooms", "kitchens"):
        assert case[name] is None or counts[name] == case[name], (name, counts)


@pytest.mark.parametrize("case", CASES, ids=[case["brief"][:60] for case in CASES])
def test_what_each_unit_is_to_hold_is_met(case: dict[str, object]) -> None:
    reply = planned(str(case["brief"]))
    for wish in receipt_of_plan(reply.program, reply.topologies):
        if wish.scope.unit and not wish.reason.startswith("no such room is known"):
            assert wish.status == "met", (wish.text, wish.reason)


def test_the_rooms_of_a_flat_are_reached_through_it() -> None:
    reply = planned("A block of flats of two storeys, three flats on each. Every flat has two bedrooms and a bathroom.")
    parents = {edge.target: edge.source for edge in reply.topologies[1].edges if edge.kind == "access"}
    inner = {name: parent for name, parent in parents.items() if name.startswith(("bedroom", "bathroom", "kitchen"))}
    assert Counter(inner.values()) == {"flat_1": 4, "flat_2": 4, "flat_3": 4}


def test_the_area_of_a_flat_is_that_of_all_its_rooms() -> None:
    reply = planned("A block of flats of two storeys. Three flats of 65 m2 each on every floor.")
    floor = reply.program.floors[1]
    parents = {edge.target: edge.source for edge in reply.topologies[1].edges if edge.kind == "access"}
    for flat in ("flat_1", "flat_2", "flat_3"):
        rooms = [room for room in floor.rooms if flat in (room.id, parents.get(room.id))]
        assert sum(room.area_estimate for room in rooms) == pytest.approx(65.0, rel=0.05)


def test_a_small_flat_has_one_bedroom_and_a_large_one_three() -> None:
    small = planned("A block of flats of two storeys. Four flats of 40 m2 each on every floor.")
    large = planned("A block of flats of two storeys. Two flats of 110 m2 each on every floor.")
    assert (counted(small, 2)["bedrooms"], counted(large, 2)["bedrooms"]) == (4, 6)


def test_flats_that_nobody_counted_hold_what_every_flat_is_to_hold() -> None:
    reply = planned(
        "An apartment building with three storeys. Every flat has three bedrooms, a kitchen and a bathroom."
    )
    floor = next(entry for entry in reply.program.floors if entry.index == 2)
    flats = sum(room.room_type in ("apartment", "small_apartment", "studio_apartment") for room in floor.rooms)
    assert flats > 0
    assert counted(reply, 2)["bedrooms"] == 3 * flats


@pytest.mark.parametrize(
    "text",
    [
        "A three-storey block with two flats per floor; each has two bedrooms, a bathroom, a kitchen and a balcony.",
        "A block of flats with four two-room flats on each of two floors, each with a balcony, bathroom and kitchen.",
    ],
)
def test_balconies_and_bedrooms_of_flats_lie_at_the_outer_wall(text: str) -> None:
    knowledge, request = default_knowledge(), BuildRequest(description=text)
    building = plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(0, "program"))
    for sketch in building.sketches.values():
        dark = {placement.room.kind.name for placement in dark_rooms(sketch, building.massing)}
        outdoor = [placement for placement in sketch.rooms if placement.room.kind.name == "balcony_room"]
        assert "bedroom" not in dark
        assert outdoor
        assert all(min(box[1] for box in p.boxes) < 0.01 or
                   max(box[3] for box in p.boxes) > building.massing.depth - 0.01 for p in outdoor)  # fmt: skip
