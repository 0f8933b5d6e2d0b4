"""Names of Jazzy's rclpy that the embedded ROS does not have, and the error that says so."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["MISSING", "missing_attribute"]

MISSING: dict[str, tuple[str, ...]] = {
    "rclpy.executors": ("EventsExecutor",),
}
"""By module. Whole modules: ``rclpy.action`` and ``rclpy.lifecycle``."""


def missing_attribute(module: str) -> Callable[[str], Any]:
    """A module's ``__getattr__`` that tells what Jazzy has and this has not."""

    def __getattr__(name: str) -> Any:
        if name in MISSING.get(module, ()):
            raise AttributeError(
                f"{module}.{name} exists in ROS 2, but the embedded ROS does not have it; "
                "install ROS 2 Jazzy to use it"
            )
        raise AttributeError(f"module {module!r} has no attribute {name!r}")

    return __getattr__
