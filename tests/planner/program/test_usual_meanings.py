"""Plain names of rooms mean what the kind of building has: guests of a restaurant eat from one kitchen."""

import pytest

from mansion_msgs_py.program import FloorProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def floors(text: str) -> list[FloorProgram]:
    """Return the storeys planned for a description."""
    return plan_building(BuildRequest(description=text)).program.floors


def types(floor: FloorProgram) -> list[tuple[str, str]]:
    """Return (name, type) of the kitchens and dining rooms of a storey."""
    return sorted(
        (room.id, room.room_type)
        for room in floor.rooms
        if room.room_type in ("kitchen", "open_kitchen", "commercial_kitchen", "dining_room", "restaurant")
    )


@pytest.mark.parametrize("kitchen", ["kitchen", "open kitchen"])
def test_the_kitchen_of_a_restaurant_is_its_commercial_one(kitchen: str) -> None:
    (ground,) = floors(f"a restaurant with a {kitchen}")
    assert types(ground) == [(kitchen.replace(" ", "_"), "commercial_kitchen"), ("restaurant", "restaurant")]


def test_the_dining_room_of_a_restaurant_is_where_guests_come_in() -> None:
    (ground,) = floors("a restaurant with a dining room and a kitchen")
    assert types(ground) == [("kitchen", "commercial_kitchen"), ("restaurant", "restaurant")]
    assert ground.rooms[0].name == "dining room"


def test_several_dining_rooms_are_rooms_for_guests() -> None:
    (ground,) = floors("a restaurant with two dining rooms and a kitchen")
    assert [kind for name, kind in types(ground) if name.startswith("dining_room")] == ["restaurant"] * 2


def test_a_restaurant_without_a_kitchen_has_none() -> None:
    (ground,) = floors("a restaurant without a kitchen")
    assert types(ground) == [("restaurant", "restaurant")]


def test_the_kitchen_of_a_flat_above_is_that_of_a_home() -> None:
    ground, upper = floors(
        "A restaurant on two floors. Ground floor: restaurant and bar. Upper floor: kitchen, living room, bedroom."
    )
    assert ("kitchen", "kitchen") in types(upper)
    assert "commercial_kitchen" in dict(types(ground))


def test_a_brief_that_tells_two_kitchens_apart_gets_both() -> None:
    (ground,) = floors("a restaurant with a commercial kitchen and a kitchen")
    assert {"commercial_kitchen", "kitchen"} <= {kind for _, kind in types(ground)}


def test_the_kitchen_of_a_house_stays_one() -> None:
    (ground,) = floors("a bungalow with a kitchen and a dining room")
    assert {kind for _, kind in types(ground)} == {"kitchen", "dining_room"}


@pytest.mark.parametrize(
    ("brief", "guests", "count"),
    [
        ("A hotel of four storeys with twenty bedrooms and a restaurant.", "hotel_room", 20),
        ("A care home of two floors with nine bedrooms on each floor.", "resident_room", 18),
        ("A hospital of two storeys with eight bedrooms upstairs.", "patient_room", 8),
    ],
)
def test_the_bedrooms_that_are_counted_are_all_that_guests_have(brief: str, guests: str, count: int) -> None:
    kinds = [room.room_type for floor in floors(brief) for room in floor.rooms]
    assert sum(kind in ("bedroom", guests) for kind in kinds) == count


def test_bedrooms_of_a_hotel_have_bathrooms_unless_guests_share_them() -> None:
    own, shared = (
        [
            room.room_type
            for floor in floors(f"A lodge with a dining room, eight bedrooms{baths}")
            for room in floor.rooms
        ]
        for baths in ("", " and three bathrooms")
    )
    assert own.count("bathroom") == 8
    assert (shared.count("bedroom"), shared.count("bathroom")) == (8, 3)


def test_the_hall_of_a_community_centre_is_where_people_meet() -> None:
    rooms = [room for floor in floors("A community centre with a hall, a cafe and a workshop") for room in floor.rooms]
    assert [room.id for room in rooms if room.room_type == "assembly_hall"] == ["hall"]


def test_bedrooms_of_staff_leave_the_guests_their_rooms() -> None:
    planned = [room.room_type for floor in floors("A hotel with two staff bedrooms.") for room in floor.rooms]
    assert "hotel_room" in planned


