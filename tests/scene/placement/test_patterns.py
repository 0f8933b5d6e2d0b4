"""Matrices of seats and of what only just fits a room."""

import itertools

import numpy as np
import pytest

from mansion_msgs_py.placement import (
    MatrixStructure,
    PlacedObject,
    PlacementObject,
    PlacementOpening,
    PlacementRoom,
    Relation,
)
from mansion_scene.placement import place_room


def hall(width: float, depth: float, rows: int, cols: int) -> PlacementRoom:
    """Return a hall with rows of three seats each."""
    return PlacementRoom(
        room_id="hall",
        room_type="cinema_hall",
        polygon=[(0, 0), (width, 0), (width, depth), (0, depth)],
        doors=[PlacementOpening(segment=((1, 0), (2.6, 0)))],
        objects=[
            PlacementObject(
                name="cinema_seat",
                size=(1.8, 0.85, 1.05),
                quantity=rows * cols,
                global_="middle",
                structure=MatrixStructure(rows=rows, cols=cols),
            )
        ],
    )


@pytest.mark.parametrize("seed", range(3))
def test_an_audience_sits_shoulder_to_shoulder(seed: int) -> None:
    result = place_room(hall(10.0, 10.0, 4, 4), seed=seed)
    seats = result.placements
    assert len(seats) == 16
    along = np.radians(seats[0].rotation)
    places = sorted({round(s.center[0] * np.cos(along) + s.center[1] * np.sin(along), 3) for s in seats})
    assert len(places) == 4
    assert np.diff(places).max() < 1.8 + 0.05


@pytest.mark.parametrize("seed", range(3))
def test_a_block_that_just_fits_is_found(seed: int) -> None:
    result = place_room(hall(8.7, 6.6, 3, 4), seed=seed)
    assert len(result.placements) == 12


def dining(width: float, depth: float, rows: int, cols: int) -> PlacementRoom:
    """Return a dining room with tables of four."""
    count = rows * cols
    return PlacementRoom(
        room_id="dining",
        room_type="restaurant",
        polygon=[(0, 0), (width, 0), (width, depth), (0, depth)],
        doors=[PlacementOpening(segment=((1, 0), (2.6, 0)))],
        objects=[
            PlacementObject(
                name="restaurant_table",
                size=(0.9, 0.9, 0.75),
                quantity=count,
                global_="middle",
                structure=MatrixStructure(rows=rows, cols=cols),
            ),
            PlacementObject(
                name="dining_chair",
                size=(0.45, 0.5, 0.85),
                quantity=4 * count,
                relative=[Relation(kind="around", target="restaurant_table")],
            ),
        ],
    )


@pytest.mark.parametrize("seed", range(3))
def test_guests_pass_between_tables_where_fewer_tables_leave_room(seed: int) -> None:
    # All twelve fit only with the chairs of two tables back to back.
    result = place_room(dining(10.0, 8.0, 3, 4), seed=seed)
    chairs = [p for p in result.placements if p.name == "dining_chair"]
    tables = [p for p in result.placements if p.name == "restaurant_table"]
    assert 8 <= len(tables) <= 12

    def table_of(chair: PlacedObject) -> int:
        return min(range(len(tables)), key=lambda i: float(np.hypot(*np.subtract(tables[i].center, chair.center))))

    for one, other in itertools.combinations(chairs, 2):
        if table_of(one) != table_of(other):
            assert max(np.abs(np.subtract(one.center, other.center))) > 0.5 + 0.3


def test_no_chair_stands_without_its_table() -> None:
    result = place_room(dining(4.2, 4.2, 3, 4), seed=0)
    tables = sum(p.name == "restaurant_table" for p in result.placements)
    assert sum(p.name == "dining_chair" for p in result.placements) <= 4 * tables < 48


@pytest.mark.parametrize("seed", range(3))
def test_an_audience_has_leg_room_and_a_view(seed: int) -> None:
    seats = place_room(hall(12.0, 9.0, 5, 4), seed=seed).placements
    angle = np.radians(seats[0].rotation)
    ahead = np.array([-np.sin(angle), np.cos(angle)])
    rows = np.unique(np.round([np.dot(seat.center, ahead) for seat in seats], 3))
    assert np.diff(rows).min() >= 0.85 + 0.5 - 1e-3
    corners = np.array([(0, 0), (12, 0), (12, 9), (0, 9)]) @ ahead
    assert corners.max() - rows.max() >= 2.0


def rows_of(
    category: str, size: tuple[float, float, float], width: float, depth: float, shape: tuple[int, int]
) -> PlacementRoom:
    """Return a hall with rows of one thing over its floor."""
    rows, cols = shape
    return PlacementRoom(
        room_id="hall",
        room_type="warehouse",
        polygon=[(0, 0), (width, 0), (width, depth), (0, depth)],
        doors=[PlacementOpening(segment=((1, 0), (4, 0)))],
        objects=[
            PlacementObject(
                name=category,
                category=category,
                size=size,
                quantity=rows * cols,
                global_="middle",
                structure=MatrixStructure(rows=rows, cols=cols),
            )
        ],
    )


def test_pallet_racks_stand_back_to_back_with_aisles_for_forklifts() -> None:
    placements = place_room(rows_of("pallet_rack", (2.7, 1.1, 4.0), 18.0, 16.0, (4, 4)), seed=0).placements
    assert len(placements) == 16
    across = np.radians(placements[0].rotation + 90.0)
    lines = sorted({round(p.center[0] * np.cos(across) + p.center[1] * np.sin(across), 2) for p in placements})
    gaps = np.diff(lines) - 1.1
    assert gaps[[0, 2]].max() < 0.2  # the two rows of a pair
    assert gaps[1] >= 2.6  # a forklift turns between pairs
    assert len({round(p.rotation) % 360 for p in placements}) == 2


