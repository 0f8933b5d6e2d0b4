"""A build that is killed at any stage leaves no process and no lock, and the next one goes on."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest

REQUEST = BuildRequest(description="a house of two storeys", seed=4)

SCRIPT = """
import sys
from pathlib import Path
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest

def report(progress):
    print(progress.done, flush=True)

build_building(BuildRequest(description="a house of two storeys", seed=4), Path(sys.argv[1]), jobs=2, report=report)
"""


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM], ids=["SIGKILL", "SIGTERM"])
@pytest.mark.parametrize("step", [1, 3])
def test_the_next_build_goes_on_where_a_killed_one_was(tmp_path: Path, step: int, number: signal.Signals) -> None:
    command = [sys.executable, "-c", SCRIPT, str(tmp_path / "house")]
    build = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, start_new_session=True)
    assert build.stdout is not None
    try:
        for line in build.stdout:
            if int(line) >= step:
                break
        time.sleep(0.2)
        build.send_signal(number)
        build.wait()
        assert ended(build.pid)
        build_building(REQUEST, tmp_path / "house")
    finally:
        build.stdout.close()
        if group_of(build.pid):
            os.killpg(build.pid, signal.SIGKILL)
    assert [path.name for path in tmp_path.iterdir()] == ["house"]


def ended(session: int) -> bool:
    """Wait until no process of a session is left."""
    deadline = time.monotonic() + 20.0
    while group_of(session) and time.monotonic() < deadline:
        time.sleep(0.05)
    return not group_of(session)


def group_of(session: int) -> list[int]:
    """Return the processes of a session that have not ended."""
    found = []
    for file in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, owner = file.read_text().rpartition(")")[2].split()[:4]
        except (FileNotFoundError, ProcessLookupError):
            continue
        if int(owner) == session and state != "Z":
            found.append(int(file.parent.name))
    return found
