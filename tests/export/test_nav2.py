"""Occupancy maps say where a wheeled robot may drive."""

import json

import msgspec
import numpy as np
import pytest

from mansion_export.nav2 import FREE, OCCUPIED, UNKNOWN, map_pgm, map_yaml, occupancy


def value(grid, x: float, y: float) -> int:
    return int(grid.data[grid.cell(x, y)])


def read_yaml(text: str) -> dict:
    """Read the flat mapping of numbers and words that the map server asks for."""
    header = {}
    for line in text.splitlines():
        key, value = line.split(": ", 1)
        try:
            header[key] = json.loads(value)
        except ValueError:
            header[key] = value
    return header


def test_rooms_are_free_walls_occupied_and_outside_unknown(ground):
    grid = occupancy(ground)
    assert value(grid, 5.0, 5.0) == FREE
    assert value(grid, 5.0, 8.5) == OCCUPIED
    assert value(grid, -0.5, -0.5) == UNKNOWN


def test_furniture_blocks_and_rugs_do_not(ground):
    grid = occupancy(ground)
    assert value(grid, 1.0, 9.0) == OCCUPIED
    assert value(grid, 3.9, 2.2) == FREE


@pytest.mark.parametrize(("is_open", "expected"), [(True, FREE), (False, OCCUPIED)])
def test_open_doors_are_passable_and_closed_ones_are_not(ground, is_open, expected):
    ground.doors[0] = msgspec.structs.replace(ground.doors[0], is_open=is_open)
    grid = occupancy(ground)
    assert value(grid, 2.45, 6.0) == expected


def test_missing_walls_are_passable_and_stairs_are_not(ground):
    grid = occupancy(ground)
    assert value(grid, 4.0, 4.0) == FREE
    assert value(grid, 12.5, 7.0) == OCCUPIED


def test_an_open_bedroom_is_reachable_from_the_hub(ground):
    grid = occupancy(ground)
    free = grid.data == FREE
    seen = np.zeros_like(free)
    queue = [grid.cell(5.0, 5.0)]
    while queue:
        i, j = queue.pop()
        if free[i, j] and not seen[i, j]:
            seen[i, j] = True
            queue += [(i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)]
    assert seen[grid.cell(3.5, 7.0)]
    assert not seen[grid.cell(10.0, 7.0)], "the lift's landing door is closed"


def test_map_files_load_as_the_map_server_reads_them(ground):
    content = map_pgm(ground)
    magic, size, depth, _ = content.split(b"\n", 3)
    width, height = (int(part) for part in size.split())
    assert (magic, depth) == (b"P5", b"255")
    pixels = np.frombuffer(content[-width * height :], dtype=np.uint8).reshape(height, width)
    header = read_yaml(map_yaml(ground))
    assert header["image"] == "map.pgm"
    assert header["mode"] == "trinary"
    assert header["resolution"] == 0.05
    assert header["negate"] == 0
    occupied = (255 - pixels) / 255.0
    trinary = np.where(
        occupied > header["occupied_thresh"], OCCUPIED, np.where(occupied < header["free_thresh"], FREE, UNKNOWN)
    )
    grid = occupancy(ground)
    assert np.array_equal(trinary[::-1], grid.data)
    assert tuple(header["origin"][:2]) == grid.origin


def test_origin_is_the_lower_left_corner_on_the_grid(ground):
    grid = occupancy(ground)
    x, y = grid.origin
    assert (x, y) == pytest.approx((-0.6, -0.6))
    assert round(x / grid.resolution) * grid.resolution == pytest.approx(x)
