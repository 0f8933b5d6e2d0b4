"""Panoramas, pages of landmarks, the lift's panel and the stair's arrows."""

from math import cos, pi, radians, sin
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills import Robot
from mansion_skills.vision import Camera
from mansion_skills.vision.annotated_pictures import (
    ACCENT,
    DOWN,
    TILE,
    UP,
    Button,
    fitted,
    font,
    panel_picture,
    tile_pages,
    with_arrows,
    wrapped,
)
from mansion_skills.vision.mjcf_model import PATTERNS, pattern_of, pattern_png
from mansion_skills.vision.panorama import FARTHEST, HEIGHT, VIEW, WIDTH, core_viewpoint, stitch, view_yaws


def view_of(yaw: float) -> np.ndarray:
    """A view of a world in which red is the direction and green the slope."""
    cx, cy = VIEW.center
    columns, rows = np.meshgrid(np.arange(VIEW.width), np.arange(VIEW.height))
    x, y = (columns - cx) / VIEW.focal, (cy - rows) / VIEW.focal
    azimuth = np.radians(yaw) - np.arctan(x)
    slope = y / np.hypot(1.0, x)
    red, green = 127 + 100 * np.cos(azimuth), 127 + 100 * slope
    return np.stack([red, green, np.zeros_like(red)], axis=-1).round().astype(np.uint8)


@given(middle=st.floats(-360.0, 360.0))
@settings(max_examples=3, deadline=None)
def test_a_panorama_shows_each_direction_where_it_belongs(middle: float) -> None:
    picture = stitch([view_of(yaw) for yaw in view_yaws(middle)]).astype(float)
    assert picture.shape == (HEIGHT, WIDTH, 3)
    azimuth = np.radians(middle) + pi - 2 * pi * (np.arange(WIDTH) + 0.5) / WIDTH
    slope = HEIGHT * pi / WIDTH * (1 - 2 * (np.arange(HEIGHT) + 0.5) / HEIGHT)
    assert np.abs(picture[..., 0] - (127 + 100 * np.cos(azimuth))[None, :]).max() < 2.5
    assert np.abs(picture[..., 1] - (127 + 100 * slope)[:, None]).max() < 2.5


def places(count: int) -> list[tuple[str, np.ndarray]]:
    return [(f"F1/room_{i}", np.full((HEIGHT, WIDTH, 3), 40 + i, dtype=np.uint8)) for i in range(count)]


