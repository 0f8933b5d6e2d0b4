"""Kernels whose machine code is on the disk."""

import os
import subprocess
import sys
from pathlib import Path

KERNELS = """
import numpy as np
from mansion_geometry.compiled import kernel

@kernel
def doubled(values):
    out = np.empty_like(values)
    for k in range(len(values)):
        out[k] = 2.0 * values[k]
    return out
"""

USES = """
import sys
import numpy as np
from some_kernels import doubled
print(doubled(np.ones(2)).tolist(), "numba.typed.typeddict" in sys.modules)
print(doubled(np.ones(2, dtype=np.float32)).tolist(), "numba.typed.typeddict" in sys.modules)
"""


def run(folder: Path, lines: int) -> list[str]:
    """Run the first lines of `USES` in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(USES.splitlines()[: 4 + lines])],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), *sys.path])},
        capture_output=True,
        text=True,
        timeout=300,
        check=True,
    )
    return done.stdout.splitlines()


def test_machine_code_is_loaded_without_what_compiles_and_more_can_be_compiled_afterwards(tmp_path: Path) -> None:
    (tmp_path / "some_kernels.py").write_text(KERNELS, encoding="utf-8")
    assert run(tmp_path, 1) == ["[2.0, 2.0] True"]
    assert run(tmp_path, 2) == ["[2.0, 2.0] False", "[2.0, 2.0] True"]
