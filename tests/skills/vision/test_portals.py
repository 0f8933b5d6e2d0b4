"""Whatever a straight line through the openings reaches is among the visible rooms."""

from math import atan2, cos, degrees, radians, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mansion_msgs_py.scene import Door
from mansion_msgs_py.shapes import Point
from mansion_skills.vision.portals import Portals, Wedge
from sample_building import scene

SCENE = scene(1, [1])
PORTALS = Portals(SCENE)
ROOMS = {"F1/hall": (0, 0, 12, 3), "F1/office": (0, 3, 6, 8), "F1/kitchen": (6, 3, 12, 8)}
DOORS = [door for door in SCENE.doors if set(door.rooms) <= set(ROOMS)]


@given(
    door=st.sampled_from(DOORS),
    side=st.integers(0, 1),
    eye=st.tuples(st.floats(0.02, 0.98), st.floats(0.02, 0.98)),
    through=st.floats(0.02, 0.98),
    beyond=st.floats(0.1, 1.0),
    aside=st.floats(-1.0, 1.0),
    half=st.floats(20.0, 60.0),
)
@settings(max_examples=150, deadline=None)
def test_no_room_that_a_line_of_sight_reaches_is_left_out(
    door: Door, side: int, eye: Point, through: float, beyond: float, aside: float, half: float
) -> None:
    here, there = str(door.rooms[side]), str(door.rooms[1 - side])
    x0, y0, x1, y1 = ROOMS[here]
    place = (x0 + eye[0] * (x1 - x0), y0 + eye[1] * (y1 - y0))
    (ax, ay), (bx, by) = door.segment
    point = (ax + through * (bx - ax), ay + through * (by - ay))
    bearing = atan2(point[1] - place[1], point[0] - place[0])
    target = (point[0] + beyond * cos(bearing), point[1] + beyond * sin(bearing))
    x0, y0, x1, y1 = ROOMS[there]
    assume(x0 <= target[0] <= x1 and y0 <= target[1] <= y1)
    # The camera looks somewhat past the opening; it is still within the picture.
    heading = degrees(bearing) + aside * 0.99 * half
    wedge = Wedge(-radians(half), radians(half))
    found = PORTALS.visible(here, place, heading, wedge, ())[there]
    seen = -radians(aside * 0.99 * half)
    assert found.low - 1e-6 <= seen <= found.high + 1e-6


def test_a_closed_door_ends_the_view() -> None:
    wedge = Wedge(-0.7, 0.7)
    view = PORTALS.visible("F1/hall", (2.45, 1.5), 90.0, wedge, ())
    assert {"F1/hall", "F1/office"} <= set(view)
    assert set(PORTALS.visible("F1/hall", (2.45, 1.5), 90.0, wedge, ["F1/door_1"])) == {"F1/hall"}


def test_a_room_behind_a_door_is_seen_in_the_door_only() -> None:
    view = PORTALS.visible("F1/hall", (2.45, 1.5), 90.0, Wedge(-0.7, 0.7), ())
    office = view["F1/office"]
    assert office.high - office.low == pytest.approx(2 * atan2(0.55, 1.5), abs=1e-6)


def test_doors_behind_the_camera_show_nothing() -> None:
    view = PORTALS.visible("F1/hall", (2.45, 1.5), 270.0, Wedge(-0.7, 0.7), ())
    assert set(view) == {"F1/hall"}


def test_who_stands_in_a_door_sees_both_rooms() -> None:
    view = PORTALS.visible("F1/hall", (2.45, 2.95), 180.0, Wedge(-0.7, 0.7), ())
    assert "F1/office" in view
