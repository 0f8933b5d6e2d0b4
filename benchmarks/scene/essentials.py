"""Which rooms of whole buildings have what they cannot be used without, over building types and seeds.

python benchmarks/scene/essentials.py [--seeds 0 1] [--only hospital hotel] [--types 10] [--rooms]
python benchmarks/scene/essentials.py --briefs benchmarks/planning/briefs/first_sight.json     # buildings of sentences
"""

import argparse
import json
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import msgspec

from mansion_bringup.pipeline import build as steps
from mansion_bringup.pipeline.stages import LocalStages
from mansion_knowledge.base import default_knowledge
from mansion_knowledge.essentials import needs_of, pieces_there
from mansion_knowledge.furnished_as import furnished_as
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene

TYPES = (
    "studio_flat", "flat", "house", "townhouse", "villa", "bungalow", "apartment_building", "student_dormitory",
    "hostel", "hotel", "office", "coworking", "bank", "school", "university", "kindergarten", "music_school",
    "library_building",
    "museum", "theater", "cinema", "nightclub", "hospital", "clinic", "dental_clinic", "nursing_home",
    "laboratory_building", "supermarket", "shopping_mall", "hair_salon", "restaurant_building", "gym_building",
    "swimming_center", "town_hall", "courthouse", "police_station", "fire_station", "airport_terminal", "factory",
    "farm_building",
)  # fmt: skip
"""Forty kinds of building: homes, lodging, work, learning, culture, health, trade, sport, the state, industry."""


@dataclass(frozen=True)
class Lack:
    """What a room has too little of."""

    room: str
    room_type: str
    area: float
    need: str
    have: int
    wanted: int
    told: bool
    """Whether the scene says that it was left out."""


def lacking(scene: FloorScene) -> tuple[int, list[Lack]]:
    """Return how many rooms of a floor have needs, and what is not met of them."""
    objects = defaultdict[str, list[tuple[str, float]]](list)
    for thing in scene.objects:
        objects[thing.room].append((thing.category, thing.size[0]))
    rooms, lacks = 0, list[Lack]()
    for room in scene.rooms:
        beside = [other.room_type for other in scene.rooms if other.id != room.id]
        kind = furnished_as(room.room_type, scene.building_type, room.name, beside)
        needs = needs_of(kind, (room.name, *room.aliases))
        rooms += bool(needs)
        for need in needs:
            have = pieces_there(need, objects[room.id])
            if have < need.count:
                told = any((lost.room, lost.name) == (room.id, need.name) for lost in scene.discarded)
                lacks.append(Lack(room.id, room.room_type, room.area, need.name, have, need.count, told))
    return rooms, lacks


def scenes(sentence: str, seed: int) -> Iterator[FloorScene]:
    """Yield the finished floors of the building of a sentence."""
    request = BuildRequest(description=sentence, seed=seed)
    stages = LocalStages()
    plan = stages.plan(identified(request))
    layouts = {number: steps.solve(stages, plan, number) for number in steps.distinct_floors(plan)}
    for number, floor in enumerate(plan.program.floors):
        layout = msgspec.structs.replace(layouts[steps.source_floor(plan, number)], floor=floor.index)
        yield steps.furnish(stages, plan, layout, number)


def main() -> None:
    """Print the share of rooms that can be used, by building type and in all, and what lacks most."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1])
    parser.add_argument("--only", nargs="*", choices=sorted(default_knowledge().buildings), help="other types")
    parser.add_argument("--types", type=int, default=len(TYPES), help="how many of the forty types, evenly drawn")
    parser.add_argument("--briefs", type=Path, help="a list of objects with a `brief` each, instead of types")
    parser.add_argument("--rooms", action="store_true", help="print each room that lacks something")
    options = parser.parse_args()
    step = len(TYPES) / options.types
    names = options.only or [TYPES[int(n * step)] for n in range(options.types)]
    chosen = {name: f"A {name.replace('_', ' ')}" for name in names}
    if options.briefs:
        chosen = {entry["brief"][:21]: entry["brief"] for entry in json.loads(options.briefs.read_text())}
    print(f"{'building':22}{'seed':>5}{'rooms':>7}{'lacking':>9}{'CPU s':>8}")
    total, usable, untold, causes = 0, 0, 0, Counter[tuple[str, str]]()
    for name, sentence in chosen.items():
        for seed in options.seeds:
            started, rooms, lacks = time.process_time(), 0, list[Lack]()
            try:
                for scene in scenes(sentence, seed):
                    some, found = lacking(scene)
                    rooms, lacks = rooms + some, lacks + found
            except MansionError as error:
                print(f"{name:22}{seed:>5}  {str(error)[:90]}")
                continue
            bare = len({lack.room for lack in lacks})
            total, usable = total + rooms, usable + rooms - bare
            untold += sum(not lack.told for lack in lacks)
            causes.update((lack.room_type, lack.need) for lack in lacks)
            print(f"{name:22}{seed:>5}{rooms:>7}{bare:>9}{time.process_time() - started:>8.1f}", flush=True)
            for lack in lacks if options.rooms else ():
                what = f"{lack.have} of {lack.wanted} {lack.need}" + ("" if lack.told else ", not told")
                print(f"    {lack.room} ({lack.room_type}, {lack.area:.1f} m2): {what}")
    for (room_type, need), count in causes.most_common():
        print(f"{count:>5}  {room_type}: {need}")
    print(f"{usable} of {total} rooms have all essentials: {usable / max(total, 1):.2%}; {untold} lacks not told")


if __name__ == "__main__":
    main()
