"""What holds for every placement: hard constraints, counts, determinism; and what a good one looks like."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.placement import PlacementObject, PlacementOpening, PlacementResult, PlacementRoom
from mansion_scene.placement import PlacementOptions, place_room
from mansion_scene.placement.evaluation import Footprint, measure
from placement_rooms import classroom, item, rectangle, restaurant, room, ward

ROOMS = {"classroom": classroom, "ward": ward, "restaurant": restaurant}


def assert_sound(asked: PlacementRoom, result: PlacementResult) -> None:
    """Every hard constraint, measured with exact polygons, and nothing lost silently."""
    found = measure(asked, result)
    assert (found.outside, found.collisions, found.blocked) == (0, 0, 0)
    assert found.reachable == found.placed == found.usable
    assert found.edges_backed == found.edges
    for obj in asked.objects:
        placed = sum(p.name == obj.name for p in result.placements)
        lost = sum(d.count for d in result.discarded if d.name == obj.name)
        assert placed + lost == obj.quantity
    assert all(d.count > 0 and d.reason for d in result.discarded)
    assert len({p.id for p in result.placements}) == len(result.placements)


@st.composite
def any_room(draw: st.DrawFn) -> PlacementRoom:
    """A rectangle, L, room with a column or bevelled room with a mix of objects, often more than fit."""
    w, d = draw(st.floats(2.6, 8.0)), draw(st.floats(2.6, 7.0))
    w, d = round(w, 2), round(d, 2)
    shape = draw(st.sampled_from(["rectangle", "ell", "column", "bevel"]))
    polygon, holes = rectangle(w, d), []
    if shape == "ell":
        polygon = [(0, 0), (w, 0), (w, d / 2), (w / 2, d / 2), (w / 2, d), (0, d)]
    elif shape == "column":
        holes = [[(w - 0.9, d - 0.9), (w - 0.5, d - 0.9), (w - 0.5, d - 0.5), (w - 0.9, d - 0.5)]]
    elif shape == "bevel":
        polygon = [(0, 0), (w, 0), (w, d / 2), (w * 0.7, d), (0, d)]
    doors = [((0.4, 0.0), (1.3, 0.0))]
    if draw(st.booleans()):
        doors.append(((0.0, d * 0.4), (0.0, d * 0.4 + 0.9)))
    size = st.floats(0.25, 1.6).map(lambda v: round(v, 2))
    objects: list[PlacementObject] = []
    for k in range(draw(st.integers(1, 7))):
        where = draw(st.sampled_from(["edge", "middle", "unconstrained"]))
        name = draw(st.sampled_from(["shelf", "table", "chair", "plant", "bed"])) + f"_{k}"
        own = (draw(size), draw(size), draw(st.sampled_from([0.5, 1.8])))
        kind = draw(st.sampled_from(["single", "single", "matrix", "paired", "relative"]))
        if kind == "matrix":
            objects.append(item(name, own, where=where, matrix=(draw(st.integers(1, 3)), 2)))
        elif kind == "paired" and objects:
            host = objects[-1]
            objects.append(item(name, own, host.quantity, where, paired=host.name))
        elif kind == "relative" and objects:
            relation = draw(st.sampled_from(["near", "far", "in_front_of", "around", "side_of"]))
            target = draw(st.sampled_from(objects)).name
            objects.append(item(name, own, draw(st.integers(1, 3)), where, **{relation: target}))
        else:
            objects.append(item(name, own, draw(st.integers(1, 4)), where))
    return room(polygon, doors, objects, holes=holes, windows=[((0.2, d), (1.0, d))])


@given(any_room(), st.integers(0, 3))
@settings(deadline=None, max_examples=25, suppress_health_check=[HealthCheck.too_slow])
def test_any_room_gets_a_sound_placement(asked: PlacementRoom, seed: int) -> None:
    quick = PlacementOptions(effort=30_000, moves=6)
    assert_sound(asked, place_room(asked, seed=seed, options=quick))


@pytest.mark.parametrize("make", ROOMS.values(), ids=ROOMS.keys())
@pytest.mark.parametrize("seed", range(3))
def test_ordinary_rooms_hold_everything(make, seed: int) -> None:  # type: ignore[no-untyped-def]
    asked = make()
    result = place_room(asked, seed=seed)
    assert_sound(asked, result)
    found = measure(asked, result)
    assert found.placed == found.asked
    assert found.relations_held == found.relations
    assert found.pairs_near == found.pairs
    assert found.around_near == found.around
    assert found.row_deviation == pytest.approx(0.0, abs=1e-6)
    assert found.column_deviation == pytest.approx(0.0, abs=1e-6)


def test_same_seed_same_bytes_and_other_seeds_other_rooms() -> None:
    first, again, other = (place_room(restaurant(), seed=s) for s in (5, 5, 6))
    assert encode_bytes(first) == encode_bytes(again)
    assert [p.center for p in first.placements] != [p.center for p in other.placements]


def test_asked_sizes_are_kept() -> None:
    asked = classroom()
    sizes = {obj.name: obj.size for obj in asked.objects}
    assert all(p.size == sizes[p.name] for p in place_room(asked, seed=1).placements)


@pytest.mark.parametrize("seed", range(3))
def test_a_class_looks_at_its_teacher(seed: int) -> None:
    items = [Footprint(p) for p in place_room(classroom(), seed=seed).placements]
    teacher = next(i for i in items if i.name == "teacher_desk")
    chairs = [i for i in items if i.name == "student_chair"]
    assert all(float(chair.v @ teacher.v) == pytest.approx(-1.0) for chair in chairs)


def test_chairs_face_their_tables() -> None:
    items = [Footprint(p) for p in place_room(restaurant(), seed=2).placements]
    tables = [i for i in items if i.name == "table"]
    for chair in (i for i in items if i.name == "chair"):
        table = min(tables, key=lambda t: chair.shape.distance(t.shape))
        towards = table.centre - chair.centre
        assert float(chair.v @ towards) > 0.7 * float(np.hypot(*towards))


def test_rows_of_beds_face_each_other_with_heads_at_walls() -> None:
    result = place_room(ward(), seed=0)
    beds = [Footprint(p) for p in result.placements if p.name == "bed"]
    assert sorted(float(bed.v @ beds[0].v) for bed in beds) == pytest.approx([-1.0] * 3 + [1.0] * 3)


def test_tall_things_keep_away_from_windows() -> None:
    window = ((0.5, 3.0), (3.5, 3.0))
    asked = room(
        rectangle(4, 3),
        [((0, 0.5), (0, 1.4))],
        [item("wardrobe", (1.2, 0.6, 2.0), 2, "edge"), item("chest", (1.0, 0.4, 0.5), 1, "edge")],
        windows=[window],
    )
    for seed in range(4):
        for p in place_room(asked, seed=seed).placements:
            if p.name == "wardrobe":
                shape = Footprint(p).shape
                assert shape.bounds[3] <= 2.7 + 1e-6 or not 0.5 < shape.centroid.x < 3.5


def test_a_matrix_that_does_not_fit_is_reduced_and_said_so() -> None:
    asked = room(
        rectangle(4, 4), [((0.3, 0), (1.2, 0))], [item("desk", (1.0, 0.8, 0.75), where="middle", matrix=(4, 4))]
    )
    result = place_room(asked, seed=0)
    assert_sound(asked, result)
    assert 0 < len(result.placements) < 16
    assert "4 x 4 matrix was reduced" in result.discarded[0].reason


def test_a_smaller_asset_stands_in_only_where_offered() -> None:
    big, small = (2.5, 1.2, 0.8), (1.2, 0.6, 0.8)
    for smaller, placed in (((), 0), ((small,), 1)):
        asked = room(rectangle(2.2, 2.4), [((0.3, 0), (1.2, 0))], [item("sofa", big, smaller=smaller)])
        result = place_room(asked, seed=0)
        assert [p.size for p in result.placements] == [small] * placed


def test_without_margins_no_path_is_narrower_than_asked() -> None:
    asked = room(rectangle(3, 3), [((0.3, 0), (1.2, 0))], [item("crate", (0.7, 0.7, 0.8), 8, "edge")])
    loose = place_room(asked, seed=0, options=PlacementOptions(tight=False))
    dense = place_room(asked, seed=0)
    assert_sound(asked, loose)
    assert len(loose.placements) <= len(dense.placements)


def test_a_door_on_the_wall_centre_line_is_moved_to_the_boundary() -> None:
    asked = room(rectangle(4, 4), [((1, -0.06), (2, -0.06))], [item("shelf", (0.8, 0.3, 1.8), 6, "edge")])
    result = place_room(asked, seed=0)
    on_wall = room(rectangle(4, 4), [((1, 0.0), (2, 0.0))], asked.objects)
    assert_sound(on_wall, result)


def test_a_room_without_doors_is_furnished() -> None:
    asked = room(rectangle(4, 4), [], [item("shelf", (0.8, 0.3, 1.8), 3, "edge")])
    assert len(place_room(asked, seed=0).placements) == 3


@pytest.mark.parametrize(
    ("objects", "path"),
    [
        ([item("a", (1, 1, 1)), item("a", (1, 1, 1))], "$.objects[1].name"),
        ([item("a", (1, 1, 1), near="b")], "$.objects[0].relative[0].target"),
        ([item("a", (1, 1, 1), paired="b")], "$.objects[0].structure.with"),
    ],
)
def test_faulty_requests_are_refused_with_their_place(objects: list[PlacementObject], path: str) -> None:
    with pytest.raises(MansionError) as refused:
        place_room(room(rectangle(4, 4), [], objects), seed=0)
    assert refused.value.info.path == path


def test_a_polygon_that_crosses_itself_is_refused() -> None:
    with pytest.raises(MansionError, match="simple"):
        place_room(room([(0, 0), (2, 2), (2, 0), (0, 2)], [], []), seed=0)


def test_circular_relations_are_placed_all_the_same() -> None:
    asked = room(
        rectangle(5, 5), [((1, 0), (2, 0))], [item("a", (0.6, 0.6, 1), near="b"), item("b", (0.6, 0.6, 1), near="a")]
    )
    result = place_room(asked, seed=0)
    assert_sound(asked, result)
    assert measure(asked, result).relations_held == 2


def test_a_reception_desk_faces_who_comes_from_outside_rather_than_the_wider_way_to_the_hall() -> None:
    desk = PlacementObject(name="reception_desk", category="reception_desk", size=(2.4, 0.9, 1.1), global_="middle")
    room = PlacementRoom(
        room_id="reception",
        room_type="reception",
        polygon=[(0, 0), (5, 0), (5, 5), (0, 5)],
        doors=[
            PlacementOpening(segment=((1.5, 0), (3.3, 0)), is_outer=True),
            PlacementOpening(segment=((0.5, 5), (4.5, 5)), is_open=True),
        ],
        objects=[desk],
    )
    (placed,) = place_room(room, seed=0).placements
    assert placed.rotation == pytest.approx(180.0)
