"""Deviations from the rules of building, by rule, of buildings made from one sentence for each kind.

python benchmarks/scene/norms.py [--kinds 20] [--seeds 1] [--lines] [--only school hotel]

Buildings are planned, drawn and furnished in this process; nothing is written. Each kind of the knowledge base that
does not follow another is a sentence of its own ("a hotel"); `--kinds` takes so many of them, evenly spread.
"""

import argparse
import time
from collections import Counter

import msgspec

from mansion_bringup.building.report import building_index
from mansion_bringup.check.norms import Deviation, check_norms
from mansion_bringup.pipeline.build import distinct_floors, furnish, solve, source_floor
from mansion_bringup.pipeline.stages import LocalStages
from mansion_knowledge import default_knowledge
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.wording import with_article


def kinds(count: int) -> list[str]:
    """Return so many kinds of building, evenly spread over those that stand for themselves."""
    names = [name for name, building in default_knowledge().buildings.items() if not building.like]
    count = min(count, len(names))
    return [names[number * len(names) // count] for number in range(count)]


def deviations(kind: str, seed: int) -> list[Deviation]:
    """Return the deviations of the building that the name of a kind alone asks for."""
    sentence = with_article(default_knowledge().buildings[kind].synonyms[0])
    request = identified(BuildRequest(description=sentence, seed=seed))
    stages = LocalStages()
    plan = stages.plan(request)
    layouts = {index: solve(stages, plan, index) for index in distinct_floors(plan)}
    scenes = []
    for index, floor in enumerate(plan.program.floors):
        layout = msgspec.structs.replace(layouts[source_floor(plan, index)], floor=floor.index)
        scenes.append(furnish(stages, plan, layout, index))
    return check_norms(building_index(request, plan, scenes), scenes)


def main() -> None:
    """Print a line for each building, and the deviations by rule."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kinds", type=int, default=20)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--lines", action="store_true", help="print every deviation")
    parser.add_argument("--only", nargs="*", default=[], help="names of kinds")
    options = parser.parse_args()
    by_rule: Counter[str] = Counter()
    buildings: Counter[str] = Counter()
    caused, begin = 0, time.process_time()
    for kind in options.only or kinds(options.kinds):
        for seed in range(options.seeds):
            try:
                found = deviations(kind, seed)
            except MansionError as error:
                print(f"{kind} {seed}: {error}", flush=True)
                continue
            counted = [item for item in found if not item.caused_by]
            caused += len(found) - len(counted)
            by_rule.update(item.rule for item in counted)
            buildings.update({item.rule for item in counted})
            print(f"{kind} {seed}: {len(counted)}", flush=True)
            for item in counted if options.lines else ():
                print(f"    {item}", flush=True)
    for rule, count in by_rule.most_common():
        print(f"{rule:24}{count:6} in {buildings[rule]} buildings")
    print(f"deviations {by_rule.total()}; caused by briefs {caused}; CPU {time.process_time() - begin:.0f} s")


if __name__ == "__main__":
    main()