@given(count=st.integers(0, 20), per_page=st.integers(1, 16))
@settings(max_examples=6, deadline=None)
def test_every_landmark_is_on_one_page_in_full_size(count: int, per_page: int) -> None:
    pages = tile_pages(places(count), "Landmarks", per_page)
    assert len(pages) == -(-count // per_page)
    for number, page in enumerate(pages):
        for i in range(per_page * number, min(per_page * (number + 1), count)):
            assert (page == 40 + i).all(axis=-1).sum() >= 0.99 * TILE[0] * TILE[1]
    if pages:
        assert len({page.shape[1] for page in pages}) == 1


@pytest.mark.parametrize("per_page", [0, 17])
def test_pages_that_nobody_can_read_are_refused(per_page: int) -> None:
    with pytest.raises(MansionError) as error:
        tile_pages(places(3), "Landmarks", per_page)
    assert error.value.code == ErrorCode.INVALID_PAYLOAD


def test_long_names_are_made_to_fit() -> None:
    text, chosen = fitted("F12/consultation_and_examination_room_17_north", 150, 26)
    assert chosen.getlength(text) <= 150
    assert text.startswith("F12")
    assert text.endswith("north")
    assert fitted("short", 150, 26)[0] == "short"


def lit(picture: np.ndarray, color: tuple[int, int, int]) -> int:
    return int((picture == np.array(color)).all(axis=-1).sum())


def test_a_panel_has_a_button_for_each_floor_and_lights_the_current_one() -> None:
    buttons = [Button(f, "G" if f == 1 else str(f), f != 3) for f in range(1, 9)]
    panel = panel_picture("elevator_1", buttons, 2)
    none = panel_picture("elevator_1", buttons, 99)
    assert 2000 < lit(panel, ACCENT) - lit(none, ACCENT) < 5000
    served = panel_picture("elevator_1", [Button(b.floor, b.label) for b in buttons], 2)
    assert (served != panel).any()
    beside = panel_picture("elevator_1", buttons, 2, np.zeros((480, 480, 3), dtype=np.uint8))
    assert beside.shape[1] > panel.shape[1]


@pytest.mark.parametrize("ways", [(None, None), ("Up to 2", None), (None, "Down to G"), ("Up", "Down")])
def test_arrows_point_only_where_stairs_lead(ways: tuple[str | None, str | None]) -> None:
    view = np.full((480, 480, 3), 120, dtype=np.uint8)
    picture = with_arrows(view, *ways).astype(int)
    green = np.abs(picture - np.array(UP)).sum(axis=-1) < 40
    orange = np.abs(picture - np.array(DOWN)).sum(axis=-1) < 40
    assert bool(green.sum() > 2000) is (ways[0] is not None)
    assert bool(orange.sum() > 2000) is (ways[1] is not None)
    if ways == (None, None):
        assert (picture == view).all()


def test_floor_patterns_are_the_same_every_time() -> None:
    for pattern in PATTERNS:
        assert pattern_png(pattern) == pattern_png(pattern)
    assert {p.name for p in PATTERNS} == {
        pattern.name
        for material in ("white_ceramic", "herringbone_oak", "grey_carpet", "terrazzo")
        if (pattern := pattern_of(material)) is not None
    }
    assert pattern_of("white_drywall") is None


def test_the_robot_gets_all_pictures_of_its_building(camera: Camera, robot: Robot) -> None:
    landmarks = robot.list_landmarks().landmarks
    assert camera.panorama("office").shape == (HEIGHT, WIDTH, 3)
    pages = camera.landmark_pages(per_page=2)
    assert len(pages) == -(-len(landmarks) // 2)
    assert np.array_equal(camera.landmark_pages(per_page=2)[0], pages[0])
    assert (camera.landmark_pages(per_page=2, floor=2)[0] != pages[0]).any()
    assert lit(camera.lift_panel(), ACCENT) > 1000
    ground = camera.stairs_view().astype(int)
    assert (np.abs(ground - np.array(DOWN)).sum(axis=-1) < 40).sum() < 100
    robot.go_to_landmark("stairs")
    robot.take_stairs("Up")
    first = camera.stairs_view().astype(int)
    assert (np.abs(first - np.array(DOWN)).sum(axis=-1) < 40).sum() > 1000


def test_what_is_not_there_is_named(camera: Camera) -> None:
    with pytest.raises(MansionError) as error:
        camera.panorama("ballroom")
    assert error.value.code == ErrorCode.NOT_FOUND
    with pytest.raises(MansionError):
        camera.landmark_pages(floor=17)


@given(st.text(st.characters(codec="ascii", min_codepoint=32), max_size=90), st.integers(90, 400))
@settings(max_examples=40, deadline=None)
def test_wrapped_rows_fit_and_keep_all_words(text: str, width: int) -> None:
    rows = wrapped(text, width, 13)
    assert all(font(13).getlength(row) <= width for row in rows)
    if not any("…" in row for row in rows):
        assert " ".join(rows).split() == text.split()


@pytest.mark.parametrize("kind", ["elevator", "stair"])
def test_a_core_is_looked_at_from_before_its_door(building: Path, kind: str) -> None:
    robot = Robot(building)
    session = robot.engine.session(robot.session)
    for floor in session.world.building.floors:
        grid = session.world.view(floor).map
        for core in (core for core in grid.scene.cores if core.type == kind):
            x, y, yaw = core_viewpoint(grid, core)
            door = next(door for door in grid.scene.doors if door.id == core.door)
            (ax, ay), (bx, by) = door.segment
            toward = (ax + bx) / 2 - x, (ay + by) / 2 - y
            assert grid.is_free(x, y)
            assert grid.room_at(x, y) == grid.room_at(core.entrance[0], core.entrance[1])
            assert np.allclose((cos(radians(yaw)), sin(radians(yaw))), toward / np.hypot(*toward))
            near = core_viewpoint(grid, core, 0.0)
            assert np.hypot(near[0] - x, near[1] - y) <= FARTHEST + 1e-6


def test_a_tile_shows_the_middle_of_the_round_above_and_what_is_behind_below() -> None:
    round_ = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    round_[:, WIDTH // 2 - 20 : WIDTH // 2 + 20] = (255, 0, 0)
    round_[:, :20] = round_[:, -20:] = (0, 0, 255)
    (page,) = tile_pages([("stair_1", round_)], "Landmarks")
    above, below = page[-TILE[1] - 12 : -12 - TILE[1] // 2], page[-12 - TILE[1] // 2 : -12]
    red, blue = (np.nonzero((half[..., c] > 200) & (half[..., 1] < 50))[1] for half, c in ((above, 0), (below, 2)))
    middle = page.shape[1] / 2
    assert abs(red.mean() - middle) < 3
    assert abs(blue.mean() - middle) < 3
