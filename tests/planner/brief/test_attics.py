"""Attics that are storeys, the main level of three, and ground floors that are all there is or that differ."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "storeys"),
    [
        ("Farmhouse, ground floor plus attic. The attic holds two bedrooms.", 2),
        ("Villa. Two floors and an attic. The attic becomes two bedrooms.", 3),
        ("Two full storeys and an attic storey. In the attic two bedrooms.", 3),
    ],
)
def test_an_attic_with_rooms_is_a_storey(text: str, storeys: int) -> None:
    facts = read_brief(text, default_knowledge())
    assert [quantity.value for quantity in facts.floors] == [storeys]
    assert [(fact.name, [ref.kind for ref in fact.floors]) for fact in facts.rooms] == [("bedroom", ["top"])]


@pytest.mark.parametrize(
    "text",
    ["All ground level: a shop.", "A shop. All level.", "A shop. Ground floor, 250 m2.", "A shop, all on that level."],
)
def test_one_storey_is_told(text: str) -> None:
    assert [quantity.value for quantity in read_brief(text, default_knowledge()).floors] == [1]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Chalet. Bottom level: a sauna. Main level: a library. Top level: bedrooms.", "middle"),
        ("Museum. Lowest: a shop. Middle: a hall. Upper: a library.", "top"),
        ("Flats, four storeys: a library on every floor. The ground floor has instead a bakery.", "upper"),
        ("Lab: the second storey has a cold room and the third a library.", "number"),
        ("Cellar with laundry, a library and a gym.", "basement"),
    ],
)
def test_rooms_are_placed(text: str, kind: str) -> None:
    room = next(fact for fact in read_brief(text, default_knowledge()).rooms if "library" in fact.name)
    assert [ref.kind for ref in room.floors] == [kind]


def test_either_storey_may_have_it() -> None:
    facts = read_brief("House on two storeys with a library, it can go on either storey.", default_knowledge())
    assert [fact.floors for fact in facts.rooms] == [()]


def test_a_flat_is_on_the_storey_before_its_rooms() -> None:
    text = "Bakery with the baker's flat, 2 floors. Downstairs a shop. Flat upstairs: two bedrooms, a bath."
    facts = read_brief(text, default_knowledge())
    flat = next(fact for fact in facts.rooms if fact.unit)
    assert [ref.kind for ref in flat.floors] == ["upper"]
    assert {room.room_type: room.count for room in flat.suite} == {"bedroom": 2, "bathroom": 1}
