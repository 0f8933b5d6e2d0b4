"""Proportions of the rooms that the planner's sketches draw for lists of briefs.

    python benchmarks/planning/proportions.py benchmarks/planning/briefs/*.json [--family home] [--every 4]

Counts rooms whose long side is more than three times the short one (strips), those over twice, buildings with three
strips or more, and rooms with windows that others are cut out of; storeys that repeat others are left out, and so are
briefs that are refused.
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
from mansion_planner.program.plan_quality import STRIP, aspect, fill

RECTANGLE = 0.97
"""Share of the rectangle around it from which on a room counts as one."""


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
    rooms = [p for storey in own for p in building.sketches[storey.index].rooms if p.boxes]
    aspects = [aspect(p.boxes) for p in rooms]
    bright = [p for p in rooms if p.room.kind.daylight and not p.room.suite]
    cut = sum(fill(p.boxes) < RECTANGLE for p in bright)
    strips = sum(each > STRIP for each in aspects)
    totals.update(
        buildings=1, rooms=len(aspects), strips=strips, over_two=sum(each > 2.0 for each in aspects), poor=strips >= 3,
        bright=len(bright), cut=cut,
    )  # fmt: skip


def main() -> None:
    """Print the shares."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lists", nargs="+", type=Path)
    parser.add_argument("--family", default="", help="buildings of this family alone, such as office")
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
        f"{totals['over_two'] / rooms:.1%} longer than twice their width, "
        f"{totals['poor']} buildings with three strips, "
        f"{totals['cut']} of {totals['bright']} rooms with windows cut by another"
    )


if __name__ == "__main__":
    main()
