"""Homes have small stairs, a hallway or a living room in the middle, and always a place to live, cook and wash in."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def plan(text: str, seed: int = 0) -> BuildingProgram:
    return plan_building(BuildRequest(description=text, seed=seed)).program


def stair_sizes(program: BuildingProgram) -> set[tuple[float, ...]]:
    cores = program.vertical_connectivity.cores
    return {tuple(sorted((c.x[1] - c.x[0], c.y[1] - c.y[0]))) for c in cores if c.type == "stair"}


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("a two-storey house", (2, 4)),
        ("a townhouse of three storeys with ceilings of 2.4 m", (2, 4)),
        ("a villa of two storeys", (2, 5)),
        ("a house of two storeys with ceilings of 3.2 m", (2, 5)),
        ("an apartment building of four storeys", (3, 6)),
        ("a two-storey clinic", (3, 6)),
        ("a two-storey building with a shop below and a flat above", (3, 6)),
    ],
)
def test_a_home_has_a_smaller_stair_than_what_the_public_uses(text: str, size: tuple[int, int]) -> None:
    assert stair_sizes(plan(text)) == {size}


@settings(max_examples=25, deadline=None)
@given(
    st.sampled_from(["house", "townhouse", "duplex", "bungalow", "flat", "villa"]),
    st.integers(1, 2),
    st.integers(55, 160),
    st.integers(1, 3),
    st.integers(0, 50),
)
def test_every_home_has_somewhere_to_live_to_cook_and_to_wash(
    kind: str, storeys: int, area: int, bedrooms: int, seed: int
) -> None:
    # A storey needs about 20 m2 for its stair, passages and walls; bedrooms lie on one storey.
    area = max(area, storeys * (30 + 9 * bedrooms))
    text = f"a {kind} of {storeys} storeys and {area} m2 in all with {bedrooms} bedrooms"
    kinds = {room.room_type for floor in plan(text, seed).floors for room in floor.rooms}
    assert "living_room" in kinds, text
    assert kinds & {"kitchen", "open_kitchen", "kitchen_diner"}, text
    assert "bathroom" in kinds, text


def test_nothing_is_added_to_a_home_whose_rooms_are_all_stated() -> None:
    program = plan("a house with two bedrooms and a library, nothing else")
    kinds = [room.room_type for floor in program.floors for room in floor.rooms]
    assert not {"kitchen", "bathroom"} & set(kinds)


@pytest.mark.parametrize(
    "text",
    [
        "a maisonette on two floors, 96 m2 in total, with three bedrooms",
        "a duplex flat of 120 m2 with kitchen, living room and WC below, and three bedrooms and two bathrooms above",
        "a two-storey penthouse with three bedrooms",
        "a flat on three floors of 55 m2: kitchen, dining room and WC below, two bedrooms and a bathroom at the top",
    ],
)
def test_a_flat_with_a_stair_has_a_hallway_and_rooms_of_a_usual_size(text: str) -> None:
    for floor in plan(text).floors:
        areas = {room.id: room.area_estimate for room in floor.rooms}
        assert [room.room_type for room in floor.rooms].count("hallway") == 1
        assert areas["hallway"] < 0.35 * sum(areas.values())
        assert all(room.area_estimate >= 7.0 for room in floor.rooms if room.room_type == "bedroom")
        assert all(room.area_estimate <= 10.0 for room in floor.rooms if room.room_type in ("toilet", "bathroom"))


@pytest.mark.parametrize("passage", ["corridor", "hallway"])
def test_a_passage_that_a_flat_asks_for_is_what_its_rooms_are_reached_from(passage: str) -> None:
    (floor,) = plan(f"a flat of 85 m2 with a {passage}, a kitchen, a living room, two bedrooms and a bathroom").floors
    assert [room.id for room in floor.rooms if room.room_type in ("corridor", "hallway")] == [passage]


def test_a_flat_without_one_is_reached_through_its_living_room() -> None:
    (floor,) = plan("a flat of 70 m2 with two bedrooms").floors
    assert not {"corridor", "hallway"} & {room.room_type for room in floor.rooms}


@pytest.mark.parametrize(
    ("text", "below", "above"),
    [
        ("a two-storey house with three bedrooms and a bathroom", 0, 1),
        ("a two-storey house with a bathroom and three bedrooms", 0, 1),
        ("a house of two storeys with four bedrooms and two bathrooms", 0, 2),
        ("a two-storey house with two bedrooms and two bathrooms", 1, 1),
        ("a two-storey house with two bedrooms above and a bathroom on the ground floor", 1, 0),
    ],
)
def test_bathrooms_lie_by_the_bedrooms(text: str, below: int, above: int) -> None:
    found = [[room.room_type for room in floor.rooms].count("bathroom") for floor in plan(text).floors]
    assert found == [below, above]
