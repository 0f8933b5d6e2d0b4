"""Plant each kind of fault in three buildings, and say which of them `mansion check` does not find.

    PYTHONPATH=tests/support python benchmarks/robustness/check_faults.py

Exit status 1 where one is not found, or where a building has faults of its own.
"""

import shutil
import sys
import tempfile
from pathlib import Path
from typing import Final

from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_msgs_py.request import BuildRequest
from planted_faults import PLANTED, plant_in

BUILDINGS: Final = (
    BuildRequest(description="a three-storey office with an elevator", floors=3, floor_area=200.0, seed=4),
    BuildRequest(description="a three-storey clinic with an elevator", seed=1),
    BuildRequest(description="a four-storey hotel with an elevator", seed=2),
)


def missed(request: BuildRequest, folder: Path) -> list[str]:
    """Build, plant each fault in a copy, and return those that the check does not find."""
    sound = build_building(request, folder / "sound").path
    if own := verify_building(sound):
        return [f"the building itself: {own[0]}"]
    names = []
    for plant, kind in PLANTED:
        copy = folder / "copy"
        shutil.copytree(sound, copy)
        plant_in(copy, plant)
        found = {fault.kind for fault in verify_building(copy)}
        if kind not in found:
            names.append(f"{plant.__name__}: {kind} is not among {sorted(found)}")
        shutil.rmtree(copy)
    return names


def main() -> int:
    """Plant, print, and return the exit status."""
    total = len({plant for plant, _ in PLANTED})
    wrong = 0
    for request in BUILDINGS:
        with tempfile.TemporaryDirectory(prefix="planted-") as folder:
            names = missed(request, Path(folder))
        print(f"{request.description}: {total} kinds planted, {len(names)} not found", flush=True)
        for name in names:
            print(f"  {name}")
        wrong += len(names)
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