def test_beds_in_rows_do_not_touch() -> None:
    placements = place_room(rows_of("kids_bed", (0.75, 1.5, 0.6), 6.0, 6.0, (3, 3)), seed=0).placements
    assert len(placements) == 9
    for one, other in itertools.combinations(placements, 2):
        dx, dy = (abs(a - b) for a, b in zip(one.center, other.center, strict=True))
        assert max(dx, dy) > 1.2


def test_an_audience_looks_along_a_long_room() -> None:
    seats = place_room(hall(16.0, 8.0, 5, 2), seed=1).placements
    assert len(seats) == 10
    assert all(abs(np.sin(np.radians(seat.rotation))) > 0.9 for seat in seats)


def nave(width: float, depth: float, rows: int) -> PlacementRoom:
    """Return a nave with an altar and two columns of pews."""
    return PlacementRoom(
        room_id="nave",
        room_type="chapel",
        polygon=[(0, 0), (width, 0), (width, depth), (0, depth)],
        doors=[PlacementOpening(segment=((1, 0), (2.6, 0)))],
        objects=[
            PlacementObject(name="altar", category="altar", size=(2.0, 0.9, 1.0), global_="edge"),
            PlacementObject(
                name="pew",
                category="pew",
                size=(3.0, 0.6, 0.95),
                quantity=2 * rows,
                global_="middle",
                structure=MatrixStructure(rows=rows, cols=2),
            ),
        ],
    )


@pytest.mark.parametrize("seed", range(3))
def test_pews_leave_an_aisle_to_the_altar_at_the_end_of_a_nave(seed: int) -> None:
    placed = place_room(nave(9.0, 18.0, 8), seed=seed).placements
    (altar,) = [item for item in placed if item.name == "altar"]
    pews = [item for item in placed if item.name == "pew"]
    assert len(pews) == 16
    assert min(altar.center[1], 18.0 - altar.center[1]) < 1.0
    assert np.diff(sorted({round(pew.center[0], 3) for pew in pews})).max() >= 3.0 + 0.8


def lobby(width: float, depth: float, sofas: int) -> PlacementRoom:
    """Return a lobby with groups of a sofa, a table and two chairs."""
    return PlacementRoom(
        room_id="lobby",
        room_type="lobby",
        polygon=[(0, 0), (width, 0), (width, depth), (0, depth)],
        doors=[PlacementOpening(segment=((1, 0), (3, 0)))],
        objects=[
            PlacementObject(name="sofa", category="sofa", size=(2.2, 0.9, 0.8), quantity=sofas, global_="middle"),
            PlacementObject(
                name="coffee_table",
                category="coffee_table",
                size=(1.0, 0.6, 0.45),
                quantity=sofas,
                relative=[Relation(kind="in_front_of", target="sofa")],
            ),
            PlacementObject(
                name="lounge_chair",
                category="lounge_chair",
                size=(0.75, 0.75, 0.75),
                quantity=2 * sofas,
                relative=[Relation(kind="near", target="coffee_table")],
            ),
        ],
    )


def gaps_of_sofas(placements: list[PlacedObject]) -> list[float]:
    """Return the distances between the middles of sofas, metres."""
    sofas = [p.center for p in placements if p.name == "sofa"]
    return [float(np.hypot(a[0] - b[0], a[1] - b[1])) for a, b in itertools.combinations(sofas, 2)]


@pytest.mark.parametrize("seed", range(3))
def test_groups_of_seats_stand_apart_over_a_large_lobby(seed: int) -> None:
    placements = place_room(lobby(12.0, 8.0, 3), seed=seed).placements
    counts = [sum(p.name == name for p in placements) for name in ("sofa", "coffee_table", "lounge_chair")]
    assert counts[0] >= 2 and counts[1] == counts[0] and counts[2] >= counts[0]
    assert min(gaps_of_sofas(placements)) > 2.4


def test_no_group_of_seats_fills_a_passage() -> None:
    placements = place_room(lobby(14.0, 2.4, 3), seed=0).placements
    sofas = [p for p in placements if p.name == "sofa"]
    assert all(min(p.center[1], 2.4 - p.center[1]) < 0.6 for p in sofas)  # along a wall, if at all


@pytest.mark.parametrize("category", ["library_stack", "gondola_shelf"])
def test_people_walk_between_rows_of_shelves(category: str) -> None:
    shelf = PlacementObject(
        name=category, category=category, size=(2.0, 0.55, 2.1), quantity=24, global_="middle",
        structure=MatrixStructure(rows=6, cols=4),
    )  # fmt: skip
    room = PlacementRoom(
        room_id="stacks",
        room_type="book_stacks",
        polygon=[(0, 0), (9, 0), (9, 6), (0, 6)],
        doors=[PlacementOpening(segment=((0, 1), (0, 2)))],
        objects=[shelf],
    )
    shelves = place_room(room, seed=0).placements
    assert len(shelves) >= 8
    along = np.radians(shelves[0].rotation)
    rows = sorted({round(-s.center[0] * np.sin(along) + s.center[1] * np.cos(along), 3) for s in shelves})
    assert len(rows) == 1 or np.diff(rows).min() > 0.55 + 0.74
