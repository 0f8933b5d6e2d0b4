"""A room of the brief that cannot be used is met in part, for the receipt and for the check alike."""

import msgspec
import pytest

from mansion_bringup.building.receipt import receipt
from mansion_bringup.check.wishes import check_wishes
from mansion_msgs_py.scene import Discard, Door, FloorScene
from mansion_msgs_py.wishes import Scope, Wish, WishStatus, WishValue
from wish_house import building, layouts, program, scenes, wish

KITCHEN = wish("room", WishValue(name="kitchen", type="kitchen", count=1))
HELD = wish("room", WishValue(name="pottery_room", type="study_room", count=1), Scope(unit="pottery", unit_type=""))
NO_STOVE = wish(
    "no_object", WishValue(name="stove", type="stove"), Scope(room="kitchen", room_type="kitchen"), name="wish_2"
)


def without(*categories: str) -> list[FloorScene]:
    """Return the floors of the house without the objects of some categories."""
    return [
        msgspec.structs.replace(scene, objects=[o for o in scene.objects if o.category not in categories])
        for scene in scenes()
    ]


@pytest.mark.parametrize(
    ("wishes", "gone", "status", "reason"),
    [
        ([KITCHEN], (), "met", ""),
        ([KITCHEN], ("stove",), "partly", "F1/kitchen has no cooker"),
        ([KITCHEN], ("stove", "sink"), "partly", "F1/kitchen has no cooker"),
        ([KITCHEN, NO_STOVE], ("stove",), "met", ""),
        ([KITCHEN, NO_STOVE], ("stove", "sink"), "partly", "F1/kitchen has no sink"),
        ([HELD], (), "met", ""),
        ([HELD], ("office_chair",), "partly", "F2/pottery has no seat"),
    ],
)
def test_receipt_and_check_agree_on_what_can_be_used(
    wishes: list[Wish], gone: tuple[str, ...], status: WishStatus, reason: str
) -> None:
    floors = without(*gone)
    told = receipt(wishes, program(wishes), floors)
    assert (told[0].status, told[0].reason) == (status, reason)
    assert list(check_wishes(building(program(wishes), told), told, layouts(floors), floors)) == []
    other = [msgspec.structs.replace(told[0], status="partly" if status == "met" else "met"), *told[1:]]
    faults = check_wishes(building(program(wishes), other), other, layouts(floors), floors)
    assert [fault.kind for fault in faults] == ["WISH_STATUS"]


def test_the_reason_is_that_of_the_furnishing() -> None:
    ground, upper = without("stove")
    lost = Discard(room="F1/kitchen", name="cooker", count=1, reason="no place of 0.6 x 0.6 m is free")
    told = receipt([KITCHEN], program([KITCHEN]), [msgspec.structs.replace(ground, discarded=[lost]), upper])
    assert told[0].reason == "F1/kitchen has no cooker: no place of 0.6 x 0.6 m is free"


def test_a_room_of_a_kind_that_is_not_known_says_what_it_is_furnished_as_even_where_it_cannot_be_used() -> None:
    room = wish("room", WishValue(name="pottery", type="study_room", count=1))
    asked = msgspec.structs.replace(room, reason="no such room is known; planned and furnished like study room")
    told = receipt([asked], program([asked]), without("office_chair"))[0]
    assert told.status == "partly"
    assert told.reason == f"{asked.reason}; F2/pottery has no seat"


OPEN = wish("room", WishValue(name="kitchen", type="open_kitchen", count=1))


@pytest.mark.parametrize(("beyond", "status"), [("living_room", "met"), ("hallway", "partly")])
def test_an_open_kitchen_is_open_to_a_room_that_is_no_passage(beyond: str, status: WishStatus) -> None:
    ground, upper = scenes()
    kinds = {"F1/kitchen": "open_kitchen", "F1/hallway": beyond}
    rooms = [msgspec.structs.replace(room, room_type=kinds.get(room.id, room.room_type)) for room in ground.rooms]
    sides, segment = ("F1/kitchen", "F1/hallway"), ((2, 1), (2, 3))
    opening = Door(id="door_9", kind="open", segment=segment, rooms=sides, width=2, height=2)
    floors = [msgspec.structs.replace(ground, rooms=rooms, doors=[opening]), upper]
    told = receipt([OPEN], program([OPEN]), floors)
    assert told[0].status == status
    assert list(check_wishes(building(program([OPEN]), told), told, layouts(floors), floors)) == []


@pytest.mark.parametrize(("refused", "status"), [("private_office", "met"), ("bedroom", "not_met")])
def test_a_refused_kind_is_refused_under_all_its_types(refused: str, status: WishStatus) -> None:
    none = wish("no_room", WishValue(name=refused, type=refused, unwanted=True))
    floors = [
        msgspec.structs.replace(
            scene,
            rooms=[
                msgspec.structs.replace(r, room_type="guest_room" if r.id == "F1/kitchen" else r.room_type)
                for r in scene.rooms
            ],
        )
        for scene in scenes()
    ]
    told = receipt([none], program([none]), floors)
    assert told[0].status == status
    assert list(check_wishes(building(program([none]), told), told, layouts(floors), floors)) == []
