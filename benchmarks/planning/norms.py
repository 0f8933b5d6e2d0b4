"""Deviations from the rules of building, by rule and kind of building, of buildings made from a sentence each.

python benchmarks/planning/norms.py [--types hotel school] [--seeds 0 1] [--jobs 1] [--lines] [--sound] [-o DIR]

The sentences are in `norms.toml`. A building is planned, drawn and furnished in this process and kept in DIR, where a
later run finds it: stopped runs go on, and changed rules are measured again on the same buildings. Take another DIR
after a change to what makes buildings. `--sound` runs the floors' checks of ``mansion check`` as well.
"""

import argparse
import time
import tomllib
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from itertools import product
from pathlib import Path

import msgspec

from mansion_bringup.building.report import building_index
from mansion_bringup.check import check_floors
from mansion_bringup.check.norms import Deviation, check_norms
from mansion_bringup.pipeline.floors import distinct_floors, furnish, solve, source_floor
from mansion_bringup.pipeline.stages import LocalStages
from mansion_export.formats import outputs_of_build
from mansion_msgs_py.building import Building
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene

SENTENCES = Path(__file__).with_suffix(".toml")


class Made(msgspec.Struct):
    """A finished building without its folder, or why there is none."""

    sentence: str
    building: Building | None = None
    scenes: list[FloorScene] = []
    refused: str = ""
    faults: list[str] = []
    seconds: float = 0.0


def made(sentence: str, seed: int, sound: bool) -> Made:
    """Return the building that a sentence asks for."""
    request = identified(BuildRequest(description=sentence, seed=seed))
    stages, begin, scenes = LocalStages(), time.process_time(), list[FloorScene]()
    try:
        plan = stages.plan(request)
        layouts = {index: solve(stages, plan, index) for index in distinct_floors(plan)}
        for index, floor in enumerate(plan.program.floors):
            layout = msgspec.structs.replace(layouts[source_floor(plan, index)], floor=floor.index)
            scenes.append(furnish(stages, plan, layout, index))
    except MansionError as error:
        return Made(sentence, refused=str(error))
    building = building_index(request, plan, scenes, outputs_of_build([]))
    faults = check_floors(building.building_id, scenes, plan.topologies) if sound else ()
    seconds = time.process_time() - begin
    return Made(sentence, building, scenes, faults=[str(fault) for fault in faults], seconds=round(seconds, 1))


def kept(folder: Path, kind: str, seed: int, sentence: str, sound: bool) -> Path:
    """Return the file of a building, made where it is not there or was asked for in other words."""
    file = folder / f"{kind}_{seed}.json"
    if not file.exists() or decode(Made, file.read_bytes()).sentence != sentence:
        part = file.with_suffix(".part")
        part.write_bytes(encode_bytes(made(sentence, seed, sound)))
        part.replace(file)
    return file


def buildings(options: argparse.Namespace) -> Iterator[tuple[str, int, Made]]:
    """Yield kind, seed and building for all kinds and seeds that are asked for, in order."""
    sentences: dict[str, str] = tomllib.loads(SENTENCES.read_text(encoding="utf-8"))
    chosen = list(product(options.types or sentences, options.seeds))
    jobs = [(options.output, kind, seed, sentences[kind], options.sound) for kind, seed in chosen]
    if options.jobs == 1:
        files: Iterator[Path] = (kept(*job) for job in jobs)
        yield from ((kind, seed, decode(Made, file.read_bytes())) for (kind, seed), file in zip(chosen, files))
        return
    with ProcessPoolExecutor(options.jobs) as pool:
        for (kind, seed), file in zip(chosen, pool.map(kept, *zip(*jobs))):
            yield kind, seed, decode(Made, file.read_bytes())


def table(found: Sequence[tuple[str, Deviation]]) -> Iterator[str]:
    """Yield a line for each rule: how many findings, in how many buildings, and in which kinds most."""
    by_rule = Counter((item.severity, item.rule) for _, item in found)
    for (severity, rule), count in sorted(by_rule.items(), key=lambda entry: (entry[0][0] == "advice", -entry[1])):
        kinds = Counter(kind for kind, item in found if item.rule == rule)
        most = ", ".join(f"{kind} {number}" for kind, number in kinds.most_common(6))
        yield f"{severity:10} {rule:24}{count:6} in {len(kinds):3} types: {most}"


def main() -> None:
    """Print a line for each building and the findings by rule."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--types", nargs="*", default=[], help="keys of norms.toml; all by default")
    parser.add_argument("--seeds", nargs="*", type=int, default=[0])
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--lines", action="store_true", help="print every finding")
    parser.add_argument("--sound", action="store_true", help="run the floors' checks on each new building")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/norms"))
    options = parser.parse_args()
    unknown = set(options.types) - tomllib.loads(SENTENCES.read_text(encoding="utf-8")).keys()
    if unknown:
        parser.error(f"no sentence in {SENTENCES.name} for {', '.join(sorted(unknown))}")
    options.output.mkdir(parents=True, exist_ok=True)
    counted: list[tuple[str, Deviation]] = []
    caused = seconds = 0.0
    for kind, seed, building in buildings(options):
        if building.building is None:
            print(f"{kind} {seed}: refused: {building.refused}", flush=True)
            continue
        found = check_norms(building.building, building.scenes)
        own = [item for item in found if not item.caused_by]
        caused, seconds = caused + len(found) - len(own), seconds + building.seconds
        counted += [(kind, item) for item in own]
        severities = Counter(item.severity for item in own)
        faults = f", {len(building.faults)} faults" if building.faults else ""
        print(f"{kind} {seed}: {severities['deviation']} deviations, {severities['advice']} advice{faults}", flush=True)
        for line in (*building.faults, *own) if options.lines else building.faults:
            print(f"    {line}", flush=True)
    print(*table(counted), sep="\n")
    print(f"{len(counted)} findings; {caused:.0f} caused by the sentences; CPU {seconds:.0f} s to make the buildings")


if __name__ == "__main__":
    main()
