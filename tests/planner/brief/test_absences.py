"""What a brief says not to be there, in any of its wordings, is one statement that the building can meet."""

import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wishes import Wish
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def _receipt(text: str) -> list[Wish]:
    plan = plan_building(BuildRequest(description=text))
    return receipt_of_plan(plan.program, plan.topologies)


@pytest.mark.parametrize(
    "text",
    [
        "A mansion with two floors; lifts were unknown in those days",
        "A castle of 3 floors, elevators did not exist then",
        "A farmhouse, 2 floors, no electric lift existed",
        "A manor on 2 floors. There were no elevators at that time",
        "A manor on 2 floors, lifts had not been invented yet",
    ],
)
def test_lifts_that_were_not_there_are_not_built(text: str) -> None:
    wishes = [wish for wish in _receipt(text) if wish.kind == "elevator"]
    assert [(wish.value.unwanted, wish.status) for wish in wishes] == [(True, "met")]
    assert read_brief(text, default_knowledge()).unread == []


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("A flat with two bedrooms. No balcony please.", ["balcony_room"]),
        ("A flat with two bedrooms, without balcony", ["balcony_room"]),
        ("A hall with a kitchen. No veranda and no pergola.", ["balcony_room", "pergola"]),
        ("A warehouse of 900 m2. No mezzanine.", ["mezzanine"]),
    ],
)
def test_parts_that_are_not_wanted_are_told_as_such(text: str, names: list[str]) -> None:
    facts = read_brief(text, default_knowledge())
    assert [name for name, _ in facts.excluded] == names
    assert facts.unread == []


@pytest.mark.parametrize(
    "text", ["A house with no windows in the study", "A flat, no steps, two bedrooms, two storeys"]
)
def test_what_no_plan_can_be_checked_for_stays_unread(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert facts.excluded == []
    assert len(facts.unread) == 1


@pytest.mark.parametrize(
    "text",
    [
        "A clinic with a lab immediately next to the pharmacy",
        "A clinic with a lab right beside the pharmacy",
        "A clinic with a lab directly adjoining the pharmacy",
        "A clinic with a lab close by the pharmacy",
    ],
)
def test_adverbs_belong_to_their_relation(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert len(facts.adjacent) == 1
    assert facts.unread == []


def test_a_grand_room_is_no_style_of_the_building() -> None:
    facts = read_brief("A Victorian mansion with a grand hall and a grand staircase", default_knowledge())
    assert [style for style, _ in facts.styles] == ["victorian"]


@pytest.mark.parametrize(
    "text",
    [
        "A library with two floors. Don't need cafe.",
        "A library with two floors, cafe we don't need.",
        "A library with two floors. Cafe no need.",
        "A library with two floors. Dont need cafe.",
        "A library with two floors. Cafe need not.",
        "A library with two floors without need of cafe.",
        "A library with two floors. Please avoid cafe.",
        "A library with two floors. Is not necessary a cafe.",
        "A library with two floors. Not needed: sauna, cafe.",
        "A library with two floors. Cafe is not a must.",
        "A library with two floors. Cafe also is not needed.",
    ],
)
def test_what_is_not_needed_is_not_built(text: str) -> None:
    plan = plan_building(BuildRequest(description=text))
    assert all(room.room_type != "cafe" for floor in plan.program.floors for room in floor.rooms)
    wishes = {wish.value.type: wish.status for wish in _receipt(text) if wish.kind == "no_room"}
    assert wishes["cafe"] == "met"


def test_what_a_room_does_not_need_is_no_room_left_out() -> None:
    facts = read_brief("A house. The kitchen don't need a window.", default_knowledge())
    assert not facts.excluded
    assert [room.room_type for room in facts.rooms] == ["kitchen"]


@pytest.mark.parametrize(
    "text",
    [
        "A flat, no pets, two bedrooms",
        "A ferry terminal with a bar, no anchors on the walls.",
        "A bar. Escalator not required.",
    ],
)
def test_what_no_building_has_is_refused_without_a_word(text: str) -> None:
    assert read_brief(text, default_knowledge()).unread == []
