"""Storeys that are named by their place alone, by what repeats, and by the way they are counted."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


def places(brief: str) -> dict[str, str]:
    """Return for each room the kind of its storey, with the number of one that is numbered."""
    found = {}
    for fact in read(brief).rooms:
        numbers = [(ref.kind, ref.first) for ref in fact.floors]
        found[fact.name] = ",".join(str(first) if kind in ("number", "range") else kind for kind, first in numbers)
    return found


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("A home of 2 levels. Lower: kitchen. Upper: reading nook.", {"kitchen": "1", "reading_nook": "upper"}),
        (
            "A library of 3 storeys. The lowest has a foyer, the one above it a lounge, and the last one an archive.",
            {"foyer": "1", "lounge": "2", "archive": "top"},
        ),
        (
            "3 storeys. On the uppermost a gym. The one just under the top has a gallery. Lowest: ticket desk.",
            {"gym": "top", "gallery": "below_top", "ticket_desk": "1"},
        ),
        ("Lodging, 3 stories, ground one: mess hall. 2nd story: library.", {"mess_hall": "1", "library": "2"}),
        (
            "A penthouse of two levels: the study is on the lower level, while kitchen and bar take the upper one.",
            {"study": "1", "kitchen": "upper", "bar": "upper"},
        ),
        ("A house. Sleeping storey above has one bathroom.", {"bathroom": "2"}),
        (
            "A school of 3 storeys. Hall at street level. A gym at the very top. Between them a storey with a library.",
            {"hall": "1", "gym": "top", "library": "middle"},
        ),
        (
            "A school, 2 storeys. The storey you arrive on: canteen. The other one: gym.",
            {"canteen": "1", "gym": "upper"},
        ),
        ("Two floors. A gym on the ground floor. The gallery floor above has a lounge.", {"gym": "1", "lounge": "2"}),
        (
            "A boathouse of two storeys. Boat hall below with ten racks and an oar store. Above: lounge.",
            {"boat_hall": "1", "oar_store": "1", "lounge": "upper"},
        ),
        (
            "A school, 3 storeys. A gym takes the first storey together with the foyer; a lounge takes the second.",
            {"gym": "1", "foyer": "1", "lounge": "2"},
        ),
        ("Two floors. On the lower of the two floors: kitchen.", {"kitchen": "1"}),
        (
            "A house of three levels. Ground floor a shop. The two floors on top hold, first, a salon, then, at the "
            "very top, a study.",
            {"shop": "1", "salon": "2", "study": "top"},
        ),
        (
            "Seven storeys. Counting from the top: a lounge on the first, a gym on the next, a library on the one "
            "after that.",
            {"lounge": "top", "gym": "below_top", "library": "below_top"},
        ),
        (
            "Two floors. Visitors come in at the ground floor, where the foyer and the cafe are.",
            {"foyer": "1", "cafe": "1"},
        ),
    ],
)
def test_a_word_for_its_place_names_a_storey(brief: str, expected: dict[str, str]) -> None:
    found = places(brief)
    assert {name: found.get(name) for name in expected} == expected


@pytest.mark.parametrize(
    ("brief", "first", "last"),
    [
        ("3 storeys. 1st storey: foyer. 2nd storey: 12 offices. 3rd storey: the same again.", 2, 3),
        ("Hotel of 4 floors. Second floor: ten rooms. Third floor: ditto. Fourth floor: bar.", 2, 3),
        ("Hotel of 5 floors. Level 2: ten rooms. Levels 3 to 5: same as level 2.", 2, 5),
        ("Six storeys. From the second storey to the sixth the plan never changes: three offices.", 2, 6),
        ("Four floors. Floors 2, 3 and 4 are the same: three offices.", 2, 4),
    ],
)
def test_storeys_that_repeat_are_copies(brief: str, first: int, last: int) -> None:
    assert [(copy.first.first, copy.first.last) for copy in read(brief).copies] == [(first, last)]


@pytest.mark.parametrize(
    ("brief", "floors", "basements"),
    [
        ("A house of 4 levels if you count the basement", [3.0], [1.0]),
        ("A house, 3 floors including the cellar, 5 bedrooms", [2.0], [1.0]),
        ("A house with 3 floors and a basement", [3.0], [1.0]),
        ("A house of 2 storeys with three floor lamps in the living room", [2.0], []),
        ("A clinic of two floors with a laboratory one floor up", [2.0], []),
    ],
)
def test_a_number_of_storeys_counts_what_it_says(brief: str, floors: list[float], basements: list[float]) -> None:
    facts = read(brief)
    assert [quantity.value for quantity in facts.floors] == floors
    assert [quantity.value for quantity in facts.basements] == basements


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("Two storeys. Twelve classrooms in all, half of them on either storey.", [(6, True)]),
        (
            "A school of two storeys with ten offices, half on the ground floor and half on the first floor.",
            [(5, True)],
        ),
        (
            "Four levels with seven dorm rooms: two on level 2, two on level 3, and the remaining three on level 4.",
            [(2, False), (2, False), (3, False)],
        ),
    ],
)
def test_parts_of_a_number_go_to_their_storeys(brief: str, expected: list[tuple[int, bool]]) -> None:
    assert [(fact.count, fact.each) for fact in read(brief).rooms] == expected


def test_a_half_that_nothing_is_made_of_is_told() -> None:
    assert "half" in [span.words for span in read("Two floors: half of the offices are on the first floor.").unread]


def test_what_is_on_some_storeys_but_not_on_another_is_unwanted_there() -> None:
    facts = read("A cinema of 3 storeys. Toilets on storeys 1 and 2 but not on 3.")
    assert [(room, ref.first) for room, ref, _ in facts.excluded_on] == [("toilet", 3)]
