"""Buildings with large square or deep storeys: proportions of their rooms, and what `mansion check` finds.

    python benchmarks/planning/deep_storeys.py [--only 3 7] [--plans-only]

For each sentence: rooms of all storeys (copies aside) that are strips, more than three times as long as wide,
the worst proportion, faults of the floors' checks, and CPU seconds. With
``--plans-only`` the floors are drawn but not furnished or checked.
"""

import argparse
import time
from collections.abc import Mapping

from mansion_bringup.building.report import building_index
from mansion_bringup.check import check_floors
from mansion_bringup.pipeline.floors import distinct_floors, furnish, solve, source_floor
from mansion_bringup.pipeline.stages import LocalStages
from mansion_export.formats import outputs_of_build
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene

SENTENCES = (
    "a department store, three storeys of 1,500 m2 each, square",
    "an office with two floors of 1,600 m2 each on a square plan",
    "a two-storey office building, 1,000 m2 per floor, square footprint",
    "a hospital with two storeys of 2,000 m2 each, square",
    "a two-storey school of 1,800 m2 per floor with a square footprint",
    "a single-storey school, 2,400 m2, square",
    "a library of two floors, 1,200 m2 each, square",
    "a shopping mall with two levels of 3,000 m2 each",
    "a shopping mall, two levels of 2,500 m2, square",
    "a museum on a square plan, two floors of 900 m2",
    "a university building, two storeys of 1,400 m2, square",
    "a laboratory building, two floors, 1,100 m2 each, square",
    "a call center on one floor of 1,300 m2, square",
    "a conference center, two storeys of 1,500 m2 each, square",
    "a courthouse with two storeys of 1,000 m2, square plan",
    "a clinic, one storey, 800 m2, square",
    "a nursing home with two storeys of 1,200 m2 each, square",
    "a factory of one storey, 2,000 m2, square",
    "an office with 500 m2 per floor, square footprint, two storeys",
)

STRIP = 3.0


PASSAGES = frozenset({"corridor", "lobby", "atrium", "concourse", "hallway", "landing"})


def proportions(layout: FloorLayout, kinds: Mapping[str, str]) -> list[float]:
    """Return the long side of each room's rectangle to its short one, passages aside."""
    found = []
    for room in layout.rooms:
        if kinds.get(room.id) not in PASSAGES:
            xs, ys = zip(*room.polygon)
            short, long = sorted((max(xs) - min(xs), max(ys) - min(ys)))
            found.append(long / max(short, 0.01))
    return found


def measured(sentence: str, furnished: bool) -> str:
    """Return a line of figures, or why there is no building."""
    request = identified(BuildRequest(description=sentence))
    stages, begin = LocalStages(), time.process_time()
    try:
        plan = stages.plan(request)
        layouts = {index: solve(stages, plan, index) for index in distinct_floors(plan)}
        faults = "not checked"
        if furnished:
            scenes: list[FloorScene] = [
                furnish(stages, plan, layouts[source_floor(plan, index)], index)
                for index in range(len(plan.program.floors))
            ]
            building = building_index(request, plan, scenes, outputs_of_build([]))
            faults = f"{len(list(check_floors(building.building_id, scenes, plan.topologies)))} faults"
    except MansionError as error:
        return f"refused: {error}"
    kinds = {index: {node.id: node.room_type for node in plan.topologies[index].nodes} for index in layouts}
    ratios = [ratio for index, layout in layouts.items() for ratio in proportions(layout, kinds[index])]
    strips = sum(ratio > STRIP for ratio in ratios)
    seconds = time.process_time() - begin
    return f"{strips:3} strips of {len(ratios):3} rooms, worst {max(ratios):4.1f}, {faults}, {seconds:.0f} s"


def main() -> None:
    """Print a line for each sentence."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", type=int, default=[], help="numbers of sentences, from 0; all by default")
    parser.add_argument("--plans-only", action="store_true")
    options = parser.parse_args()
    for number, sentence in enumerate(SENTENCES):
        if number in options.only or not options.only:
            print(f"{number:2} {sentence}: {measured(sentence, not options.plans_only)}", flush=True)


if __name__ == "__main__":
    main()
