"""The whole graph in use for an hour: what gets lost, slow or larger while robots, an editor and a builder work.

    python benchmarks/ros/graph_soak.py [--minutes 60] [--building DIR]

Starts the nodes of ``mansion up`` in a domain of its own under Mansion's loopback profile, and builds an office of four
storeys through them. In it are four robots, each with a session of its own and a call every 0.2 to 0.5 s: skills,
questions about routes and objects, loading again now and then, and a question to the scene editor in every round of
some fifteen calls. An editor calls every 0.3 to 0.8 s: questions, placing, painting, turning, instructions, and the
undoing of it all. A builder has a small building built every 60 s.

Prints a line for each minute: calls, refused and failed ones; median, 95th and 99th percentile of the seconds of each
kind of call; the memory of each node with its children (Pss). A call is refused where what it asks cannot be done, and
failed for any other error. The exit status is 1 where a call failed or was lost, a node ended, the 99th percentile of
skills, questions or edits is above 0.5 s, or the median memory of a node in the last quarter is 20 MB more than in the
first.
"""

import argparse
import importlib.util
import statistics
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Final

from _processes import load, proportional_mb
from _visitors import BUILD, EDIT, LOAD, QUESTION, SKILL, Ledger, Visitor, builds, edits, errands

from mansion_bringup.client import MansionClient
from mansion_bringup.discovery import kept_to_this_machine
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses

OFFICE: Final = "A four-storey office with a cafeteria on the ground floor"

SLOWEST: Final = 0.5
"""Seconds of the 99th percentile."""

BOUNDED: Final = (SKILL, QUESTION, EDIT)
"""Kinds of calls that the bound holds for."""

KINDS: Final = (*BOUNDED, LOAD, BUILD)

GROWTH: Final = 20.0
"""MB by which the median memory of a node may grow from the first quarter to the last."""

ROBOTS: Final = 4
ROBOT_PACE: Final = (0.2, 0.5)
EDITOR_PACE: Final = (0.3, 0.8)
BUILDER_PACE: Final = (60.0, 60.0)

SAMPLE: Final = 10.0
"""Seconds between two looks at the memory."""


