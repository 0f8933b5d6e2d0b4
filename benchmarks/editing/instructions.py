"""The editing agent on instructions over many buildings; what must be true afterwards is checked from scene.json alone.

    python benchmarks/editing/instructions.py BUILDINGS [--each 10] [--seed 0] [--physics mujoco] [--work FOLDER]

BUILDINGS is a folder of building folders. Each instruction is made from what a building holds together with the facts
that it asks for; the verdict comes from code that shares nothing with the agent but the scene's payload types: it
reads the object's category, its parent and its box. An instruction counts when every fact is true, the number of edits
is at most one above the least, and ``mansion check`` finds no fault that was not there before.
"""

import argparse
import shutil
import tempfile
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mansion_bringup.check import check_building
from mansion_bringup.cli.edit import open_editor
from mansion_bringup.edit_hooks import building_files, floor_files
from mansion_msgs_py.codec import decode
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_scene.editing.agent.instruct import instruct

SMALL = {
    "mug": "mug", "apple": "apple", "banana": "banana", "book": "book", "cola": "cola_can", "pen": "pen",
    "newspaper": "newspaper", "laptop": "laptop", "stapler": "stapler", "remote control": "remote_control",
    "wine bottle": "wine_bottle", "cell phone": "cell_phone", "vase": "vase", "toilet paper": "toilet_paper",
}  # fmt: skip
COLD = {
    "cola": "cola_can",
    "milk": "milk_carton",
    "yogurt": "yogurt",
    "apple": "apple",
    "juice": "juice_carton",
}
CARRIERS = ("dining_table", "coffee_table", "desk", "office_desk", "conference_table", "side_table", "counter_top",
            "console_table", "kitchen_counter", "sideboard", "nightstand", "cafe_table", "training_table")  # fmt: skip
ORDINALS = ("", "first", "second", "third", "fourth")
MARGIN = 0.02


@dataclass
class Case:
    """An instruction, the least number of edits, and what must be true of the scenes."""

    text: str
    least: int
    holds: Callable[[list[FloorScene]], bool]
    kind: str


def within(item: SceneObject, carrier: SceneObject) -> bool:
    """Whether an object's centre lies over a carrier and at its height."""
    reach = max(carrier.size[:2]) / 2 + MARGIN
    dx, dy = (abs(item.position[k] - carrier.position[k]) for k in (0, 1))
    foot = item.position[2] - item.size[2] / 2
    low = carrier.position[2] - carrier.size[2] / 2
    return (
        dx <= reach
        and dy <= reach
        and low - MARGIN <= foot <= carrier.position[2] + carrier.size[2] / 2 + 0.05
    )


def count(scenes: list[FloorScene], carrier: str, category: str) -> int:
    """Count objects of a category that name a carrier as parent and lie within its reach."""
    for scene in scenes:
        own = next((item for item in scene.objects if item.id == carrier), None)
        if own is not None:
            return sum(
                item.parent == carrier and item.category == category and within(item, own)
                for item in scene.objects
            )
    return -1


def room_words(scene: FloorScene, room: str, several_floors: bool) -> str:
    """Name a room as a person would, unambiguously."""
    name = room.split("/", 1)[1]
    words = name.replace("_", " ") if not name[-1].isdigit() else name
    return f"the {words} on the {ORDINALS[scene.floor]} floor" if several_floors else f"the {words}"


