"""What a bathroom is told to hold stands in it; what a wash room is for is told by the rooms beside it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "a bathroom with shower and toilet",
        "a bathroom with a shower and a toilet",
        "bathroom of 6 m2: shower, toilet",
        "a bathroom (shower, toilet)",
        "a bathroom that has a walk-in shower and a loo",
    ],
)
def test_fittings_of_a_bathroom_are_furniture(words: str) -> None:
    facts = read(f"A flat with {words}.")
    assert [room.name for room in facts.rooms] == ["bathroom"]
    assert [(thing.category, thing.room) for thing in facts.objects] == [
        ("shower_cabin", "bathroom"), ("toilet", "bathroom"),
    ]  # fmt: skip


def test_rooms_beside_a_bathroom_stay_rooms() -> None:
    facts = read("A house with a bathroom with a shower, a toilet and a kitchen. Upstairs: bathroom, toilet, bedroom.")
    assert [room.name for room in facts.rooms][:3] == ["bathroom", "toilet", "kitchen"]
    assert [thing.category for thing in facts.objects] == ["shower_cabin"]


def test_every_bathroom_of_several_has_them() -> None:
    facts = read("A bungalow with two bathrooms with bath and toilet and a guest toilet.")
    assert [(thing.category, thing.each) for thing in facts.objects] == [("bathtub", True), ("toilet", True)]
    assert [room.name for room in facts.rooms] == ["bathroom", "guest_toilet"]


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


@pytest.mark.parametrize("refused", ["a shower, no bath", "a shower but without a bath"])
def test_no_bath_in_a_bathroom_is_no_tub(refused: str) -> None:
    facts = read_brief(f"A flat with a bathroom with {refused}.", default_knowledge())
    assert [(fact.category, fact.excluded) for fact in facts.objects][-1] == ("bathtub", True)
    assert facts.excluded == []
