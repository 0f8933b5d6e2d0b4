"""Commands and clients stay on this machine unless the environment or a sourced ROS 2 says otherwise."""

import os
from pathlib import Path

import pytest

from mansion_bringup import client as client_module
from mansion_bringup.client import MansionClient
from mansion_bringup.discovery import (
    CHOICES,
    CHOSEN_FILES,
    LOOPBACK_PROFILE,
    keep_to_this_machine,
    kept_to_this_machine,
)

MANSIONS_OWN = {
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT",
    "FASTRTPS_DEFAULT_PROFILES_FILE": str(LOOPBACK_PROFILE),
}
"""The range is then the profile's: rmw_fastrtps adds nothing to it."""


def test_processes_are_kept_to_loopback_where_nothing_is_chosen() -> None:
    environment: dict[str, str] = {}
    keep_to_this_machine(environment)
    assert environment == MANSIONS_OWN
    keep_to_this_machine(environment)
    assert environment == MANSIONS_OWN


@pytest.mark.parametrize("name", CHOICES)
def test_a_choice_of_the_user_is_left_alone(name: str) -> None:
    environment = {name: "SUBNET"}
    keep_to_this_machine(environment)
    with kept_to_this_machine(environment):
        assert environment == {name: "SUBNET"}
    assert environment == {name: "SUBNET"}


@pytest.mark.parametrize("name", CHOSEN_FILES)
def test_a_profile_in_the_working_directory_is_a_choice_too(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).touch()
    environment: dict[str, str] = {}
    keep_to_this_machine(environment)
    assert environment == {}


def test_beside_a_sourced_ros_the_range_is_that_of_its_tools() -> None:
    environment = {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}
    keep_to_this_machine(environment)
    assert environment == {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}


def test_a_private_graph_stays_on_this_machine_beside_a_sourced_ros_too() -> None:
    environment = {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}
    with kept_to_this_machine(environment):
        # Whatever its middleware: each knows the range.
        assert environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "LOCALHOST"
        assert environment["FASTRTPS_DEFAULT_PROFILES_FILE"] == str(LOOPBACK_PROFILE)
    assert environment == {"AMENT_PREFIX_PATH": "/opt/ros/jazzy"}


@pytest.mark.graph
@pytest.mark.parametrize("nodes_run", [False, True])
def test_a_client_in_a_process_with_nodes_keeps_their_range(nodes_run: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    rclpy = pytest.importorskip("rclpy")
    asked: list[str] = []
    monkeypatch.setattr(client_module, "keep_to_this_machine", lambda: asked.append("range"))
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
