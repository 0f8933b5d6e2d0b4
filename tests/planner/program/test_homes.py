"""Homes have small stairs, a hallway or a living room in the middle, and always a place to live, cook and wash in."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.bands import Segment
from mansion_planner.program.blocks import DOOR, Block
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.home_orders import best_sketch, home_orders
from mansion_planner.program.model import Massing, Placement, Sketch, short_edges, touching
from mansion_planner.program.plan_quality import aspect, shallow_garages
from mansion_planner.program.planned_rooms import planned_room

MASSING = Massing(length=12.0, north=4.0, corridor=1.0, south=4.0, cores=())


def sketched(text: str, seed: int) -> PlannedBuilding:
    request, knowledge = BuildRequest(description=text, seed=seed), default_knowledge()
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(seed, "program"))


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


@pytest.mark.parametrize("brief", ["a two-storey house", "a townhouse", "a villa"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_the_hall_of_a_home_is_no_longer_than_its_doors_need(brief: str, seed: int) -> None:
    building = sketched(brief, seed)
    for index, sketch in building.sketches.items():
        (hall,) = sketch.corridors
        _, low, end, high = hall.boxes[0]
        fronts = [box for p in sketch.rooms for box in p.boxes if p.parent == hall.id]
        doors = [box[0] for box in fronts if low in (box[1], box[3]) or high in (box[1], box[3])]
        assert end <= max(max(doors), *(core.box[2] for core in building.massing.cores)) + DOOR + 0.8
        assert not short_edges(sketch)
        assert hall.area < 0.24 * building.envelopes[index].area


def test_the_rest_of_a_hall_goes_to_a_room_of_free_area_and_no_bathroom() -> None:
    for seed in range(3):
        building = sketched("a two-storey house with a living room of 24 m2", seed)
        for placement in (p for sketch in building.sketches.values() for p in sketch.rooms):
            low, high = building.massing.south, building.massing.south + building.massing.corridor
            if any(box[1] == low and box[3] == high for box in placement.boxes):
                assert not placement.room.fixed and not placement.room.kind.wet


@pytest.mark.parametrize("brief", ["a two-storey house", "a villa", "a house with four bedrooms and a utility room"])
def test_kitchen_dining_and_living_room_are_one_group(brief: str) -> None:
    sketch = sketched(brief, 0).sketches[1]
    kitchens = [p for p in sketch.rooms if p.room.kind.name == "kitchen"]
    days = [p for p in sketch.rooms if p.room.kind.name in ("dining_room", "living_room")]
    assert kitchens and any(touching(a, b) for a in kitchens for b in days)


def test_the_widest_rooms_are_tried_at_the_end_of_the_hall() -> None:
    knowledge = default_knowledge()
    blocks = tuple(
        Block(planned_room(knowledge.room(name), knowledge)) for name in ("living_room", "bathroom", "bedroom")
    )
    segment = Segment("main", True, 0.0, 12.0, 5.0, 4.0, blocks=blocks)
    orders = [[block.host.kind.name for block in order[0].blocks] for order in home_orders([segment])]
    assert orders[0] == [block.host.kind.name for block in blocks]
    assert orders[1][-1] == "living_room"
    assert all(order[-1] != "bathroom" for order in orders)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    "brief", ["a two-storey house with a garage", "a bungalow with a garage", "a villa with a double garage"]
)
def test_cars_drive_into_a_garage_along_its_length(brief: str, seed: int) -> None:
    sketch = sketched(brief, seed).sketches[1]
    assert any("garage" in placement.room.id for placement in sketch.rooms)
    assert not shallow_garages(sketch)


def test_a_garage_for_two_cars_is_wider_than_one_for_one() -> None:
    one, two = (
        next(room for room in plan(f"a house with {garage}").floors[0].rooms if "garage" in room.id)
        for garage in ("a garage", "a double garage")
    )
    assert two.room_type == "double_garage" and two.area_estimate > one.area_estimate + 8.0


@pytest.mark.parametrize(
    "brief",
    ["a studio flat", "a studio flat of 34 m2 for a single person", "a small studio of 30 m2 with a sleeping area"],
)
def test_a_studio_is_one_room_and_a_bathroom(brief: str) -> None:
    kinds = {room.room_type for room in plan(brief).floors[0].rooms}
    assert {"studio_room", "bathroom"} <= kinds
    assert not kinds & {"kitchen", "laundry_room", "home_office", "library_room"}


@pytest.mark.parametrize("brief", ["a two-storey house", "a house with four bedrooms and a utility room", "a villa"])
def test_halls_of_homes_take_no_more_than_their_share(brief: str) -> None:
    building = sketched(brief, 0)
    floor = sum(building.envelopes[storey.index].area for storey in building.storeys)
    halls = sum(corridor.area for sketch in building.sketches.values() for corridor in sketch.corridors)
    assert halls < 0.16 * floor


def test_blocks_change_places_where_that_brings_rooms_together() -> None:
    knowledge = default_knowledge()
    names = ("kitchen", "bedroom", "living_room", "home_office")
    segment = Segment(
        "main", True, 0.0, 12.0, 5.0, 4.0,
        blocks=tuple(Block(planned_room(knowledge.room(name), knowledge)) for name in names),
    )  # fmt: skip

    def lay(order: list[Segment]) -> Sketch:
        placed = [
            Placement(block.host, [part.world(box, x0, MASSING) for box in [(0.0, 0.0, x1 - x0, part.depth)]], "hall")
            for part in order
            for block, x0, x1 in part.laid()
        ]
        return Sketch([], placed, {})

    def price(sketch: Sketch) -> tuple[float, float, float]:
        rooms = {placement.room.kind.name: placement for placement in sketch.rooms}
        return 0.0, float(not touching(rooms["kitchen"], rooms["living_room"])), 0.0

    assert price(lay([segment]))[1] == 1.0
    assert price(best_sketch([segment], lay, price))[1] == 0.0


@pytest.mark.parametrize("area", [22, 25, 28, 31, 34, 37, 40, 48])
@pytest.mark.parametrize("kind", ["studio flat", "tiny house", "one-bedroom flat"])
def test_a_small_home_has_a_bathroom_and_a_place_to_cook(kind: str, area: int) -> None:
    types = {room.room_type for room in plan(f"A {kind} of {area} m2 for a single person").floors[0].rooms}
    assert "bathroom" in types
    assert types & {"kitchen", "studio_room"}


def test_who_lives_in_a_studio_gets_no_bedroom_beside_it() -> None:
    types = [room.room_type for room in plan("A studio flat of 34 m2 for a single person").floors[0].rooms]
    assert "bedroom" not in types


def test_a_home_has_no_room_twice_that_only_fills_up() -> None:
    text = "A luxury villa of 740 m2 on two floors with a basement: great room, kitchen; three bedrooms upstairs"
    program = plan_building(BuildRequest(description=text)).program
    kinds = [room.room_type for floor in program.floors for room in floor.rooms if not room.notes]
    for name in ("playroom", "game_room", "home_office", "guest_room"):
        assert kinds.count(name) <= 1


def test_a_living_and_dining_room_leaves_no_other_place_to_live_and_dine() -> None:
    text = "A bungalow of 130 m2: living-dining room 34 m2, kitchen 14 m2, bedroom 18 m2, a guest room and a bathroom"
    program = plan_building(BuildRequest(description=text)).program
    kinds = [room.room_type for room in program.floors[0].rooms]
    assert kinds.count("living_room") == 1 and "dining_room" not in kinds


@pytest.mark.parametrize(
    "text",
    [
        "A two-bedroom flat of 75 square metres with a kitchen, living room, bathroom and a storage room.",
        "A two-bedroom flat of 80 m2 with an open kitchen and a balcony.",
    ],
)
def test_the_living_room_that_the_others_line_is_no_strip(text: str) -> None:
    (sketch,) = sketched(text, 0).sketches.values()
    assert aspect(sketch.corridors[0].boxes) < 2.2
