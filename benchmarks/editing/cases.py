"""Instructions with what must be true afterwards, and their run over a folder of buildings.

The verdict comes from code that shares nothing with the agent but the scene's payload types: it reads the object's
category, its parent and its box. An instruction counts when every fact is true, the number of edits is at most one
above the least, and nothing was taken away that it does not speak of; `mansion check` must find no new fault.
"""

import argparse
import shutil
import tempfile
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mansion_bringup.edit_hooks import kept_files
from mansion_bringup.editor import open_editor
from mansion_bringup.verify import verify_building
from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_msgs_py.codec import decode
from mansion_msgs_py.scene import FloorScene, SceneObject

Scenes = list[FloorScene]
SMALL = {
    "mug": "mug", "apple": "apple", "banana": "banana", "book": "book", "cola": "cola_can", "pen": "pen",
    "newspaper": "newspaper", "laptop": "laptop", "stapler": "stapler", "remote control": "remote_control",
    "wine bottle": "wine_bottle", "cell phone": "cell_phone", "vase": "vase", "toilet paper": "toilet_paper",
}  # fmt: skip
COLD = {"cola": "cola_can", "milk": "milk_carton", "yogurt": "yogurt", "apple": "apple", "juice": "juice_carton"}
CARRIERS = ("dining_table", "coffee_table", "desk", "office_desk", "conference_table", "side_table", "counter_top",
            "console_table", "kitchen_counter", "sideboard", "nightstand", "cafe_table", "training_table")  # fmt: skip
ORDINALS = ("", "first", "second", "third", "fourth")
MARGIN = 0.02


@dataclass
class Case:
    """An instruction and what must be true of the scenes afterwards.

    Attributes
    ----------
    text : str
    least : int
        Number of edits.
    holds : callable
        Whether what is asked for is true of the scenes.
    kind : str
        What it is counted as.
    refusal : str or None
        For an instruction that no tool can do: a word that the refusal must name, empty for any.
    gone : int or None
        Most objects that may be taken away; None where nothing is said of it.
    """

    text: str
    least: int
    holds: Callable[[Scenes], bool]
    kind: str
    refusal: str | None = None
    gone: int | None = None


def within(item: SceneObject, carrier: SceneObject) -> bool:
    """Whether an object's centre lies over a carrier and at its height."""
    reach = max(carrier.size[:2]) / 2 + MARGIN
    dx, dy = (abs(item.position[k] - carrier.position[k]) for k in (0, 1))
    foot = item.position[2] - item.size[2] / 2
    low = carrier.position[2] - carrier.size[2] / 2
    return dx <= reach and dy <= reach and low - MARGIN <= foot <= carrier.position[2] + carrier.size[2] / 2 + 0.05


def count(scenes: Scenes, carrier: str, category: str) -> int:
    """Count objects of a category that name a carrier as parent and lie within its reach."""
    for scene in scenes:
        own = next((item for item in scene.objects if item.id == carrier), None)
        if own is not None:
            return sum(
                item.parent == carrier and item.category == category and within(item, own) for item in scene.objects
            )
    return -1


def room_words(scene: FloorScene, room: str, several_floors: bool) -> str:
    """Name a room as a person would, unambiguously."""
    name = room.split("/", 1)[1]
    words = name.replace("_", " ") if not name[-1].isdigit() else name
    return f"the {words} on the {ORDINALS[scene.floor]} floor" if several_floors else f"the {words}"


def read(folder: Path) -> Scenes:
    """Return the scenes of a folder."""
    files = sorted(folder.glob("floors/*/scene.json"))
    return [decode(FloorScene, file.read_bytes()) for file in files]


def objects(scenes: Scenes) -> list[SceneObject]:
    """Return all objects."""
    return [item for scene in scenes for item in scene.objects]


def plural(word: str) -> str:
    """Return a noun in the plural."""
    return word + ("es" if word.endswith(("s", "sh", "x", "ch")) else "s")


def article(word: str) -> str:
    """Return a noun with its article."""
    return f"{'an' if word[0] in 'aeiou' else 'a'} {word}"


Making = Callable[[SceneEditor, Path, np.random.Generator, int, int], Case | None]
"""Makes a case for an editor's building in a folder, with the numbers of the building and of the turn in it."""


@dataclass
class Score:
    """Cases met and asked for of each kind, and buildings with new faults."""

    met: Counter[str]
    asked: Counter[str]
    unclean: int
    buildings: int

    def show(self) -> None:
        """Print the figures."""
        for kind in sorted(self.asked):
            print(f"{kind:10s} {self.met[kind]:4d} of {self.asked[kind]}")
        met, asked = sum(self.met.values()), sum(self.asked.values())
        print(f"met {met} of {asked} ({met / max(1, asked):.1%})")
        print(f"{self.unclean} of {self.buildings} buildings with new faults")


def options(description: str | None, each: int) -> argparse.ArgumentParser:
    """Return the parser of a benchmark's command line."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("buildings", type=Path, help="a folder of building folders")
    parser.add_argument("--each", type=int, default=each, help="instructions for each building")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--physics", default="mujoco")
    return parser


def run(args: argparse.Namespace, make: Making) -> Score:
    """Give each building's copy its instructions one after the other and count those that were met."""
    score = Score(Counter(), Counter(), 0, 0)
    folders = [path.parent for path in sorted(args.buildings.glob("*/building.json"))]
    score.buildings = len(folders)
    with tempfile.TemporaryDirectory() as work:
        for number, folder in enumerate(folders):
            copy = Path(work) / folder.name
            shutil.copytree(folder, copy)
            faults = set(verify_building(copy))
            editor = open_editor(copy, physics=args.physics, who="bench")
            for turn in range(args.each):
                rng = np.random.default_rng([args.seed, number, turn])
                case = make(editor, copy, rng, number, turn)
                if case is not None:
                    score.asked[case.kind] += 1
                    score.met[case.kind] += judge(editor, copy, case)
            editor.store.refresh(kept_files)
            new = set(verify_building(copy)) - faults
            score.unclean += bool(new)
            for fault in sorted(new, key=str):
                print(f"{folder.name}: new fault {fault}")
    return score


def judge(editor: SceneEditor, folder: Path, case: Case) -> bool:
    """Run one instruction; print it with the agent's words when it is not met."""
    before = read(folder)
    report = instruct(editor, case.text)
    after = read(folder)
    if case.refusal is not None:
        named = case.refusal.lower() in report.message.lower()
        good = not report.done and after == before and named
        verdict = f"done: {report.done}, edits {report.edits}, names {case.refusal!r}: {named}"
    else:
        true = case.holds(after)
        lost = _gone(before, after)
        spared = case.gone is None or lost <= case.gone
        good = report.done and true and report.edits <= case.least + 1 and spared
        verdict = f"done {report.done}, true {true}, edits {report.edits}, least {case.least}, gone {lost}"
    if not good:
        print(f"{folder.name}: {case.text!r}: {report.message} ({verdict})")
    return good


def _gone(before: Scenes, after: Scenes) -> int:
    """Count the objects that are no longer there, by category."""
    had = Counter(item.category for scene in before for item in scene.objects)
    have = Counter(item.category for scene in after for item in scene.objects)
    return sum((had - have).values())
