"""A use whose rooms are listed is that of its storey; rooms of a dwelling are the dwelling's."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "use", "storey"),
    [
        ("A house. He has the practice on the ground floor: waiting room, two consulting rooms, WC", "clinic", 1),
        ("Three floors; on the second floor a doctor's practice with a waiting room and a laboratory", "clinic", 2),
        ("A hotel. Second floor: a dentist's surgery with reception, two treatment rooms and a store", "clinic", 2),
        ("A house; she runs the office downstairs: reception, two offices, archive", "office", 1),
        ("Ground floor is her bakery: shop, bakehouse, store. Above is a flat", "bakery_building", 1),
        ("A school on two floors. Ground floor: kindergarten: two group rooms, cloakroom", "kindergarten", 1),
    ],
)
def test_a_use_with_a_list_of_rooms_is_its_storeys(text: str, use: str, storey: int) -> None:
    facts = _facts(text)
    assert [(fact.building_type, fact.floors[0].first) for fact in facts.uses] == [(use, storey)]


@pytest.mark.parametrize(
    "text",
    [
        "A house with an office with two desks on the ground floor",
        "A manor: second floor: library (a hidden study next to it), two bedrooms",
        "A hotel with a restaurant on the ground floor and a bar",
        "A clinic on one floor: reception, four consulting rooms",
    ],
)
def test_a_room_with_its_own_things_is_no_use(text: str) -> None:
    assert _facts(text).uses == []


@pytest.mark.parametrize(
    "text",
    [
        "Two storeys. Ground floor: shop. First floor is the flat: two bedrooms, bathroom, kitchen",
        "Two storeys. Ground floor: shop. Upstairs: apartment with two bedrooms and bathroom",
        "A house; an office downstairs. Upstairs home: kitchen, two bedrooms, bath",
    ],
)
def test_a_dwelling_holds_the_rooms_that_it_heads(text: str) -> None:
    (dwelling,) = (room for room in _facts(text).rooms if room.unit)
    assert ("bedroom", 2) in [(room.room_type, room.count) for room in dwelling.suite]


def test_what_a_storey_holds_first_is_not_the_building() -> None:
    assert _facts("Basement: car park. Ground floor: shop, lobby").building_name == ""
