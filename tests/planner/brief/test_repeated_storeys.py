"""Storeys that a brief tells once for several: typical floors, storeys set equal, those above or between others."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def rooms_of(brief: str, room: str) -> dict[int, int]:
    """Return how many rooms of that name the plan has on each storey that has one."""
    program = plan_building(BuildRequest(description=brief)).program
    counts = {f.index: sum(r.id.rstrip("_0123456789") == room for r in f.rooms) for f in program.floors}
    return {floor: count for floor, count in counts.items() if count}


def kinds_of(brief: str) -> dict[int, list[str]]:
    """Return the room types of each storey of the plan."""
    program = plan_building(BuildRequest(description=brief)).program
    return {floor.index: sorted(room.room_type for room in floor.rooms) for floor in program.floors}


@pytest.mark.parametrize(
    ("brief", "room", "expected"),
    [
        (
            "Office, basement + ground + 3 typ. floors. Ground: lobby. Typ. floor (x3, identical): four focus rooms.",
            "focus_room",
            {2: 4, 3: 4, 4: 4},
        ),
        ("Hostel, 4 fl. Fl. 1: reception. Fl. 2-4 typ.: six dormitories.", "dormitory", {2: 6, 3: 6, 4: 6}),
        ("Student residence, 3 st. St. 1: common lounge. St. 2-3 typical: ten bedrooms.", "bedroom", {2: 10, 3: 10}),
        ("Tower of 4 storeys. GF: lobby. Floors above (3 no., all alike): two flats.", "flat", {2: 2, 3: 2, 4: 2}),
        ("Clinic, 3 storeys. GF: lobby. Storeys above: five exam rooms.", "exam_room", {2: 5, 3: 5}),
        ("Housing. Ground floor: bike store. Typ. upper floor (x2): three flats.", "flat", {2: 3, 3: 3}),
        (
            "Flats, ground floor + 2 identical floors. Ground floor: a shop. Each identical floor: two flats.",
            "flat",
            {2: 2, 3: 2},
        ),
        ("Ward block. L0: reception. L1 = L2: eight patient rooms.", "patient_room", {2: 8, 3: 8}),
        ("Clinic. 1F: reception. 2F = 3F = 4F: five exam rooms.", "exam_room", {2: 5, 3: 5, 4: 5}),
        (
            "Hotel of five storeys. Lobby at ground level, a spa at the top. Between them three storeys with six "
            "guest rooms each.",
            "guest_room",
            {2: 6, 3: 6, 4: 6},
        ),
        (
            "Office. On the ground floor a cafe, at the top a bar. Between these lie two floors, each with a gym.",
            "gym",
            {2: 1, 3: 1},
        ),
        ("Three upper floors carry two studios each; the ground floor has a laundry.", "studio", {2: 2, 3: 2, 4: 2}),
        ("Hostel. Bar at ground level. The two upper floors get five dorm rooms each.", "dorm_room", {2: 5, 3: 5}),
        (
            "Hotel, five storeys. From the second up to the fourth storey there are nine rooms on each.",
            "room",
            {2: 9, 3: 9, 4: 9},
        ),
    ],
)
def test_what_is_told_once_stands_on_each_of_the_storeys(brief: str, room: str, expected: dict[int, int]) -> None:
    assert rooms_of(brief, room) == expected


@pytest.mark.parametrize(
    "brief",
    [
        "Office, 4 floors. Ground: lobby. Typ. floor (x3, identical): open office, pantry.",
        "Student residence, 4 st. St. 1: lounge. St. 2-4 typical: six bedrooms, two shower rooms.",
        "Ward block of four storeys. EG: reception. 1. OG = 2. OG = 3. OG: eight patient rooms.",
        "Tower of 4 storeys. GF: lobby. Floors above (3 no., all alike): two flats.",
        "A hotel with four floors. At the bottom: a lobby. Each of the three floors above has six guest rooms.",
        "Office tower, twelve storeys, ground floor with a reception, every upper floor has six offices.",
    ],
)
def test_storeys_that_are_told_alike_hold_the_same_rooms(brief: str) -> None:
    kinds = kinds_of(brief)
    assert all(kinds[floor] == kinds[2] for floor in kinds if floor > 1)


def test_a_storey_set_equal_to_another_repeats_it() -> None:
    kinds = kinds_of("Ward, three storeys. Level 1: day room. Level 2: ten patient rooms. Level 3 = Level 2.")
    assert kinds[3] == kinds[2] != kinds[1]


@pytest.mark.parametrize(
    "brief",
    [
        "Clinic, two storeys. 1F = lobby, 2F = 3 offices.",
        "House. Upper floor = bedrooms. Ground floor = kitchen.",
        "Office, three floors. The typical user sits at a desk. Ground floor: lobby.",
    ],
)
def test_what_a_storey_holds_makes_it_like_no_other(brief: str) -> None:
    assert read_brief(brief, default_knowledge()).copies == []


@pytest.mark.parametrize(
    ("brief", "floors"),
    [
        ("Ground floor: shop. The three upper floors have two flats each.", 4),
        ("Ground floor: shop. Above the ground floor: three floors of offices.", 4),
        ("Office. GF: lobby. Typ. floor (x3): open office.", 4),
        ("Office. GF: lobby. Typ. floor (x3): open office. Top floor: bar.", 5),
        ("Offices on the upper two floors, 5 floors in all.", 5),
        ("A day centre: ground floor and cellar, no floors above.", 1),
        ("A cabin with a ground floor and a cellar, nothing above.", 1),
        ("A school. Ground floor: hall. First floor: library. No floors above.", 2),
    ],
)
def test_storeys_are_counted_by_what_is_said_of_some(brief: str, floors: int) -> None:
    program = plan_building(BuildRequest(description=brief)).program
    assert max(floor.index for floor in program.floors) == floors


def test_a_number_of_storeys_told_twice_counts_once() -> None:
    text = "A G+2 eye hospital, that is three floors in all, with a ward."
    assert [quantity.value for quantity in read_brief(text, default_knowledge()).floors] == [3.0]
    assert plan_building(BuildRequest(description=text)).program.downgrades == []


def test_a_number_of_shower_rooms_holds_for_shower_areas() -> None:
    text = "A dormitory of two floors. On each floor six bedrooms and two shower rooms."
    program = plan_building(BuildRequest(description=text)).program
    kinds = [room.room_type for floor in program.floors for room in floor.rooms]
    assert kinds.count("bathroom") + kinds.count("shower_area") == 4
