"""Every room of some buildings furnished anew, each on a copy: what is refused, what has a fault, and the time.

    python benchmarks/editing/rooms.py BUILDING [BUILDING ...] [--type "meeting room"]

Each edit lands and is undone, and the documents afterwards are compared with those before.
"""

import argparse
import re
import shutil
import statistics
import tempfile
import time
from pathlib import Path

from mansion_bringup.edit_hooks import kept_files
from mansion_bringup.editor import open_editor
from mansion_bringup.verify import verify_building
from mansion_msgs_py.errors import MansionError


def documents(folder: Path) -> dict[str, bytes]:
    """Return the building's documents without their revisions."""
    files = [folder / "building.json", folder / "report.json"]
    for name in ("scene", "topology", "layout"):
        files += sorted(folder.glob(f"floors/*/{name}.json"))
    return {str(file): re.sub(rb'"revision": \d+', b"", file.read_bytes()) for file in files}


def main() -> None:
    """Measure."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("buildings", type=Path, nargs="+")
    parser.add_argument("--type", default="", help="the type that every room is to become; its own when absent")
    options = parser.parse_args()
    seconds: list[float] = []
    refused: list[str] = []
    faults = restored = 0
    for building in options.buildings:
        with tempfile.TemporaryDirectory() as work:
            folder = Path(shutil.copytree(building, Path(work) / "building"))
            editor = open_editor(folder, physics="static", who="benchmark")
            for room_id in [room.id for _, room in editor.state.rooms()]:
                before = documents(folder)
                started = time.process_time()
                try:
                    editor.call("FurnishRoom", {"room_id": room_id, "room_type": options.type})
                except MansionError as error:
                    refused.append(f"{room_id}: {error}")
                    continue
                seconds.append(time.process_time() - started)
                editor.store.refresh(kept_files)
                faults += len(verify_building(folder))
                editor.call("Undo")
                restored += documents(folder) == before
    print(f"{len(seconds)} rooms furnished, {len(refused)} refused, {faults} faults of the check, {restored} restored")
    print(f"CPU seconds: {statistics.median(seconds):.2f} in the median, {max(seconds):.2f} at most")
    print("\n".join(refused))


if __name__ == "__main__":
    main()