@pytest.mark.parametrize("home", ["flat", "bungalow"])
def test_the_lounge_of_a_home_is_its_living_room(home: str) -> None:
    (ground,) = floors(f"a {home} with a lounge of 20 m2, two bedrooms and a bathroom")
    living = [(room.id, room.room_type) for room in ground.rooms if room.room_type in ("lounge", "living_room")]
    assert living == [("lounge", "living_room")]


def test_the_lounge_of_a_hotel_stays_one() -> None:
    ground = floors("a hotel with a lounge and six rooms")[0]
    assert "lounge" in [room.room_type for room in ground.rooms]


@pytest.mark.parametrize(("text", "kind"), [
    ("a car dealership with a showroom", "car_showroom"),
    ("a kitchen shop with a showroom", "showroom"),
])  # fmt: skip
def test_cars_stand_in_the_showroom_of_who_sells_cars(text: str, kind: str) -> None:
    assert kind in [room.room_type for room in floors(text)[0].rooms]


@pytest.mark.parametrize(
    ("brief", "hub", "name"),
    [
        ("A warehouse of 1,400 m2 with a storage hall, two offices and a break room", "warehouse", "storage hall"),
        ("A restaurant of 200 m2 with a dining hall, a kitchen and a store", "restaurant", "dining hall"),
    ],
)
def test_the_hall_that_a_building_is_there_for_is_one_under_any_name(brief: str, hub: str, name: str) -> None:
    [floor] = floors(brief)
    assert (floor.rooms[0].room_type, floor.rooms[0].name) == (hub, name)
    assert sum(room.room_type == hub for room in floor.rooms) == 1


def test_a_hall_of_a_stated_area_is_a_room_beside_others() -> None:
    [floor] = floors("A warehouse of 700 m2 on one storey, with a storage hall of 400 m2 and an office")
    assert floor.rooms[0].room_type == "lobby"


@pytest.mark.parametrize(
    ("brief", "name", "kind"),
    [
        (
            "A three-storey hotel with eight en-suite guest rooms on each upper floor",
            "ensuite_guest_room",
            "hotel_room",
        ),
        ("A villa of 300 m2 with a gym, four bedrooms and two bathrooms", "gym", "home_gym"),
        (
            "A duplex of 130 m2: upstairs two bedrooms, a dressing room and a bathroom",
            "dressing_room",
            "walk_in_closet",
        ),
    ],
)
def test_rooms_of_guests_and_of_a_household_are_of_their_size(brief: str, name: str, kind: str) -> None:
    found = [room.room_type for floor in floors(brief) for room in floor.rooms if room.id.startswith(name)]
    assert found
    assert set(found) == {kind}


def test_counted_guest_rooms_are_all_that_a_hotel_has() -> None:
    _, *upper = floors("A three-storey hotel of 1,000 m2 with eight en-suite guest rooms on each upper floor")
    assert [sum(room.room_type == "hotel_room" for room in floor.rooms) for floor in upper] == [8, 8]


@pytest.mark.parametrize(
    ("brief", "name", "kind"),
    [
        ("A kindergarten with two playrooms and a nap room", "playroom", "kindergarten_classroom"),
        ("A dental clinic with three treatment rooms", "treatment_room", "dental_room"),
        ("A fire station with a garage for two trucks", "apparatus_bay", "apparatus_bay"),
        ("A grocery store with a storage room", "storage_room", "stock_room"),
        ("An office with ten desks and a bathroom", "bathroom", "restroom"),
    ],
)
def test_plain_names_mean_what_such_a_building_has(brief: str, name: str, kind: str) -> None:
    found = [room.room_type for floor in floors(brief) for room in floor.rooms if room.id.startswith(name)]
    assert found
    assert set(found) == {kind}


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A school with six classrooms and toilets for boys and girls.", "restroom"),
        ("A house with three bedrooms and a toilet for visitors.", "toilet"),
    ],
)
def test_toilets_for_some_in_a_public_building_have_several_cubicles(brief: str, kind: str) -> None:
    rooms = [room for floor in floors(brief) for room in floor.rooms if "toilet" in room.id]
    assert {room.room_type for room in rooms if room.room_type != "accessible_toilet"} == {kind}
