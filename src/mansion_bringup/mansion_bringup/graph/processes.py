"""The node graph as processes: which nodes it has, started in a domain, watched, and ended by their ids."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from mansion_bringup.discovery import kept_to_this_machine
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.rclpy_available import check_rclpy
from mansion_bringup.graph.shared_memory import SegmentLedger, remove_left_behind
from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interface_types import DEFAULT_NAMESPACE
from mansion_msgs_py.late_imports import importing

if TYPE_CHECKING:
    from mansion_bringup.client import MansionClient

__all__ = ["GRAPH_NODES", "GraphOptions", "GraphProcesses", "NodeProcess", "graph_client"]


@dataclass(frozen=True)
class NodeProcess:
    """A node of the graph: `package` and `executable` are those of ``ros2 run``."""

    package: str
    executable: str
    service: str

    @property
    def module(self) -> str:
        """The Python module that ``python -m`` runs."""
        return f"{self.package}.nodes.{self.executable}"


GRAPH_NODES: tuple[NodeProcess, ...] = (
    NodeProcess("mansion_planner", "program_planner", "plan_program"),
    NodeProcess("mansion_planner", "floor_solver", "solve_floor"),
    NodeProcess("mansion_scene", "object_placer", "furnish_floor"),
    NodeProcess("mansion_editing", "scene_editor", "scene/open"),
    NodeProcess("mansion_skills", "skill_server", "load_building"),
    NodeProcess("mansion_bringup", "building_director", "build_building"),
)


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
    allow : tuple of Path
        Folders below which the services may write, beside the working folder and the temporary one.
    quiet : bool
        Keep the nodes' logs off the terminal.
    """

    namespace: str = DEFAULT_NAMESPACE
    domain_id: int | None = None
    log_level: str = "info"
    parameters: Mapping[str, Mapping[str, str]] | None = None
    params_file: Path | None = None
    allow: tuple[Path, ...] = ()
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
        if options.allow:
            arguments += ["-p", f"allow:={encode([str(folder.absolute()) for folder in options.allow])}"]
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
        with importing:
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


LOOK_FOR_GRAPH = 1.0
"""Seconds to look for a running graph."""


@contextmanager
def graph_client(
    *,
    namespace: str = DEFAULT_NAMESPACE,
    service: str = "build_building",
    allow: Sequence[Path] = (),
    notice: Callable[[str], None] = lambda text: None,
) -> Iterator["MansionClient"]:
    """Yield a client of the graph of this domain; without one, start a private graph and end it afterwards.

    Parameters
    ----------
    namespace : str
    service : str
        What must be served for a graph to count as running.
    allow : sequence of Path
        Where the services of a private graph may write, beside the working folder and the temporary one.
    notice : callable
        Gets a line when a private graph is started.
    """
    with importing:
        from mansion_bringup.client import MansionClient

    with MansionClient(namespace=namespace) as client:
        if client.wait_served(service, LOOK_FOR_GRAPH):
            yield client
            return
    options = GraphOptions(namespace=namespace, domain_id=free_domain(), allow=tuple(allow), quiet=True)
    notice("no graph is running here: starting a private one")
    with kept_to_this_machine(), GraphProcesses(options) as graph:
        graph.wait_ready()
        with MansionClient(domain_id=options.domain_id, namespace=namespace) as client:
            graph.note_segments()
            yield client
