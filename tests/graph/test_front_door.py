"""The front door over a running graph: the same names, done by its nodes."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import mansion
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphProcesses

pytestmark = pytest.mark.graph


@pytest.fixture(scope="module")
def connected(graph: GraphProcesses) -> Iterator[mansion.Graph]:
    """A connection to the running graph."""
    with mansion.connect(domain_id=graph.options.domain_id) as found:
        yield found


@pytest.fixture(scope="module")
def flat(connected: mansion.Graph, tmp_path_factory: pytest.TempPathFactory) -> mansion.Building:
    """A flat that the graph built, with a model of its floor."""
    folder = tmp_path_factory.mktemp("graph") / "flat"
    return connected.build("a small flat for two", folder, seed=4, formats="mjcf")


def test_a_plan_is_that_of_this_process(connected: mansion.Graph) -> None:
    assert (
        connected.plan("a small flat for two", seed=4).program == mansion.plan("a small flat for two", seed=4).program
    )


def test_a_building_is_that_of_this_process(flat: mansion.Building, tmp_path: Path) -> None:
    here = mansion.build("a small flat for two", tmp_path / "here", seed=4)
    assert here.floors == flat.floors and here.objects == flat.objects


def test_an_edit_lands_through_the_scene_editor_and_is_undone(flat: mansion.Building) -> None:
    before = flat.objects
    done = flat.edit("put a red mug on the coffee table")
    assert done.added.ids == ("F1/living_room/mug_1",)
    assert done.added.ids[0] in (flat.folder / "floors/floor_1/model.xml").read_text()
    assert not (flat.folder / "floors/floor_1/house.json").exists()
    assert flat.undo().removed.ids == done.added.ids
    assert flat.objects == before
    with pytest.raises(mansion.MansionError, match="parameter `physics`"):
        flat.edit("put a red mug on the coffee table", physics="static")


def test_a_robot_runs_the_skills_of_the_skill_server(flat: mansion.Building) -> None:
    for session, room in (("", "kitchen"), ("front_door", "bathroom")):
        robot = flat.robot(session)
        assert robot.go_to(room).status.value == "SUCCESS"
        assert robot.where_am_i().room == f"F1/{room}"
        assert robot.pick_up("moon").status.value == "INVALID_ACTION"
    with pytest.raises(mansion.MansionError, match="did you mean landmark"):
        robot.go_to_landmark(landmrk="kitchen")


def test_the_command_line_runs_the_same_skills(flat: mansion.Building, graph: GraphProcesses) -> None:
    flat.robot("shell")
    environment = {**os.environ, "ROS_DOMAIN_ID": str(graph.options.domain_id)}
    ran = [
        subprocess.run(
            [sys.executable, "-m", "mansion_bringup", "skill", *words, "--session", "shell"],
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
            env=environment,
        )
        for words in (["WhereAmI"], ["PickUp", '{"object": "moon"}'], ["WhereAmI", '{"roam": 1}'])
    ]
    assert [done.returncode for done in ran] == [0, 1, 1]
    assert json.loads(ran[0].stdout)["session"] == "shell"
    assert json.loads(ran[1].stdout)["status"] == "INVALID_ACTION"
    assert "INVALID_PAYLOAD" in ran[2].stderr


def test_a_robot_sees_through_the_camera_topic(flat: mansion.Building) -> None:
    pytest.importorskip("mujoco")
    robot = flat.robot("eyes")
    before = robot.look()
    robot.rotate(180)
    assert before.ndim == 3 and before.shape[2] == 3 and before.std() > 1
    with pytest.raises(mansion.MansionError, match="skill_server"):
        robot.look(width=64)


def test_without_a_graph_the_error_says_how_to_start_one() -> None:
    with pytest.raises(mansion.MansionError, match="mansion up") as caught:
        mansion.connect(domain_id=free_domain())
    assert caught.value.code == "UNAVAILABLE"
