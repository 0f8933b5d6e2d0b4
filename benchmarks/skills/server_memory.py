"""The server's memory while a client carries things about and rides between floors.

python benchmarks/skills/server_memory.py BUILDING [--minutes 5] [--samples 10]
"""

import argparse
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import Any

from soak import PAGE_MB

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_msgs_py.errors import MansionError


def resident(pid: int) -> float:
    """Return the memory that a process has now, MB."""
    return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * PAGE_MB


def calls(loaded: dict[str, Any], client: MansionClient) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield skills without end: look, take something seen, ride, put it down."""
    rng = Random(0)
    while True:
        yield "go_to_landmark", {"landmark": rng.choice(loaded["landmarks"])["name"]}
        seen = client.call("skills/list_visible", {})["objects"]
        for thing in [entry["id"] for entry in seen if entry["pickupable"]][:1]:
            yield "go_near_object", {"object": thing}
            yield "pick_up", {"object": thing}
        yield "go_to_landmark", {"landmark": "elevator"}
        yield "call_elevator", {}
        yield "use_elevator", {"target_floor": rng.choice(loaded["floors"])}
        yield "rotate", {"degrees": rng.uniform(-180, 180)}
        yield "move_ahead", {"distance": 0.5}
        yield "place", {"target": "floor"}


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("building")
    parser.add_argument("--minutes", type=float, default=5.0)
    parser.add_argument("--samples", type=int, default=10)
    options = parser.parse_args()
    graph = GraphOptions(domain_id=free_domain(), quiet=True)
    node = NodeProcess("mansion_skills", "skill_server", "load_building")
    with GraphProcesses(graph, [node]) as running:
        running.wait_ready(60.0)
        pid = running.running["skill_server"].pid
        with MansionClient(domain_id=graph.domain_id) as client:
            loaded = client.call("load_building", {"path": options.building, "reset": True})
            begin, count, series = time.monotonic(), 0, list[float]()
            for name, arguments in calls(loaded, client):
                done = (time.monotonic() - begin) / (60.0 * options.minutes)
                if done * options.samples >= len(series):
                    series.append(round(resident(pid), 1))
                if done >= 1.0:
                    break
                with suppress(MansionError):
                    client.call(f"skills/{name}", arguments if arguments else None)
                count += 1
    print(f"{count} calls in {options.minutes:g} minutes; the server's resident memory, MB: {series}")


if __name__ == "__main__":
    main()
