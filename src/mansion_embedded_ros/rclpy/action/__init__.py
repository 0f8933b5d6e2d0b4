"""Actions are not part of the embedded ROS."""

from typing import Any

__all__: list[str] = []


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    raise ImportError(
        f"rclpy.action.{name}: the embedded ROS has no actions; use services and topics, or install "
        "ROS 2 Jazzy"
    )
