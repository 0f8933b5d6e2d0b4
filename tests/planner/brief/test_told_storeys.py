"""What stands on which storey, told by the way: asides, "where" clauses, places between, low and high floors."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def storeys_of(brief: str, room: str) -> dict[int, int]:
    """Return how many rooms of that name the plan has on each storey that has one."""
    program = plan_building(BuildRequest(description=brief)).program
    counts = {f.index: sum(r.id.rstrip("_0123456789") == room for r in f.rooms) for f in program.floors}
    return {floor: count for floor, count in counts.items() if count}


@pytest.mark.parametrize(
    ("brief", "room", "expected"),
    [
        (
            "Office of four storeys. Ground floor: reception. In between come two floors laid out identically, with "
            "a print room on each. Top floor: boardroom.",
            "print_room",
            {2: 1, 3: 1},
        ),
        (
            "A school with a library on the ground floor and a studio on the top floor. In between are three storeys "
            "with two classrooms each.",
            "classroom",
            {2: 2, 3: 2, 4: 2},
        ),
        ("Offices, 4 storeys. 1: lobby. 2-3 (typical): two meeting rooms. 4: a gym.", "meeting_room", {2: 2, 3: 2}),
        ("Block of 5 storeys. 1: shop. 2-4 (identical): one open office. 5: bar.", "open_office", {2: 1, 3: 1, 4: 1}),
        ("House, two storeys. Ground floor: kitchen. Quiet rooms topmost: two bedrooms.", "bedroom", {2: 2}),
        ("Museum, three storeys. Service rooms lowermost: a workshop. Second floor: a gallery.", "workshop", {1: 1}),
        ("Hotel of three floors. In the low floor there is a luggage room.", "luggage_room", {1: 1}),
        (
            "Hotel of three floors. In the low floor is the bar. The two high floors are equal, with four guest rooms "
            "each one.",
            "guest_room",
            {2: 4, 3: 4},
        ),
        ("Law firm, three storeys. The archive, being heavy, belongs in a basement.", "archive", {0: 1}),
        ("Club of three storeys. The bar, which is noisy, goes on the ground floor.", "bar", {1: 1}),
        (
            "House of three storeys with a basement. The basement has the laundry, the kitchen is on the ground "
            "floor, the living room (with a fireplace) takes the floor above.",
            "living_room",
            {2: 1},
        ),
        (
            "Museum, two storeys. Ground floor: a foyer. The paintings gallery is shown upstairs, where the lab is.",
            "lab",
            {2: 1},
        ),
        ("Shop. A sales area. Also a staff room, at same floor. On the second floor an office.", "staff_room", {1: 1}),
        (
            "Hotel, three storeys. On the third floor is a gym. Also a sauna and a bar, on the same floor.",
            "sauna",
            {3: 1},
        ),
        (
            "House of two levels. On the lowest level, and that is the ground because cellar we don't make, is a "
            "garage.",
            "garage",
            {1: 1},
        ),
    ],
)
def test_a_room_stands_on_the_storey_told(brief: str, room: str, expected: dict[int, int]) -> None:
    assert storeys_of(brief, room) == expected


@pytest.mark.parametrize(
    ("brief", "floors"),
    [
        ("Flat with a low floor to ceiling window in the bedroom.", 0),
        ("An office with a high floor load in the archive.", 0),
        ("A hall with the high floor loads of a press.", 0),
    ],
)
def test_low_and_high_floors_of_something_else_are_no_storeys(brief: str, floors: int) -> None:
    facts = read_brief(brief, default_knowledge())
    assert not any(room.floors for room in facts.rooms)
    assert len(facts.floors) == floors


@pytest.mark.parametrize(
    "brief",
    [
        "House, two storeys. All bedrooms on the same floor.",
        "House, two storeys. Also a kitchen on the same floor as the dining room.",
        "House, two storeys, a kitchen and a larder on the same floor.",
    ],
)
def test_the_same_floor_as_one_another_names_no_storey(brief: str) -> None:
    assert not any(room.floors for room in read_brief(brief, default_knowledge()).rooms)


def test_a_cellar_that_is_wanted_stays() -> None:
    facts = read_brief("House with a cellar. In the cellar we make wine.", default_knowledge())
    assert not facts.excluded


@pytest.mark.parametrize(
    "brief",
    ["A school; please shape it like an L.", "A school. Shape it as a U around the yard.", "Form it like a T, please."],
)
def test_a_building_may_be_shaped_like_a_letter(brief: str) -> None:
    assert len(read_brief(brief, default_knowledge()).shapes) == 1


def test_a_room_shaped_like_a_letter_tells_no_outline() -> None:
    assert not read_brief("A house; shape the kitchen like an L.", default_knowledge()).shapes


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("Two flats, one above the other and alike to the last cupboard. Each flat has two bedrooms.", {1: 1, 2: 1}),
        (
            "Three apartments, one on top of the other. Each apartment has a kitchen on its own floor.",
            {1: 1, 2: 1, 3: 1},
        ),
        ("A house with two flats one over the other, each with two bedrooms.", {1: 1, 2: 1}),
    ],
)
def test_flats_one_above_the_other_are_storeys_with_one_each(brief: str, expected: dict[int, int]) -> None:
    assert storeys_of(brief, "apartment" if "apartments" in brief else "flat") == expected


def test_stacked_flats_that_are_alike_make_equal_storeys() -> None:
    assert read_brief("Two flats, one above the other and alike. Each has a bath.", default_knowledge()).copies
    assert not read_brief("Two flats, one above the other. Each has a bath.", default_knowledge()).copies


@pytest.mark.parametrize(
    ("brief", "floors"),
    [
        ("Two flats, one beside the other.", []),
        ("House of three storeys with two flats, one above the other.", [3.0]),
        ("A ground-floor shop and two flats, one above the other.", []),
        ("Two ovens, one above the other, in the kitchen of a flat.", []),
    ],
)
def test_flats_elsewhere_or_other_things_one_above_the_other_are_no_storeys(brief: str, floors: list[float]) -> None:
    assert [quantity.value for quantity in read_brief(brief, default_knowledge()).floors] == floors


def test_a_room_in_a_basement_that_a_clause_tells_more_of_lies_there() -> None:
    brief = "House of two storeys. Ground floor: kitchen. The laundry is in the basement, where the boiler stands."
    assert storeys_of(brief, "laundry") == {0: 1}


def test_lists_that_end_downstairs_and_upstairs_lie_there_as_a_whole() -> None:
    brief = "A house with a kitchen, a study and a WC downstairs, three bedrooms, a playroom and a bathroom upstairs."
    assert [storeys_of(brief, name) for name in ("kitchen", "study", "wc")] == [{1: 1}] * 3
    assert [storeys_of(brief, name) for name in ("bedroom", "playroom", "bathroom")] == [{2: 3}, {2: 1}, {2: 1}]


def test_what_belongs_to_an_entry_of_a_list_is_not_on_each_storey_of_the_next() -> None:
    brief = "A school of two storeys with a library, a canteen with a kitchen, and toilets on each floor."
    rooms = {room.name: room for room in read_brief(brief, default_knowledge()).rooms}
    assert not rooms["kitchen"].floors
    assert rooms["toilet"].each


def test_what_a_list_names_before_it_goes_on_upstairs_lies_below() -> None:
    brief = "A villa with a living room, a study, a guest bedroom, and upstairs three bedrooms and a bathroom."
    assert [storeys_of(brief, name) for name in ("study", "guest_bedroom")] == [{1: 1}] * 2
    assert storeys_of(brief, "bedroom") == {2: 3}


def test_a_room_for_people_lies_on_the_storey_that_stands_behind_them() -> None:
    brief = "A fire station with a garage for two trucks and sleeping quarters for eight firefighters upstairs."
    rooms = {room.name: room for room in read_brief(brief, default_knowledge()).rooms}
    assert [ref.kind for ref in rooms["sleeping_quarter"].floors] == ["upper"]
    assert not rooms["garage"].floors
