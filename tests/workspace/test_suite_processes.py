"""A suite that is ended takes its processes along."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

STARTER = """
import subprocess, sys
from mansion_bringup.cli.run_tests import pytest_command
folder = sys.argv[1]
command = pytest_command(["--no-cov", "-p", "no:cacheprovider", "--rootdir", folder, folder])
subprocess.run(command, cwd=folder)
"""

SLOW = """
import time
from pathlib import Path
import pytest

@pytest.mark.parametrize("n", range(2))
def test_slow(n):
    Path(__file__).with_name(f"running_{n}").touch()
    time.sleep(600)
"""


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_no_worker_outlives_the_command(tmp_path: Path, number: signal.Signals) -> None:
    pytest.importorskip("xdist")
    (tmp_path / "test_slow.py").write_text(SLOW)
    (tmp_path / "starter.py").write_text(STARTER)
    suite = subprocess.Popen(
        [sys.executable, str(tmp_path / "starter.py"), str(tmp_path)], start_new_session=True, stdout=subprocess.DEVNULL
    )
    try:
        assert soon(lambda: len(list(tmp_path.glob("running_*"))) == 2)
        suite.send_signal(number)
        suite.wait()
        assert soon(lambda: not session(suite.pid))
    finally:
        for pid in session(suite.pid):
            subprocess.run(["kill", "-KILL", str(pid)], check=False)


def soon(condition, seconds: float = 60.0) -> bool:
    deadline = time.monotonic() + seconds
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.05)
    return bool(condition())


def session(leader: int) -> list[int]:
    """Return the processes of a session that have not ended."""
    found = []
    for file in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, owner = file.read_text().rpartition(")")[2].split()[:4]
        except (FileNotFoundError, ProcessLookupError):
            continue
        if int(owner) == leader and state != "Z":
            found.append(int(file.parent.name))
    return found