class Memory:
    """The memory of the nodes over time."""

    def __init__(self, running: GraphProcesses) -> None:
        self._running = running
        self.series: dict[str, list[float]] = {name: [] for name in running.running}

    def sample(self) -> None:
        """Note what each node has now, with its children."""
        for name, process in self._running.running.items():
            if process.poll() is None:
                self.series[name].append(sum(map(_proportional_mb, _with_children(process.pid))))

    def latest(self) -> str:
        """Return the last samples in words."""
        return ", ".join(f"{name} {values[-1]:.0f}" for name, values in self.series.items() if values)

    def quarters(self, name: str) -> tuple[float, float]:
        """Return the median of the first and of the last quarter, MB."""
        values = self.series[name]
        quarter = max(1, len(values) // 4)
        return statistics.median(values[:quarter]), statistics.median(values[-quarter:])


def _with_children(pid: int) -> list[int]:
    """Return a process with all that it has started."""
    found = [pid]
    for number in found:
        try:
            for file in Path(f"/proc/{number}/task").glob("*/children"):
                found += map(int, file.read_text(encoding="ascii").split())
        except OSError:
            continue
    return found


def _proportional_mb(pid: int) -> float:
    try:
        return proportional_mb(pid)
    except (OSError, StopIteration):  # it has ended meanwhile
        return 0.0


def percentile(values: Sequence[float], share: float) -> float:
    """Return the value that a share of all are no greater than."""
    ordered = sorted(values)
    return ordered[max(0, -int(-share * len(ordered) // 1) - 1)]


def row(name: str, values: Sequence[float]) -> str:
    """Return a line of the last table."""
    if not values:
        return f"{name:28}{0:7d}"
    figures = (*(percentile(values, share) for share in (0.5, 0.95, 0.99)), max(values))
    return f"{name:28}{len(values):7d}" + "".join(f"{each:9.3f}" for each in figures)


def described(ledger: Ledger) -> str:
    """Return the times of each kind of call in words."""
    told = []
    for kind in KINDS:
        if values := ledger.of_kind(kind):
            figures = " ".join(f"{percentile(values, share):.3f}" for share in (0.5, 0.95, 0.99))
            told.append(f"{kind} {len(values)}: {figures}")
    return "; ".join(told)


def run(options: argparse.Namespace, folder: Path) -> int:
    """Let everybody work, print the figures, and return the exit status."""
    graph = GraphOptions(domain_id=free_domain(options.domain), log_level="error")
    with kept_to_this_machine(), GraphProcesses(graph) as running:
        running.wait_ready()
        building = options.building or _built(graph, folder / "office")
        memory, ledger, whole = Memory(running), Ledger(), Ledger()
        visitors = _visitors(graph, building.resolve(), folder, ledger)
        faults: list[str] = []
        with ExitStack() as stack:
            stack.callback(_stop, visitors, faults)
            for visitor in visitors:
                visitor.start()
            _watch(options.minutes, running, memory, ledger, whole)
        whole.add(ledger.take())
        faults += [f"node {name} ended with status {status}" for name, status in running.ended().items()]
    return report(whole, memory, faults)


def _built(graph: GraphOptions, output: Path) -> Path:
    with MansionClient(domain_id=graph.domain_id) as client:
        return Path(client.build(OFFICE, output=str(output)).path)


def _visitors(graph: GraphOptions, building: Path, folder: Path, ledger: Ledger) -> list[Visitor]:
    """Return who will call, after the building was opened for editing."""

    def client() -> MansionClient:
        return MansionClient(domain_id=graph.domain_id)

    with client() as opener:
        opener.call("scene/open", {"path": str(building), "who": "soak"})
    robots = [
        Visitor(name, client(), ledger, errands(building, name), ROBOT_PACE)
        for name in (f"robot_{number}" for number in range(1, ROBOTS + 1))
    ]
    return [
        *robots,
        Visitor("editor", client(), ledger, edits, EDITOR_PACE),
        Visitor("builder", client(), ledger, builds(folder / "small"), BUILDER_PACE),
    ]


def _watch(minutes: float, running: GraphProcesses, memory: Memory, ledger: Ledger, whole: Ledger) -> None:
    """Print a line for each minute, until the time is over or a node has ended."""
    begin = time.monotonic()
    sampled = printed = begin
    while time.monotonic() - begin < 60.0 * minutes and not running.ended():
        time.sleep(0.5)
        now = time.monotonic()
        if now - sampled >= SAMPLE:
            memory.sample()
            sampled = now
        if now - printed >= 60.0:
            printed = now
            part = ledger.take()
            whole.add(part)
            calls = sum(map(len, part.seconds.values()))
            print(
                f"minute {round((now - begin) / 60.0)}: {calls} calls, "
                f"{part.refused} refused, {len(part.failed)} failed; "
                f"{described(part)}; MB: {memory.latest()}; {load()}",
                flush=True,
            )
            for failure in part.failed[:5]:
                print(f"  {failure[:500]}", flush=True)


def _stop(visitors: list[Visitor], faults: list[str]) -> None:
    """Stop all visitors once their calls have ended, and note those that had an end of their own, or have none."""
    for visitor in visitors:
        visitor.stopped.set()
    deadline = time.monotonic() + 60.0
    for visitor in visitors:
        visitor.join(max(0.0, deadline - time.monotonic()))
        if visitor.is_alive():
            faults.append(f"{visitor.name} still waits for an answer")
        elif visitor.fault:
            faults.append(visitor.fault)


def report(whole: Ledger, memory: Memory, faults: list[str]) -> int:
    """Print the figures of the whole time, and return the exit status."""
    calls = sum(map(len, whole.seconds.values()))
    print(
        f"{calls} calls, {whole.refused} refused, {len(whole.failed)} failed; median, 95th, 99th percentile, slowest:"
    )
    for kind in KINDS:
        values = whole.of_kind(kind)
        print(row(f"{kind} calls", values))
        if kind in BOUNDED and values and (last := percentile(values, 0.99)) > SLOWEST:
            faults.append(f"the 99th percentile of {kind} calls is {last:.2f} s")
        for (found, service), own in sorted(whole.seconds.items()):
            if found == kind:
                print(row(f"  {service}", own))
    for name, values in memory.series.items():
        if not values:
            continue
        first, end = memory.quarters(name)
        print(
            f"  {name:18}{first:8.1f} MB in the first quarter, {end:.1f} MB in the last, {max(values):.1f} MB at most"
        )
        if end > first + GROWTH:
            faults.append(f"{name} grew from {first:.1f} to {end:.1f} MB")
    faults += [f"failed: {failure[:500]}" for failure in whole.failed]
    print(f"{len(faults)} faults; {load()}")
    for fault in faults[:40]:
        print(f"  {fault}")
    return int(bool(faults))


def main() -> int:
    """Run the soak."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=60.0, help="how long (60)")
    parser.add_argument("--building", type=Path, help="a building of four storeys, instead of an office built for it")
    parser.add_argument("--domain", type=int, help="where to look for a free ROS domain")
    options = parser.parse_args()
    if importlib.util.find_spec("mujoco") is None:
        parser.error("the editor's placing needs MuJoCo: python -m mansion_bringup.extras sim")
    threading.excepthook = lambda hook: print(f"thread: {hook.exc_value}", file=sys.stderr)
    with tempfile.TemporaryDirectory(prefix="graph-soak-") as folder:
        return run(options, Path(folder))


if __name__ == "__main__":
    sys.exit(main())
