"""What becomes of briefs that say nothing, say something twice, or cannot be met."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize("brief", ["", "   ", "\n\t"])
def test_a_blank_brief_is_refused(brief: str) -> None:
    with pytest.raises(MansionError) as caught:
        plan_building(BuildRequest(description=brief))
    assert caught.value.code == "INVALID_PAYLOAD"
    assert caught.value.info.path == "$.description"


@pytest.mark.parametrize("brief", ["a submarine", "xyzzy foo quux", "Ein Haus mit drei Schlafzimmern und Balkon"])
def test_a_brief_of_which_nothing_is_understood_is_refused_with_a_way_out(brief: str) -> None:
    with pytest.raises(MansionError) as caught:
        plan_building(BuildRequest(description=brief))
    assert caught.value.code == "INVALID_PAYLOAD"
    assert "--planner llm" in caught.value.info.message


def test_a_brief_of_more_than_twenty_thousand_characters_is_refused() -> None:
    with pytest.raises(MansionError) as caught:
        plan_building(BuildRequest(description="two bedrooms, " * 2000))
    assert "20000" in caught.value.info.message


def test_node_ids_differ_when_the_brief_speaks_of_corridors() -> None:
    brief = "a community centre with corridors and a hall. corridors"
    for topology in plan_building(BuildRequest(description=brief)).topologies:
        ids = [node.id for node in topology.nodes]
        assert len(ids) == len(set(ids))


def test_a_room_said_again_is_the_same_room() -> None:
    def libraries(brief: str) -> int:
        return sum(r.room_type == "library_room" for r in read_brief(brief, default_knowledge()).rooms)

    assert libraries("a house with a library, library and library") == 1
    assert libraries("a house with a library and another library") == 2


def test_doubled_letters_and_sounds_are_read() -> None:
    facts = read_brief("a house with threee bedrooms", default_knowledge())
    assert [(room.name, room.count) for room in facts.rooms] == [("bedroom", 3)]
    assert read_brief("a farmacy", default_knowledge()) != read_brief("", default_knowledge())


def test_a_floor_area_too_small_is_refused_where_it_was_given() -> None:
    with pytest.raises(MansionError) as caught:
        plan_building(BuildRequest(description="a flat", floor_area=3))
    assert caught.value.info.path == "$.floor_area"
    assert caught.value.info.message.startswith("the rooms of a flat")


def test_what_stands_under_flats_is_on_the_ground_floor() -> None:
    brief = "museum and a shop under a block of flats, ten floors"
    program = plan_building(BuildRequest(description=brief)).program
    kinds = [{room.room_type for room in floor.rooms} for floor in program.floors]
    assert len(kinds) == 10
    assert {"gallery", "shop"} <= kinds[0]
    assert not kinds[0] & {"apartment", "small_apartment"}
    assert all(k & {"apartment", "small_apartment", "studio_apartment"} for k in kinds[1:])


def test_a_bungalow_of_five_storeys_is_reported() -> None:
    program = plan_building(BuildRequest(description="bungalow with five floors")).program
    assert len(program.floors) == 5
    assert [d.wish for d in program.downgrades] == ["bungalow"]


def test_a_building_that_only_its_last_noun_is_known_of_is_planned() -> None:
    program = plan_building(BuildRequest(description="A canteen building.")).program
    assert (program.building_type, program.kind) == ("canteen_building", "restaurant_building")
