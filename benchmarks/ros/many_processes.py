"""Processes with a node each in one domain: how long until each knows all others, and what they cost.

    python benchmarks/ros/many_processes.py [--processes 40] [--idle 10] [--setting all] [--no-shm]

Every process is started first and waits; the clock runs from the common start to the moment at which the last of them
lists all nodes and all their services (the aim is 5 s for 40). Then their memory is read, each shared page divided by
those that share it (Pss), and the processor time of the idle nodes (the aim is 1% of a core for each).

The table has a row for Mansion's loopback profile, and with ``--setting all`` one for the middleware as it comes with
ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST. There Fast DDS looks for the first 32 participants of a machine only, so that
more do not all find each other. ``--no-shm`` adds, for both settings, runs in a private mount namespace where /dev/shm
has 64 MB, can only be read, or is full. (In a full one rclpy cannot be imported: its tracing writes a page there.)
"""

import argparse
import os
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass
from typing import Final

from _processes import (
    LOOPBACK,
    RANGE,
    Worker,
    all_ended,
    begin_worker,
    environment,
    load,
    processor_seconds,
    proportional_mb,
    say,
    spin,
)

from mansion_bringup.graph.domains import free_domain

SHARED: Final = "/dev/shm"

MOUNTS: Final = {"as it is": "", "64 MB": "size=64m", "read-only": "ro", "full": "size=4k"}
"""What /dev/shm is like, and the options of the tmpfs that is mounted over it; 4 kB is less than one segment."""

NAMESPACES: Final = (("unshare", "--mount"), ("unshare", "--mount", "--map-root-user"))
"""Commands that run another in a mount namespace, for root and for others."""

HEADER: Final = (
    "                                         all known  discovery  idle mean     most       Pss  /dev/shm\n"
    "setting           /dev/shm   known               s      cpu s    % core   % core        MB        MB"
)

SETTLE: Final = 2.0
"""Seconds between the discovery and the measuring of idle nodes."""

LOOK: Final = 0.1
"""Seconds between two looks of a node at the others."""


@dataclass(frozen=True)
class Fleet:
    """What a number of processes came to.

    Attributes
    ----------
    known : int
        Nodes that the least informed process knows, itself included.
    seconds : float
        From the common start until the last process knew all, or gave up.
    discovery, idle : float
        Processor seconds of a process until then (mean), and its share of a core afterwards in percent (mean).
    busiest : float
        The largest share of a core.
    memory : float
        MB (Pss) of a process, mean.
    shared : float
        MB in /dev/shm.
    """

    known: int
    seconds: float
    discovery: float
    idle: float
    busiest: float
    memory: float
    shared: float


def be_node(number: int, count: int, patience: float) -> None:
    """Be one node: say how many it knows once these are all, or `patience` seconds are over."""
    import rclpy
    from std_msgs.msg import String
    from std_srvs.srv import Trigger

    say("loaded")
    sys.stdin.readline()
    end = time.monotonic() + patience
    rclpy.init(args=[])
    node = rclpy.create_node(f"node_{number}")
    node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda message: None, 10)
    node.create_service(Trigger, f"ping_{number}", lambda request, response: response)
    known = 0
    while node.context.ok() and known < count and time.monotonic() < end:
        time.sleep(LOOK)
        services = [name for name, _ in node.get_service_names_and_types() if "/ping_" in name]
        known = min(len(set(node.get_node_names())), len(services))
    say([known, time.monotonic()])
    spin(node)


def measure(options: argparse.Namespace) -> Fleet:
    """Start the processes here, with the environment as it is, and end them."""
    count, patience = options.processes, options.patience
    arguments = ["--patience", str(patience), "--processes", str(count)]
    workers: list[Worker] = []
    with all_ended(workers):
        for number in range(count):
            role = [__file__, *arguments, "--node", str(number)]
            workers.append(Worker(role, dict(os.environ)))
        for worker in workers:
            worker.hear(patience)
        before = [processor_seconds(worker.pid) for worker in workers]
        begin = time.monotonic()
        for worker in workers:
            worker.tell("go")
        found = [worker.hear(2 * patience) for worker in workers]
        discovery = [processor_seconds(worker.pid) - spent for worker, spent in zip(workers, before, strict=True)]
        time.sleep(SETTLE)
        before = [processor_seconds(worker.pid) for worker in workers]
        time.sleep(options.idle)
        idle = [
            100 * (processor_seconds(worker.pid) - spent) / options.idle
            for worker, spent in zip(workers, before, strict=True)
        ]
        return Fleet(
            known=min(known for known, _ in found),
            seconds=max(moment for _, moment in found) - begin,
            discovery=statistics.mean(discovery),
            idle=statistics.mean(idle),
            busiest=max(idle),
            memory=statistics.mean(proportional_mb(worker.pid) for worker in workers),
            shared=shared_mb(),
        )


