"""Build briefs with the command line and count the stated facts that the finished buildings meet.

    python benchmarks/planning/score_facts.py benchmarks/planning/briefs/training.json out/facts [--jobs 2]

A list holds briefs with facts that a careful reader would agree to. `first_sight.json` to `eleventh_sight.json`,
`fourteenth_sight.json` to `twentyfirst_sight.json` were written apart and scored once, before anyone read them; the
reader has since been mended on what they showed, as on the other lists (`training_3.json` is worded by people of other
mother tongues, `training_4.json` tersely, `training_5.json` to `training_9.json` in many voices), so only a list nobody
has seen is a measure. A fact that is not met counts as told when a wish that is not met, or a downgrade, names one of
its words; else as silent. A brief that is refused loses its facts, unless one of them says that no building can meet
it.
"""

import argparse
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from shapely.geometry import Polygon

from mansion_language import singular

Fact = Mapping[str, Any]
STAIRS = {"stair", "stairs", "staircase", "stairwell"}
CORNERS = {"rectangle": 4, "square": 4, "L": 6, "U": 8, "T": 8, "H": 12}


def stems(text: object) -> str:
    """Return the words of a text in the singular, with blanks around each."""
    return f" {' '.join(singular(word) for word in re.findall(r'[a-z0-9]+', str(text).lower()))} "


def names(text: object, options: Iterable[str]) -> bool:
    """Whether a text holds one of some phrases as whole words."""
    held = stems(text)
    return any(stems(option) in held for option in options)


class Built:
    """A finished building as far as facts go."""

    def __init__(self, folder: Path) -> None:
        self.building = json.loads((folder / "building.json").read_text())
        self.program = self.building["program"]
        self.scenes = sorted(
            (json.loads(file.read_text()) for file in folder.glob("floors/*/scene.json")),
            key=lambda scene: scene["floor"],
        )
        notes = {f"F{f['index']}/{r['id']}": r.get("notes", "") for f in self.program["floors"] for r in f["rooms"]}
        self.rooms = [
            (
                scene["floor"],
                room,
                Polygon(room["polygon"], room.get("holes") or []),
                " | ".join(
                    (room["id"], room["name"], room["room_type"], notes.get(room["id"], ""), *room.get("aliases", []))
                ),
            )
            for scene in self.scenes
            for room in scene["rooms"]
            if room["room_type"] not in ("stair", "elevator")
        ]
        self.floors = [scene["floor"] for scene in self.scenes]
        self.cores = Counter(core["type"] for core in self.program["vertical_connectivity"]["cores"])

    def find(self, options: Iterable[str], floor: object = None) -> list[Any]:
        """Return the rooms that one of the phrases names, on a storey or anywhere."""
        where = {"ground": 1, "top": max(self.floors), "basement": self.floors[0], "lowest": self.floors[0]}
        wanted = None if floor is None else int(where.get(str(floor), floor))  # type: ignore[arg-type]
        return [room for room in self.rooms if names(room[3], options) and wanted in (None, room[0])]

    def told(self, fact: Fact) -> bool:
        """Whether the building's own records say that a fact is not met."""
        words = [word for key in ("any_of", "a", "b", "because") for word in fact.get(key) or []]
        words += [str(fact["value"])] if "value" in fact else []
        unmet = [f"{wish['text']} {wish['reason']}" for wish in self.building["wishes"] if wish["status"] != "met"]
        unmet += [json.dumps(entry) for entry in self.program["downgrades"]]
        return any(names(text, words) for text in unmet)


def counted(number: int, wanted: Any) -> bool:
    """Whether a number is the one wanted, or within its bounds."""
    if isinstance(wanted, dict):
        return bool(wanted.get("min", 0) <= number <= wanted.get("max", 10**9))
    return bool(number == wanted)


def close(value: float, fact: Fact) -> bool:
    """Whether a measure is within the fact's tolerance."""
    return bool(abs(value - fact["value"]) <= fact.get("tolerance", 0.1) * fact["value"])


