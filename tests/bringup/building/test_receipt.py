"""What becomes of wishes: each kind on a house that is drawn by hand."""

import msgspec
import pytest

from mansion_bringup.building.receipt import receipt, receipt_of_plan
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.wishes import Scope, Wish, WishStatus, WishValue
from wish_cases import CASES
from wish_house import L_OUTLINE, box, program, scenes, wish

FORMS: list[tuple[str, Ring]] = [
    ("L", L_OUTLINE),
    ("U", [(0, 0), (12, 0), (12, 9), (8, 9), (8, 4), (4, 4), (4, 9), (0, 9)]),
    ("T", [(4, 0), (8, 0), (8, 5), (12, 5), (12, 9), (0, 9), (0, 5), (4, 5)]),
    ("H", [(0, 0), (4, 0), (4, 4), (8, 4), (8, 0), (12, 0), (12, 12), (8, 12), (8, 8), (4, 8), (4, 12), (0, 12)]),
    ("rectangle", [(0, 0), (5, 0), (10, 0), (10, 8), (0, 8)]),
    ("square", box(0, 0, 9, 9)),
]


def settled(asked: Wish, floors: list[FloorScene] | None = None, outline: Ring | None = None) -> Wish:
    return receipt([asked], program([asked], outline), floors or scenes())[0]


@pytest.mark.parametrize(("asked", "status"), [case[1:] for case in CASES], ids=[case[0] for case in CASES])
def test_a_wish_gets_its_status_from_the_finished_floors(asked: Wish, status: WishStatus) -> None:
    found = settled(asked)
    assert found.status == status, found.reason
    assert (found.reason == "") == (status in ("met", "not_understood"))


@pytest.mark.parametrize(("name", "outline"), FORMS, ids=[form[0] for form in FORMS])
def test_an_outline_has_the_form_that_it_is_named_by_and_no_other(name: str, outline: Ring) -> None:
    met = {
        other
        for other in ("L", "U", "T", "H", "square")
        if settled(wish("outline", WishValue(name=other)), outline=outline).status == "met"
    }
    assert met == {name} - {"rectangle"}
    rectangle = settled(wish("outline", WishValue(name="rectangle")), outline=outline)
    assert (rectangle.status == "met") == (name in ("rectangle", "square"))


def test_what_answers_to_a_wish_is_named_by_ids_of_the_scene() -> None:
    desks = wish("object", WishValue(name="desks", type="desk", count=2), Scope(room="pottery_room"))
    found = settled(desks)
    assert found.rooms == ["F2/pottery"]
    assert found.objects == ["F2/pottery/office_desk_1", "F2/pottery/office_desk_2"]


@pytest.mark.parametrize(
    ("category", "asset", "asked", "number", "status"),
    [
        ("cinema_seat", "cinema_seat_1", "chair", 3, "met"),
        ("cinema_seat", "cinema_seat_1", "chair", 4, "partly"),
        ("wall_tv", "wall_tv_1", "television", 1, "met"),
        ("hospital_bed", "hospital_bed_1", "bed", 1, "met"),
        ("wall_tv", "wall_tv_1", "chair", 1, "not_met"),
    ],
)
def test_kinds_of_a_thing_answer_and_rows_count_their_seats(
    category: str, asset: str, asked: str, number: int, status: WishStatus
) -> None:
    floors = scenes()
    thing = msgspec.structs.replace(
        floors[0].objects[0], id="F1/hallway/thing_1", room="F1/hallway", category=category, asset=asset
    )
    floors[0] = msgspec.structs.replace(floors[0], objects=[thing])
    wanted = wish("object", WishValue(name=f"{asked}s", type=asked, count=number), Scope(room="hallway", floors=[1]))
    assert settled(wanted, floors).status == status


def test_a_room_that_something_known_stands_in_for_is_met_in_part() -> None:
    room = wish("room", WishValue(name="pottery", type="study_room", count=1))
    asked = msgspec.structs.replace(room, reason="no such room is known; planned and furnished like study room")
    assert settled(asked).status == "partly"
    assert settled(asked).reason == asked.reason


