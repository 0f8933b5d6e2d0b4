"""Statements that a brief makes, as its receipt words them: what is read, on which storey, in which room."""

import pytest

from mansion_bringup.building.wish_words import read_as
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def statements(brief: str) -> list[str]:
    """Return the wishes of a plan in words; of what was not understood, its text in brackets."""
    wishes = plan_building(BuildRequest(description=brief)).program.wishes
    return [read_as(wish) or f"[{wish.text}]" for wish in wishes]


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        (
            "A house of two storeys; an elevator is forbidden, a sauna is prohibited.",
            ["building: house", "2 storeys", "no lift", "no sauna"],
        ),
        (
            "A hostel with a lift. Stairs are mandatory, an elevator is present.",
            ["building: hostel", "lift", "stair", "lift"],
        ),
        (
            "A school with six classrooms. Every classroom has not fewer than ten desks.",
            ["building: school", "6 classrooms", "10 desks, in each classroom"],
        ),
        (
            "A law firm with a pantry and six partner offices. Partner offices: one desk and one bookcase each.",
            [
                "building: law firm",
                "1 pantry",
                "6 partner offices",
                "1 desk, no others, in each partner office",
                "1 bookcase, no others, in each partner office",
            ],
        ),
        (
            "An office with two meeting rooms with a sofa each, a nap room, and a kitchen.",
            ["building: office", "2 meeting rooms", "1 sofa, in each meeting room", "1 nap room", "1 kitchen"],
        ),
        ("We start a chess club. A house with a library.", ["[chess club]", "building: house", "1 library"]),
        (
            "A kindergarten for the study of children with four group rooms; to each group room belongs an own toilet.",
            ["building: kindergarten", "4 group rooms", "4 toilets, in group room"],
        ),
        (
            "A house with a kitchen and a bedroom below: their bedroom has a desk. Upstairs: three bedrooms.",
            ["building: house", "1 kitchen", "1 bedroom, ground floor", "1 desk, in bedroom", "3 bedrooms, floor 2"],
        ),
        (
            "A library with a children's corner room and a study room far from the children's room.",
            ["building: library", "1 child corner room", "1 study room", "study room away from child corner room"],
        ),
        (
            "A hotel. A spa in the basement with two saunas.",
            ["building: hotel", "1 spa, basement 1", "2 saunas, basement 1"],
        ),
        (
            "A surgery. 2 x exam room (16 m2 ea), 1 x-ray room, a waiting area near the exam rooms, not near the lab.",
            [
                "building: surgery",
                "2 exam rooms of 16 m2",
                "1 xray room",
                "1 waiting area",
                "waiting area next to exam room",
                "waiting area away from lab",
                "1 lab",
            ],
        ),
        ("A bungalow with a kitchen. I hate carpets.", ["building: bungalow", "1 kitchen", "no carpets"]),
        (
            "A clinic with a 10-person conference room.",
            ["building: clinic", "10 seats, in each conference room", "1 conference room"],
        ),
        (
            "A house with Lily's room, Oskar's room and our bedroom. Each child has a desk.",
            [
                "building: house",
                "1 lily room",
                "1 oskar room",
                "1 bedroom",
                "1 desk, in lily room",
                "1 desk, in oskar room",
            ],
        ),
        (
            "A house with three bedrooms. The main bedroom is 18 m2 and has its own bathroom.",
            ["building: house", "2 bedrooms", "1 main bedroom of 18 m2", "1 bathroom, in main bedroom"],
        ),
        (
            "A startup office. One open room with 20 desks.",
            ["building: startup office", "1 room", "20 desks, no others, in room"],
        ),
        (
            "A veterinary clinic with staff quarters under the roof.",
            ["building: veterinary clinic", "staff quarters, floor 2"],
        ),
        ("A house with a skylight in the studio.", ["building: house", "[skylight]"]),
        ("An apartment where a robot can vacuum.", ["building: apartment"]),
        ("An office with 6 rows of 10 desks.", ["building: office", "60 desks, no others"]),
        (
            "A bakery. Upstairs two-bedroom flat with kitchen and bath.",
            [
                "building: bakery",
                "2 bedrooms, in each flat, floor 2",
                "1 flat, floor 2",
                "1 kitchen, in each flat, floor 2",
                "1 bath, in each flat, floor 2",
            ],
        ),
        (
            "A house with a granny flat on the ground floor (own entrance, bedroom, bathroom).",
            [
                "building: house",
                "1 granny flat, ground floor",
                "1 bedroom, in each granny flat, ground floor",
                "1 bathroom, in each granny flat, ground floor",
            ],
        ),
        (
            "A clinic with an operating suite upstairs (two operating theatres), a pharmacy downstairs.",
            [
                "building: clinic",
                "1 operating suite, floor 2",
                "2 operating theatres, floor 2",
                "1 pharmacy, ground floor",
            ],
        ),
        (
            "A ski lodge of two floors: boot room with 20 lockers and a drying room on the ground floor.",
            [
                "building: ski lodge",
                "2 storeys",
                "1 boot room, ground floor",
                "20 lockers, no others, in boot room",
                "1 drying room, ground floor",
            ],
        ),
        (
            "A car dealer with a workshop with 4 lifts.",
            ["building: car dealer", "1 workshop", "4 lifts, no others, in workshop"],
        ),
        (
            "A music school with a percussion room and a library. Percussion must not be next to the library.",
            ["building: music school", "1 percussion room", "1 library", "percussion room away from library"],
        ),
        (
            "A supermarket with a cafe. The sales hall must be bigger than everything else, namely 550 m2.",
            ["building: supermarket", "1 cafe", "1 sale hall of 550 m2", "[bigger than everything else]"],
        ),
        (
            "An office of three floors. GF: lobby. 1F + 2F: 8 team offices per floor, each 20 m2, and a kitchenette.",
            [
                "building: office",
                "3 storeys",
                "1 lobby, ground floor",
                "8 team offices of 20 m2, each of floors 2 and 3",
                "1 kitchenette, each of floors 2 and 3",
            ],
        ),
        (
            "A bookshop: the shop with 20 bookshelves and the till.",
            ["building: bookshop", "1 shop", "20 bookshelves, no others, in shop", "1 till, in shop"],
        ),
        (
            "A fitness club with a sauna. All on the first floor of a shopping centre.",
            ["building: fitness club", "1 sauna"],
        ),
        (
            "A hotel: kitchen, restaurant, lobby. The kitchen is adjacent to the restaurant but not to the lobby.",
            [
                "building: hotel",
                "1 kitchen",
                "1 restaurant",
                "1 lobby",
                "kitchen next to restaurant",
                "kitchen away from lobby",
            ],
        ),
        (
            "A house: hall, upstairs three bedrooms; garage attached to the side.",
            ["building: house", "1 hall", "3 bedrooms, floor 2", "1 garage", "[side]"],
        ),
        (
            "A post office with a lobby and a sorting hall. The public must not get into the sorting hall.",
            ["building: post office", "1 lobby", "1 sorting hall", "[get]"],
        ),
        (
            "A youth centre: kitchen for cooking classes, office, disco room. The disco must be away from the office.",
            ["building: youth centre", "1 kitchen", "1 office", "1 disco room", "disco room away from office"],
        ),
        ("We are converting a church into a climbing centre.", ["building: climbing centre"]),
        (
            "A townhouse: the ground floor is a shop and the two floors above are one apartment with a study.",
            [
                "building: townhouse",
                "1 shop, ground floor",
                "3 storeys",
                "1 apartment, floors 2 and 3",
                "1 study, in each apartment, floors 2 and 3",
            ],
        ),
        (
            "A bank. Hall with three counters and two tables, a lobby, office, vault in the basement, archive.",
            [
                "building: bank",
                "1 hall",
                "3 counters, no others, in hall",
                "2 tables, no others, in hall",
                "1 lobby",
                "1 office",
                "1 vault, basement 1",
                "1 archive",
            ],
        ),
        (
            "A house of two floors: bedroom with a bed, study with a desk and a chair, bathroom on every floor.",
            [
                "building: house",
                "2 storeys",
                "1 bedroom",
                "1 bed, in bedroom",
                "1 study",
                "1 desk, in study",
                "1 chair, in study",
                "1 bathroom, each of floors 1 and 2",
            ],
        ),
        (
            "A house. Kitchen with a dishwasher open to the dining room.",
            [
                "building: house",
                "1 kitchen",
                "kitchen next to dining room",
                "1 dishwasher, in kitchen",
                "1 dining room",
            ],
        ),
        ("A museum of natural history with a shop.", ["building: museum", "[natural history]", "1 shop"]),
        (
            "A laboratory with four labs. Each lab gets two fume hoods and an eye wash.",
            ["building: laboratory", "4 labs", "2 fume hoods, no others, in each lab", "[eye wash]"],
        ),
        ("A hostel with luggage lockers.", ["building: hostel", "luggage lockers"]),
    ],
)
def test_each_statement_is_read_once_where_it_holds(brief: str, expected: list[str]) -> None:
    assert statements(brief) == expected


