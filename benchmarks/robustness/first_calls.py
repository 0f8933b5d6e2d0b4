"""Let eight threads of a new process call the stages, or load a building and run every skill, all at once.

    PYTHONPATH=tests/support python benchmarks/robustness/first_calls.py [--rounds 3] [-o FOLDER]

Threads change places as often as Python lets them. Exit status 1 where a process ended, a call failed with anything but
an answer of Mansion's own, or two threads that asked the same were told different things.
"""

import argparse
import faulthandler
import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
import threading
import traceback
from collections.abc import Callable
from pathlib import Path

from mansion_msgs_py.codec import convert, decode, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import SessionArgs

THREADS = 8

KINDS = ("stages", "skills", "loads")

Call = Callable[[], str]


def stage_calls(folder: Path) -> list[tuple[str, Call]]:
    """Return calls of the three stages in turns, with what a house of two storeys asks of them."""
    from mansion_bringup.pipeline.stages import LocalStages
    from mansion_msgs_py.layout import FloorProblem
    from mansion_msgs_py.request import BuildRequest
    from mansion_msgs_py.stages import FurnishRequest

    stock = json.loads((folder / "stock.json").read_text())
    request = json.dumps({"description": "a two-storey house with two bedrooms upstairs", "seed": 3})
    calls: list[tuple[str, Call]] = [
        ("plan", lambda: encode(LocalStages().plan(decode(BuildRequest, request)))),
        ("solve", lambda: encode(LocalStages().solve(decode(FloorProblem, json.dumps(stock["problem"]))))),
        ("furnish", lambda: encode(LocalStages().furnish(decode(FurnishRequest, json.dumps(stock["request"]))))),
    ]
    return [calls[number % 3] for number in range(THREADS)]


def skill_calls(folder: Path, *, loading: bool) -> list[tuple[str, Call]]:
    """Return calls that run every skill, each thread those of its own robot; with `loading` they load it too."""
    from mansion_msgs_py.allowed_folders import AllowedFolders
    from mansion_msgs_py.building import LoadBuilding
    from mansion_skills.engine import Engine
    from mansion_skills.skills.registry import SKILLS

    copy = Path(tempfile.mkdtemp(dir=folder)) / "building"
    shutil.copytree(folder / "building", copy)
    engine = Engine(durable=False, allowed=AllowedFolders((copy.parent,)))
    names = sorted(SKILLS)

    def load(session: str) -> None:
        engine.load(LoadBuilding(path=str(copy), session=session))

    def answer(name: str, session: str) -> str:
        try:
            arguments = convert(SKILLS[name].interface.arguments or SessionArgs, {"session": session})
            encode(engine.run(name, arguments))
        except MansionError as error:
            if error.code == ErrorCode.INTERNAL:
                raise
            return f"{name}: {error.code}"
        return f"{name}: answered"

    def run(number: int) -> str:
        if loading:
            load(f"s{number}")
        return "\n".join(sorted(answer(name, f"s{number}") for name in names[number:] + names[:number]))

    if not loading:
        for number in range(THREADS):
            load(f"s{number}")
    return [("skills", lambda number=number: run(number)) for number in range(THREADS)]  # type: ignore[misc]


def at_once(calls: list[tuple[str, Call]]) -> int:
    """Run the calls at once, print what came of them, and return how many faults there were."""
    told: dict[str, set[str]] = {}
    failed: list[str] = []
    barrier = threading.Barrier(len(calls))

    def run(name: str, call: Call) -> None:
        barrier.wait()
        try:
            told.setdefault(name, set()).add(hashlib.sha256(call().encode()).hexdigest())
        except Exception:
            failed.append(traceback.format_exc())

    sys.setswitchinterval(1e-6)
    threads = [threading.Thread(target=run, args=entry) for entry in calls]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    different = [name for name, answers in told.items() if len(answers) > 1]
    print(f"{len(calls)} threads: {len(failed)} failed, {len(different)} told different things", *failed[:1])
    return len(failed) + len(different)


def keep_stock(folder: Path) -> None:
    """Build the house and keep what its stages asked of each other."""
    from fuzzing import make_stock

    stock = make_stock(folder / "building")
    (folder / "stock.json").write_text(json.dumps({"problem": stock.problems[0], "request": stock.requests[0]}))


def main() -> None:
    """Start a process for each kind and round."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--kind", choices=KINDS, help=argparse.SUPPRESS)
    parser.add_argument("-o", "--output", type=Path, default=None, help="where the house is built")
    options = parser.parse_args()
    folder = options.output or Path(tempfile.mkdtemp(prefix="first-calls-"))
    if options.kind:
        faulthandler.enable()
        calls = (
            stage_calls(folder) if options.kind == "stages" else skill_calls(folder, loading=options.kind == "loads")
        )
        sys.exit(at_once(calls) > 0)
    folder.mkdir(parents=True, exist_ok=True)
    keep_stock(folder)
    faults = 0
    for number in range(options.rounds):
        for kind in KINDS:
            print(f"round {number + 1}, {kind}: ", end="", flush=True)
            command = [sys.executable, __file__, "--kind", kind, "-o", str(folder)]
            faults += subprocess.run(command, check=False).returncode != 0
    print(f"{faults} of {options.rounds * len(KINDS)} processes with a fault")
    sys.exit(faults > 0)


if __name__ == "__main__":
    main()
