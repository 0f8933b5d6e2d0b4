"""Many sentences, several seeds: every building built in this process and verified as ``mansion check`` does.

python benchmarks/pipeline/many_buildings.py [--seeds 0 1 2] [--only hospital] [--limit 5] [--keep DIR] [--scenes]
python benchmarks/pipeline/many_buildings.py --variety 20      # seeds of one sentence: do they differ, do all pass
"""

import argparse
import itertools
import shutil
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from mansion_bringup.building.report import building_index
from mansion_bringup.check import Fault, check_floors
from mansion_bringup.check.request import check_request
from mansion_bringup.pipeline import build as steps
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.pipeline.stages import LocalStages
from mansion_bringup.verify import check_houses, verify_building
from mansion_export.formats import Outputs
from mansion_export.thor import house
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene

SENTENCES = {
    "flat": "A small flat with one bedroom and a balcony",
    "house": "A two-storey family house with three bedrooms, a study and a garage",
    "duplex": "A duplex apartment of 140 m2 with an open kitchen, two bathrooms and a balcony upstairs",
    "villa": "A villa with a basement, a wine cellar, a home cinema and four bedrooms",
    "office": "A four-storey office with a cafeteria on the ground floor",
    "school": "A three-storey primary school with twelve classrooms, a library and a gym",
    "kindergarten": "A kindergarten for 60 children with a nap room and a kitchen",
    "hospital": "A ten-storey hospital with an emergency department on the ground floor",
    "clinic": "A two-floor medical clinic with a pharmacy and a laboratory",
    "hotel": "A five-storey hotel with 40 rooms, a restaurant and a spa",
    "dormitory": "A student dormitory on three floors with shared kitchens and a laundry",
    "supermarket": "A supermarket with a bakery, cold storage and a staff room",
    "mall": "A three-level shopping mall with a food court and a cinema",
    "library": "A public library with two floors, reading rooms and a children's area",
    "museum": "A museum with four exhibition halls, a gift shop and a cafe",
    "restaurant": "A restaurant with a bar, a terrace and a large kitchen",
    "cinema": "A cinema with three screens and a lobby with a snack bar",
    "gym": "A two-storey gym with a swimming pool, changing rooms and a cafe",
    "fire_station": "A fire station with a vehicle bay, a dormitory and a kitchen",
    "laboratory": "A research laboratory of three floors with clean rooms and offices",
    "warehouse": "A warehouse of 1200 m2 with loading docks and a small office",
    "mixed": "A six-storey mixed-use building with shops on the ground floor and apartments above",
    "basement": "A two-storey office with a basement for archives, servers and parking",
    "court": "A courthouse with two courtrooms, a law library and offices on two floors",
}


@dataclass(frozen=True)
class Row:
    """What became of one sentence under one seed."""

    name: str
    seed: int
    floors: int
    rooms: int
    area: float
    objects: int
    discarded: int
    downgrades: int
    seconds: float
    faults: list[Fault]
    notes: list[str]
    scenes: list[FloorScene]


