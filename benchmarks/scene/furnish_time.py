"""CPU seconds of ``furnish_floor`` for whole floors: structure, furniture, small objects, light; checks on request.

python benchmarks/scene/furnish_time.py [--seeds 0 1 2] [--only dwelling] [--check]
"""

import argparse
import time

from mansion_bringup.check import check_floors
from mansion_bringup.pipeline import floors as steps
from mansion_bringup.pipeline.stages import LocalStages
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.stages import PlanReply

FLOORS = {
    "dwelling": ("A family house with six bedrooms, three bathrooms and a study", 500.0),
    "office": ("An office", 500.0),
    "ward": ("A hospital", 500.0),
    "school": ("A school with six classrooms", 800.0),
    "market": ("A supermarket with a bakery", 1000.0),
}
"""Name to sentence and area of its one floor, square metres."""


def layout_of(sentence: str, area: float, seed: int) -> tuple[PlanReply, FloorLayout]:
    """Plan a one-storey building and lay it out."""
    request = BuildRequest(description=sentence, floors=1, floor_area=area, seed=seed)
    stages = LocalStages()
    plan = stages.plan(identified(request))
    return plan, steps.solve(stages, plan, 0)


def furnish_seconds(plan: PlanReply, layout: FloorLayout, *, check: bool) -> tuple[float, int, int]:
    """Return CPU seconds, rooms and objects of one furnishing, the checks of the scene with it if asked."""
    stages = LocalStages()
    begin = time.process_time()
    scene = steps.furnish(stages, plan, layout, 0)
    if check:
        faults = list(check_floors(plan.program.building_id, [scene], plan.topologies))
        if faults:
            raise SystemExit(f"the check found {faults}")
    spent = time.process_time() - begin
    return spent, len(scene.rooms), len(scene.objects)


def main() -> None:
    """Print a line for each floor: the least of `--repeat` measurements."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2])
    parser.add_argument("--only", nargs="*", default=list(FLOORS), choices=list(FLOORS))
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--check", action="store_true", help="count the checks of the scene too")
    options = parser.parse_args()
    print(f"{'floor':12}{'seed':>5}{'m2':>6}{'rooms':>7}{'objects':>9}{'CPU s':>8}")
    for name in options.only:
        sentence, area = FLOORS[name]
        for seed in options.seeds:
            plan, layout = layout_of(sentence, area, seed)
            runs = [furnish_seconds(plan, layout, check=options.check) for _ in range(options.repeat)]
            spent, rooms, objects = min(runs)
            print(f"{name:12}{seed:5}{area:6.0f}{rooms:7}{objects:9}{spent:8.2f}", flush=True)


if __name__ == "__main__":
    main()
