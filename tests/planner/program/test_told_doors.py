"""Rooms off others are entered from these, and balconies and terraces lie where people go out to them."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge, is_class
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.building import PlannedBuilding, plan_program


def planned(text: str) -> PlannedBuilding:
    knowledge = default_knowledge()
    request = BuildRequest(description=text)
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(0, "program"))


def parents(text: str) -> dict[str, str]:
    return {p.room.id: p.parent for sketch in planned(text).sketches.values() for p in sketch.rooms}


@pytest.mark.parametrize(
    ("text", "inner", "outer"),
    [
        ("a house with a balcony off the master bedroom", "balcony", "master_bedroom"),
        ("a house with a pantry off the kitchen", "pantry", "kitchen"),
        ("a clinic with a store room off the treatment room", "store_room", "treatment_room"),
        ("a two-storey house with a terrace off the living room", "terrace", "living_room"),
    ],
)
def test_a_room_off_another_is_entered_from_it(text: str, inner: str, outer: str) -> None:
    assert parents(text)[inner] == outer
    edges = [e for topology in plan_building(BuildRequest(description=text)).topologies for e in topology.edges]
    assert [(e.source, e.kind) for e in edges if e.target == inner] == [(outer, "access")]


def test_rooms_that_only_lie_side_by_side_are_reached_from_the_corridor() -> None:
    assert parents("a clinic with a store room next to the treatment room")["store_room"] != "treatment_room"


@pytest.mark.parametrize(
    ("text", "kind", "most"),
    [
        ("a two-bedroom flat with a balcony", "balcony_room", 16.0),
        ("a house with a patio", "terrace", 40.0),
        ("a cafe with a terrace", "terrace", 40.0),
    ],
)
def test_a_balcony_or_terrace_is_outdoors_and_in_scale(text: str, kind: str, most: float) -> None:
    found = [p for sketch in planned(text).sketches.values() for p in sketch.rooms if p.room.kind.name == kind]
    assert len(found) == 1
    assert is_class(kind, "outdoor")
    assert found[0].area <= most


def test_a_terrace_lies_on_the_ground_and_a_roof_terrace_on_top() -> None:
    storeys = {
        text: [
            index for index, sketch in planned(text).sketches.items() for p in sketch.rooms if "terrace" in p.room.id
        ]
        for text in ("a three-storey hotel with a terrace", "a three-storey hotel with a roof terrace")
    }
    assert list(storeys.values()) == [[1], [3]]


@pytest.mark.parametrize("text", ["a duplex with a roof garden", "a house with a roof terrace"])
def test_a_roof_terrace_of_a_home_leaves_place_for_what_it_tops(text: str) -> None:
    found = [p for sketch in planned(text).sketches.values() for p in sketch.rooms]
    assert sum(p.area for p in found if p.room.kind.name == "roof_terrace") <= 55.0
    assert any("bedroom" in p.room.kind.name for p in found)
