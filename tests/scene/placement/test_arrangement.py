"""What stands together stands as it is used: kitchens, beds, sofas and screens, tables and chairs."""

import numpy as np
import pytest

from mansion_msgs_py.placement import PlacementObject, PlacementOpening, PlacementResult, PlacementRoom, Relation
from mansion_scene.placement import place_room
from mansion_scene.placement.evaluation import Footprint, measure
from mansion_scene.placement.kitchen_runs import run_orders
from placement_rooms import item, rectangle, room

SEEDS = range(4)


def pieces(result: PlacementResult, name: str) -> list[Footprint]:
    return [Footprint(placed) for placed in result.placements if placed.name == name]


def kitchen(width: float, depth: float) -> PlacementRoom:
    beside = {"side_of": "counter_top"}
    return room(
        rectangle(width, depth),
        [((0.3, 0.0), (1.2, 0.0))],
        [
            item("counter_top", (1.2, 0.6, 0.9), 2, "edge", smaller=[(0.6, 0.6, 0.9)]),
            item("stove", (0.6, 0.62, 0.92), 1, "edge", **beside),
            item("kitchen_sink_unit", (1.0, 0.62, 1.15), 1, "edge", **beside),
            item("fridge", (0.8, 0.7, 1.8), 1, "edge"),
            item("shelf", (0.8, 0.3, 1.8), 1, "edge"),
        ],
        kind="kitchen",
        windows=[((1.4, depth), (2.6, depth))],
    )


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("width", "depth"), [(4.6, 3.4), (3.2, 4.0), (2.8, 4.2)])
def test_sink_hob_and_fridge_are_joined_by_worktops(width: float, depth: float, seed: int) -> None:
    asked = kitchen(width, depth)
    result = place_room(asked, seed=seed)
    assert measure(asked, result).collisions == 0
    run = [p for name in ("kitchen_sink_unit", "stove", "fridge", "counter_top") for p in pieces(result, name)]
    joined = {0}
    for _ in run:
        joined |= {i for i, p in enumerate(run) if any(p.shape.distance(run[j].shape) < 0.1 for j in joined)}
    assert {0, 1, 2} <= joined


@pytest.mark.parametrize("seed", SEEDS)
def test_a_hob_stands_before_no_window_where_another_wall_is_free(seed: int) -> None:
    (hob,) = pieces(place_room(kitchen(4.6, 3.4), seed=seed), "stove")
    assert not (abs(hob.centre[1] - 3.4) < 0.6 and 1.4 - 0.3 < hob.centre[0] < 2.6 + 0.3)


def test_a_run_keeps_a_worktop_between_sink_and_hob() -> None:
    for worktops in (2, 3, 5):
        for order in run_orders(worktops, ["fridge", "sink", "hob"]):
            assert "worktop" in order[order.index("sink") : order.index("hob")]


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("width", [2.6, 3.0, 4.2])
def test_bedside_tables_stand_at_either_side_of_the_head(width: float, seed: int) -> None:
    asked = room(
        rectangle(width, 3.6),
        [((0.2, 0.0), (1.1, 0.0))],
        [
            item("bed", (1.6, 2.1, 0.9), 1, "edge"),
            item("nightstand", (0.45, 0.4, 0.5), 2, side_of="bed", near="bed"),
            item("wardrobe", (1.2, 0.6, 2.0), 1, "edge"),
        ],
        kind="bedroom",
    )
    result = place_room(asked, seed=seed)
    (bed,) = pieces(result, "bed")
    sides = []
    for table in pieces(result, "nightstand"):
        aside, ahead = (float((table.centre - bed.centre) @ axis) for axis in (bed.u, bed.v))
        assert ahead < -bed.depth / 2 + 0.5
        assert bed.shape.distance(table.shape) < 0.3
        sides.append(aside > 0)
    assert sides
    assert len(set(sides)) == len(sides)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("windowed", [False, True])