def shared_mb() -> float:
    """Return what is used of /dev/shm in MB."""
    status = os.statvfs(SHARED)
    return (status.f_blocks - status.f_bfree) * status.f_frsize / 1e6


def namespaced(mount: str) -> list[str]:
    """Return the start of a command that runs with a tmpfs of these options over /dev/shm.

    Raises
    ------
    PermissionError
        With the system's words where rights are lacking.
    """
    script = f'mount -t tmpfs -o {mount} tmpfs {SHARED} && exec "$@"'
    for namespace in NAMESPACES:
        prefix = [*namespace, "sh", "-c", script, "sh"]
        tried = subprocess.run([*prefix, "true"], capture_output=True, text=True, check=False)
        if tried.returncode == 0:
            return prefix
    raise PermissionError(tried.stderr.strip())


def row(setting: str, shared: str, options: argparse.Namespace) -> str:
    """Measure in a process of its own, in a namespace where `shared` asks for one, and return a row of the table."""
    title = f"{setting:18}{shared:11}"
    try:
        prefix = namespaced(MOUNTS[shared]) if MOUNTS[shared] else []
    except PermissionError as error:
        return f"{title}skipped: no rights to a mount namespace ({error})"
    names = ("processes", "idle", "patience")
    arguments = [word for name in names for word in (f"--{name}", str(getattr(options, name)))]
    variables = environment(setting, free_domain(options.domain))
    runner = Worker([__file__, *arguments, "--fleet"], variables, prefix)
    with all_ended([runner]):
        # Starting, finding, idling and ending are all bounded by the runner itself.
        answer = runner.hear(6 * options.patience + options.idle)
        runner.process.wait(options.patience)
    if isinstance(answer, str):
        return f"{title}{answer}"
    fleet = Fleet(**answer)
    return (
        f"{title}{fleet.known:4d} of {options.processes:<4d}{fleet.seconds:9.1f}"
        f"{fleet.discovery:11.2f}{fleet.idle:10.2f}{fleet.busiest:9.2f}{fleet.memory:10.1f}"
        f"{fleet.shared:10.1f}"
    )


def run_fleet(options: argparse.Namespace) -> None:
    """Measure, and say the figures or why there are none."""
    try:
        say(vars(measure(options)))
    except (EOFError, BrokenPipeError, TimeoutError) as error:
        say(f"failed: {error}")


def main() -> None:
    """Print the table, or be one of its processes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--processes", type=int, default=40, help="nodes in the domain (40)")
    parser.add_argument("--idle", type=float, default=10.0, help="seconds to watch idle nodes (10)")
    parser.add_argument("--patience", type=float, default=60.0, help="seconds until a node gives up looking (60)")
    parser.add_argument("--setting", choices=["loopback", "localhost", "all"], default="loopback")
    parser.add_argument("--no-shm", action="store_true", help="also with little or no /dev/shm")
    parser.add_argument("--domain", type=int, help="where to look for a free ROS domain")
    parser.add_argument("--fleet", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--node", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.node is not None:
        begin_worker()
        be_node(options.node, options.processes, options.patience)
        return
    if options.fleet:
        begin_worker()
        run_fleet(options)
        return
    chosen = {"loopback": [LOOPBACK], "localhost": [RANGE], "all": [LOOPBACK, RANGE]}
    rows = [(setting, "as it is") for setting in chosen[options.setting]]
    if options.no_shm:
        rows += [(setting, name) for setting in (LOOPBACK, RANGE) for name in list(MOUNTS)[1:]]
    print(HEADER)
    for setting, shared in rows:
        print(row(setting, shared, options), flush=True)
    print(load())


if __name__ == "__main__":
    main()
