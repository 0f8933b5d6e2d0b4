"""What a storey holds and no more is told of that storey; a number of lifts says nothing of stairs."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("text", "storey"),
    [
        ("Guest house on three floors: a lounge on the ground floor, nothing but five bedrooms on the second floor", 2),
        ("A hotel with 4 floors. On the third floor only six suites and nothing else", 3),
        ("A two-storey office. Upstairs there is only one open-plan office. Downstairs reception", 2),
        ("The first floor contains exclusively bedrooms, four of them; the ground floor a kitchen", 2),
        ("A house with two floors, on the second floor we want bedrooms only", 2),
        ("An office on three floors. The third floor has nothing but a boardroom", 3),
    ],
)
def test_a_storey_gets_no_room_but_those_named(text: str, storey: int) -> None:
    program = plan_building(BuildRequest(description=text)).program
    (wish,) = (wish for wish in program.wishes if wish.kind == "only")
    assert wish.scope.floors == [storey]
    asked = {wish.value.type for wish in program.wishes if wish.kind == "room"}
    floor = next(floor for floor in program.floors if floor.index == storey)
    ways = {"corridor", "hallway", "stair", "elevator"}
    added = {room.room_type for room in floor.rooms} - asked - ways
    assert added <= {"bathroom"}  # of a suite


def test_other_storeys_are_filled_as_ever() -> None:
    floors = plan_building(
        BuildRequest(description="A hotel with 4 floors. On the third floor only six suites")
    ).program.floors
    assert len(floors[1].rooms) > 5


@pytest.mark.parametrize(
    "text",
    [
        "A house with two bedrooms and a library, nothing else",
        "An apartment house, four floors, two flats each. Nothing else except a bin room on the ground floor",
    ],
)
def test_nothing_else_without_a_storey_is_of_the_whole_building(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert len(facts.only) == 1
    assert facts.only_on == []


@pytest.mark.parametrize(
    "text",
    [
        "A mansion. Second floor: three bedrooms, a study, only one bathroom",
        "A school on two floors, only the ground floor has toilets",
        "A hotel with only one lift and three floors",
    ],
)
def test_only_may_say_something_else(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert facts.only == facts.only_on == []


def test_only_one_lift_leaves_the_stairs() -> None:
    facts = read_brief("A hotel with only one lift and three floors", default_knowledge())
    assert [kind for kind, _ in facts.vertical] == ["elevator"]
    assert "no_elevator" in [kind for kind, _ in read_brief("Two floors, only a stair", default_knowledge()).vertical]


def test_a_private_storey_is_told() -> None:
    facts = read_brief("A guest house on three floors; the third floor is private", default_knowledge())
    assert [span.words for span in facts.unread] == ["private"]
