"""Start the nodes as processes, watch them, and end them by their ids."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType

from mansion_bringup.graph.nodes import GRAPH_NODES, NodeProcess
from mansion_bringup.graph.rclpy_available import check_rclpy
from mansion_bringup.graph.shared_memory import SegmentLedger, remove_left_behind
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE

__all__ = ["GraphOptions", "GraphProcesses"]

GRACE = 3.0
"""Seconds that a node has to end after SIGTERM before it is killed."""


@dataclass(frozen=True)
class GraphOptions:
    """How to start the nodes.

    Attributes
    ----------
    parameters : mapping
        Node name to its parameters, as ``-p NAME:=VALUE`` takes them.
    params_file : Path, optional
        A ROS parameter file for all nodes.
    quiet : bool
        Keep the nodes' logs off the terminal.
    """

    namespace: str = DEFAULT_NAMESPACE
    domain_id: int | None = None
    log_level: str = "info"
    parameters: Mapping[str, Mapping[str, str]] | None = None
    params_file: Path | None = None
    quiet: bool = False


class GraphProcesses:
    """The processes of one graph; a context manager that ends them all.

    Parameters
    ----------
    options : GraphOptions
    nodes : sequence of NodeProcess
    """

    def __init__(self, options: GraphOptions | None = None, nodes: Sequence[NodeProcess] = GRAPH_NODES) -> None:
        self.options = options or GraphOptions()
        self.nodes = tuple(nodes)
        self.running: dict[str, subprocess.Popen[bytes]] = {}
        self._segments = SegmentLedger()

    def __enter__(self) -> "GraphProcesses":
        check_rclpy()
        params = self.options.params_file
        if params is not None and not params.is_file():
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no parameter file {params}")
        remove_left_behind()
        try:
            for node in self.nodes:
                self.start(node.executable)
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stop()

    def start(self, executable: str) -> int:
        """Start (again) the node of that name and return its process id."""
        node = next(entry for entry in self.nodes if entry.executable == executable)
        quiet = subprocess.DEVNULL if self.options.quiet else None
        self.running[executable] = subprocess.Popen(
            self.command(node),
            env=self._environment(),
            stdin=subprocess.DEVNULL,
            stdout=quiet,
            stderr=quiet,
            start_new_session=True,
        )
        return self.running[executable].pid

    def command(self, node: NodeProcess) -> list[str]:
        """Return the command line that runs `node`."""
        options = self.options
        arguments = ["-r", f"__ns:={options.namespace}", "--log-level", options.log_level]
        if options.params_file is not None:
            arguments += ["--params-file", str(options.params_file)]
        for name, value in (options.parameters or {}).get(node.executable, {}).items():
            arguments += ["-p", f"{name}:={value}"]
        child = [sys.executable, "-m", "mansion_bringup.graph.child", str(os.getpid()), node.module]
        return [*child, "--ros-args", *arguments]

    def _environment(self) -> dict[str, str]:
        environment = dict(os.environ)
        if self.options.domain_id is not None:
            environment["ROS_DOMAIN_ID"] = str(self.options.domain_id)
        return environment

    def ended(self) -> dict[str, int]:
        """Return the exit status of each node that is no longer running."""
        self.note_segments(interval=1.0)
        return {name: process.returncode for name, process in self.running.items() if process.poll() is not None}

    def wait_ready(self, timeout: float = 180.0) -> None:
        """Wait until every node serves its service.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` with the node that ended or did not come up.
        """
        from mansion_bringup.client import MansionClient

        deadline = time.monotonic() + timeout
        options = self.options
        with MansionClient(domain_id=options.domain_id, namespace=options.namespace) as client:
            missing = {node.service: node.executable for node in self.nodes}
            while missing:
                for name, status in self.ended().items():
                    raise MansionError(ErrorCode.UNAVAILABLE, f"node {name} ended with status {status} at start")
                for service in [name for name in missing if client.is_served(name)]:
                    del missing[service]
                if missing and time.monotonic() > deadline:
                    names = ", ".join(sorted(missing.values()))
                    raise MansionError(ErrorCode.UNAVAILABLE, f"not up after {timeout:g} s: {names}")
                time.sleep(0.02)
        self.note_segments()

    def note_segments(self, interval: float = 0.0) -> None:
        """Note the shared memory of the nodes and of this process, unless that was done in the last `interval` s."""
        pids = [process.pid for process in self.running.values() if process.returncode is None]
        self._segments.note([os.getpid(), *pids], interval)

    def stop(self) -> None:
        """End every node: SIGTERM, and SIGKILL for what is still there after a grace."""
        self.note_segments()
        for process in self.running.values():
            _signal(process, signal.SIGTERM)
        deadline = time.monotonic() + GRACE
        for process in self.running.values():
            try:
                process.wait(timeout=max(0.0, deadline - time.monotonic()))
            except subprocess.TimeoutExpired:
                _signal(process, signal.SIGKILL)
                process.wait()
        self.running.clear()
        self._segments.remove_dead()
        remove_left_behind()


def _signal(process: subprocess.Popen[bytes], number: signal.Signals) -> None:
    if process.poll() is None:
        with contextlib.suppress(ProcessLookupError):
            os.kill(process.pid, number)
