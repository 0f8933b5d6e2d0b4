"""Refuses to stand in where a ROS 2 is installed."""

from __future__ import annotations

import os
import sys
from pathlib import Path

__all__ = ["refuse_beside_real_ros"]

_HERE = Path(__file__).resolve().parent


def _find_other() -> str | None:
    for entry in sys.path:
        candidate = Path(entry or ".") / "rclpy" / "__init__.py"
        try:
            if candidate.exists() and candidate.resolve().parent != _HERE:
                other = candidate.parent
                if not (other / "_real_ros.py").exists():
                    return str(other)
        except OSError:
            continue
    return None


def refuse_beside_real_ros() -> None:
    """Raise where another ``rclpy`` can be imported or a ROS 2 is sourced.

    Raises
    ------
    ImportError
        With what was found and what to do.
    """
    if os.environ.get("MANSION_EMBEDDED_ROS") == "1":
        return
    other = _find_other()
    sourced = os.environ.get("ROS_DISTRO") if os.environ.get("AMENT_PREFIX_PATH") else None
    if other is None and sourced is None:
        return
    what = (
        f"a real rclpy is at {other}"
        if other
        else f"ROS 2 {sourced} is sourced (AMENT_PREFIX_PATH)"
    )
    raise ImportError(
        f"{what}, and this is the rclpy of mansion_embedded_ros ({_HERE}), which only stands in where "
        "there is none. Take its folder off PYTHONPATH (or pip uninstall mansion-embedded-ros) to use "
        "ROS 2, or use a shell in which no ROS 2 is sourced. MANSION_EMBEDDED_ROS=1 imports this one "
        "all the same."
    )
