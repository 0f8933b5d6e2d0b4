"""What is said of some of several rooms is of those: accessible toilets, furniture in two of six classrooms."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "others", "accessible"),
    [
        ("A hall with toilets, one of them accessible, and a kitchen", None, 1),
        ("An office with three toilets, one of which is wheelchair accessible", 2, 1),
        ("A restaurant with four toilets, one for disabled guests", 3, 1),
        ("A clinic with two toilets (one accessible)", 1, 1),
        ("A museum with toilets, one of which must be barrier-free", None, 1),
        ("A station with WCs, of which one is wheelchair accessible, and a kiosk", None, 1),
        ("An office with 4 WCs (2 of them accessible) and a kitchen", 2, 2),
        ("A clinic with toilets, including one for disabled people", None, 1),
        ("A hall with WCs incl. one accessible.", None, 1),
    ],
)
def test_accessible_toilets_are_rooms_beside_the_others(text: str, others: int | None, accessible: int) -> None:
    facts = _facts(text)
    counts = {room.room_type: room.count for room in facts.rooms if "toilet" in room.room_type}
    assert counts == {"toilet": others, "accessible_toilet": accessible}
    assert facts.unread == []


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A hotel with 12 rooms, two of them accessible", "two of them accessible"),
        ("A house with three bathrooms, two of them small, and a garage", "two of them small"),
        ("A gym with showers, one of them for wheelchair users", "one of them for wheelchair users"),
    ],
)
def test_what_nothing_is_made_of_is_told_in_one_piece(text: str, words: str) -> None:
    facts = _facts(text)
    assert [span.words for span in facts.unread] == [words]
    assert len(facts.rooms) >= 1


def test_a_number_of_all_of_them_is_still_their_count() -> None:
    facts = _facts("A house with toilets, three of them, and a kitchen")
    assert [room.count for room in facts.rooms if room.room_type == "toilet"] == [3]


def test_furniture_of_some_rooms_is_in_as_many() -> None:
    program = plan_building(BuildRequest(description="A school with 6 classrooms, two of them with a piano")).program
    wish = next(wish for wish in program.wishes if wish.kind == "object")
    assert (wish.value.count, wish.scope.each) == (2, False)
    pianos = [
        wanted.count for floor in program.floors for room in floor.rooms for wanted in room.objects
        if wanted.category == "piano"
    ]  # fmt: skip
    assert pianos == [1, 1]
