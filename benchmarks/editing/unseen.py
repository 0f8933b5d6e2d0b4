"""Instructions with facts, judged on the scenes before and after.

    python benchmarks/editing/unseen.py LIST.json FOLDER --scorer SCORER.py

A list holds cases with the brief of a building, an instruction and the facts that must hold afterwards. Buildings are
made once into FOLDER; each case works on a copy. The scorer is a module with ``load(folder)`` and
``chk(fact, before, after, report)``. A case is right when its facts hold and the answer says that it was done (of a
question, an ambiguous or a hostile text: when nothing changed), silent when the answer says so and they do not,
refused when nothing was done, part when something was. The lists in `instructions_seen` were read after their first
score, so only the first scores, in docs/editing.md, forecast others. With ``--times`` the CPU seconds that instructions
took once the building was loaded are printed too: the median, the 95th percentile and the slowest.
"""

import argparse
import importlib.util
import json
import shutil
import statistics
import tempfile
import time
from collections import Counter
from pathlib import Path
from types import ModuleType
from typing import Any

from mansion_bringup.editor import open_editor
from mansion_bringup.pipeline.build import build_building
from mansion_editing.instructions.instruct import instruct
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest


def scorer_at(path: Path) -> ModuleType:
    """Load the module that judges facts."""
    spec = importlib.util.spec_from_file_location("scorer", path)
    if spec is None or spec.loader is None:
        raise SystemExit(f"{path} is no Python module")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def verdict_of(case: dict[str, Any], world: Path, scorer: ModuleType) -> tuple[str, str, float]:
    """Give one instruction to a copy of a building and judge it; return the verdict, the answer and the seconds."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "building"
        shutil.copytree(world, copy)
        editor = open_editor(copy, physics="static")
        began = time.process_time()
        try:
            report = instruct(editor, case["instruction"])
            done, message = report.done, report.message
        except MansionError as error:
            done, message = False, str(error)
        seconds = time.process_time() - began
        before, after = scorer.load(world), scorer.load(copy)
    told = {"done": done, "message": message}
    changed = not scorer.chk({"kind": "unchanged"}, before, after, told)[0]
    holds = all(scorer.chk(fact, before, after, told)[0] for fact in case["facts"])
    idle = case.get("hostile") or (case["facts"] and case["facts"][0]["kind"] == "unchanged")
    if idle:
        return ("silent" if changed else "ok"), message, seconds
    if done:
        return ("ok" if holds else "silent"), message, seconds
    return ("part" if changed else "refused"), message, seconds


def times_of(seconds: list[float], slowest: str) -> str:
    """Return the times of instructions in words."""
    ordered = sorted(seconds)
    late = ordered[max(0, -(-95 * len(ordered) // 100) - 1)]
    median = statistics.median(ordered)
    return f"CPU seconds: median {median:.2f}, 95% within {late:.2f}, slowest {ordered[-1]:.2f} ({slowest})"


def main() -> None:
    """Score a list and print what was not right."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("list", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--scorer", type=Path, required=True)
    parser.add_argument("--times", action="store_true", help="print the CPU seconds of instructions after loading")
    options = parser.parse_args()
    scorer = scorer_at(options.scorer)
    verdicts: Counter[str] = Counter()
    seconds: dict[str, float] = {}
    for case in json.loads(options.list.read_text(encoding="utf-8")):
        world = options.folder / case["building"]
        if not (world / "building.json").exists():
            build_building(BuildRequest(description=case["brief"]), world)
        verdict, message, seconds[case["id"]] = verdict_of(case, world, scorer)
        verdicts[verdict] += 1
        if verdict != "ok":
            print(f"{verdict:8} {case['id']:6} {case['instruction']}\n         {message[:200]}", flush=True)
    print(json.dumps({"cases": verdicts.total(), **verdicts}))
    if options.times and seconds:
        print(times_of(list(seconds.values()), max(seconds, key=lambda name: seconds[name])))


if __name__ == "__main__":
    main()
