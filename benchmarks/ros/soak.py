"""Hours of use in minutes: what grows, hangs or gets lost while clients call, come and go in several processes.

    python benchmarks/ros/soak.py [--seconds 60] [--servers 2] [--callers 3]

Each server is a node of run_node and add_json_service. Each caller is a process with one MansionClient that calls them
all the time, and one thread in which others are made, call once and are closed. Everything is under Mansion's loopback
profile. Prints what was done, and memory (Pss) after a quarter of the time and at the end. The exit status is 1 if a
call was lost, a process hung or ended, or one of them grew by 20 MB.
"""

import argparse
import json
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable
from typing import Any, Final

from _processes import (
    LOOPBACK,
    Worker,
    all_ended,
    begin_worker,
    environment,
    load,
    processor_seconds,
    proportional_mb,
    say,
)

from mansion_bringup.graph.domains import free_domain
from mansion_msgs_py.errors import MansionError

PATIENCE: Final = 15.0
"""Seconds for a call; a process that says nothing for twice as long hangs."""

GROWTH: Final = 20.0
"""MB by which a process may grow."""

TEXT: Final = "x" * 1000


def serve(number: int) -> None:
    """Answer until told to end."""
    from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE, ServiceInterface
    from mansion_msgs_py.nodes.node import MansionNode
    from mansion_msgs_py.nodes.run import run_node
    from mansion_msgs_py.nodes.shell import add_json_service

    def make() -> MansionNode:
        name = f"echo_{number}"
        node = MansionNode(name)
        echo = ServiceInterface(name, name, "Sends its text back.", str, str)
        add_json_service(node, echo, lambda text: text)
        return node

    run_node(make, ["--ros-args", "-r", f"__ns:={DEFAULT_NAMESPACE}"])


class Caller:
    """What the threads of a calling process do, and count.

    Parameters
    ----------
    servers : int
    """

    def __init__(self, servers: int) -> None:
        from mansion_bringup.client import MansionClient

        self.make: Callable[[], MansionClient] = lambda: MansionClient(timeout=PATIENCE)
        self.servers = servers
        self.counts: Counter[str] = Counter()
        self.faults: list[str] = []
        self.slowest = {"call": 0.0, "close": 0.0}
        self.stopped = threading.Event()

    def call_steadily(self) -> None:
        """Call the servers in turn with one client."""
        with self.make() as client:
            while not self.stopped.is_set():
                self._call(client, self.counts["calls"])
                self.counts["calls"] += 1

    def come_and_go(self) -> None:
        """Make a client, call once, close it."""
        while not self.stopped.is_set():
            client = self.make()
            self._call(client, self.counts["guests"])
            begin = time.monotonic()
            client.close()
            self._note("close", time.monotonic() - begin)
            self.counts["guests"] += 1

    def _call(self, client: Any, count: int) -> None:
        begin = time.monotonic()
        try:
            reply = client.call(f"echo_{count % self.servers}", TEXT, wait=PATIENCE)
        except MansionError as error:
            self.faults.append(str(error))
        else:
            if reply != TEXT:
                self.faults.append(f"{len(reply)} characters came back")
        self._note("call", time.monotonic() - begin)

    def _note(self, name: str, seconds: float) -> None:
        self.slowest[name] = max(self.slowest[name], seconds)

    def report(self) -> dict[str, Any]:
        """Return the counts so far."""
        return {"counts": self.counts, "faults": self.faults, "slowest": self.slowest}


def call(servers: int) -> None:
    """Be a caller: report whenever asked, until asked to stop."""
    caller = Caller(servers)
    jobs = (caller.call_steadily, caller.come_and_go)
    threads = [threading.Thread(target=job, name=job.__name__, daemon=True) for job in jobs]
    for thread in threads:
        thread.start()
    for line in sys.stdin:
        stopping = json.loads(line) == "stop"
        if stopping:
            caller.stopped.set()
            for thread in threads:
                thread.join(PATIENCE)
        report = caller.report()
        if stopping:
            hung = [f"{thread.name} hangs" for thread in threads if thread.is_alive()]
            report["faults"] = report["faults"] + hung
        say(report)


