"""The sample building, and a robot in it."""

from pathlib import Path

import pytest

from mansion_skills import Robot
from sample_building import write_building


@pytest.fixture
def building(tmp_path: Path) -> Path:
    return write_building(tmp_path / "building")


@pytest.fixture
def robot(building: Path) -> Robot:
    return Robot(building)
