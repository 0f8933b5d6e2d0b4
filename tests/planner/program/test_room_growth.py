"""Rooms that a brief asks for grow before a storey gets others that nobody asked for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.room_growth import reach
from mansion_planner.program.storey_rooms import fit_areas

FILLERS = {
    "meeting_room", "study_room", "archive", "team_room", "sample_room", "workshop", "storage", "dance_studio",
    "sauna", "lounge", "playroom", "game_room", "library_room", "training_room", "business_center",
}  # fmt: skip


def planned(brief: str) -> list[RoomProgram]:
    """Return the rooms of all storeys."""
    return [room for floor in plan_building(BuildRequest(description=brief)).program.floors for room in floor.rooms]


@pytest.mark.parametrize(
    "brief",
    [
        "Chemistry research lab, 450 m2 on a single level: two wet labs, an instrument room, a chemicals store, an "
        "office for eight researchers and a coffee room.",
        "Fitness club, 550 m2, one floor: free weights area, cardio room, yoga room, changing rooms for men and women, "
        "reception.",
        "A villa of 380 m2 on two floors with a living room, a library, a kitchen with an island, five bedrooms with "
        "their own bathrooms and a sauna.",
        "A warehouse of 2,000 m2 with a storage hall, a packing area, two offices and a break room.",
        "A two-storey conference hotel of 1,000 m2: reception, restaurant, bar and a lounge on the ground floor, ten "
        "guest rooms upstairs.",
    ],
)
def test_a_described_building_has_few_rooms_that_nobody_asked_for(brief: str) -> None:
    rooms = planned(brief)
    unasked = sum(room.area_estimate for room in rooms if room.room_type in FILLERS and not room.notes)
    assert unasked <= 0.06 * sum(room.area_estimate for room in rooms)


def test_a_library_has_bookshelves_whatever_else_the_brief_asks_for() -> None:
    brief = (
        "Public library on two levels, 900 m2: a reading room, a children's corner, a computer room and study rooms."
    )
    kinds = [room.room_type for room in planned(brief)]
    assert "book_stacks" in kinds
    assert kinds.count("study_room") == 2


def test_flexible_rooms_grow_further_than_stores() -> None:
    knowledge = default_knowledge()
    gym, store = (planned_room(knowledge.room(name), knowledge) for name in ("gym", "storage"))
    assert reach([gym]) / gym.area > reach([store]) / store.area
    grown_gym, grown_store = fit_areas([gym, store], 1.5 * (gym.area + store.area))
    assert grown_gym.area / gym.area > grown_store.area / store.area


def test_bedrooms_with_bathrooms_of_their_own_leave_place_for_a_guest_toilet_and_not_for_other_bathrooms() -> None:
    rooms = planned("A villa of 380 m2 on two floors with five bedrooms with their own bathrooms and a library")
    assert sum(room.room_type == "toilet" for room in rooms) == 1
    assert sum(room.room_type == "bathroom" for room in rooms) == 5


@pytest.mark.parametrize(("room", "most"), [("bar", 22.0), ("hobby room", 26.0), ("music room", 29.0)])
def test_rooms_that_other_buildings_have_for_many_are_small_in_a_home(room: str, most: float) -> None:
    rooms = planned(f"A house of 200 m2 with a {room}, a living room, a kitchen and three bedrooms")
    [own] = [each for each in rooms if each.id == room.replace(" ", "_")]
    assert own.area_estimate <= most
