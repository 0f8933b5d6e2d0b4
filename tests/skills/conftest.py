"""The sample building, and a robot in it."""

from pathlib import Path

import pytest

from mansion_skills import Robot
from sample_building import write_building


@pytest.fixture
def building(tmp_path: Path) -> Path:
    return write_building(tmp_path / "building")


@pytest.fixture
def robot(request: pytest.FixtureRequest) -> Robot:
    """A robot in the sample building, with models to render where the tests are of pictures.

    One fixture for both: colcon runs these tests from the package's folder, where one that overrides it in a folder
    below would hold for all.
    """
    pictures = "vision" in request.path.parts
    folder: Path = request.getfixturevalue("pictured" if pictures else "building")
    return Robot(folder)