@pytest.mark.parametrize(
    ("storeys", "scope"),
    [
        ("The floors from 2 until 5 are equal, each with a pantry.", "each of floors 2 to 5"),
        ("Storeys 2 to 5 are typical: one pantry.", "each of floors 2 to 5"),
        ("The four upper floors are repeated without change: one pantry.", "each of floors 2 to 5"),
    ],
)
def test_storeys_that_are_alike_are_told_of_once(storeys: str, scope: str) -> None:
    found = statements(f"An office building of five floors. {storeys}")
    assert f"1 pantry, {scope}" in found
    assert sum(text.startswith("alike") for text in found) == 1


def test_mid_heads_the_storey_between() -> None:
    found = statements("House, 3 storeys. GF: kitchen. Mid: living room, study. Top: 3 bedrooms.")
    assert found[3:] == ["1 living room, floor 2", "1 study, floor 2", "3 bedrooms, floor 3"]


def test_what_a_building_is_named_after_in_is_the_building() -> None:
    found = statements("Robots will be evaluated in an office building of six floors.")
    assert "building: office building" in found


@pytest.mark.parametrize(
    "text",
    [
        "Between the kitchen and the cold storage is a direct connection.",
        "Between kitchen and cold storage there should be a door.",
    ],
)
def test_what_is_told_between_two_rooms_joins_them(text: str) -> None:
    found = statements(f"A restaurant with a dining room, a kitchen and a cold storage. {text}")
    assert found[4:] == ["kitchen next to cold storage"]


