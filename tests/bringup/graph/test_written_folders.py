"""Where services may write: as the user said at the start, whatever a caller or a parameter says later."""

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from mansion_bringup.graph.processes import GRAPH_NODES, GraphOptions, GraphProcesses
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import BuildJob

rclpy = pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")

Start = Callable[..., Any]


@pytest.fixture
def start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Start]:
    """Make a director that builds nothing, whose working and temporary folder is ``here``."""
    from mansion_bringup.nodes import building_director

    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    monkeypatch.setattr("mansion_msgs_py.allowed_folders.SYSTEM_TEMPORARY", tmp_path / "here")
    monkeypatch.setattr("tempfile.gettempdir", lambda: str(tmp_path / "here"))
    made: list[Any] = []

    def make(*parameters: str) -> Any:
        options = [part for parameter in parameters for part in ("-p", parameter)]
        rclpy.init(args=["--ros-args", *options], domain_id=150 + os.getpid() % 50)
        made.append(building_director.BuildingDirector())
        return made[0]

    yield make
    for node in made:
        node.destroy_node()
    rclpy.try_shutdown()


def output(director: Any, place: Path | None) -> Path:
    job = BuildJob(description="a flat", building_id="flat", output=None if place is None else str(place))
    folder: Path = director._output(job, BuildRequest(description="a flat", building_id="flat"))
    return folder


def refusal(director: Any, place: Path | None) -> MansionError:
    with pytest.raises(MansionError) as caught:
        output(director, place)
    return caught.value


def test_a_build_goes_below_the_working_folder_or_a_named_one(start: Start, tmp_path: Path) -> None:
    director = start(f"allow:=['{tmp_path}/named']")
    for place in (tmp_path / "here" / "a", tmp_path / "named" / "b"):
        assert output(director, place) == place
    assert output(director, None) == Path("buildings/flat")
    error = refusal(director, tmp_path / "other")
    assert (error.code, error.info.path) == (ErrorCode.FORBIDDEN, "$.output")
    assert str(tmp_path / "named") in error.info.message


def test_the_folder_for_buildings_without_one_counts_as_named_at_the_start_alone(start: Start, tmp_path: Path) -> None:
    director = start(f"output_root:={tmp_path}/root")
    assert output(director, None) == tmp_path / "root" / "flat"
    parameter = rclpy.parameter.Parameter("output_root", value=str(tmp_path / "later"))
    director.set_parameters([parameter])
    assert refusal(director, None).code == ErrorCode.FORBIDDEN


def test_nobody_widens_it_later(start: Start) -> None:
    answer = start().set_parameters([rclpy.parameter.Parameter("allow", value=["/"])])[0]
    assert not answer.successful and "read-only" in answer.reason


def test_the_home_of_a_user_that_there_is_not_is_refused(start: Start) -> None:
    assert refusal(start(), Path("~nobody_of_that_name/a")).code == ErrorCode.NOT_FOUND


def test_every_node_process_gets_the_folders_that_the_user_names(tmp_path: Path) -> None:
    graph = GraphProcesses(GraphOptions(allow=(tmp_path, Path("with space"))))
    for node in GRAPH_NODES:
        assert f'allow:=["{tmp_path}","{Path.cwd()}/with space"]' in graph.command(node)
