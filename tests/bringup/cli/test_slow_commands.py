"""What commands say that take long and show no steps."""

import subprocess
import sys

import pytest
import typer.main

from mansion_bringup.cli.app import app
from mansion_bringup.cli.settings_file import commands_below
from mansion_bringup.cli.slow_commands import WORK

SCRIPT = """
import sys, time
from mansion_bringup.cli import slow_commands
from mansion_bringup.cli.console import err
slow_commands.ANNOUNCED_AFTER, seconds, err.quiet = 0.1, float(sys.argv[2]), sys.argv[3] == "quiet"
answer = slow_commands.announced(sys.argv[1], lambda: time.sleep(seconds) or 7)()
time.sleep(0.3)
print(answer)
"""


def run(command: str, seconds: float, how: str = "") -> subprocess.CompletedProcess[str]:
    words = [sys.executable, "-c", SCRIPT, command, str(seconds), how]
    return subprocess.run(words, capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize(
    ("command", "seconds", "how", "said"),
    [
        ("check", 0.5, "", "deriving every promise from the geometry again: about"),
        ("check", 0.0, "", ""),
        ("check", 0.5, "quiet", ""),
        ("schema", 0.5, "", ""),
    ],
)
def test_what_takes_long_says_once_what_it_does(command: str, seconds: float, how: str, said: str) -> None:
    done = run(command, seconds, how)
    assert done.returncode == 0 and done.stdout == "7\n"
    assert done.stderr.startswith(said) and len(done.stderr.splitlines()) == bool(said)


def test_every_command_that_is_told_of_exists() -> None:
    known = {" ".join(path) for path, _ in commands_below(typer.main.get_command(app))}
    assert set(WORK) <= known


IMPORTS = """
import sys, time
from mansion_bringup.cli import slow_commands
found = []
sys.addaudithook(lambda event, arguments: found.append(arguments[0]) if event == "import" else None)
slow_commands.ANNOUNCED_AFTER = 0.1
slow_commands.announced("plan", lambda: time.sleep(0.5))()
print(found)
"""


def test_nothing_is_imported_to_say_it_because_it_may_interrupt_an_import() -> None:
    done = subprocess.run([sys.executable, "-c", IMPORTS], capture_output=True, text=True, timeout=60)
    assert done.stdout == "[]\n" and done.stderr.startswith("reading the sentence")
