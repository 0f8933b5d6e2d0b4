"""A lift's shaft, cabin and panels on one floor."""

import math
from collections.abc import Sequence
from typing import Final

from shapely.geometry import Polygon

from mansion_msgs_py.scene import LiftButton, LiftDetails
from mansion_msgs_py.shapes import Point, Point3, Ring, Segment
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS

__all__ = ["lift_details"]

_GAP: Final = 0.08  # between the cabin and the shaft's walls
_CABIN_HEIGHT: Final = 2.3
_PANEL_HEIGHT: Final = 1.1
_BUTTON_PITCH: Final = 0.07
_PANEL_OFFSET: Final = 0.25


def lift_details(
    net: Polygon,
    landing_door: Segment,
    outward: Point,
    floors: Sequence[int],
    labels: Sequence[str],
    *,
    goes_up: bool,
    comes_from_below: bool,
) -> LiftDetails:
    """Lay out a lift on one floor.

    Parameters
    ----------
    net : Polygon
        Net interior of the shaft.
    landing_door : Segment
        Clear opening of the landing door.
    outward : Point
        Unit vector from the shaft out through the landing door.
    floors, labels : sequence
        All floors of the building, ascending, and what their buttons say.
    """
    x0, y0, x1, y1 = net.bounds
    cabin = (x0 + _GAP, y0 + _GAP, x1 - _GAP, y1 - _GAP)
    ring: Ring = [(round(x, 4), round(y, 4)) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    panel = _button_panel(cabin, landing_door, outward)
    return LiftDetails(
        cabin=(
            (round(cabin[0], 4), round(cabin[1], 4), 0.0),
            (round(cabin[2], 4), round(cabin[3], 4), _CABIN_HEIGHT),
        ),
        facing=round(math.degrees(math.atan2(outward[1], outward[0])), 4) + 0.0,
        call_panel=_call_panel(landing_door, outward),
        button_panel=panel,
        buttons=_buttons(panel, floors, labels, outward),
        floor_opening=ring if comes_from_below else [],
        ceiling_opening=ring if goes_up else [],
    )


def _call_panel(door: Segment, outward: Point) -> Point3:
    """Return a place on the wall to the right of the door as one faces it from outside."""
    (ox, oy), right = outward, (-outward[1], outward[0])
    end = max(door, key=lambda p: p[0] * right[0] + p[1] * right[1])
    face = INTERIOR_THICKNESS / 2 + 0.01
    return (
        round(end[0] + right[0] * _PANEL_OFFSET + ox * face, 4),
        round(end[1] + right[1] * _PANEL_OFFSET + oy * face, 4),
        _PANEL_HEIGHT,
    )


def _button_panel(
    cabin: tuple[float, float, float, float], door: Segment, outward: Point
) -> Point3:
    """Return a place on the cabin's side wall next to the door."""
    (ox, oy), (rx, ry) = outward, (-outward[1], outward[0])
    cx, cy = (cabin[0] + cabin[2]) / 2, (cabin[1] + cabin[3]) / 2
    half_out = abs(ox) * (cabin[2] - cabin[0]) / 2 + abs(oy) * (cabin[3] - cabin[1]) / 2
    half_side = abs(rx) * (cabin[2] - cabin[0]) / 2 + abs(ry) * (cabin[3] - cabin[1]) / 2
    forward, side = half_out * 0.55, half_side - 0.05
    return (
        round(cx + ox * forward + rx * side, 4),
        round(cy + oy * forward + ry * side, 4),
        1.2,
    )


def _buttons(
    panel: Point3, floors: Sequence[int], labels: Sequence[str], outward: Point
) -> list[LiftButton]:
    """Return the buttons in two columns, the lowest floor below."""
    rows = (len(floors) + 1) // 2
    buttons = []
    for index, floor in enumerate(floors):
        row, column = divmod(index, 2)
        shift = (column - 0.5) * _BUTTON_PITCH
        buttons.append(
            LiftButton(
                floor=floor,
                label=labels[index] if index < len(labels) and labels[index] else str(floor),
                position=(
                    round(panel[0] + outward[0] * shift, 4),
                    round(panel[1] + outward[1] * shift, 4),
                    round(panel[2] + (row - (rows - 1) / 2) * _BUTTON_PITCH, 4),
                ),
            )
        )
    return buttons
