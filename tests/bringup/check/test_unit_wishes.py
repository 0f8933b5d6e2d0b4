"""What each unit holds, judged by the receipt and by the check: the doors tell what is reached through a unit alone."""

import msgspec
import pytest

from mansion_bringup.building.receipt import receipt
from mansion_bringup.check.wishes import check_wishes
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.wishes import Scope, Wish, WishStatus, WishValue
from wish_house import building, layouts, program, scenes, wish

THROUGH = [("hallway", "pottery"), ("pottery", "bedroom_1"), ("pottery", "bedroom_2")]
PAST = [("hallway", "pottery"), ("pottery", "bedroom_1"), ("bedroom_2", "hallway")]


def upstairs(pairs: list[tuple[str, str]]) -> list[FloorScene]:
    """Return the floors of the house, where the upper one has doors between these rooms and to the stair."""
    ground, upper = scenes()
    rooms = [(f"F2/{first}", f"F2/{second}") for first, second in pairs] + [("F2/hallway", "stair_1")]
    doors = [
        Door(id=f"F2/door_{number}", kind="single", segment=((2.0, 1.0), (2.0, 2.0)), rooms=pair, width=1.0, height=2.1)
        for number, pair in enumerate(rooms, 1)
    ]
    return [ground, msgspec.structs.replace(upper, doors=doors)]


def held(name: str, count: int | None, area: float | None = None, unit: str = "pottery") -> Wish:
    value = WishValue(name=name, type=name, count=count, area=area)
    return wish("room", value, Scope(floors=[2], unit=unit, unit_type=unit))


def whole(area: float) -> Wish:
    value = WishValue(name="pottery", type="study_room", count=1, area=area, whole=True)
    return wish("room", value, Scope(floors=[2]))


CASES: list[tuple[str, Wish, list[tuple[str, str]], WishStatus]] = [
    ("two bedrooms", held("bedroom", 2), THROUGH, "met"),
    ("several bedrooms", held("bedroom", None), THROUGH, "met"),
    ("one bedroom", held("bedroom", 1), THROUGH, "partly"),
    ("a bedroom off the hallway is not the unit's", held("bedroom", 2), PAST, "partly"),
    ("one bedroom beside another", held("bedroom", 1), PAST, "met"),
    ("bedrooms of that area", held("bedroom", 2, 16.0), THROUGH, "met"),
    ("bedrooms of another area", held("bedroom", 2, 25.0), THROUGH, "partly"),
    ("the main room counts", held("pottery_room", 1), THROUGH, "met"),
    ("no kitchen in it", held("kitchen", 1), THROUGH, "not_met"),
    ("no such unit", held("bedroom", 1, unit="flat"), THROUGH, "not_met"),
    ("area of the whole", whole(64.0), THROUGH, "met"),
    ("area without a room past it", whole(64.0), PAST, "partly"),
    ("area of the main room alone", whole(32.0), THROUGH, "partly"),
]


@pytest.mark.parametrize(("asked", "pairs", "status"), [case[1:] for case in CASES], ids=[case[0] for case in CASES])
def test_receipt_and_check_agree_on_what_a_unit_holds(
    asked: Wish, pairs: list[tuple[str, str]], status: WishStatus
) -> None:
    floors = upstairs(pairs)
    told = receipt([asked], program([asked]), floors)[0]
    assert told.status == status, told.reason
    house = building(program([asked]), [told])
    assert list(check_wishes(house, [told], layouts(floors), floors)) == []
    other = msgspec.structs.replace(told, status="not_met" if status == "met" else "met")
    faults = check_wishes(building(program([asked]), [other]), [other], layouts(floors), floors)
    assert [fault.kind for fault in faults] == ["WISH_STATUS"]


def test_rooms_inside_units_are_not_counted_among_the_rooms_of_the_house() -> None:
    inside, free = held("bedroom", 1), wish("room", WishValue(name="bedroom", type="bedroom", count=1), name="wish_2")
    floors = upstairs(PAST)
    told = receipt([inside, free], program([inside, free]), floors)
    assert [entry.status for entry in told] == ["met", "met"]
    assert told[1].rooms == ["F2/bedroom_2"]
    assert list(check_wishes(building(program([inside, free]), told), told, layouts(floors), floors)) == []