def test_besides_adds_to_a_list_and_beside_joins() -> None:
    assert statements("An office with a canteen besides toilets.")[1:] == ["1 canteen", "toilets"]


def test_an_area_may_be_named_after_an_aside_or_a_sum() -> None:
    assert "640 m2 in all" in statements("A kindergarten on two floors, sum of areas 640 m2.")


@pytest.mark.parametrize("form", ["an L-shaped plan", "the form of an L"])
def test_the_noun_of_an_outline_belongs_to_it(form: str) -> None:
    assert statements(f"A school with {form}.") == ["building: school", "outline: L"]


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A police station with a custody suite.", "holding_cell"),
        ("A hotel with a bridal suite.", "hotel_suite"),
        ("A monastery with twelve cells.", "dorm_room"),
        ("A police station with twelve cells.", "holding_cell"),
        ("A museum with one big hall.", "assembly_hall"),
        ("A dental practice with four surgeries.", "dental_room"),
        ("A kindergarten with a sleeping room.", "nap_room"),
        ("A radio station with two studios.", "recording_studio"),
        ("A villa with a cinema room.", "home_theater"),
        ("A library with a stack room.", "book_stacks"),
        ("A supermarket with a sales hall.", "sales_area"),
    ],
)
def test_a_room_is_what_its_words_mean_in_the_building(brief: str, kind: str) -> None:
    wishes = plan_building(BuildRequest(description=brief)).program.wishes
    assert [wish.value.type for wish in wishes if wish.kind == "room"] == [kind]


@pytest.mark.parametrize(
    "aside", ["because my knees are bad", "for the testing of a disinfecting robot", "for our navigation benchmark"]
)
def test_reasons_and_purposes_ask_for_nothing(aside: str) -> None:
    assert statements(f"A bungalow with a study {aside}.") == ["building: bungalow", "1 study"]


def test_a_reason_that_asks_for_something_is_told_of_whole() -> None:
    found = statements("A house of two floors because we want a lift, by the railway.")
    assert found == ["building: house", "2 storeys", "lift", "[railway]"]
