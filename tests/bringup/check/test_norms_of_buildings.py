"""Finished buildings have the exits that the rules ask for, and are sound with them."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mansion_bringup.check.norms import norms_of_folder
from mansion_bringup.cli.app import app
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.request import BuildRequest


@pytest.fixture(scope="module")
def restaurant(tmp_path_factory: pytest.TempPathFactory) -> Path:
    request = BuildRequest(description="a restaurant", seed=0)
    return build_building(request, tmp_path_factory.mktemp("norms") / "restaurant").path


def test_a_restaurant_has_two_exits_far_apart_and_no_fault(restaurant: Path) -> None:
    scene = BuildingFolder(restaurant).scenes()[0]
    exits = [door for door in scene.doors if door.kind == "entrance"]
    (x0, y0), (x1, y1) = (door.segment[0] for door in exits)
    assert abs(x0 - x1) + abs(y0 - y1) > 6.0
    assert verify_building(restaurant) == []
    assert "exits" not in {item.rule for item in norms_of_folder(restaurant)}


def test_the_command_fails_for_deviations_only_where_it_is_asked_for_them(restaurant: Path) -> None:
    plain = CliRunner().invoke(app, ["check", str(restaurant)])
    assert plain.exit_code == 0
    found = CliRunner().invoke(app, ["check", str(restaurant), "--norms", "--json"])
    deviations = json.loads(found.stdout)["deviations"]
    assert [item["rule"] for item in deviations] == [item.rule for item in norms_of_folder(restaurant)]
    assert found.exit_code == int(any(not item["caused_by"] and item["severity"] == "deviation" for item in deviations))