def main() -> None:
    """Print a line for each building, its faults below it, and a summary by kind of fault."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2])
    parser.add_argument("--only", nargs="*", default=[], help="names of sentences")
    parser.add_argument("--limit", type=int, default=len(SENTENCES), help="how many sentences")
    parser.add_argument("--keep", type=Path, help="folder in which the buildings stay")
    parser.add_argument("--scenes", action="store_true", help="no files, only scenes and houses")
    parser.add_argument("--variety", type=int, default=0, help="compare so many seeds of --only")
    options = parser.parse_args()
    chosen = [name for name in SENTENCES if not options.only or name in options.only]
    seeds = options.seeds
    if options.variety:
        chosen, seeds = (chosen if options.only else ["office"])[:1], range(options.variety)
    folder = options.keep or Path(tempfile.mkdtemp(prefix="many_buildings_"))
    print(f"{'sentence':14}{'seed':>4}{'floors':>7}{'rooms':>6}{'m2':>7}{'objects':>8}"
          f"{'left':>5}{'down':>5}{'CPU s':>7}{'faults':>7}")  # fmt: skip
    rows = []
    for name in chosen[: options.limit]:
        for seed in seeds:
            rows.append(_row(name, seed, folder, scenes_only=options.scenes))
            _print_row(rows[-1])
    if options.keep is None:
        shutil.rmtree(folder)
    _summary(rows)
    if options.variety:
        _print_variety(rows)
    if any(row.faults for row in rows):
        raise SystemExit(1)


def _row(name: str, seed: int, folder: Path, *, scenes_only: bool) -> Row:
    request = BuildRequest(description=SENTENCES[name], seed=seed)
    started = time.process_time()
    notes: list[str] = []
    try:
        if scenes_only:
            scenes, faults = _scenes(request, notes)
        else:
            path = folder / f"{name}_{seed}"
            built = build_building(request, path)
            faults = verify_building(path)
            scenes = [decode(FloorScene, (path / entry.files["scene"]).read_bytes()) for entry in built.building.floors]
    except MansionError as error:
        scenes, faults = [], [Fault("BUILD", name, f"{error} {error.info.details.get('stage')}")]
    return Row(
        name=name,
        seed=seed,
        floors=len(scenes),
        rooms=sum(len(scene.rooms) for scene in scenes),
        area=sum(room.area for scene in scenes for room in scene.rooms),
        objects=sum(len(scene.objects) for scene in scenes),
        discarded=sum(item.count for scene in scenes for item in scene.discarded),
        downgrades=sum(len(scene.downgrades) for scene in scenes),
        seconds=time.process_time() - started,
        faults=faults,
        notes=notes + _left_out(scenes),
        scenes=scenes,
    )


def _scenes(request: BuildRequest, notes: list[str]) -> tuple[list[FloorScene], list[Fault]]:
    """Run the stages without writing a file, and every check that needs none."""
    request, stages = identified(request), LocalStages()
    plan = steps.at_stage("plan_program", lambda: stages.plan(request))
    layouts = {index: steps.solve(stages, plan, index) for index in steps.distinct_floors(plan)}
    scenes, all_layouts = [], []
    for index, floor in enumerate(plan.program.floors):
        layout = layouts[steps.source_floor(plan, index)]
        layout = msgspec.structs.replace(layout, floor=floor.index)
        all_layouts.append(layout)
        scenes.append(steps.furnish(stages, plan, layout, index))
    building = building_index(request, plan, scenes, Outputs((), ()))
    faults = [
        *check_request(building, all_layouts, scenes),
        *check_floors(building.building_id, scenes, plan.topologies),
    ]
    for scene in scenes:
        faults += check_houses(f"floor {scene.floor}", house(scene), notes.append)
    return scenes, faults


def _left_out(scenes: Sequence[FloorScene]) -> list[str]:
    return [
        f"left: {item.room} {item.name} x{item.count}: {item.reason}" for scene in scenes for item in scene.discarded
    ] + [
        f"down: floor {scene.floor} {wish.wish}: {wish.got} ({wish.reason})"
        for scene in scenes
        for wish in scene.downgrades
    ]


def _print_row(row: Row) -> None:
    print(f"{row.name:14}{row.seed:4}{row.floors:7}{row.rooms:6}{row.area:7.0f}{row.objects:8}"
          f"{row.discarded:5}{row.downgrades:5}{row.seconds:7.1f}{len(row.faults):7}",
          flush=True)  # fmt: skip
    for fault in row.faults:
        print(f"      {fault}")
    for note in row.notes:
        print(f"      - {note}")


def _summary(rows: Sequence[Row]) -> None:
    kinds = Counter(fault.kind for row in rows for fault in row.faults)
    clean = sum(not row.faults for row in rows)
    print(f"{clean} of {len(rows)} buildings without a fault; {dict(sorted(kinds.items()))}")


def _print_variety(rows: Sequence[Row]) -> None:
    """How many of the seeds differ in outline, in rooms, and in what stands in them."""
    outlines = {str([scene.outline for scene in row.scenes]) for row in rows}
    layouts = {str([room.polygon for scene in row.scenes for room in scene.rooms]) for row in rows}
    contents = {str([(item.asset, item.position) for scene in row.scenes for item in scene.objects]) for row in rows}
    assets = [{item.asset for scene in row.scenes for item in scene.objects} for row in rows]
    alike = [len(a & b) / len(a | b) for a, b in itertools.pairwise(assets) if a | b]
    print(f"of {len(rows)} seeds: {len(outlines)} outlines, {len(layouts)} layouts, "
          f"{len(contents)} furnishings; neighbours share {sum(alike) / max(1, len(alike)):.0%} "
          f"of their assets")  # fmt: skip


if __name__ == "__main__":
    main()
