"""Export many buildings in one process, as the building director's workers do, and say how its memory goes.

    python benchmarks/export/worker_memory.py DIR... [--exports 120]

The buildings are exported by turns, each with the files that every build writes and with the check of its floors.
Prints a line for every ten: the memory of the process (Pss) and the processor time that it has used. The exit status is
1 where its median memory over the last quarter of the exports is 20 MB more than over the second: until then it fills
its caches.
"""

import argparse
import itertools
import statistics
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Final

from mansion_bringup.building.files import floor_files
from mansion_bringup.pipeline.executors import export_pool
from mansion_bringup.verify import floor_faults
from mansion_export.formats import outputs_of_build
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.workers import release_memory

GROWTH: Final = 20.0
"""MB by which the memory may grow."""


def export(folder: Path, worker: ProcessPoolExecutor) -> None:
    """Have a worker do what it does for a build: the files of each floor and of the building, and the check."""
    building, outputs = BuildingFolder(folder), outputs_of_build()
    topologies = [building.topology(floor) for floor in building.floors]
    scenes = building.scenes()
    for floor, topology, scene in zip(building.floors, topologies, scenes):
        worker.submit(floor_files, topology, building.layout(floor), scene, outputs.floor).result()
    for output in outputs.building:
        worker.submit(output.make, scenes).result()
    worker.submit(floor_faults, building.building.building_id, scenes, topologies).result()


def memory() -> float:
    """Return the memory of the process that is asked, MB."""
    lines = Path("/proc/self/smaps_rollup").read_text(encoding="ascii").splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("Pss:")) / 1024.0


def measured(folders: list[Path], exports: int, worker: ProcessPoolExecutor) -> list[float]:
    """Export, and return the memory of the worker after each building."""
    series = []
    for number, folder in enumerate(itertools.islice(itertools.cycle(folders), exports), start=1):
        export(folder, worker)
        worker.submit(release_memory)
        series.append(worker.submit(memory).result())
        if number % 10 == 0:
            used = worker.submit(time.process_time).result()
            print(f"{number} exports: {statistics.median(series[-10:]):.0f} MB, {used:.1f} s", flush=True)
    return series


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path, help="of buildings")
    parser.add_argument("--exports", type=int, default=120, help="how many (120)")
    options = parser.parse_args()
    with export_pool(1) as worker:
        series = measured(options.folders, options.exports, worker)
    quarter = max(1, len(series) // 4)
    medians = [statistics.median(series[k * quarter : (k + 1) * quarter]) for k in range(4)]
    print("MB by quarters:", ", ".join(f"{each:.0f}" for each in medians), f"at most {max(series):.0f}")
    return int(medians[3] > medians[1] + GROWTH)


if __name__ == "__main__":
    sys.exit(main())
