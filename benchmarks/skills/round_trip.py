"""Skill round trips through a server process: python benchmarks/skills/round_trip.py BUILDING [--calls 300]."""

import argparse
import statistics
import time

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("building")
    parser.add_argument("--calls", type=int, default=300)
    options = parser.parse_args()
    graph = GraphOptions(domain_id=free_domain(), quiet=True)
    node = NodeProcess("mansion_skills", "skill_server", "load_building")
    with GraphProcesses(graph, [node]) as running:
        running.wait_ready(60.0)
        with MansionClient(domain_id=graph.domain_id) as client:
            client.call("load_building", {"path": options.building, "reset": True})
            for name, arguments in (("where_am_i", None), ("list_visible", {}), ("rotate", {"degrees": 10})):
                seconds = []
                for _ in range(options.calls):
                    begin = time.perf_counter()
                    client.call(f"skills/{name}", arguments)
                    seconds.append(time.perf_counter() - begin)
                print(f"{name}: median {statistics.median(seconds) * 1e3:.2f} ms")


if __name__ == "__main__":
    main()