class Maker:
    """Makes the cases of one building."""

    def __init__(self, scenes: list[FloorScene], rng: np.random.Generator) -> None:
        self.scenes, self.rng = scenes, rng
        self.tall = len(scenes) > 1
        rooms = [o.room + o.category for s in scenes for o in s.objects]
        single = {key for key, number in Counter(rooms).items() if number == 1}
        self.carriers = [
            (s, o)
            for s in scenes
            for o in s.objects
            if o.category in CARRIERS and o.room + o.category in single
        ]
        self.fridges = [
            (s, o)
            for s in scenes
            for o in s.objects
            if o.category == "fridge" and o.room + o.category in single
        ]

    def pick(self, values: list[object]) -> object:
        """Draw one."""
        return values[int(self.rng.integers(len(values)))]

    def make(self, number: int) -> Case:
        """Make the case of that number."""
        kinds = [
            self.place,
            self.cold,
            self.count_of,
            self.both,
            self.absent,
            self.switch,
            self.path,
            self.move,
        ]
        for shift in range(len(kinds)):
            case = kinds[(number + shift) % len(kinds)]()
            if case is not None:
                return case
        raise SystemExit("a building without anything to edit")

    def where(self, scene: FloorScene, item: SceneObject) -> str:
        """Name a carrier and its room."""
        return f"the {item.name} in {room_words(scene, item.room, self.tall)}"

    def place(self) -> Case | None:
        """A small thing on a table."""
        if not self.carriers:
            return None
        scene, carrier = self.pick(self.carriers)
        word = self.pick(list(SMALL))
        lead = self.pick(["make sure there is a", "put a", "there should be a", "please add a"])
        have = count(self.scenes, carrier.id, SMALL[word])
        return Case(
            f"{lead} {word} on {self.where(scene, carrier)}",
            max(0, 1 - have),
            lambda scenes: count(scenes, carrier.id, SMALL[word]) >= 1,
            "place",
        )

    def cold(self) -> Case | None:
        """A cold thing in a fridge, and a way to a room."""
        if not self.fridges:
            return None
        scene, fridge = self.pick(self.fridges)
        word = self.pick(list(COLD))
        target_scene = self.pick(self.scenes)
        room = self.pick([r for r in target_scene.rooms if r.kind not in ("stair", "elevator")])
        have = count(self.scenes, fridge.id, COLD[word])
        return Case(
            f"make sure there is a cold {word} in {self.where(scene, fridge)} and a way to "
            f"{room_words(target_scene, room.id, self.tall)}",
            max(0, 1 - have),
            lambda scenes: count(scenes, fridge.id, COLD[word]) >= 1,
            "cold",
        )

    def count_of(self) -> Case | None:
        """Several things of a colour."""
        if not self.carriers:
            return None
        scene, carrier = self.pick(self.carriers)
        colour = self.pick(["red", "blue", "white"])
        have = sum(
            o.parent == carrier.id and o.category == "mug" and o.material.endswith(colour)
            for o in scene.objects
        )

        def holds(scenes: list[FloorScene]) -> bool:
            return (
                sum(
                    o.parent == carrier.id and o.category == "mug" and o.material.endswith(colour)
                    for s in scenes
                    for o in s.objects
                )
                >= 2
            )

        text = f"ensure two {colour} mugs on {self.where(scene, carrier)}"
        return Case(text, max(0, 2 - have), holds, "count")

    def both(self) -> Case | None:
        """Two things at one place."""
        if not self.carriers:
            return None
        scene, carrier = self.pick(self.carriers)
        one, other = (
            str(w) for w in self.rng.choice(["apple", "pen", "book", "mug"], 2, replace=False)
        )
        least = sum(count(self.scenes, carrier.id, SMALL[w]) < 1 for w in (one, other))
        return Case(
            f"put a {one} and a {other} on {self.where(scene, carrier)}",
            least,
            lambda scenes: all(count(scenes, carrier.id, SMALL[w]) >= 1 for w in (one, other)),
            "both",
        )

    def absent(self) -> Case | None:
        """Things gone from a carrier."""
        loaded = [
            (s, c, o)
            for s, c in self.carriers
            for o in s.objects
            if o.parent == c.id and not any(x.parent == o.id for x in s.objects)
        ]
        if not loaded:
            return None
        scene, carrier, item = self.pick(loaded)
        have = count(self.scenes, carrier.id, item.category)
        return Case(
            f"remove all {item.name}s from {self.where(scene, carrier)}",
            have,
            lambda scenes: (
                not any(
                    o.parent == carrier.id and o.category == item.category
                    for s in scenes
                    for o in s.objects
                )
            ),
            "absent",
        )

    def switch(self) -> Case | None:
        """Something opened."""
        able = [
            (s, o)
            for s in self.scenes
            for o in s.objects
            if o.openable
            and o.mount == "floor"
            and sum(x.room == o.room and x.category == o.category for x in s.objects) == 1
        ]
        if not able:
            return None
        scene, item = self.pick(able)
        return Case(
            f"open {self.where(scene, item)}",
            0 if item.states.get("open") else 1,
            lambda scenes: any(
                o.id == item.id and o.states.get("open") is True for s in scenes for o in s.objects
            ),
            "open",
        )

    def path(self) -> Case | None:
        """A way between two rooms; buildings that pass the check have it."""
        ends = [
            (s, self.pick([r for r in s.rooms if r.kind not in ("stair", "elevator")]))
            for s in (self.pick(self.scenes), self.pick(self.scenes))
        ]
        names = [room_words(s, r.id, self.tall) for s, r in ends]
        return Case(
            f"make sure the robot can get from {names[0]} to {names[1]}",
            0,
            lambda scenes: True,
            "path",
        )

    def move(self) -> Case | None:
        """A thing moved from one carrier to another."""
        loaded = [
            (s, c, o)
            for s, c in self.carriers
            for o in s.objects
            if o.parent == c.id
            and o.pickupable
            and max(o.size) < 0.35
            and sum(x.category == o.category and x.parent == c.id for x in s.objects) == 1
        ]
        if not loaded or len(self.carriers) < 2:
            return None
        scene, source, item = self.pick(loaded)
        target_scene, target = self.pick([(s, c) for s, c in self.carriers if c.id != source.id])

        def holds(scenes: list[FloorScene]) -> bool:
            there = count(scenes, target.id, item.category)
            return there > before and count(scenes, source.id, item.category) == 0

        before = count(self.scenes, target.id, item.category)
        return Case(
            f"move the {item.name} from {self.where(scene, source)} to {self.where(target_scene, target)}",
            1,
            holds,
            "move",
        )


