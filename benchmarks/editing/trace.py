"""Count the project's files that one call passes through, and how often it returns to one.

    python benchmarks/editing/trace.py edit BUILDING ["put a mug on the desk"]
    python benchmarks/editing/trace.py floor BUILDING [FLOOR]

``edit`` follows an instruction on a copy of the building, from `mansion_bringup.cli.edit.edit` to the changed scene;
``floor`` solves the floor problem of a floor again. A reader who follows the call enters each function when it is first
called: `files` are those that hold such functions, and `returns` are the times that he comes back from another file.
The calls of a second reading are left out, as are imports.
"""

import sys
from collections.abc import Callable
from pathlib import Path
from types import CodeType, FrameType

SRC = Path(__file__).resolve().parents[2] / "src"


class Trace:
    """The functions of the project in the order of their first calls, and where each was called from."""

    def __init__(self) -> None:
        self.calls: dict[CodeType, str] = {}

    def run(self, call: Callable[[], object]) -> None:
        """Follow a call."""
        sys.setprofile(self._enter)
        try:
            call()
        finally:
            sys.setprofile(None)

    def _enter(self, frame: FrameType, event: str, _: object) -> None:
        code = frame.f_code
        if event == "call" and code not in self.calls and _file(code):
            caller = frame.f_back
            while caller is not None and not _file(caller.f_code):
                caller = caller.f_back
            self.calls[code] = _file(caller.f_code) if caller else ""


def _file(code: CodeType) -> str:
    name = code.co_filename
    return name[len(str(SRC)) + 1 :] if name.startswith(str(SRC)) and code.co_name != "<module>" else ""
