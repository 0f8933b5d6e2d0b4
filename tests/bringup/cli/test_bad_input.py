"""Input that no command can use ends in one line, never in a traceback."""

import os
import subprocess
import sys

import pytest


def run(arguments: list[bytes | str], **environment: str) -> tuple[int, str]:
    """Run a command and return its exit status and what it wrote to stderr."""
    done = subprocess.run(
        [sys.executable, "-m", "mansion_bringup", *arguments],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), **environment},
        capture_output=True,
        check=False,
    )
    return done.returncode, done.stderr.decode(errors="replace")


@pytest.mark.parametrize(
    "arguments",
    [["plan", b"a house \xff\xfe of two"], ["build", "a flat", "-o", b"/tmp/\xff"], ["check", b"\x80"]],
    ids=["brief", "output", "folder"],
)
def test_bytes_that_are_no_text_are_refused(arguments: list[bytes | str]) -> None:
    status, errors = run(arguments)
    assert status == 1
    assert "is not UTF-8 text" in errors and len(errors.splitlines()) == 1


@pytest.mark.parametrize("domain", ["999", "-1", "abc", "1.5"])
def test_a_domain_that_is_none_is_refused(domain: str) -> None:
    pytest.importorskip("rclpy")
    status, errors = run(["call", "build_building", "{}"], ROS_DOMAIN_ID=domain)
    assert status == 1
    assert "from 0 to 232" in errors and len(errors.splitlines()) == 1


@pytest.mark.parametrize("area", ["inf", "nan", "1e300", "9223372036854775808"])
def test_an_area_that_is_none_is_refused(area: str) -> None:
    status, errors = run(["plan", "an office", "--area", area])
    assert status != 0 and "Traceback" not in errors


@pytest.mark.parametrize("command", ["check", "view", "export", "edit"])
def test_a_path_that_is_too_long_is_refused(command: str) -> None:
    further = {"export": ["--to", "sdf"], "edit": ["Undo"]}.get(command, [])
    status, errors = run([command, "a" * 5_000, *further])
    assert status == 1 and "Traceback" not in errors
