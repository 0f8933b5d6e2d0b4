"""A build in this process beside the same build through a running graph."""

import hashlib
import os
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from mansion_bringup.client import MansionClient
from mansion_bringup.discovery import kept_to_this_machine
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.world import Progress

__all__ = ["BuildComparison", "compare_builds", "digest"]


@dataclass(frozen=True)
class BuildComparison:
    """Median seconds of both ways, and how many different buildings came out."""

    local: float
    graph: float
    runs: int
    distinct: int

    def __str__(self) -> str:
        return (
            f"one process tree  {self.local:.2f} s (median of {self.runs})\n"
            f"running graph     {self.graph:.2f} s, {self.graph / self.local:.2f}x\n"
            f"buildings         {self.distinct} distinct of {2 * self.runs + 2}"
        )


def digest(folder: Path) -> str:
    """Return one hash of all files of a building but its report, which holds times."""
    whole = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.name != "report.json":
            whole.update(str(path.relative_to(folder)).encode())
            whole.update(path.read_bytes())
    return whole.hexdigest()


def compare_builds(
    brief: str, repeat: int, report: Callable[[Progress], None] = lambda progress: None
) -> BuildComparison:
    """Build `brief` in turns in this process tree and through a private graph; the first turn only warms up."""
    request = BuildRequest(description=brief)
    options = GraphOptions(domain_id=free_domain(), quiet=True)
    local: list[float] = []
    remote: list[float] = []
    with tempfile.TemporaryDirectory() as folder, kept_to_this_machine(), GraphProcesses(options) as graph:
        root = Path(folder)
        graph.wait_ready(180.0)
        with MansionClient(domain_id=options.domain_id) as client:
            for turn in range(repeat + 1):
                report(Progress(stage="bench", message=f"turn {turn}", done=turn, total=repeat + 1))
                start = time.perf_counter()
                build_building(request, root / f"local_{turn}", jobs=os.cpu_count() or 1)
                middle = time.perf_counter()
                client.build(brief, output=str(root / f"graph_{turn}"))
                local.append(middle - start)
                remote.append(time.perf_counter() - middle)
        distinct = len({digest(path) for path in root.iterdir()})
    return BuildComparison(median(local[1:]), median(remote[1:]), repeat, distinct)
