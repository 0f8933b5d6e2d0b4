"""No worker outlives the process that made it, and none keeps memory that it needs no more."""

import ctypes
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from mansion_msgs_py.workers import release_memory

SCRIPT = """
import os, sys, time
from mansion_msgs_py.workers import worker_pool

if __name__ == "__main__":
    pool = worker_pool(2, sys.argv[1])
    work = [pool.submit(time.sleep, float(sys.argv[2])) for _ in range(2)]
    while len(pool._processes) < 2:
        time.sleep(0.01)
    pool.submit(os.getpid).result() if sys.argv[2] == "0" else time.sleep(1.0)
    print(*pool._processes, flush=True)
    time.sleep(600)
"""

INTERRUPTED = """
import os, signal, sys
from mansion_msgs_py.workers import worker_pool

if __name__ == "__main__":
    signal.signal(signal.SIGINT, lambda number, frame: None)
    with worker_pool(2, sys.argv[1]) as pool:
        work = [pool.submit(abs, -k) for k in range(4)]
        os.killpg(0, signal.SIGINT)
        print(*(done.result() for done in work))
"""


def is_running(pid: int) -> bool:
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"


def ended(pids: list[int], seconds: float) -> bool:
    deadline = time.monotonic() + seconds
    while any(map(is_running, pids)) and time.monotonic() < deadline:
        time.sleep(0.05)
    return not any(map(is_running, pids))


@pytest.mark.parametrize("busy", ["0", "600"], ids=["idle", "busy"])
@pytest.mark.parametrize("method", ["fork", "forkserver", "spawn"])
def test_workers_end_when_their_parent_is_killed(tmp_path: Path, method: str, busy: str) -> None:
    script = tmp_path / "owner.py"
    script.write_text(SCRIPT)
    owner = subprocess.Popen([sys.executable, str(script), method, busy], stdout=subprocess.PIPE, text=True)
    assert owner.stdout is not None
    workers = [int(pid) for pid in owner.stdout.readline().split()]
    helpers = [*workers, *children(owner.pid)]
    try:
        assert len(workers) == 2 and all(map(is_running, workers))
        owner.kill()
        owner.wait()
        assert ended(helpers, 20.0)
    finally:
        owner.kill()
        owner.stdout.close()
        for pid in filter(is_running, helpers):
            os.kill(pid, signal.SIGKILL)


def children(pid: int) -> list[int]:
    """Return the direct children of a process: its workers, a fork server, a tracker of resources."""
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


@pytest.mark.parametrize("method", ["fork", "forkserver", "spawn"])
def test_an_interrupt_while_workers_start_is_left_to_their_owner(tmp_path: Path, method: str) -> None:
    script = tmp_path / "owner.py"
    script.write_text(INTERRUPTED)
    done = subprocess.run(
        [sys.executable, str(script), method],
        capture_output=True, text=True, timeout=60, check=False, start_new_session=True,
    )  # fmt: skip
    assert (done.stdout, done.stderr) == ("0 1 2 3\n", "")


@pytest.mark.skipif(not hasattr(ctypes.CDLL(None), "malloc_trim"), reason="a C library that cannot")
def test_memory_that_was_freed_is_given_back() -> None:
    def resident() -> float:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
        return pages * resource.getpagesize() / 1e6

    blocks = [bytearray(80_000) for _ in range(4_000)]
    kept = blocks[::50]
    del blocks
    before = resident()
    release_memory()
    assert len(kept) == 80
    assert resident() < before - 200.0