def run(options: argparse.Namespace) -> int:
    """Let the processes work, print the figures, and return the exit status."""
    variables = environment(LOOPBACK, free_domain(options.domain))
    count = ["--servers", str(options.servers)]
    workers: dict[str, Worker] = {}
    started: list[Worker] = []
    faults: list[str] = []
    with all_ended(started):
        for number in range(options.servers):
            workers[f"server {number}"] = Worker([__file__, "--serve", str(number)], variables)
            started.append(workers[f"server {number}"])
        callers = {
            f"caller {number}": Worker([__file__, "--call", *count], variables) for number in range(options.callers)
        }
        workers |= callers
        started += callers.values()
        time.sleep(options.seconds / 4)
        early = memory(workers)
        reports: dict[str, Any] = {}
        end = time.monotonic() + 0.75 * options.seconds
        while time.monotonic() < end:
            time.sleep(max(0.0, min(5.0, end - time.monotonic())))
            reports |= ask(callers, "report", faults)
        late = memory(workers)
        spent = {name: processor_seconds(worker.pid) for name, worker in workers.items()}
        reports |= ask(callers, "stop", faults)
        for name, worker in workers.items():
            if worker.process.poll() is not None:
                faults.append(f"{name} ended with status {worker.process.returncode}")
    print(f"{'':12}{'calls':>9}{'guests':>9}{'slowest':>10}{'close':>9}{'cpu s':>9}{'Pss MB':>18}")
    for name in workers:
        report = reports.get(name, {"counts": {}, "faults": [], "slowest": {}})
        faults += [f"{name}: {fault}" for fault in report["faults"]]
        print(
            f"{name:12}{report['counts'].get('calls', 0):9d}{report['counts'].get('guests', 0):9d}"
            f"{report['slowest'].get('call', 0.0):9.2f}s{report['slowest'].get('close', 0.0):8.2f}s"
            f"{spent[name]:9.1f}{early[name]:9.1f} to {late[name]:.1f}"
        )
        if late[name] > early[name] + GROWTH:
            faults.append(f"{name} grew from {early[name]:.1f} to {late[name]:.1f} MB")
    print(f"{len(faults)} faults; {load()}")
    for fault in faults[:20]:
        print(f"  {fault}")
    return int(bool(faults))


def memory(workers: dict[str, Worker]) -> dict[str, float]:
    """Return the MB of each process; 0 for one that has ended."""
    return {
        name: proportional_mb(worker.pid) if worker.process.poll() is None else 0.0 for name, worker in workers.items()
    }


def ask(callers: dict[str, Worker], question: str, faults: list[str]) -> dict[str, Any]:
    """Return the reports of the callers; note those that do not answer, and ask them no more."""
    reports = {}
    for name, worker in list(callers.items()):
        try:
            reports[name] = worker.ask(question, 3 * PATIENCE)
        except (TimeoutError, EOFError, BrokenPipeError) as error:
            faults.append(f"{name}: {error}")
            del callers[name]
    return reports


def main() -> int:
    """Run the soak, or one of its processes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=60.0, help="how long to call (60)")
    parser.add_argument("--servers", type=int, default=2, help="serving processes (2)")
    parser.add_argument("--callers", type=int, default=3, help="calling processes (3)")
    parser.add_argument("--domain", type=int, help="where to look for a free ROS domain")
    parser.add_argument("--serve", type=int, help=argparse.SUPPRESS)
    parser.add_argument("--call", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.serve is not None or options.call:
        begin_worker()
        if options.call:
            call(options.servers)
        else:
            serve(options.serve)
        return 0
    return run(options)


if __name__ == "__main__":
    sys.exit(main())
