"""How many of the pieces that sentences ask for stand once they are planned and their rooms furnished.

python benchmarks/scene/furniture_sentences.py [--seed 0] [--misses] [--only 3 7]

The rooms of a plan are furnished one by one as rectangles of their planned area. A piece counts where its category or
name holds one of the asked words, as in `benchmarks/planning/score_facts.py`.
"""

import argparse
import json
import math
import re
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from requested_objects import room_request

from mansion_language import singular
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import SceneObject
from mansion_planner.plan import plan_building
from mansion_scene.assembly import furnish_floor

SENTENCES = Path(__file__).with_name("furniture_sentences.json")


def stems(text: str) -> str:
    """Return the words of a text in the singular, with blanks around each."""
    return f" {' '.join(singular(word) for word in re.findall(r'[a-z0-9]+', text.lower()))} "


def names(text: str, words: list[str]) -> bool:
    """Whether a text holds one of some phrases as whole words."""
    return any(stems(word) in stems(text) for word in words)


def furnished(room: RoomProgram, seed: int) -> list[SceneObject]:
    """Return the objects of a planned room as a rectangle of its area."""
    scene = furnish_floor(room_request(room.objects, room.room_type, max(room.area_estimate, 2.0), seed))
    return [thing for thing in scene.objects if thing.room == "F1/room"]


def pieces(brief: str, asked: list[Mapping[str, Any]], seed: int) -> list[int]:
    """Return how many pieces of each kind asked for stand in the rooms of the plan of a brief."""
    program = plan_building(BuildRequest(description=brief, seed=seed)).program
    rooms = [room for floor in program.floors for room in floor.rooms if room.room_type not in ("stair", "elevator")]
    done: dict[str, list[SceneObject]] = {}
    counts = []
    for entry in asked:
        meant = [r for r in rooms if not entry["room"] or names(f"{r.id} | {r.name} | {r.room_type}", entry["room"])]
        things = []
        for room in meant:
            key = f"{room.room_type} {room.area_estimate:.1f} {room.objects}"
            if key not in done:
                done[key] = furnished(room, seed)
            things += done[key]
        counts.append(sum(names(f"{thing.category} | {thing.name}", entry["any_of"]) for thing in things))
    return counts


def main() -> None:
    """Print a line for each kind asked for, and the share of the pieces that stand."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--misses", action="store_true", help="print only what is short")
    parser.add_argument("--only", type=int, nargs="*", default=[], help="numbers of sentences, from 1")
    options = parser.parse_args()
    wanted = there = whole = kinds = unwanted = kept = 0
    begin = time.process_time()
    for number, entry in enumerate(json.loads(SENTENCES.read_text()), 1):
        if options.only and number not in options.only:
            continue
        counts = pieces(entry["brief"], entry["asked"], options.seed)
        for ask, count in zip(entry["asked"], counts, strict=True):
            good = count >= ask["count"] if ask["count"] else count == 0
            if ask["count"]:
                wanted, there = wanted + ask["count"], there + min(count, ask["count"])
                kinds, whole = kinds + 1, whole + good
            else:
                unwanted, kept = unwanted + 1, kept + good
            if not (options.misses and good):
                where = "|".join(ask["room"]) or "any room"
                mark = "" if good else "  !"
                print(f"{number:3} {'|'.join(ask['any_of']):32}{where:24}{ask['count']:5}{count:5}{mark}", flush=True)
    share = there / max(wanted, 1)
    mean = math.floor(1000 * whole / max(kinds, 1)) / 10
    print(f"pieces {there} of {wanted} ({share:.1%}); kinds met {whole} of {kinds} ({mean}%);", end=" ")
    print(f"unwanted kinds absent {kept} of {unwanted}; CPU {time.process_time() - begin:.0f} s")


if __name__ == "__main__":
    main()
