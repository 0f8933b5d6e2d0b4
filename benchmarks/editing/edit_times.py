"""Processor time of edits and questions of a building: how long a caller of the scene editor waits at least.

    python benchmarks/editing/edit_times.py BUILDING [--rounds 24]

Works in a copy. Each round lists surfaces, searches assets, puts something on a surface, paints and turns what carries
it, and takes it all back; every fourth one carries out an instruction. Six rounds before are not counted. Prints the
median, the 95th percentile and the longest of each kind of call, in seconds.
"""

import argparse
import random
import shutil
import tempfile
import time
from collections import defaultdict
from pathlib import Path
from typing import Any

from mansion_bringup.editor import open_editor
from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_msgs_py.errors import MansionError

INSTRUCTION = "put a red mug on the reception desk in the lobby"
WARM_UP = 6


class Timed:
    """An editor whose calls are timed."""

    def __init__(self, editor: SceneEditor) -> None:
        self.editor = editor
        self.seconds: dict[str, list[float]] = defaultdict(list)

    def call(self, tool: str, arguments: dict[str, Any] | None = None) -> Any:
        """Call a tool; nothing where it is refused."""
        begin = time.process_time()
        try:
            return self.editor.call(tool, arguments)
        except MansionError:
            return None
        finally:
            self.seconds[tool].append(time.process_time() - begin)

    def instruct(self) -> bool:
        """Carry out the instruction; return whether it changed something."""
        begin = time.process_time()
        report = instruct(self.editor, INSTRUCTION)
        self.seconds["instruct"].append(time.process_time() - begin)
        return bool(report.edits)


def one_round(timed: Timed, rng: random.Random, number: int) -> None:
    """Ask, edit, and take the edits back."""
    keyword, query = rng.choice(("desk", "table", "shelf")), rng.choice(("a mug", "a book", "a laptop"))
    surfaces = [item.id for item in timed.call("ListObjects", {"keyword": keyword, "limit": 500}).objects]
    assets = [hit.asset_id for hit in timed.call("SearchAssets", {"query": query, "top_k": 3}).assets]
    timed.call("CheckPath", {})
    surface = rng.choice(surfaces)
    edits = (
        ("PlaceOnSurface", {"asset_id": rng.choice(assets), "receptacle_id": surface}),
        ("PaintObject", {"object_id": surface, "color": rng.choice(("red", "white", "green"))}),
        ("MoveObject", {"object_id": surface, "turn": 180.0}),
    )
    done = sum(timed.call(tool, arguments) is not None for tool, arguments in edits)
    done += number % 4 == 0 and timed.instruct()
    for _ in range(done):
        timed.call("Undo")


def main() -> None:
    """Time the edits and print the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("building", type=Path, help="an office, as the README builds it")
    parser.add_argument("--rounds", type=int, default=24, help="how many are counted (24)")
    options = parser.parse_args()
    rng = random.Random(1)
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(shutil.copytree(options.building, Path(folder) / "building"))
        timed = Timed(open_editor(copy))
        for number in range(WARM_UP):
            one_round(timed, rng, number)
        timed.seconds.clear()
        for number in range(options.rounds):
            one_round(timed, rng, number)
    for tool, seconds in timed.seconds.items():
        ordered = sorted(seconds)
        high = ordered[int(0.95 * len(ordered))]
        print(f"{tool:16}{len(ordered):5d}{ordered[len(ordered) // 2]:9.3f}{high:9.3f}{ordered[-1]:9.3f}")


if __name__ == "__main__":
    main()
