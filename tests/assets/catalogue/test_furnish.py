"""What rooms are furnished with."""

from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_assets.catalogue import furnish_request, load_catalogue
from mansion_assets.catalogue.piece_counts import pieces
from mansion_msgs_py.codec import encode
from mansion_msgs_py.placement import MatrixStructure, PairedStructure
from mansion_msgs_py.program import RequestedObject

CATALOGUE = load_catalogue()
TYPES = st.sampled_from(CATALOGUE.room_types)


@settings(deadline=None, max_examples=80)
@given(room_type=TYPES, area=st.floats(2.0, 500.0), seed=st.integers(0, 10**6))
def test_a_request_is_well_formed_and_fits_its_share_of_the_room(room_type: str, area: float, seed: int) -> None:
    wishes = furnish_request(CATALOGUE, room_type, area, seed=seed, room_id="F1/r")
    names = [o.name for o in wishes.floor]
    assert len(set(names)) == len(names)
    quantity = {o.name: o.quantity for o in wishes.floor}
    for entry in wishes.floor:
        assert entry.size == wishes.floor_assets[entry.name].size
        assert all(r.target in quantity for r in entry.relative)
        if isinstance(entry.structure, PairedStructure):
            assert quantity[entry.structure.with_] == entry.quantity
        if isinstance(entry.structure, MatrixStructure):
            assert entry.structure.rows * entry.structure.cols == entry.quantity
        for size, asset in zip(entry.smaller, wishes.alternatives.get(entry.name, []), strict=True):
            assert asset.size == size
            assert wishes.asset_for(entry.name, size).size == size
    covered = sum(o.size[0] * o.size[1] * o.quantity for o in wishes.floor)
    assert covered <= 0.62 * area


def test_the_same_seed_gives_the_same_request_and_other_seeds_differ() -> None:
    def asked(seed: int) -> str:
        return encode(furnish_request(CATALOGUE, "living_room", 24.0, seed=seed, room_id="F1/a").floor)

    assert asked(3) == asked(3)
    assert len({asked(seed) for seed in range(20)}) >= 15


@pytest.mark.parametrize("room_type", ["open_office", "classroom", "cafeteria", "sales_area", "ward"])
def test_larger_rooms_get_more(room_type: str) -> None:
    counts = [
        sum(o.quantity for o in furnish_request(CATALOGUE, room_type, a, seed=1, room_id="r").floor)
        for a in (30.0, 60.0, 110.0)
    ]
    assert counts[0] < counts[1] < counts[2]


def test_desk_rows_are_a_matrix_with_paired_chairs() -> None:
    floor = furnish_request(CATALOGUE, "open_office", 150.0, seed=2, room_id="r").floor
    structures = {o.name: o.structure for o in floor}
    assert isinstance(structures["office_desk"], MatrixStructure)
    assert isinstance(structures["office_chair"], PairedStructure)


def test_essential_objects_are_there_in_small_rooms() -> None:
    for seed in range(10):
        names = {o.name for o in furnish_request(CATALOGUE, "bathroom", 4.2, seed=seed).floor}
        assert {"toilet", "washbasin"} <= names
        names = {o.name for o in furnish_request(CATALOGUE, "bedroom", 9.0, seed=seed).floor}
        assert {"bed", "wardrobe"} <= names


def test_shafts_and_voids_stay_empty() -> None:
    assert furnish_request(CATALOGUE, "elevator_shaft", 4.0, seed=0).floor == []


def test_a_building_keeps_to_its_own_variants_more_often_than_not() -> None:
    chairs = [
        furnish_request(CATALOGUE, "private_office", 14.0, seed=5, style="x", room_id=f"r{i}")
        .floor_assets["bookshelf"]
        .key
        for i in range(30)
    ]
    assert max(chairs.count(key) for key in set(chairs)) >= 15


def _numbers(room_type: str, area: float, category: str, count: int) -> Counter[str]:
    request = furnish_request(
        CATALOGUE, room_type, area, seed=0, requested=[RequestedObject(category=category, count=count, exact=True)]
    )
    numbers = Counter[str]()
    for thing in request.floor:
        asset = request.floor_assets[thing.name]
        numbers[asset.category] += thing.quantity * pieces(category, asset)
    return numbers


def test_shelves_of_a_number_are_all_the_shelves_of_a_shop() -> None:
    numbers = _numbers("sales_area", 180.0, "bookshelf", 14)
    assert {name: n for name, n in numbers.items() if name.endswith("shelf")} == {"bookshelf": 14}


@pytest.mark.parametrize(
    ("room_type", "category", "count", "noun"),
    [
        ("restaurant", "chair", 8, "chair"),
        ("waiting_room", "chair", 8, "chair"),
        ("cafe", "bar_stool", 8, "stool"),
        ("classroom", "desk", 10, "desk"),
        ("open_office", "desk", 5, "desk"),
        ("cafe", "round_table", 7, "table"),
    ],
)
def test_a_room_has_no_more_of_a_noun_than_are_asked_for(room_type: str, category: str, count: int, noun: str) -> None:
    numbers = _numbers(room_type, 40.0, category, count)
    assert sum(n for name, n in numbers.items() if name.endswith((f"_{noun}", "_seat")) or name == noun) == count


def test_other_nouns_stay_when_a_number_is_asked_for() -> None:
    numbers = _numbers("bar", 40.0, "chair", 5)
    assert (numbers["cafe_chair"], numbers["bar_stool"] > 0) == (5, True)


