"""Memory and idle processor time of the nodes of the graph.

    python benchmarks/ros/node_memory.py [--idle 10] [--nodes floor_solver object_placer ...]

Starts the graph in a domain of its own under Mansion's loopback profile, waits until every service is served, and
prints for each node its memory in MB, with shared pages divided by those that share them (Pss) and in full (Rss), its
threads, the processor seconds of its start, and its share of a core while nobody calls (the aim is 1%).
"""

import argparse
import statistics
import time
from pathlib import Path

from _processes import load, processor_seconds, proportional_mb, resident_mb

from mansion_bringup.discovery import kept_to_this_machine
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GRAPH_NODES, GraphOptions, GraphProcesses

SETTLE = 2.0
"""Seconds between the last service's coming up and the measuring."""


def main() -> None:
    """Measure and print the table."""
    names = [node.executable for node in GRAPH_NODES]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--idle", type=float, default=10.0, help="seconds to watch (10)")
    parser.add_argument("--nodes", nargs="+", choices=names, default=names, help="all of them")
    parser.add_argument("--patience", type=float, default=180.0, help="seconds for the nodes to come up (180)")
    parser.add_argument("--domain", type=int, help="where to look for a free ROS domain")
    options = parser.parse_args()
    graph = GraphOptions(domain_id=free_domain(options.domain), log_level="warn")
    nodes = [node for node in GRAPH_NODES if node.executable in options.nodes]
    begin = time.monotonic()
    with kept_to_this_machine(), GraphProcesses(graph, nodes) as running:
        running.wait_ready(options.patience)
        print(f"{len(nodes)} nodes up after {time.monotonic() - begin:.1f} s")
        time.sleep(SETTLE)
        pids = {name: process.pid for name, process in running.running.items()}
        before = {name: processor_seconds(pid) for name, pid in pids.items()}
        time.sleep(options.idle)
        idle = [100 * (processor_seconds(pid) - before[name]) / options.idle for name, pid in pids.items()]
        shared = [proportional_mb(pid) for pid in pids.values()]
        resident = [resident_mb(pid) for pid in pids.values()]
        threads = [len(list(Path(f"/proc/{pid}/task").iterdir())) for pid in pids.values()]
    print("node                  Pss MB    Rss MB   threads   start cpu s   idle % core")
    for row in zip(pids, shared, resident, threads, before.values(), idle, strict=True):
        print("{:20}{:8.1f}{:10.1f}{:10d}{:14.1f}{:14.2f}".format(*row))
    print(f"{'together':20}{sum(shared):8.1f}{'':20}{sum(before.values()):14.1f}{sum(idle):14.2f}")
    print(f"{statistics.mean(shared):.0f} MB (Pss) a node; {load()}")


if __name__ == "__main__":
    main()
