"""`mansion --version`: what a report of a fault needs to say."""

import subprocess
import sys

from mansion_bringup import __version__
from mansion_bringup.cli.version import about


def test_the_command_line_says_what_is_running() -> None:
    command = [sys.executable, "-P", "-m", "mansion_bringup", "--version"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    first, *rest = done.stdout.splitlines()
    assert first == f"mansion {__version__}"
    assert [line.split()[0] for line in rest] == ["python", "platform", "middleware", "lock"]
    assert sys.executable in rest[0]


def test_every_fact_is_known_or_said_to_be_missing() -> None:
    assert all(value.strip() for value in about().values())
