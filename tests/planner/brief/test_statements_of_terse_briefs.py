"""Short forms and numbers in brackets, and what closes a list, belong to what they are said of."""

import pytest

from mansion_bringup.building.receipt import receipt_of_plan
from mansion_bringup.building.wish_words import read_as
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def _read(text: str) -> list[str]:
    reply = plan_building(BuildRequest(description=text))
    return [read_as(wish) or f"[{wish.text}]" for wish in receipt_of_plan(reply.program, reply.topologies)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Makerspace, 450 m2, one level: wood workshop (90), electronics lab (60), a classroom.",
            ["1 wood workshop of 90 m2", "1 electronics lab of 60 m2", "1 classroom"],
        ),
        ("Office of 900 m2 with offices (10) and a meeting room (2).", ["10 offices", "2 meeting rooms"]),
        (
            "Newsroom, 3 floors. Fl. 1 reception, 2 studios. Fl. 2 newsroom. Fl. 3 offices (10).",
            ["1 reception, ground floor", "2 studios, ground floor", "1 newsroom, floor 2", "10 offices, floor 3"],
        ),
        (
            "A house of two floors with living/dining downstairs (approx. 50 m2) and a utility room.",
            ["1 living dining of 50 m2, ground floor"],
        ),
        (
            "A dental surgery of two floors with a reception, a waiting room and a staff room upstairs.",
            ["1 reception", "1 waiting room", "1 staff room, floor 2"],
        ),
        (
            "A clinic with a cats' waiting room, a dogs' waiting room (apart from one another).",
            ["cat waiting room away from dog waiting room"],
        ),
        (
            "An apartment building of five floors. Each floor has four flats, two of 55 m2 and two of 80 m2.",
            ["2 flats of 55 m2 in all, each of floors 1 to 5", "2 flats of 80 m2 in all, each of floors 1 to 5"],
        ),
        ("A hotel. Floors 2 to 4: 9 rooms each, all en suite.", ["9 rooms, each of floors 2 to 4"]),
        (
            "Co-living building on five storeys: every floor has five single rooms of 14 m2.",
            ["5 rooms of 14 m2, each of floors 1 to 5"],
        ),
        ("A flat with four bedrooms, 91 m2 on each of 2 storeys.", ["4 bedrooms", "91 m2 a floor"]),
    ],
)
def test_statements_hold_where_they_are_made(text: str, expected: list[str]) -> None:
    found = _read(text)
    assert [entry for entry in expected if entry not in found] == []


def test_furniture_beside_a_room_that_has_no_such_things_is_the_buildings() -> None:
    assert "desks" in _read("An office with long corridors and rows of desks.")


def test_what_is_said_all_the_way_up_is_on_every_upper_storey() -> None:
    found = _read("Office tower, three floors, a reception at the bottom and workstations all the way up.")
    assert "workstations, floors 2 and 3" in found


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "A house: downstairs the kitchen and the living room, then two bedrooms, and a studio on top.",
            ["1 kitchen, ground floor", "2 bedrooms, floor 2", "1 studio, floor 3"],
        ),
        (
            "A townhouse. Downstairs: kitchen. First floor: two bedrooms. Second floor: a study.",
            ["1 kitchen, ground floor", "2 bedrooms, floor 2", "1 study, floor 3"],
        ),
        ("A flat of 120 m2 with 4BHK.", ["4 bedrooms", "120 m2 in all"]),
        ("A bakery with a shop; up one flight, two bedrooms.", ["2 bedrooms, floor 2"]),
    ],
)
def test_storeys_that_the_order_of_a_brief_tells(text: str, expected: list[str]) -> None:
    found = _read(text)
    assert [entry for entry in expected if entry not in found] == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Tower hotel: 12 storeys. Storeys 1-2 lobby, 3-11 four rooms per storey each with bathroom, 12 sky bar.",
            ["1 lobby, each of floors 1 and 2", "4 rooms, each of floors 3 to 11", "1 sky bar, floor 12"],
        ),
        (
            "A hospital ward with 10 patient rooms (2 beds each, ensuite bathroom), nurse station.",
            ["10 ensuite bathrooms, in patient room"],
        ),
        (
            "A school of two floors with 2 science labs upstairs with a preparation room in between.",
            ["1 preparation room, floor 2", "preparation room next to science lab"],
        ),
        ("A police station with an office. Outside parking is not part of it.", ["no parking"]),
        ("House of two storeys: two bathrooms upstairs, guest WC down.", ["1 guest wc, ground floor"]),
        ("A house: ground floor 80 m2, upper floor 70 m2.", ["75 m2 a floor"]),
        ("A cinema with 3 screens, a foyer and a projection room for each screen.", ["3 projection rooms"]),
        ("The ministry asks for a border post on a single floor: 3 offices.", ["building: border post", "3 offices"]),
        ("A clinic of two floors with two lifts, one of them for beds.", ["2 lifts"]),
        (
            "A town house on three levels. At street level a kitchen; one level up the lounge; the top level a study.",
            ["1 kitchen, ground floor", "1 lounge, floor 2", "1 study, floor 3"],
        ),
        (
            "An embassy of 4 storeys; a hall at the bottom; the second has eight offices; third is the library.",
            ["8 offices, floor 2", "1 library, floor 3"],
        ),
        ("Mansion, 3 storeys. Ground: hall. First floor: library. Attic floor: nursery.", ["1 nursery, floor 3"]),
        ("A clinic with two operating theatres (35 m2 each) with a shared scrub area.", ["1 scrub area"]),
        ("A rehab centre of two floors with 14 patient rooms with shower.", ["14 showers, in patient room"]),
        ("A pub on one floor with a kitchen, office upstairs is not wanted.", ["no private office, ground floor"]),
        ("A chalet sleeping ten over three floors.", ["for 10 people", "3 storeys"]),
        ("A three-storey house. Each level should come to roughly 65 m2.", ["65 m2 a floor"]),
        ("Warehouse, one floor, general area 760 m2. A toilet.", ["760 m2 in all"]),
        (
            "An office with a reception, 45 workstations in open plan.",
            ["45 workstations, no others, in open plan office"],
        ),
    ],
)
def test_statements_in_other_words(text: str, expected: list[str]) -> None:
    found = _read(text)
    assert [entry for entry in expected if entry not in found] == []
    assert "beds" not in found