def test_a_kind_of_building_that_something_known_stands_in_for_is_met_in_part() -> None:
    kind = wish("building_type", WishValue(name="observatory", type="house"))
    asked = msgspec.structs.replace(kind, reason="no such kind of building is known; planned like house")
    assert settled(asked).status == "partly"


def test_one_high_room_does_not_make_high_ceilings() -> None:
    floors = scenes()
    rooms = floors[0].rooms
    high = [msgspec.structs.replace(rooms[0], ceiling_height=3.5), *rooms[1:]]
    floors[0] = msgspec.structs.replace(floors[0], rooms=high)
    assert settled(wish("height", WishValue(height=3.5)), floors).status == "partly"


def test_rooms_around_a_corner_share_no_wall_for_a_door() -> None:
    floors = scenes()
    bent = [(4.0, 0.0), (6.0, 0.0), (6.0, 4.0), (2.0, 4.0), (2.0, 1.0), (3.0, 1.0), (3.0, 0.9), (4.0, 0.9)]
    small = [(2.0, 0.0), (4.0, 0.0), (4.0, 0.9), (3.0, 0.9), (3.0, 1.0), (2.0, 1.0)]
    by_id = {room.id: room for room in floors[0].rooms}
    by_id["F1/kitchen"] = msgspec.structs.replace(by_id["F1/kitchen"], polygon=bent)
    larder = msgspec.structs.replace(by_id["F1/kitchen"], id="F1/larder", room_type="larder", polygon=small)
    floors[0] = msgspec.structs.replace(floors[0], rooms=[*by_id.values(), larder])
    asked = wish("adjacent", WishValue(name="larder", type="larder", other="kitchen", other_type="kitchen"))
    assert settled(asked, floors).status == "not_met"


def test_storeys_that_repeat_each_other_are_copies() -> None:
    asked = wish("copy", WishValue(), Scope(floors=[1, 2]))
    plan = program([asked])
    plan.floors[1] = msgspec.structs.replace(plan.floors[1], copy=1)
    assert receipt([asked], plan, scenes())[0].status == "met"


def test_storeys_that_repeat_copies_are_copies_of_the_first() -> None:
    asked = wish("copy", WishValue(), Scope(floors=[2, 3]))
    plan = program([asked])
    second = msgspec.structs.replace(plan.floors[1], copy=1)
    plan.floors[1:] = [second, msgspec.structs.replace(second, index=3, copy=2)]
    assert receipt([asked], plan, scenes())[0].status == "met"


def test_a_plan_knows_the_ceilings_that_its_storeys_will_have() -> None:
    plan = program([wish("height", WishValue(height=2.75)), wish("height", WishValue(height=3.0))])
    assert [found.status for found in receipt_of_plan(plan, [])] == ["met", "not_met"]


@pytest.mark.parametrize(("floors", "status"), [([2], "met"), ([1], "not_met"), ([], "not_met")])
def test_nothing_else_is_said_of_a_storey_or_of_all(floors: list[int], status: WishStatus) -> None:
    ledger = [
        wish("room", WishValue(name="bedroom", type="bedroom", count=2), name="wish_1"),
        wish("room", WishValue(name="pottery_room", type="study_room", count=1), name="wish_2"),
        wish("only", scope=Scope(floors=floors), name="wish_3"),
    ]
    assert receipt(ledger, program(ledger), scenes())[-1].status == status


@pytest.mark.parametrize(("name", "status"), [("toilet", "not_met"), ("man_toilet", "met")])
def test_away_from_the_toilets_is_away_from_those_of_every_type(name: str, status: WishStatus) -> None:
    asked = wish("apart", WishValue(name="kitchen", type="kitchen", other=name, other_type="toilet"))
    floors = scenes()
    rooms = [
        msgspec.structs.replace(room, room_type="restroom") if room.id == "F1/dining_room" else room
        for room in floors[0].rooms
    ]
    floors[0] = msgspec.structs.replace(floors[0], rooms=rooms)
    assert settled(asked, floors).status == status
