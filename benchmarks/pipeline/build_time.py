"""Time of ``mansion build`` in one process tree and through a running graph, and whether the bytes agree.

python benchmarks/pipeline/build_time.py [--brief TEXT] [--repeat 3]
"""

import argparse
import hashlib
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domain import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses

BRIEF = "A four-storey office with a cafeteria on the ground floor"


def digest(folder: Path) -> str:
    """One hash of all files but the report."""
    whole = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.name != "report.json":
            whole.update(str(path.relative_to(folder)).encode())
            whole.update(path.read_bytes())
    return whole.hexdigest()


def run_local(brief: str, output: Path) -> float:
    """Seconds of the whole command, the interpreter's start included."""
    start = time.perf_counter()
    command = [sys.executable, "-m", "mansion_bringup", "build", brief, "-o", str(output)]
    subprocess.run(command, check=True, capture_output=True)
    return time.perf_counter() - start


def run_graph(client: MansionClient, brief: str, output: Path) -> float:
    """Seconds of the service call."""
    start = time.perf_counter()
    client.build(brief, output=str(output))
    return time.perf_counter() - start


def main() -> None:
    """Print medians, their ratio and whether all buildings are the same bytes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--brief", default=BRIEF)
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    graph_options = GraphOptions(domain_id=free_domain(), quiet=True)
    with tempfile.TemporaryDirectory() as folder, GraphProcesses(graph_options) as graph:
        root = Path(folder)
        graph.wait_ready()
        local, remote = [], []
        with MansionClient(domain_id=graph_options.domain_id) as client:
            run_local(options.brief, root / "warm")
            run_graph(client, options.brief, root / "warm_graph")
            for index in range(options.repeat):
                local.append(run_local(options.brief, root / f"local_{index}"))
                remote.append(run_graph(client, options.brief, root / f"graph_{index}"))
        hashes = {digest(path) for path in root.iterdir()}
    print(f"mansion build      {median(local):.2f} s (median of {options.repeat})")
    print(f"running graph      {median(remote):.2f} s, {median(remote) / median(local):.2f}x")
    print(f"buildings          {len(hashes)} distinct of {2 * options.repeat + 2}")


if __name__ == "__main__":
    main()
