"""What the writer of a brief makes tells what the building is for, and storeys are used as their rooms are headed."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("brief", "kind", "goods"),
    [
        ("I make fitted kitchens for a living and need a showroom and a timber store.", "factory", "kitchen"),
        ("We repair and sell bicycles. Downstairs a sales floor, upstairs two bedrooms.", "shop_building", "bicycle"),
        ("We build saunas and need an assembly room of 90 m2 and an office.", "factory", "sauna"),
        ("For a couple who sell old books: a sales floor and a bedroom.", "shop_building", "book"),
    ],
)
def test_a_trade_tells_the_kind_of_building(brief: str, kind: str, goods: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [name for name, _ in facts.trades] == [kind]
    assert goods not in {fact.room_type for fact in facts.rooms} | {fact.category for fact in facts.objects}
    assert plan_building(BuildRequest(description=brief)).program.building_type == kind


@pytest.mark.parametrize(
    "brief",
    [
        "We make two kitchens and a dining room on the ground floor of a house.",
        "I want to build kitchens and a bathroom for a house.",
        "We sell our villa and want a bungalow with two bedrooms.",
        "A house that we build with two kitchens and a workshop.",
    ],
)
def test_what_is_to_be_built_is_no_trade(brief: str) -> None:
    assert not read_brief(brief, default_knowledge()).trades


def test_a_named_building_keeps_its_kind_whatever_the_trade() -> None:
    brief = "We renovate bathrooms and make cabinets; we need a warehouse with an office."
    facts = read_brief(brief, default_knowledge())
    assert facts.building[0][0] == "warehouse_building"
    assert {fact.room_type for fact in facts.rooms} == {"private_office"}
    assert "for a living" not in {span.words for span in facts.unread}


def test_for_a_living_is_no_living_room() -> None:
    facts = read_brief("I stream for a living and need a house with a streaming room.", default_knowledge())
    assert {fact.name for fact in facts.rooms} == {"streaming_room"}


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


def test_stores_in_a_basement_and_a_walk_up_are_no_use() -> None:
    museum = read_brief("A museum with a lecture room and stores in the basement", default_knowledge())
    flat = read_brief("City flat, second-floor walk-up: one bedroom, bathroom", default_knowledge())
    assert (museum.uses, flat.uses) == ([], [])
    assert [fact.room_type for fact in museum.rooms] == ["lecture_hall", "storage"]
    assert [fact.room_type for fact in flat.rooms] == ["bedroom", "bathroom"]