def met(fact: Fact, built: Built) -> bool:
    """Whether a building meets a fact."""
    kind = fact["kind"]
    gross = {floor["index"]: floor["gross_floor_area"] for floor in built.program["floors"]}
    above = [area for index, area in gross.items() if index >= 1]
    if kind in ("floors", "floors_range"):
        low, high = (fact["value"], fact["value"]) if kind == "floors" else (fact["min"], fact["max"])
        return bool(low <= len(above) <= high)
    if kind == "total_area":
        return close(sum(above), fact) or close(sum(gross.values()), fact)
    if kind == "floor_area":
        return close(sorted(above)[len(above) // 2], fact)
    if kind in ("building_type", "style"):
        return names(built.program[kind], fact["any_of"])
    if kind == "room":
        return counted(len(built.find(fact["any_of"], fact.get("floor"))), fact["count"])
    if kind == "room_area":
        rooms = built.find(fact["any_of"])
        return bool(rooms) and 2 * sum(close(room[2].area, fact) for room in rooms) >= len(rooms)
    if kind == "room_areas":
        have, want = sorted(room[2].area for room in built.find(fact["any_of"])), sorted(fact["values"])
        slack = fact.get("tolerance", 0.1)
        return len(have) == len(want) and all(abs(x - y) <= slack * y for x, y in zip(have, want))
    if kind in ("adjacent", "not_adjacent"):
        firsts, seconds = built.find(fact["a"]), built.find(fact["b"])
        touch = any(
            x[0] == y[0] and x[1]["id"] != y[1]["id"] and x[2].buffer(0.02).intersection(y[2].buffer(0.02)).length > 1.2
            for x in firsts
            for y in seconds
        )
        return touch if kind == "adjacent" else bool(firsts and seconds) and not touch
    return met_otherwise(fact, built)


def met_otherwise(fact: Fact, built: Built) -> bool:
    """Go on from `met`: what is absent, cores, outline, equal storeys, furniture, what no building can meet."""
    kind = fact["kind"]
    if kind == "absent":
        rooms = not set(fact["any_of"]) <= STAIRS and bool(built.find(fact["any_of"]))
        return not rooms and not any(names(core, fact["any_of"]) for core in built.cores)
    if kind == "vertical":
        stair, lift = built.cores["stair"] > 0, built.cores["elevator"] > 0
        return {"stair": stair, "elevator": lift, "no_elevator": not lift, "stair_and_elevator": stair and lift}[
            fact["value"]
        ]
    if kind == "outline":
        scene = built.scenes[built.floors.index(1)]
        corners = len(scene["outline"])
        if fact["value"] == "courtyard":
            return bool(scene.get("holes")) or corners == 8
        return corners == CORNERS[fact["value"]] and not scene.get("holes")
    if kind == "same_floors":
        kinds = [sorted(room[1]["room_type"] for room in built.rooms if room[0] == floor) for floor in fact["floors"]]
        return bool(kinds[0]) and all(other == kinds[0] for other in kinds)
    if kind == "object":
        rooms = built.find(fact["room"]) if fact.get("room") else built.rooms
        inside = {room[1]["id"] for room in rooms}
        things = [thing for scene in built.scenes for thing in scene["objects"] if thing["room"] in inside]
        called = [f"{thing['category']} | {thing.get('name', '')}" for thing in things]
        # The options are names that one thing may have, and some name other things too: "pallet rack" or "pallet".
        options = [fact["any_of"], *([option] for option in fact["any_of"])]
        return any(counted(sum(names(name, option) for name in called), fact["count"]) for option in options)
    if kind == "infeasible":
        return bool(built.program["downgrades"]) or any(wish["status"] != "met" for wish in built.building["wishes"])
    raise ValueError(f"unknown kind of fact {kind!r}")


def build(brief: Mapping[str, Any], folder: Path) -> int:
    """Build a brief unless it is built already; return the command's exit status."""
    if (folder / "building.json").exists():
        return 0
    command = [sys.executable, "-m", "mansion_bringup", "build", brief["brief"], "-o", str(folder), "--jobs", "1"]
    return subprocess.run(command, capture_output=True, timeout=600).returncode


def main() -> None:
    """Build, score and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("briefs", type=Path)
    parser.add_argument("folder", type=Path, help="where the buildings go; finished ones are not built again")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--misses", action="store_true", help="print every fact that is not met")
    options = parser.parse_args()
    briefs = json.loads(options.briefs.read_text(encoding="utf-8"))
    with ThreadPoolExecutor(options.jobs) as pool:
        codes = list(pool.map(lambda brief: build(brief, options.folder / brief["id"]), briefs))
    kinds: dict[str, Counter[str]] = {}
    refused = 0
    for brief, code in zip(briefs, codes):
        hopeless = any(fact["kind"] == "infeasible" for fact in brief["facts"])
        refused += bool(code) and not hopeless
        built = None if code else Built(options.folder / brief["id"])
        for fact in brief["facts"]:
            ok = hopeless if built is None else met(fact, built)
            verdict = "met" if ok else "told" if built is None or built.told(fact) else "silent"
            kinds.setdefault(fact["kind"], Counter())[verdict] += 1
            if options.misses and not ok:
                print(brief["id"], verdict, json.dumps(fact, ensure_ascii=False))
    total = sum(kinds.values(), Counter())
    count = sum(total.values())
    for kind, verdicts in sorted(kinds.items()):
        share = f"{verdicts['met']:4} of {sum(verdicts.values()):4}"
        print(f"{kind:15} {share}, told {verdicts['told']}, silent {verdicts['silent']}")
    print(
        f"{'all':15} {total['met']:4} of {count:4} = {total['met'] / count:.1%}, silent {total['silent'] / count:.1%}"
    )
    print(f"{len(briefs)} briefs, {refused} refused that a building could meet")


if __name__ == "__main__":
    main()
