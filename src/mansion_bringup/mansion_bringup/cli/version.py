"""``mansion --version``: the version of Mansion, and what its results and its graph depend on."""

import hashlib
import importlib.util
import os
import platform
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import typer

from mansion_bringup import __version__

__all__ = ["about", "print_version"]


def about() -> dict[str, str]:
    """Return version, Python, platform, middleware and lock, as ``mansion --version`` prints them.

    Nothing is imported for it: it also answers where an import fails.

    Examples
    --------
    >>> list(about())
    ['mansion', 'python', 'platform', 'middleware', 'lock']
    """
    return {
        "mansion": __version__,
        "python": f"{platform.python_implementation()} {platform.python_version()} ({sys.executable})",
        "platform": platform.platform(),
        "middleware": _middleware(),
        "lock": _lock(Path(sys.prefix)),
    }


def _middleware() -> str:
    """Name the rclpy that is found and its middleware."""
    if importlib.util.find_spec("rclpy") is None:
        return "none (no rclpy)"
    chosen = os.environ.get("RMW_IMPLEMENTATION") or "rmw_fastrtps_cpp"
    if os.environ.get("AMENT_PREFIX_PATH"):
        return f"{chosen}, rclpy of ROS 2 {os.environ.get('ROS_DISTRO', 'of unknown name')}"
    try:
        return f"{chosen}, rclpy {version('ros-rclpy')} from wheels"
    except PackageNotFoundError:
        return f"{chosen}, rclpy of unknown origin"


def _lock(prefix: Path) -> str:
    """Name the lock that ``./mansion`` made the environment from, by the first figures of its hash."""
    if not (prefix / ".mansion-venv").exists():
        return "none (not an environment of ./mansion)"
    file = (
        Path(__file__).resolve().parents[4] / "requirements" / f"core-{sys.version_info[0]}.{sys.version_info[1]}.txt"
    )
    if not file.exists():
        return f"missing ({file})"
    return f"{file.name}, sha256 {hashlib.sha256(file.read_bytes()).hexdigest()[:12]}"


def print_version(wanted: bool) -> None:
    """Print what is running, and end; the callback of ``--version``."""
    if wanted:
        for name, value in about().items():
            typer.echo(f"{name} {value}" if name == "mansion" else f"  {name:<11} {value}")
        raise typer.Exit
