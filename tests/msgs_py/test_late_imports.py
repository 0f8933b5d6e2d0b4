"""Functions that import what they need may be called for the first time by several threads at once."""

import subprocess
import sys
from pathlib import Path

import pytest

ENTERED_FROM_TWO_SIDES = """
import sys
import threading
import time
from contextlib import nullcontext

from mansion_msgs_py.late_imports import importing

sys.path.insert(0, {folder!r})
held = importing if {locked} else nullcontext()
failed = []

def by_the_package():
    with held:
        import entered

def by_a_module():
    with held:
        from entered.part import thing

def attempt(call):
    try:
        call()
    except ImportError as error:
        failed.append(error)

first = threading.Thread(target=attempt, args=(by_the_package,))
second = threading.Thread(target=attempt, args=(by_a_module,))
first.start()
time.sleep(0.2)
second.start()
first.join()
second.join()
print(len(failed))
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Return the folder of a package that imports a module of its own, and the module the package."""
    folder = tmp_path / "entered"
    folder.mkdir()
    (folder / "__init__.py").write_text("import time\nstate = 1\ntime.sleep(0.6)\nfrom entered.part import thing\n")
    (folder / "part.py").write_text("from entered import state\nimport time\ntime.sleep(0.3)\nthing = state\n")
    return tmp_path


def _failures(package: Path, *, locked: bool) -> int:
    code = ENTERED_FROM_TWO_SIDES.format(folder=str(package), locked=locked)
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    return int(ended.stdout)


def test_python_itself_fails_where_two_threads_enter_a_package_from_two_sides(package: Path) -> None:
    assert _failures(package, locked=False) > 0


def test_no_import_fails_where_one_thread_at_a_time_imports(package: Path) -> None:
    assert _failures(package, locked=True) == 0
