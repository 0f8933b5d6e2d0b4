"""The locks are complete, hashed, and name no place."""

import re
from pathlib import Path

import pytest

from mansion_bringup.extras import EXTRAS

PYTHONS = ("3.11", "3.12", "3.13")
NAMES = ("core", "rclpy", *EXTRAS)
OLDER = {("thor", "python-dateutil")}
"""What an extra needs in an older version than all others; those accept it too."""


def entries(lock: Path) -> dict[str, str]:
    """Distribution -> pinned version; fails on an entry without a hash."""
    text = lock.read_text(encoding="utf-8").replace("\\\n", " ")
    pins = {}
    for line in text.splitlines():
        if line.startswith(("#", "--")) or not line.strip():
            continue
        pin = re.fullmatch(r"([\w.-]+)==(\S+)((?:\s+--hash=sha256:[0-9a-f]{64})+)\s*", line)
        assert pin, f"{lock.name}: {line[:80]}"
        pins[pin.group(1)] = pin.group(2)
    return pins


@pytest.mark.parametrize("python", PYTHONS)
@pytest.mark.parametrize("name", NAMES)
def test_each_requirement_is_pinned_with_hashes(root: Path, name: str, python: str) -> None:
    pins = entries(root / f"requirements/{name}-{python}.txt")
    assert pins
    wanted = re.findall(r"^([a-z][\w-]*)", (root / f"requirements/{name}.in").read_text("utf-8"), re.MULTILINE)
    assert {distribution.lower() for distribution in wanted} <= set(pins)


def test_every_lock_has_its_source_and_names_no_place(root: Path) -> None:
    for lock in sorted((root / "requirements").glob("*.txt")):
        text = lock.read_text(encoding="utf-8")
        assert "://" not in text and "/" not in re.sub(r"requirements/lock.sh", "", text), lock
        assert lock.with_name(re.sub(r"-3\.\d+\.txt$|\.txt$", ".in", lock.name)).exists()


def test_one_version_of_a_package_across_the_locks_of_a_python(root: Path) -> None:
    for python in PYTHONS:
        seen: dict[str, str] = {}
        for name in NAMES:
            for package, version in entries(root / f"requirements/{name}-{python}.txt").items():
                if (name, package) in OLDER:
                    continue
                assert seen.setdefault(package, version) == version, (name, python, package)


def test_what_jazzy_runs_is_locked(root: Path) -> None:
    for python in ("3.11", "3.12"):
        assert entries(root / f"requirements/core-{python}.txt")["numpy"] == "1.26.4"
    assert entries(root / "requirements/core-3.13.txt")["numpy"].startswith("2.")
    for python in PYTHONS:
        assert entries(root / f"requirements/core-{python}.txt")["shapely"].startswith("2.0.")


SERIES = {
    "ros-rclpy": "7.1.",
    "ros-rcl": "9.2.",
    "ros-rmw-fastrtps-cpp": "8.4.",
    "ros-fastrtps": "2.14.",
    "ros-rosidl-runtime-c": "4.6.",
    "ros-builtin-interfaces": "2.0.",
    **{f"ros-{name}-msgs": "5.3." for name in ("std", "geometry", "nav", "sensor", "diagnostic")},
}
"""What ROS 2 Jazzy has; the newest releases under these names belong to later distributions."""


@pytest.mark.parametrize("python", PYTHONS)
def test_the_wheels_of_rclpy_are_those_of_jazzy_and_a_lock_of_their_own(root: Path, python: str) -> None:
    wheels = entries(root / f"requirements/rclpy-{python}.txt")
    assert {name for name, start in SERIES.items() if not wheels[name].startswith(start)} == set()
    assert all(name.startswith("ros-") for name in wheels)
    core = entries(root / f"requirements/core-{python}.txt")
    assert not any(name.startswith("ros-") for name in core)


def test_what_starts_python_twice_is_not_installed(root: Path) -> None:
    for python in PYTHONS:
        wheels = entries(root / f"requirements/rclpy-{python}.txt")
        assert "ros-wheels-bootstrapper" not in wheels


def test_only_wheels_are_installed_but_for_the_one_without(root: Path) -> None:
    for lock in sorted((root / "requirements").glob("*.txt")):
        options = re.findall(r"^--\S.*", lock.read_text(encoding="utf-8"), re.MULTILINE)
        allowed = ["--only-binary :all:"]
        from_source = ["--no-binary empy"] * lock.name.startswith(("test-", "rosidl-"))
        assert options == allowed + from_source, lock
