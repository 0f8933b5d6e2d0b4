"""The source files that a reader passes through who follows one call: an instruction, or a floor problem.

    python benchmarks/editing/trace.py edit BUILDING ["put a red vase on the conference table"]
    python benchmarks/editing/trace.py floor ["a two-storey office"]

``edit`` follows an instruction from `mansion_bringup.cli.edit` to the changed scene of a copy of the building;
``floor`` follows `solve_floor` on the first floor of a planned sentence. The reader enters each function where it is
first called: `files` hold such functions, and a `return` is the way back from a function to a caller in another file.
Functions of the package under study are counted apart from the services of other packages (codecs, catalogue, checks,
derived files). Imports, lambdas and comprehensions are not calls.
"""

import argparse
import contextlib
import inspect
import io
import shutil
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import CodeType, FrameType

from mansion_bringup.cli.edit import edit
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.solver import solve_floor

SRC = f"{Path(__file__).resolve().parents[2] / 'src'}/"
INSTRUCTION = "put a red vase on the conference table"
SENTENCE = "a two-storey office"


def first_calls(call: Callable[[], object]) -> dict[CodeType, str]:
    """Run a call and return the project's functions that it enters, each with the file of its first caller."""
    callers: dict[CodeType, str] = {}

    def enter(frame: FrameType, event: str, _: object) -> None:
        code = frame.f_code
        if code in callers or not file_of(code):
            return
        caller = frame.f_back
        while caller is not None and not file_of(caller.f_code):
            caller = caller.f_back
        callers[code] = file_of(caller.f_code) if caller else file_of(code)

    sys.settrace(enter)
    try:
        call()
    finally:
        sys.settrace(None)
    return callers


def file_of(code: CodeType) -> str:
    """Return the source file of a function below ``src``, empty for other code (class bodies are not optimized)."""
    name, is_function = code.co_filename, code.co_flags & inspect.CO_OPTIMIZED and code.co_name[0] != "<"
    return name.removeprefix(SRC) if name.startswith(SRC) and is_function else ""


def follow_edit(building: Path, instruction: str) -> dict[CodeType, str]:
    """Trace one instruction on a copy of a building."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "building"
        shutil.copytree(building, copy, ignore=shutil.ignore_patterns("state"))
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            return first_calls(lambda: edit(copy, instruction, physics="static", who="trace"))


def follow_floor(sentence: str) -> dict[CodeType, str]:
    """Trace the solver on the first floor of a sentence."""
    problem = plan_building(BuildRequest(description=sentence)).problems[0]
    return first_calls(lambda: solve_floor(problem))


def show(callers: dict[CodeType, str], own: tuple[str, ...]) -> None:
    """Print the counts, and the files of the path in the order of entry."""
    functions = Counter(file_of(code) for code in callers)
    path = [name for name in functions if name.startswith(own)]
    returns = sum(
        caller != file_of(code) and caller.startswith(own) and file_of(code).startswith(own)
        for code, caller in callers.items()
    )
    for name in path:
        print(f"{functions[name]:4} functions  {name}")
    print(f"{len(path)} files, {sum(functions[name] for name in path)} functions, {returns} returns")
    print(f"{len(functions) - len(path)} files of other packages")


def main() -> None:
    """Follow what the command line names."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    editing = commands.add_parser("edit")
    editing.add_argument("building", type=Path, help="folder that `mansion build` wrote")
    editing.add_argument("instruction", nargs="?", default=INSTRUCTION)
    commands.add_parser("floor").add_argument("sentence", nargs="?", default=SENTENCE)
    options = parser.parse_args()
    if options.command == "edit":
        own = ("mansion_editing/", "mansion_bringup/mansion_bringup/cli/edit.py")
        show(follow_edit(options.building, options.instruction), own)
    else:
        show(follow_floor(options.sentence), ("mansion_planner/",))


if __name__ == "__main__":
    main()