def read(folder: Path) -> list[FloorScene]:
    """Return the scenes of a folder."""
    files = sorted(folder.glob("floors/*/scene.json"))
    return [decode(FloorScene, file.read_bytes()) for file in files]


def main() -> None:
    """Run the cases and print the score."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("buildings", type=Path)
    parser.add_argument("--each", type=int, default=10)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--physics", default="mujoco")
    args = parser.parse_args()
    met: Counter[str] = Counter()
    asked: Counter[str] = Counter()
    unclean = 0
    folders = [path.parent for path in sorted(args.buildings.glob("*/building.json"))]
    with tempfile.TemporaryDirectory() as work:
        for number, folder in enumerate(folders):
            copy = Path(work) / folder.name
            shutil.copytree(folder, copy)
            faults = set(check_building(copy))
            editor = open_editor(copy, physics=args.physics, who="bench")
            for turn in range(args.each):
                rng = np.random.default_rng([args.seed, number, turn])
                case = Maker(read(copy), rng).make(turn)
                report = instruct(editor, case.text)
                true = case.holds(read(copy))
                frugal = report.edits <= case.least + 1
                asked[case.kind] += 1
                met[case.kind] += report.done and true and frugal
                if not (report.done and true and frugal):
                    verdict = f"true: {true}, edits {report.edits}, least {case.least}"
                    print(f"{folder.name}: {case.text!r}: {report.message} ({verdict})")
            editor.store.refresh(floor_files, building_files)
            new = set(check_building(copy)) - faults
            unclean += bool(new)
            for fault in sorted(new, key=str):
                print(f"{folder.name}: new fault {fault}")
    for kind in asked:
        print(f"{kind:8s} {met[kind]:4d} of {asked[kind]}")
    total = sum(asked.values())
    print(
        f"met {sum(met.values())} of {total} ({sum(met.values()) / max(1, total):.1%}); "
        f"{unclean} of {len(folders)} buildings with new faults"
    )


if __name__ == "__main__":
    main()
