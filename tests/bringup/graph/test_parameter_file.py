"""The installed parameter file names every parameter of every node, with its default."""

import os
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
import yaml

from mansion_bringup.graph.processes import GRAPH_NODES, NodeProcess

rclpy = pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")

FILE = Path(__file__).resolve().parents[3] / "src" / "mansion_bringup" / "config" / "mansion.yaml"
GIVEN_BY_ROS = {"use_sim_time", "start_type_description_service"}


def node_class(entry: NodeProcess) -> type[Any]:
    """The node class that an executable runs."""
    from mansion_msgs_py.nodes.node import MansionNode

    kinds = [
        kind
        for kind in vars(import_module(entry.module)).values()
        if isinstance(kind, type) and issubclass(kind, MansionNode) and kind is not MansionNode
    ]
    assert len(kinds) == 1
    return kinds[0]


@pytest.fixture
def context() -> Iterator[None]:
    arguments = ["--ros-args", "-r", "__ns:=/mansion"]
    rclpy.init(args=arguments, domain_id=150 + os.getpid() % 50)
    yield
    rclpy.try_shutdown()


def test_it_is_the_nodes_own_defaults(context: None) -> None:
    listed = {
        (node, name): (type(value), value)
        for node, entry in yaml.safe_load(FILE.read_text(encoding="utf-8")).items()
        for name, value in entry["ros__parameters"].items()
    }
    declared: dict[tuple[str, str], tuple[type, Any]] = {}
    for entry in GRAPH_NODES:
        node = node_class(entry)()
        names = [name for name in node.list_parameters([], 0).names if name not in GIVEN_BY_ROS]
        for name in names:
            value = node.get_parameter(name).value
            declared[node.get_fully_qualified_name(), name] = (type(value), value)
        node.destroy_node()
    assert listed == declared


def test_every_node_starts_with_it(context: None) -> None:
    from rclpy.parameter import Parameter

    for entry in GRAPH_NODES:
        cli = ["--ros-args", "--params-file", str(FILE)]
        probe = rclpy.create_node(entry.executable, cli_args=cli, automatically_declare_parameters_from_overrides=True)
        names = [name for name in probe.list_parameters([], 0).names if name not in GIVEN_BY_ROS]
        assert names, entry.executable
        assert all(probe.get_parameter(name).type_ is not Parameter.Type.NOT_SET for name in names)
        probe.destroy_node()
