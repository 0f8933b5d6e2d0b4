"""Proportions of the rooms that the planner's sketches draw for lists of briefs.

    python benchmarks/planning/proportions.py benchmarks/planning/briefs/*.json [--family home] [--every 4]

Counts rooms whose long side is more than three times the short one (strips), those over twice, and buildings with three
strips or more; storeys that repeat others are left out, and so are briefs that are refused.
"""

import argparse
import json
from collections import Counter
from pathlib import Path

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.reader import read_brief
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.plan_quality import STRIP, aspect


def planned(brief: str) -> PlannedBuilding | None:
    """Return the planned building of a brief, or nothing where it is refused."""
    request, knowledge = BuildRequest(description=brief), default_knowledge()
    try:
        return plan_program(
            request, read_brief(brief, knowledge), knowledge, "measured", item_generator(request.seed, "program")
        )
    except MansionError:
        return None


def measure(building: PlannedBuilding, totals: Counter[str]) -> None:
    """Add the rooms of a building to the totals."""
    own = [storey for storey in building.storeys if storey.copy is None and storey.index >= 1]
    aspects = [aspect(p.boxes) for storey in own for p in building.sketches[storey.index].rooms if p.boxes]
    strips = sum(each > STRIP for each in aspects)
    totals.update(
        buildings=1, rooms=len(aspects), strips=strips, over_two=sum(each > 2.0 for each in aspects), poor=strips >= 3
    )


def main() -> None:
    """Print the shares."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lists", nargs="+", type=Path)
    parser.add_argument("--family", default="", help="buildings of this family alone, such as home")
    parser.add_argument("--every", type=int, default=1, help="take every n-th brief")
    options = parser.parse_args()
    briefs = [case["brief"] for file in options.lists for case in json.loads(file.read_text()) if "brief" in case]
    totals: Counter[str] = Counter()
    for brief in briefs[:: options.every]:
        building = planned(brief)
        if building is not None and options.family in ("", building.decisions.building.family):
            measure(building, totals)
    rooms = max(totals["rooms"], 1)
    print(
        f"{totals['buildings']} buildings, {rooms} rooms: {totals['strips']} strips ({totals['strips'] / rooms:.1%}), "
        f"{totals['over_two'] / rooms:.1%} longer than twice their width, {totals['poor']} buildings with three strips"
    )


if __name__ == "__main__":
    main()
