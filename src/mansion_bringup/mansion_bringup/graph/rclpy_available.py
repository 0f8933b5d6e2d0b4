"""The check for rclpy, without which there is no node graph, and advice where it is missing."""

import importlib.util
import os
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["NO_RCLPY", "check_domain", "check_rclpy"]

NO_RCLPY: Final = (
    "the node graph needs rclpy, which is not installed here: on Linux with x86-64 and glibc 2.28 `./mansion` installs "
    "it; elsewhere install ROS 2 Jazzy (apt or RoboStack) and source it; build, plan, check and view need none"
)

WHEELS: Final = "rmw_fastrtps_cpp"


def check_rclpy() -> None:
    """Refuse where the node graph cannot run.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an invalid ``ROS_DOMAIN_ID``.
        ``UNAVAILABLE`` where there is no rclpy, or where ``RMW_IMPLEMENTATION`` asks its wheels for another middleware.
    """
    if importlib.util.find_spec("rclpy") is None:
        raise MansionError(ErrorCode.UNAVAILABLE, NO_RCLPY)
    check_domain()
    wanted = os.environ.get("RMW_IMPLEMENTATION", "")
    if "AMENT_PREFIX_PATH" not in os.environ and wanted not in ("", WHEELS):
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"RMW_IMPLEMENTATION is {wanted}, but without a sourced ROS 2 only {WHEELS} is available; unset it, or "
            f"source a ROS 2 that provides {wanted}",
        )


LAST_DOMAIN: Final = 232
"""The highest ROS domain: above it no ports are left."""


def check_domain() -> None:
    """Raise ``INVALID_PAYLOAD`` where ``ROS_DOMAIN_ID`` is not a domain."""
    text = os.environ.get("ROS_DOMAIN_ID", "")
    if text and not (text.isascii() and text.isdecimal() and int(text) <= LAST_DOMAIN):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"ROS_DOMAIN_ID is {text[:80]!r}; it must be a whole number from 0 to {LAST_DOMAIN}",
        )
