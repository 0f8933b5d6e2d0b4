"""What the first use of compiled kernels says."""

import os
import subprocess
import sys
from pathlib import Path

import mansion_geometry

SCRIPT = """
import sys
sys.path.insert(0, sys.argv[1])
from mansion_geometry.compiled import kernel
from some_kernels import twice
print(twice(4.0))
"""

KERNELS = """
from mansion_geometry.compiled import kernel

@kernel
def twice(number: float) -> float:
    return 2.0 * number

@kernel
def thrice(number: float) -> float:
    return 3.0 * number
"""


def run(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", SCRIPT, str(folder)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), *sys.path])},
        capture_output=True,
        text=True,
        timeout=300,
    )


def test_the_first_compilation_says_once_what_is_kept_where_and_how_to_remove_it(tmp_path: Path) -> None:
    own = tmp_path / "mansion_geometry"
    own.mkdir()
    source = Path(mansion_geometry.__file__).parent
    for name in ("__init__.py", "compiled.py"):
        (own / name).write_text((source / name).read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "some_kernels.py").write_text(KERNELS, encoding="utf-8")
    first, second = run(tmp_path), run(tmp_path)
    assert first.stdout == second.stdout == "8.0\n", first.stderr
    assert first.stderr.count("numba compiles the kernels") == 1
    assert "__pycache__" in first.stderr and "delete *.nbi and *.nbc" in first.stderr
    assert second.stderr == ""
    for file in tmp_path.rglob("*.nb[ic]"):
        file.unlink()
    assert run(tmp_path).stderr.count("numba compiles the kernels") == 1
