"""What these benchmarks share: processes that are spoken to line by line, their middleware settings and their costs."""

import contextlib
import json
import os
import select
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

from mansion_bringup.discovery import CHOICES, kept_to_this_machine
from mansion_msgs_py.workers import end_with_parent

__all__ = [
    "LOOPBACK",
    "RANGE",
    "Worker",
    "all_ended",
    "begin_worker",
    "environment",
    "load",
    "proportional_mb",
    "processor_seconds",
    "resident_mb",
    "say",
    "spin",
]

LOOPBACK: Final = "loopback profile"
"""Mansion's own setting: sockets bound to 127.0.0.1 and no shared memory."""

RANGE: Final = "range LOCALHOST"
"""The middleware as it comes, with ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST: shared memory and all interfaces."""

MARK: Final = b"@"
"""Begins the lines that are meant for the parent; the middleware prints others to the same stream."""

GRACE: Final = 5.0
"""Seconds that processes have to end after SIGTERM before they are killed."""

SPIN: Final = 0.5
"""Seconds after which a node with nothing to do looks whether it shall end."""

TICKS: Final = os.sysconf("SC_CLK_TCK")


def environment(setting: str, domain: int) -> dict[str, str]:
    """Return the variables of a process with a middleware setting in a ROS domain.

    Parameters
    ----------
    setting : {LOOPBACK, RANGE}
    domain : int
    """
    variables = {name: value for name, value in os.environ.items() if name not in CHOICES}
    variables["ROS_DOMAIN_ID"] = str(domain)
    if setting == LOOPBACK:
        with kept_to_this_machine(variables):
            return dict(variables)
    return {**variables, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


class Worker:
    """A Python process that answers with one JSON value a line (see `say`).

    Parameters
    ----------
    arguments : sequence of str
        Of the interpreter.
    variables : dict
        Its environment.
    prefix : sequence of str
        A command that runs it, as ``unshare`` does.
    """

    def __init__(self, arguments: Sequence[str], variables: dict[str, str], prefix: Sequence[str] = ()) -> None:
        self.process = subprocess.Popen(
            [*prefix, sys.executable, "-u", *arguments],
            env=variables,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            bufsize=0,
        )
        self.pid = self.process.pid
        self._received = b""

    def tell(self, value: Any) -> None:
        """Send one value, which the process reads as a line of its standard input."""
        assert self.process.stdin is not None
        self.process.stdin.write(json.dumps(value).encode() + b"\n")

    def hear(self, timeout: float) -> Any:
        """Return the next value that the process says.

        Raises
        ------
        TimeoutError
            After `timeout` seconds.
        EOFError
            When the process ended instead.
        """
        deadline = time.monotonic() + timeout
        while True:
            line, complete, rest = self._received.partition(b"\n")
            if complete:
                self._received = rest
                if line.startswith(MARK):
                    return json.loads(line[len(MARK) :])
            else:
                self._read(max(0.0, deadline - time.monotonic()))

    def ask(self, value: Any, timeout: float) -> Any:
        """Send a value and return the answer."""
        self.tell(value)
        return self.hear(timeout)

    def end(self) -> None:
        """Tell the process to end: by SIGTERM, and by the end of its input where it waits for that."""
        assert self.process.stdin is not None
        self.process.terminate()
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.close()

    def _read(self, timeout: float) -> None:
        assert self.process.stdout is not None
        if not select.select([self.process.stdout], [], [], timeout)[0]:
            raise TimeoutError(f"process {self.pid} is silent")
        received = os.read(self.process.stdout.fileno(), 1 << 16)
        if not received:
            raise EOFError(f"process {self.pid} ended with status {self.process.wait(GRACE)}")
        self._received += received


@contextmanager
def all_ended(workers: list[Worker]) -> Iterator[None]:
    """End all of `workers` at the end of the block: SIGTERM, and SIGKILL after a grace."""
    try:
        yield
    finally:
        for worker in workers:
            worker.end()
        deadline = time.monotonic() + GRACE
        for worker in workers:
            try:
                worker.process.wait(max(0.0, deadline - time.monotonic()))
            except subprocess.TimeoutExpired:
                print(f"process {worker.pid} does not end and is killed", file=sys.stderr)
                worker.process.kill()
                worker.process.wait()


def begin_worker() -> None:
    """Let this process, a `Worker`, end with the one that started it."""
    end_with_parent(os.getppid())


def say(value: Any) -> None:
    """Say a value to the parent."""
    sys.stdout.write(MARK.decode() + json.dumps(value) + "\n")
    sys.stdout.flush()


def spin(node: Any) -> None:
    """Spin a node until SIGTERM."""
    from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor

    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    with contextlib.suppress(ExternalShutdownException):
        while node.context.ok():
            # With an end, because rclpy can miss the wake-up of a context that a signal shuts down.
            executor.spin_once(timeout_sec=SPIN)
    executor.shutdown(timeout_sec=SPIN)
    node.destroy_node()
    node.context.try_shutdown()


def processor_seconds(pid: int) -> float:
    """Return the processor time of all threads of a process so far."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def proportional_mb(pid: int) -> float:
    """Return the memory of a process in MB, each shared page divided by those that share it (Pss)."""
    return _rollup_mb(pid, "Pss:")


def resident_mb(pid: int) -> float:
    """Return the resident memory of a process in MB, shared pages included (Rss)."""
    return _rollup_mb(pid, "Rss:")


def _rollup_mb(pid: int, name: str) -> float:
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="ascii").splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(name)) * 1024 / 1e6


def load() -> str:
    """Return a line that says how busy the machine is, to be printed with the figures."""
    return f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores"
