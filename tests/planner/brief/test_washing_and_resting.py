"""What wash rooms and rest rooms are for is told by what else the brief names."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


def types(brief: str) -> dict[str, str]:
    return {fact.name: fact.room_type for fact in read_brief(brief, default_knowledge()).rooms}


@pytest.mark.parametrize(
    "rooms",
    [
        "wash room, bath room and toilet",
        "a toilet, a bath and a washroom",
        "a bathroom, a separate WC and a wash room with a basin",
    ],
)
def test_a_wash_room_beside_bath_and_toilet_is_neither(rooms: str) -> None:
    found = types(f"A house with {rooms}.")
    assert sorted(found.values()) == ["bathroom", "laundry_room", "toilet"]


@pytest.mark.parametrize("rooms", ["a washroom", "two washrooms and a toilet", "a washroom and a bathroom"])
def test_other_wash_rooms_are_bathrooms(rooms: str) -> None:
    assert types(f"A house with {rooms}.")["washroom"] == "bathroom"


@pytest.mark.parametrize("things", ["six beds", "two sofas", "four recliners"])
def test_a_rest_room_to_lie_down_in_is_no_lavatory(things: str) -> None:
    assert types(f"A day centre with a rest room with {things} and a kitchen.")["rest_room"] == "nap_room"


@pytest.mark.parametrize("things", ["two basins", "three stalls"])
def test_other_rest_rooms_are_lavatories(things: str) -> None:
    assert types(f"A day centre with a rest room with {things} and a kitchen.")["rest_room"] == "restroom"
