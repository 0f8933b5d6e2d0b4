"""Areas and things that a brief says of some or each of several rooms, and areas that are nobody's."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


def sizes(brief: str) -> list[tuple[str, int | None, float | None]]:
    return [(fact.name, fact.count, fact.area) for fact in read(brief).rooms]


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        (
            "Two function rooms on the upper floor, one of 50 m2 and the other 35 m2.",
            [("function_room", 1, 50.0), ("function_room", 1, 35.0)],
        ),
        (
            "An office with one meeting room of 30 m2 and two of 15 m2 each.",
            [("meeting_room", 1, 30.0), ("meeting_room", 2, 15.0)],
        ),
        (
            "An office with one meeting room of 30 and two of 15 each; lobby 20 m2.",
            [("meeting_room", 1, 30.0), ("meeting_room", 2, 15.0), ("lobby", 1, 20.0)],
        ),
        (
            "An office with two conference rooms (a big one with 40 qm and a small one with 20 qm).",
            [("conference_room", 1, 40.0), ("conference_room", 1, 20.0)],
        ),
        ("An office with two labs, one big with 40 m2 and one small with 20 m2.", [("lab", 1, 40.0), ("lab", 1, 20.0)]),
        ("A school with four labs: one of 80 m2, three of 50 m2.", [("lab", 1, 80.0), ("lab", 3, 50.0)]),
        ("Around it sit six private offices at 12 m2 apiece.", [("private_office", 6, 12.0)]),
        ("A school with Lab A and Lab B, each 40 m2.", [("lab_a", 1, 40.0), ("lab_b", 1, 40.0)]),
        ("A flat with a kitchen and a living room, 20 m2 each.", [("kitchen", 1, 20.0), ("living_room", 1, 20.0)]),
        ("A monastery with fourteen cells, all alike at 10 m2.", [("cell", 14, 10.0)]),
        (
            "Two floors, fifteen bedrooms on the ground floor and fifteen on the first floor. A bedroom is 22 m2.",
            [("bedroom", 15, 22.0), ("bedroom", 15, 22.0)],
        ),
    ],
)
def test_areas_go_to_the_rooms_that_they_are_said_of(brief: str, expected: list[tuple[str, int, float]]) -> None:
    assert sizes(brief) == expected
    assert read(brief).area == []


@pytest.mark.parametrize(
    "brief",
    [
        "A school with a gym. Xyzzy Two (90 m2) is upstairs.",
        "A school with a gym. Of the others, each 90 m2, two are upstairs.",
        "A school with a gym. They need 90 m2 each.",
    ],
)
def test_an_area_of_what_nobody_knows_is_not_the_buildings(brief: str) -> None:
    facts = read(brief)
    assert facts.area == facts.floor_area == []
    assert any("90" in span.words for span in facts.unread)


@pytest.mark.parametrize(
    "brief",
    [
        "A school. Total should come to about 600 m2.",
        "A school with four halls, gross floor area in the region of 600 m2.",
        "A school with 8 classrooms. We have 600 m2.",
        "A school of two floors with a gym, alltogether 600 m2.",
    ],
)
def test_the_area_of_the_building_may_be_said_late(brief: str) -> None:
    assert [quantity.value for quantity in read(brief).area] == [600.0]


def test_what_a_room_of_several_has_all_of_them_have() -> None:
    facts = read(
        "Two floors, five bedrooms on the ground floor and six on the first floor. A bedroom comes with its own wet "
        "room, a bed and a recliner."
    )
    assert [[inner.name for inner in room.suite] for room in facts.rooms] == [["wet_room"], ["wet_room"]]
    assert [(thing.category, thing.room, thing.each) for thing in facts.objects] == [
        ("bed", "bedroom", True),
        ("recliner", "bedroom", True),
    ]


def test_furniture_that_stands_at_furniture_does_not_multiply_rooms() -> None:
    facts = read("A dining room with 18 tables, each with four chairs, a bar and a kitchen with a scullery.")
    assert [room.count for room in facts.rooms] == [1, 1, 1, 1]
    assert [thing.count for thing in facts.objects] == [18, 72]


def test_lockers_with_a_number_are_furniture() -> None:
    facts = read("A hostel. Every dorm room gets four bunk beds and eight lockers. Men's and women's lockers.")
    assert [(thing.category, thing.count) for thing in facts.objects] == [("bunk_bed", 4), ("locker", 8)]


def test_what_one_of_several_rooms_has_is_not_for_each() -> None:
    facts = read("A music school with five practice rooms of 10 m2 each, one of them with a grand piano.")
    assert [(thing.category, thing.count, thing.each) for thing in facts.objects] == [("grand_piano", 1, False)]
    assert facts.unread == []


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("A hotel of 5 floors with 48 rooms, twelve rooms on each of floors 2 to 5.", [("room", 12)]),
        (
            "A radio station with two studios (Studio Red and Studio Blue, 20 m2 each).",
            [("studio_red", 1), ("studio_blue", 1)],
        ),
        ("A lab building of 4 storeys. Wet labs on the odd storeys (three each).", [("wet_lab", 3)]),
        (
            "Office, G + 5. Ground: lobby. 1st to 4th: three meeting rooms each. 5th: gym.",
            [("lobby", 1), ("meeting_room", 3), ("gym", 1)],
        ),
        ("A court with two courtrooms, of 120 m2 and 80 m2, on level 2.", [("courtroom", 1), ("courtroom", 1)]),
        (
            "A hospice. A nurse station between the resident rooms and the lounge.",
            [("nurse_station", 1), ("resident_room", None), ("lounge", 1)],
        ),
    ],
)
def test_no_room_is_counted_twice(brief: str, expected: list[tuple[str, int | None]]) -> None:
    assert [(room.name, room.count) for room in read(brief).rooms] == expected
