"""Round trips of a service between two processes: bare rclpy, the same under Mansion's profile, and MansionClient.

    python benchmarks/ros/service_round_trip.py [--rounds 10] [--calls 200] [--commands 10]

The service is a diagnostic_msgs/AddDiagnostics that sends its text back. Pairs of a server and a client run side by
side and are measured in turns; the others stand idle meanwhile:

    (a) bare rclpy, middleware as it comes with ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
    (b) bare rclpy, Mansion's loopback profile
    (c) MansionClient and a node of run_node and add_json_service, loopback profile (the aim is 1.3 times (a))

Bare clients call synchronously beside a thread that spins. The tables give
milliseconds of small calls and of large texts, and then the seconds of whole commands in turns: ``mansion call`` of the
echo by way of a resident client, as ``mansion up`` offers one (the aim is 0.7 s), the same with a participant of its
own, a Python that ends at once, and a script from its start to the moment at which its MansionClient sees the service.

The command runs as ``python -m mansion_bringup``; with ``--launcher`` as ``./mansion``, which first makes its
environment anew when the requirements have changed.
"""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final

from _processes import LOOPBACK, RANGE, Worker, all_ended, begin_worker, environment, load, say, spin

from mansion_bringup.graph.domains import free_domain

MODULE: Final = (sys.executable, "-P", "-m", "mansion_bringup")
LAUNCHER: Final = (str(Path(__file__).resolve().parents[2] / "mansion"),)

PAIRS: Final = {
    "a": ("bare", RANGE, "(a) bare rclpy, LOCALHOST"),
    "b": ("bare", LOOPBACK, "(b) bare rclpy, loopback profile"),
    "c": ("mansion", LOOPBACK, "(c) MansionClient, loopback profile"),
}
"""Kind of nodes, middleware setting and label of each pair."""

PATIENCE: Final = 60.0
"""Seconds for a worker's answer."""


def serve_bare() -> None:
    """Answer with rclpy alone, until told to end."""
    import rclpy
    from diagnostic_msgs.srv import AddDiagnostics

    def answer(request: Any, response: Any) -> Any:
        response.success, response.message = True, request.load_namespace
        return response

    rclpy.init(args=[])
    node = rclpy.create_node("bare_server")
    node.create_service(AddDiagnostics, "bare_echo", answer)
    spin(node)


def serve_mansion() -> None:
    """Answer as Mansion's nodes do, until told to end."""
    from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE, ServiceInterface
    from mansion_msgs_py.nodes.node import MansionNode
    from mansion_msgs_py.nodes.run import run_node
    from mansion_msgs_py.nodes.shell import add_json_service

    echo = ServiceInterface("echo", "echo", "Sends its text back.", str, str)

    def make() -> MansionNode:
        node = MansionNode("echo")
        add_json_service(node, echo, lambda text: text)
        return node

    run_node(make, ["--ros-args", "-r", f"__ns:={DEFAULT_NAMESPACE}"])


def bare_client() -> Callable[[str], str]:
    """Return a call of the bare server."""
    import rclpy
    from diagnostic_msgs.srv import AddDiagnostics

    rclpy.init(args=[])
    node = rclpy.create_node("bare_client")
    client = node.create_client(AddDiagnostics, "bare_echo")
    # Not spin_until_future_complete: in rclpy 7.1.6 each call of it takes longer than the one before.
    threading.Thread(target=spin, args=(node,)).start()
    if not client.wait_for_service(PATIENCE / 2):
        raise TimeoutError("no bare server")

    def call(text: str) -> str:
        response = client.call(AddDiagnostics.Request(load_namespace=text), PATIENCE / 2)
        if response is None:
            raise TimeoutError(f"no answer to {len(text)} characters")
        return str(response.message)

    return call


def mansion_client() -> Callable[[str], str]:
    """Return a call of the echo node."""
    from mansion_bringup.client import MansionClient

    client = MansionClient(timeout=PATIENCE / 2)

    def call(text: str) -> str:
        return str(client.call("echo", text, wait=PATIENCE / 2))

    return call


def measure(call: Callable[[str], str]) -> None:
    """Answer each pair of a text's length and a number of calls with the seconds of each call."""
    say("ready")
    for line in sys.stdin:
        length, calls = json.loads(line)
        text = "x" * length
        seconds = []
        for _ in range(calls):
            begin = time.perf_counter()
            reply = call(text)
            seconds.append(time.perf_counter() - begin)
            if len(reply) != length:
                raise ValueError(f"{len(reply)} characters came back for {length}")
        say(seconds)


def match() -> None:
    """Say when this process had imported the client, made one, and seen the echo node."""
    from mansion_bringup.client import MansionClient

    moments = [time.monotonic()]
    with MansionClient() as client:
        moments.append(time.monotonic())
        client.wait_served("echo", PATIENCE)
        say([*moments, time.monotonic()])


def keep() -> None:
    """Offer a resident client, as ``mansion up`` does, until the end of the input."""
    from mansion_bringup.graph.resident_client import ResidentClient
    from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE

    with ResidentClient(DEFAULT_NAMESPACE):
        say("ready")
        sys.stdin.read()


