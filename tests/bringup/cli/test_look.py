"""``mansion look`` writes what the robot sees and leaves the session as it was."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_skills.vision.offscreen import GlThread


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    try:
        GlThread(64, 64).close()
    except MansionError as error:
        pytest.skip(str(error))
    folder = tmp_path_factory.mktemp("look") / "house"
    build_building(identified(BuildRequest(description="a two-storey house", floor_area=70.0)), folder)
    return folder


def look(house: Path, *options: str) -> None:
    result = CliRunner().invoke(app, ["look", str(house), *options], catch_exceptions=False)
    assert result.exit_code == 0


def picture(path: Path) -> np.ndarray:
    return np.array(Image.open(path))


def test_each_kind_of_picture_is_written_and_nothing_is_moved(house: Path, tmp_path: Path) -> None:
    for what in ("view", "depth", "segmentation", "panorama", "stairs"):
        look(house, "--what", what, "-o", str(tmp_path / f"{what}.png"))
        assert picture(tmp_path / f"{what}.png").std() > 5
    assert not (house / "state").exists()


def test_views_have_the_size_that_was_asked_and_turn(house: Path, tmp_path: Path) -> None:
    a, b = tmp_path / "a.png", tmp_path / "b.png"
    look(house, "--width", "300", "--height", "200", "-o", str(a))
    look(house, "--width", "300", "--height", "200", "--turn", "90", "-o", str(b))
    assert picture(a).shape == (200, 300, 3)
    assert (picture(a) != picture(b)).any()


def test_pages_of_landmarks_are_numbered(house: Path, tmp_path: Path) -> None:
    look(house, "--what", "landmarks", "--per-page", "2", "-o", str(tmp_path / "marks.png"))
    assert (tmp_path / "marks_1.png").exists()
    assert (tmp_path / "marks_2.png").exists()


def test_a_room_that_is_not_there_is_named(house: Path) -> None:
    with pytest.raises(MansionError, match="ballroom"):
        look(house, "--room", "ballroom")


def test_what_is_not_there_is_answered_with_what_is(house: Path, tmp_path: Path) -> None:
    with pytest.raises(MansionError) as caught:
        look(house, "--room", "bathrom", "-o", str(tmp_path / "a.png"))
    assert "did you mean F" in str(caught.value) and "bathroom" in str(caught.value)
    with pytest.raises(MansionError, match="there is no floor 9; floors: 1, 2"):
        look(house, "--floor", "9")
    with pytest.raises(MansionError) as caught:
        look(house, "--room", "F1/garage_99", "--floor", "2")
    assert "on floor 2" in str(caught.value) and "F1/" not in str(caught.value).split(";")[1]


def test_a_floor_is_looked_at_from_a_place_on_it(house: Path, tmp_path: Path) -> None:
    a, b = tmp_path / "a.png", tmp_path / "b.png"
    look(house, "-o", str(a))
    look(house, "--floor", "2", "-o", str(b))
    assert (picture(a) != picture(b)).any()
