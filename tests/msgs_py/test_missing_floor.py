"""A scene that leads to a floor of which ``building.json`` says nothing."""

from pathlib import Path

import pytest

from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import ErrorCode, MansionError
from sample_building import write_building


def test_a_floor_that_the_building_does_not_have_is_named(tmp_path: Path) -> None:
    folder = BuildingFolder(write_building(tmp_path / "house"))
    with pytest.raises(MansionError, match="has no floor 9; floors are 1, 2, 3") as caught:
        folder.entry(9)
    assert caught.value.code == ErrorCode.NOT_FOUND
