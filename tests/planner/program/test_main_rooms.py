"""A building has the rooms that it is there for, whatever else a brief asks for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building

CALLED: dict[str, tuple[str, str]] = {
    "public swimming pool": ("public_swimming_pool", "indoor_pool"),
    "bakery": ("bakery", "bakery"),
    "butcher's": ("butcher", "butchery"),
    "garden centre": ("garden_centre", "greenhouse"),
    "planetarium": ("planetarium", "planetarium"),
    "climbing hall": ("climbing_hall", "climbing_room"),
    "ice rink": ("ice_rink", "ice_rink"),
    "city archive": ("city_archive", "archive"),
    "yoga studio": ("yoga_studio", "yoga_studio"),
    "animal shelter": ("animal_shelter", "kennel"),
    "makerspace": ("makerspace", "makerspace"),
    "library": ("library", "book_stacks"),
}


@pytest.mark.parametrize("noun", CALLED)
def test_a_building_called_so_has_its_main_room_beside_what_the_brief_adds(noun: str) -> None:
    article = "an" if noun[0] in "aeiou" else "a"
    reply = plan_building(BuildRequest(description=f"{article} {noun} with a small cafe and an office", seed=5))
    kind, room_type = CALLED[noun]
    entrance = reply.program.floors[0]
    assert reply.program.building_type == kind
    assert {room_type, "cafe"} <= {room.room_type for room in entrance.rooms}


def test_a_brief_that_says_how_many_gets_so_many() -> None:
    reply = plan_building(BuildRequest(description="a one-storey school with four classrooms and a library", seed=5))
    assert sum(room.room_type == "classroom" for floor in reply.program.floors for room in floor.rooms) == 4


def test_a_main_room_that_the_brief_excludes_is_not_built() -> None:
    reply = plan_building(BuildRequest(description="a one-storey community centre without an assembly hall", seed=5))
    assert "assembly_hall" not in {room.room_type for floor in reply.program.floors for room in floor.rooms}


def test_main_rooms_are_listed_for_the_entrance_storey() -> None:
    for building in default_knowledge().buildings.values():
        if building.main and not building.like:
            listed = {entry.room_type for role in ("single", "ground") for entry in building.storeys.get(role, ())}
            assert building.main <= listed, building.name