def test_seats_of_a_council_stand_though_its_tables_stand_before_the_chair() -> None:
    request = furnish_request(
        CATALOGUE, "council_chamber", 185.0, seed=0, requested=[RequestedObject(category="chair", count=60)]
    )
    assert (
        sum(thing.quantity for thing in request.floor if request.floor_assets[thing.name].category == "meeting_chair")
        >= 60
    )


def test_a_long_piece_that_is_asked_for_stands_lengthwise_in_a_narrow_room() -> None:
    asked = [RequestedObject(category="exam_table", count=1)]
    request = furnish_request(CATALOGUE, "consultation_room", 12.5, seed=0, extent=(6.2, 2.05), requested=asked)
    assert "exam_table" in {asset.category for asset in request.floor_assets.values()}


@pytest.mark.parametrize("sides", [(9.0, 6.5), (12.0, 8.0), (20.9, 13.0), (26.0, 14.0)])
def test_a_pool_leaves_a_deck_to_walk_around_it(sides: tuple[float, float]) -> None:
    asked = [RequestedObject(category="pool_basin", count=1)]
    area = sides[0] * sides[1]
    floor = furnish_request(CATALOGUE, "indoor_pool", area, seed=2, extent=sides, requested=asked).floor
    (pool,) = [o for o in floor if o.name.startswith("pool_basin")]
    assert all(side - length >= 2 * 0.9 for side, length in zip(sides, pool.size))


def test_a_lobby_leaves_the_desk_to_a_reception_beside_it() -> None:
    def has_desk(*beside: str) -> bool:
        wishes = furnish_request(CATALOGUE, "lobby", 60.0, seed=1, room_id="F1/lobby", beside=beside)
        return any(entry.name == "reception_desk" for entry in wishes.floor)

    assert has_desk()
    assert not has_desk("reception")
    assert not has_desk("open_office", "service_counter")
    assert has_desk("ticket_office")  # visitors are received in the hall, wherever tickets are sold


def test_a_terrace_of_a_home_has_one_table_and_a_place_to_lounge() -> None:
    counts = {o.category: o.quantity for o in furnish_request(CATALOGUE, "home_terrace", 60.0, seed=1).floor}
    assert counts["patio_table"] == 1 and counts["patio_chair"] == 4
    assert {"loveseat", "barbecue", "planter_box", "lounger"} <= counts.keys()


def test_a_womens_restroom_has_no_urinals() -> None:
    men, women = (
        {o.category for o in furnish_request(CATALOGUE, name, 24.0, seed=1).floor}
        for name in ("restroom", "womens_restroom")
    )
    assert "urinal" in men and "urinal" not in women and "toilet_stall" in women


def test_a_garage_for_two_has_two_cars() -> None:
    counts = {o.category: o.quantity for o in furnish_request(CATALOGUE, "double_garage", 38.0, seed=1).floor}
    assert counts["garage_car"] == 2


def test_a_lobby_leaves_the_counter_to_the_reception() -> None:
    alone = {o.category for o in furnish_request(CATALOGUE, "lobby", 60.0, seed=1).floor}
    beside = {o.category for o in furnish_request(CATALOGUE, "lobby", 60.0, seed=1, beside=["reception"]).floor}
    assert "reception_desk" in alone and not {"reception_desk", "office_chair"} & beside


def test_a_large_store_has_racks_in_rows_and_a_small_one_along_its_walls() -> None:
    def racks(area: float) -> dict[str, int]:
        floor = furnish_request(CATALOGUE, "storage", area, seed=1, room_id="F1/storage").floor
        return {o.name: o.quantity for o in floor if o.name in ("metal_shelf", "storage_rack")}

    assert set(racks(12.0)) == {"metal_shelf"}
    assert set(racks(70.0)) == {"storage_rack"} and racks(70.0)["storage_rack"] >= 12


def test_a_living_room_has_no_table_where_the_kitchen_has() -> None:
    def tables(room_type: str, *beside: str) -> int:
        floor = furnish_request(CATALOGUE, room_type, 33.0, seed=1, beside=beside).floor
        return sum(o.category in ("dining_table", "round_table") for o in floor)

    assert tables("living_room", "kitchen") == 1
    assert tables("living_room", "kitchen_diner") == 0
    assert tables("kitchen", "dining_room") == 0


def test_each_lobby_sofa_has_its_own_table_and_chairs() -> None:
    counts = {o.name: o.quantity for o in furnish_request(CATALOGUE, "lobby", 90.0, seed=1).floor}
    assert counts["reception_sofa"] >= 3
    assert counts["coffee_table"] == counts["reception_sofa"]
    assert counts["lounge_chair"] >= counts["reception_sofa"]


def test_rows_that_are_asked_for_are_as_many_and_as_long_as_the_room_allows() -> None:
    asked = [RequestedObject(category="pallet_rack", count=6, rows=6)]
    wishes = furnish_request(CATALOGUE, "warehouse", 480.0, seed=1, extent=(28.0, 17.0), requested=asked)
    (racks,) = [o for o in wishes.floor if o.category == "pallet_rack"]
    assert isinstance(racks.structure, MatrixStructure)
    assert racks.structure.rows == 6 and racks.structure.cols >= 8


def test_an_accessible_bathroom_has_a_shower_and_bars_and_no_tub() -> None:
    wishes = furnish_request(CATALOGUE, "accessible_bathroom", 6.0, seed=1)
    assert {"shower_cabin", "pedestal_sink"} <= {o.category for o in wishes.floor}
    assert not any(o.category == "bathtub" for o in wishes.floor)
    assert sum(w.count for w in wishes.wall if w.asset.category == "grab_bar") >= 2
