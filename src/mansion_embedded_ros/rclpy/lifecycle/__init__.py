"""Lifecycle nodes are not part of the embedded ROS."""

from typing import Any

__all__: list[str] = []


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    raise ImportError(
        f"rclpy.lifecycle.{name}: the embedded ROS has no lifecycle nodes; use rclpy.node.Node, or install "
        "ROS 2 Jazzy"
    )
