"""Commands and clients stay on this machine unless the environment or a sourced ROS 2 says otherwise."""

import os

import pytest

from mansion_bringup import client as client_module
from mansion_bringup.client import MansionClient
from mansion_bringup.discovery import CHOICES, keep_to_this_machine, kept_to_this_machine

LOOPBACK = "<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast></General></Domain></CycloneDDS>"


def test_the_range_is_this_machine_where_nothing_is_chosen() -> None:
    environment: dict[str, str] = {}
    keep_to_this_machine(environment)
    assert environment == {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


@pytest.mark.parametrize("name", CHOICES)
def test_a_choice_of_the_user_is_left_alone(name: str) -> None:
    environment = {name: "SUBNET"}
    keep_to_this_machine(environment)
    with kept_to_this_machine(environment):
        assert environment == {name: "SUBNET"}
    assert environment == {name: "SUBNET"}


def test_beside_a_sourced_ros_the_range_is_that_of_its_tools() -> None:
    environment = {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}
    keep_to_this_machine(environment)
    assert environment == {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}


def test_a_private_graph_kept_to_this_machine_beside_a_sourced_ros_too() -> None:
    environment = {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}
    with kept_to_this_machine(environment):
        assert environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "LOCALHOST"
    assert environment == {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}


@pytest.mark.graph
@pytest.mark.parametrize("nodes_run", [False, True])
def test_a_client_in_a_process_with_nodes_keeps_their_range(
    nodes_run: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    rclpy = pytest.importorskip("rclpy")
    asked: list[str] = []
    monkeypatch.setattr(client_module, "keep_to_this_machine", lambda: asked.append("range"))
    monkeypatch.setenv("CYCLONEDDS_URI", LOOPBACK)
    domain = 150 + os.getpid() % 50
    if nodes_run:
        rclpy.init(args=[], domain_id=domain)
    try:
        with MansionClient(domain_id=domain) as client:
            assert client.is_served("build_building") is False
            client.close()
    finally:
        rclpy.try_shutdown()
    assert bool(asked) is not nodes_run