def test_a_sofa_faces_the_screen_and_armchairs_their_table(windowed: bool, seed: int) -> None:
    windows = [((0.1, 4.0), (5.9, 4.0)), ((0.0, 0.1), (0.0, 3.9)), ((6.0, 0.1), (6.0, 3.9))] if windowed else []
    asked = room(
        rectangle(6.0, 4.0),
        [((0.2, 0.0), (1.1, 0.0))],
        [
            item("sofa", (2.0, 0.9, 0.95), 1, "edge"),
            item("media_console", (1.4, 0.4, 0.5), 1, "edge", center_aligned="sofa"),
            item("coffee_table", (1.0, 0.6, 0.4), in_front_of="sofa"),
            item("armchair", (0.8, 0.8, 0.8), 2, near="coffee_table"),
            item("bookshelf", (0.9, 0.35, 1.9), 1, "edge"),
        ],
        kind="living_room",
        windows=windows,
    )
    result = place_room(asked, seed=seed)
    (sofa,), (screen,), (table,) = (pieces(result, name) for name in ("sofa", "media_console", "coffee_table"))
    way = screen.centre - sofa.centre
    assert way @ sofa.v > 1.2
    assert abs(way @ sofa.u) < 0.5
    assert sofa.v @ screen.v < -0.9
    for chair in pieces(result, "armchair"):
        way = table.centre - chair.centre
        assert way @ chair.v / np.hypot(*way) > 0.4


@pytest.mark.parametrize("seed", SEEDS)
def test_chairs_that_find_no_side_of_their_table_are_left_out(seed: int) -> None:
    asked = room(
        rectangle(2.6, 2.4),
        [((0.2, 0.0), (1.1, 0.0))],
        [
            item("cupboard", (1.2, 0.5, 1.9), 1, "edge"),
            item("dining_table", (1.2, 0.8, 0.75), 1, "middle"),
            item("chair", (0.45, 0.5, 0.9), 6, around="dining_table"),
        ],
        kind="dining_room",
    )
    result = place_room(asked, seed=seed)
    (table,) = pieces(result, "dining_table")
    for chair in pieces(result, "chair"):
        ahead = chair.centre + chair.v * (chair.depth / 2 + 0.3)
        assert chair.shape.distance(table.shape) <= 0.2
        assert abs((ahead - table.centre) @ table.u) < table.width / 2 + 0.12
        assert abs((ahead - table.centre) @ table.v) < table.depth / 2 + 0.12


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize(("width", "depth"), [(4.0, 5.0), (6.0, 4.0), (8.0, 6.0)])
def test_a_reception_desk_looks_towards_the_way_in_with_its_chair_behind_it(
    width: float, depth: float, seed: int
) -> None:
    asked = room(
        rectangle(width, depth),
        [((0.2, 0.0), (width - 0.2, 0.0))],
        [
            item("reception_desk", (1.8, 0.8, 1.1), 1, "middle"),
            item("office_chair", (0.6, 0.6, 1.0), 1, near="reception_desk"),
        ],
        kind="reception",
    )
    result = place_room(asked, seed=seed)
    (desk,), (chair,) = pieces(result, "reception_desk"), pieces(result, "office_chair")
    assert desk.v[1] < -0.9
    assert (chair.centre - desk.centre) @ desk.v < 0.0


def test_seats_at_short_sides_of_restaurant_tables_are_in_their_middle() -> None:
    asked = room(
        rectangle(9.0, 7.0),
        [((6.6, 7.0), (8.4, 7.0))],
        [
            item("restaurant_table", (0.8, 0.8, 0.75), 9, "middle"),
            item("chair", (0.45, 0.5, 0.9), 36, around="restaurant_table"),
        ],
        kind="restaurant",
    )
    result = place_room(asked, seed=0)
    tables, chairs = (np.array([piece.centre for piece in pieces(result, n)]) for n in ("restaurant_table", "chair"))
    away = np.abs(chairs[:, None] - tables[None])
    nearest = away[np.arange(len(chairs)), np.hypot(*away.transpose(2, 0, 1)).argmin(axis=1)]
    assert np.mean(nearest.min(axis=1) < 0.05) > 0.7


def test_a_second_row_of_worktops_leaves_room_to_work_at_the_first() -> None:
    worktops = PlacementObject(
        name="counter_top", category="counter_top", size=(1.8, 0.6, 0.9), quantity=4, global_="edge"
    )
    sink = PlacementObject(
        name="kitchen_sink_unit",
        category="kitchen_sink_unit",
        size=(0.9, 0.6, 0.9),
        global_="edge",
        relative=[Relation(kind="side_of", target="counter_top")],
    )
    room = PlacementRoom(
        room_id="kitchen",
        room_type="kitchen",
        polygon=[(0, 0), (5.0, 0), (5.0, 1.8), (0, 1.8)],
        doors=[PlacementOpening(segment=((5.0, 0.4), (5.0, 1.3)))],
        objects=[worktops, sink],
    )
    placements = place_room(room, seed=0).placements
    assert placements
    assert len({round(p.rotation) % 360 for p in placements if p.name == "counter_top"} & {0, 180}) == 1