def worker(role: str, pair: str, domains: dict[str, int]) -> Worker:
    """Start one side of a pair."""
    setting = PAIRS[pair][1]
    return Worker([__file__, "--role", role], environment(setting, domains[setting]))


def round_trips(clients: dict[str, Worker], length: int, calls: int, rounds: int) -> dict[str, list[float]]:
    """Return the seconds of all calls of each pair; a first round only warms up."""
    seconds: dict[str, list[float]] = {pair: [] for pair in clients}
    for turn in range(rounds + 1):
        for pair, client in clients.items():
            measured = client.ask([length, calls], PATIENCE)
            if turn:
                seconds[pair] += measured
    return seconds


def print_round_trips(title: str, seconds: dict[str, list[float]]) -> None:
    """Print median and 95th percentile of each pair in ms, and their ratios to those of (a)."""
    figures = {
        pair: (statistics.median(values), statistics.quantiles(values, n=20)[-1]) for pair, values in seconds.items()
    }
    first = figures["a"]
    print(f"{title:38}{'median':>9}{'p95':>9}   ratio of medians, of p95")
    for pair, (median, p95) in figures.items():
        print(f"{PAIRS[pair][2]:38}{median * 1e3:9.2f}{p95 * 1e3:9.2f}   {median / first[0]:.2f}, {p95 / first[1]:.2f}")


def print_commands(command: Sequence[str], repeat: int, domain: int) -> None:
    """Print the seconds of ``mansion call``, and of a script's way to its first match."""
    with tempfile.TemporaryDirectory() as runtime:
        variables = {**environment(LOOPBACK, domain), "XDG_RUNTIME_DIR": runtime}
        keeper = Worker([__file__, "--role", "keeper"], variables)
        with all_ended([keeper]):
            keeper.hear(PATIENCE)
            ways = {
                "by the resident client": ([*command, "call", "echo", '"x"'], variables),
                "with a participant of its own": (
                    [*command, "call", "echo", '"x"'],
                    {**variables, "XDG_RUNTIME_DIR": f"{runtime}/none"},
                ),
                "a Python that ends at once": ([sys.executable, "-c", "pass"], variables),
            }
            calls: dict[str, list[float]] = {name: [] for name in ways}
            steps: list[list[float]] = []
            for _ in range(repeat):
                for name, (words, chosen) in ways.items():
                    begin = time.monotonic()
                    subprocess.run(words, env=chosen, stdout=subprocess.DEVNULL, timeout=PATIENCE, check=True)
                    calls[name].append(time.monotonic() - begin)
                begin = time.monotonic()
                script = Worker([__file__, "--role", "match"], variables)
                with all_ended([script]):
                    steps.append([moment - begin for moment in script.hear(PATIENCE)])
                    script.process.wait(PATIENCE)
    for name, seconds in calls.items():
        what = name if name.startswith("a ") else f"mansion call echo {name}"
        print(
            f"{what}: median {statistics.median(seconds):.2f} s, {min(seconds):.2f} to {max(seconds):.2f} s of {repeat}"
        )
    imported, made, matched = (statistics.median(column) for column in zip(*steps, strict=True))
    print(
        f"from a script's start: client imported {imported:.2f} s, made {made:.2f} s, "
        f"service seen {matched:.2f} s (at most {max(step[-1] for step in steps):.2f} s)"
    )


def run(options: argparse.Namespace) -> None:
    """Start the pairs, measure and print."""
    first = free_domain(options.domain)
    domains = {LOOPBACK: first, RANGE: free_domain(first)}
    print(load())
    workers: list[Worker] = []
    with all_ended(workers):
        workers += [worker(f"{PAIRS[pair][0]}_server", pair, domains) for pair in PAIRS]
        clients = {pair: worker(f"{PAIRS[pair][0]}_client", pair, domains) for pair in PAIRS}
        workers += clients.values()
        for client in clients.values():
            client.hear(PATIENCE)
        print_round_trips("ms", round_trips(clients, 10, options.calls, options.rounds))
        for megabytes in options.megabytes:
            seconds = round_trips(clients, megabytes * 1_000_000, 2, options.rounds)
            print_round_trips(f"ms, {megabytes} MB there and back", seconds)
        if options.commands:
            command = LAUNCHER if options.launcher else MODULE
            print_commands(command, options.commands, domains[LOOPBACK])
    print(load())


def main() -> None:
    """Run the benchmark, or one of its workers."""
    roles: dict[str, Callable[[], None]] = {
        "bare_server": serve_bare,
        "mansion_server": serve_mansion,
        "bare_client": lambda: measure(bare_client()),
        "mansion_client": lambda: measure(mansion_client()),
        "keeper": keep,
        "match": match,
    }
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=10, help="turns of each pair (10)")
    parser.add_argument("--calls", type=int, default=200, help="small calls in each turn (200)")
    parser.add_argument("--megabytes", type=int, nargs="*", default=[5], help="sizes of large texts (5)")
    parser.add_argument("--commands", type=int, default=10, help="times to run a command (10)")
    parser.add_argument("--launcher", action="store_true", help="time ./mansion itself")
    parser.add_argument("--domain", type=int, help="where to look for free ROS domains")
    parser.add_argument("--role", choices=roles, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.role:
        begin_worker()
        roles[options.role]()
    else:
        run(options)


if __name__ == "__main__":
    main()
