"""Storeys that are called by what they are for lie where the brief says they do."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("text", "floors"),
    [
        (
            "A factory with an office storey above the production level. Production level: loading bay and tool store. "
            "Office storey: meeting room and canteen.",
            {"loading_bay": [1], "tool_store": [1], "meeting_room": [2], "canteen": [2]},
        ),
        (
            "A house with the sleeping level below the living level. The living level has a kitchen; on the sleeping "
            "level there are three bedrooms.",
            {"kitchen": [2], "bedroom": [1]},
        ),
        (
            "A bus terminal with an office floor above. Down: a waiting hall. Up: a canteen and a control room.",
            {"waiting_hall": [1], "canteen": [2], "control_room": [2]},
        ),
    ],
)
def test_rooms_are_on_the_storey_of_their_use(text: str, floors: dict[str, list[int]]) -> None:
    program = plan_building(BuildRequest(description=text)).program
    told = {wish.value.name: wish.scope.floors for wish in program.wishes if wish.kind == "room" and wish.scope}
    assert len(program.floors) == 2
    assert told == floors


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("A gym with a dance floor above the pool", {"indoor_pool"}),
        ("A shop with an office floor above", {"open_office"}),
        ("An office of three floors. The first floor above the ground floor has a library", {"library"}),
    ],
)
def test_other_words_before_floor_stay_what_they_are(text: str, rooms: set[str]) -> None:
    assert rooms <= {fact.room_type for fact in read_brief(text, default_knowledge()).rooms}
