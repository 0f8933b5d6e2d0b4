"""Matrices of seats and of what only just fits a room."""

import numpy as np
import pytest

from mansion_msgs_py.placement import MatrixStructure, PlacementObject, PlacementOpening, PlacementRoom
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
