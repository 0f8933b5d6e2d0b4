"""How a brief numbers its storeys, and which of them is above which."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


def storeys(brief: str) -> dict[str, int | str]:
    """Return for each room the number or the kind of its storey."""
    refs = {fact.name: fact.floors[0] for fact in read(brief).rooms if fact.floors}
    return {name: ref.first if ref.kind in ("number", "range") else ref.kind for name, ref in refs.items()}


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("A house. The ground floor has a kitchen, floor one has three bedrooms.", {"kitchen": 1, "bedroom": 2}),
        (
            "A three-storey school: ground floor with a gym, floor 1 with a lab and floor 2 with a library.",
            {"gym": 1, "lab": 2, "library": 3},
        ),
        (
            "A hotel of three floors. The ground floor has a bar. The first and second floors have a lounge each.",
            {"bar": 1, "lounge": 2},
        ),
        (
            "A hotel of two floors. The ground floor has a bar. The first and second floors have a lounge each.",
            {"bar": 1, "lounge": 1},
        ),
        (
            "A ferry terminal, three floors. At quay level a check-in hall. Above that a departure lounge.",
            {"check_in_hall": 1, "departure_lounge": 2},
        ),
        ("A house of five floors. A dentist and a law office share the second floor.", {"dentist": 2, "law_office": 2}),
        ("An office. The ground floor (level 1) has a cafe, level 2 has a library.", {"cafe": 1, "library": 2}),
        ("A two-storey office. Floor 1: cafe on the ground floor. Floor 2: library.", {"cafe": 1, "library": 2}),
        (
            "Ground storey: dining room. 1st storey above it: two bathrooms; 2nd storey: studio.",
            {"dining_room": 1, "bathroom": 2, "studio": 3},
        ),
        (
            "A school of four floors. On ground floor is gym. First and second floor are same: six classrooms on each. "
            "On third floor a library.",
            {"gym": 1, "classroom": 2, "library": 4},
        ),
        (
            "A clinic with 4 levels. Ground floor: pharmacy. The 1st and the 2nd floor have a lab. 3rd floor: archive.",
            {"pharmacy": 1, "lab": 2, "archive": 4},
        ),
        (
            "An office, three floors. The ground floor has a cafe. First, second and third floors have a lab.",
            {"cafe": 1, "lab": 1},
        ),
    ],
)
def test_numbers_count_from_the_ground_floor_or_above_it(brief: str, expected: dict[str, int | str]) -> None:
    assert storeys(brief) == expected


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("A museum of 3 levels. The shop and the depot are underground.", {"shop": "basement", "depot": "basement"}),
        ("A school, 4 storeys. Canteen on 2. A gym on the ground floor.", {"canteen": 2, "gym": 1}),
        ("An inn, 3 storeys: a kitchen on the bottom one; three bedrooms on the next.", {"kitchen": 1, "bedroom": 2}),
        ("A block of three storeys. Parter: bakery. A lounge on the top floor.", {"bakery": 1, "lounge": "top"}),
        ("A house, 2 storeys. On the ground are a kitchen. Upstairs a library.", {"kitchen": 1, "library": "upper"}),
    ],
)
def test_a_storey_is_known_by_few_words(brief: str, expected: dict[str, int | str]) -> None:
    assert storeys(brief) == expected


@pytest.mark.parametrize(
    "brief",
    [
        "An office of three floors. Second floor and third floor are same, each have two labs.",
        "An office of three floors. On the second floor and the third floor there are two labs.",
        "An office of three floors with two labs on the second floor and the third floor.",
    ],
)
def test_two_storeys_joined_by_and_are_told_of_together(brief: str) -> None:
    (lab,) = read(brief).rooms
    assert [ref.first for ref in lab.floors] == [2, 3]
    assert lab.each


def test_a_storey_after_and_may_open_what_is_told_of_it() -> None:
    brief = "An office of three floors with a lab on the second floor and the third floor has a library."
    assert storeys(brief) == {"lab": 2, "library": 3}


def test_storeys_above_another_are_counted_with_it() -> None:
    facts = read("A hotel with a lobby floor and three guest floors above it, eight rooms on each guest floor.")
    assert [quantity.value for quantity in facts.floors] == [4]
    assert [ref.kind for ref in facts.rooms[0].floors] == ["upper"]


def test_rooms_on_some_floors_above_lie_on_either() -> None:
    facts = read("A hotel with a lobby on the ground floor and twelve rooms on two floors above.")
    assert [quantity.value for quantity in facts.floors] == [3]
    assert [(room.count, room.each) for room in facts.rooms if room.name == "room"] == [(12, False)]


def test_a_number_on_its_own_is_no_storey_without_storeys() -> None:
    assert storeys("A flat. A study with two desks, one lamp on 2.") == {}


def test_storeys_by_their_number_alone_count_from_the_one_above_the_ground() -> None:
    brief = (
        "Office, three storeys: on the ground floor a cafe; on the first 24 desks in an open office and four phone"
        " booths; on the second two meeting rooms."
    )
    program = plan_building(BuildRequest(description=brief)).program
    places = {wish.value.name: wish.scope.floors for wish in program.wishes if wish.kind == "room"}
    assert places == {"cafe": [1], "open_office": [2], "phone_booth": [2], "meeting_room": [3]}
