"""What the launch file starts, read through stand-ins that take what Jazzy's launch and launch_ros take."""

import runpy
import sys
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from mansion_bringup.graph.processes import GRAPH_NODES

PACKAGE = Path(__file__).resolve().parents[3] / "src" / "mansion_bringup"


@dataclass
class Configuration:
    """``launch.substitutions.LaunchConfiguration``."""

    name: str

    def perform(self, context: Any) -> str:
        return context.launch_configurations[self.name]


@dataclass
class Argument:
    """``launch.actions.DeclareLaunchArgument``."""

    name: str
    default_value: str
    description: str
    choices: list[str] | None = None


@dataclass(kw_only=True)
class NodeAction:
    """``launch_ros.actions.Node``, with the keywords of ``ExecuteProcess`` that are used."""

    package: str
    executable: str
    name: str | None = None
    namespace: str | None = None
    parameters: list[Any] = field(default_factory=list)
    arguments: list[str] = field(default_factory=list)
    ros_arguments: list[str] = field(default_factory=list)
    remappings: list[tuple[str, str]] = field(default_factory=list)
    output: str = "log"
    respawn: bool = False
    respawn_delay: float = 0.0


@pytest.fixture
def description(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What `generate_launch_description` returns: the arguments, then the function that makes the nodes."""
    modules = {
        "launch": {"LaunchDescription": list},
        "launch.actions": {"DeclareLaunchArgument": Argument, "OpaqueFunction": lambda *, function: function},
        "launch.substitutions": {"LaunchConfiguration": Configuration},
        "launch_ros": {},
        "launch_ros.actions": {"Node": NodeAction},
        "ament_index_python": {},
        "ament_index_python.packages": {"get_package_share_directory": lambda name: f"/share/{name}"},
    }
    for name, content in modules.items():
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)
    loaded = runpy.run_path(str(PACKAGE / "launch" / "mansion.launch.py"))
    found: list[Any] = loaded["generate_launch_description"]()
    return found


def started(description: list[Any], **given: str) -> dict[str, NodeAction]:
    """The nodes by executable, for arguments as on the command line."""
    *arguments, make = description
    values = {argument.name: argument.default_value for argument in arguments}
    assert given.keys() <= values.keys()
    context = SimpleNamespace(launch_configurations=values | {"lend_client": "false"} | given)
    return {action.executable: action for action in make(context)}


def test_every_argument_has_a_default_and_says_what_it_is(description: list[Any]) -> None:
    for argument in description[:-1]:
        assert argument.description
        assert argument.choices is None or argument.default_value in argument.choices


def test_all_nodes_of_the_graph_start_below_mansion(description: list[Any]) -> None:
    nodes = started(description)
    assert list(nodes) == [entry.executable for entry in GRAPH_NODES]
    for entry in GRAPH_NODES:
        node = nodes[entry.executable]
        assert (node.package, node.name, node.namespace) == (entry.package, entry.executable, "/mansion")
        assert node.ros_arguments == ["--log-level", "info"]
        assert (node.parameters, node.output, node.respawn) == ([], "screen", False)


def test_parameter_files_come_after_the_switches_and_the_own_one_last(description: list[Any], tmp_path: Path) -> None:
    every, own = str(tmp_path / "all.yaml"), str(tmp_path / "own.yaml")
    for path in (every, own):
        Path(path).touch()
    nodes = started(description, params_file=every, skill_server_params=own, use_sim_time="true")
    assert nodes["skill_server"].parameters == [{"use_sim_time": True}, every, own]
    assert nodes["floor_solver"].parameters == [{"use_sim_time": True}, every]


def test_a_parameter_file_that_is_missing_is_named(description: list[Any]) -> None:
    for name in ("params_file", "skill_server_params"):
        with pytest.raises(RuntimeError, match=rf"{name}:=/nowhere.yaml: there is no such file"):
            started(description, **{name: "/nowhere.yaml"})


def test_two_buildings_have_names_frames_and_clocks_of_their_own(description: list[Any]) -> None:
    nodes = started(description, namespace="site_b", frame_prefix="site_b/", use_sim_time="true")
    assert {"frame_prefix": "site_b/"} in nodes["skill_server"].parameters
    assert all(node.remappings == [("/clock", "/site_b/clock")] for node in nodes.values())
    nodes = started(description, namespace="site_b", robot_namespace="/", use_sim_time="true")
    assert {"robot_namespace": "/"} in nodes["skill_server"].parameters
    assert all(node.remappings == [] for node in nodes.values())
    assert all(node.remappings == [] for node in started(description, use_sim_time="true").values())


def test_the_clock_is_published_by_the_skill_server_alone(description: list[Any]) -> None:
    nodes = started(description, publish_clock="true")
    assert nodes.pop("skill_server").parameters == [{"publish_clock": True}]
    assert all(node.parameters == [] for node in nodes.values())


def test_nodes_come_back_and_rviz_opens_its_view_when_asked(description: list[Any]) -> None:
    nodes = started(description, respawn="true", rviz="true", namespace="/site/mansion")
    view = nodes.pop("rviz2")
    assert view.arguments == ["-d", "/share/mansion_bringup/rviz/mansion.rviz"]
    assert (PACKAGE / "rviz" / "mansion.rviz").is_file()
    assert all(node.respawn and node.namespace == "/site/mansion" for node in nodes.values())


def test_the_director_alone_lends_its_client_unless_told_otherwise(description: list[Any]) -> None:
    lends = {argument.name: argument for argument in description[:-1]}["lend_client"]
    assert lends.default_value == "true"
    nodes = started(description, lend_client="true")
    assert nodes.pop("building_director").parameters == [{"lend_client": True}]
    assert all(node.parameters == [] for node in nodes.values())


def test_every_node_is_told_where_services_may_write(description: list[Any]) -> None:
    nodes = started(description, allow="/srv/buildings:/data")
    assert all(node.parameters == [{"allow": ["/srv/buildings", "/data"]}] for node in nodes.values())
