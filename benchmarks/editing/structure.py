"""Random changes of structure on built buildings: how many are done, refused with a reason, or leave a fault.

    python benchmarks/editing/structure.py BUILDINGS [-n 60] [--seed 1]

BUILDINGS is a folder of building folders, of which copies are edited. A third of the requests are areas, a third doors,
a third rooms that change places. Of the doors four in five are wanted between rooms that share a wall and have none
yet, of the places four in five are not those of corridors; the others may be anything. After each that is done the
whole building is checked with all its files; areas must be as asked within 1%, the polygons of rooms that are not named
in the reply and the objects of rooms that did not change must be what they were; then it is undone, and the documents
must be what they were.
"""

import argparse
import random
import shutil
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

from shapely import Polygon

from mansion_bringup.building.files import kept_files
from mansion_bringup.editor import open_editor
from mansion_bringup.verify import verify_building
from mansion_editing.editor import SceneEditor
from mansion_editing.structure.room_shapes import is_circulation
from mansion_geometry.shared_walls import edge_array, shared_walls, total_length
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneRoom

REASONS = (ErrorCode.INFEASIBLE, ErrorCode.CONFLICT, ErrorCode.INVALID_PAYLOAD)
CHANGES = (-8.0, -5.0, -3.0, -2.0, 2.0, 3.0, 5.0, 8.0, 10.0)


def requests(editors: list[SceneEditor], number: int, generator: random.Random) -> Iterator[tuple[int, dict[str, Any]]]:
    """Yield the number of a building and the arguments of a request."""
    for count in range(number):
        building = count % len(editors)
        scenes = editors[building].state.scenes
        scene = scenes[generator.choice(sorted(scenes))]
        what = ("area", "door", "swap")[count // len(editors) % 3]
        if what == "area":
            room = generator.choice(scene.rooms)
            yield building, {"what": what, "room_id": room.id, "area": generator.choice(CHANGES)}
            continue
        pairs = list(combinations(scene.rooms, 2))
        if generator.random() < 0.8:
            likely = _could_join if what == "door" else _could_swap
            pairs = [pair for pair in pairs if likely(scene, *pair)] or pairs
        first, second = generator.choice(pairs)
        yield building, {"what": what, "room_id": first.id, "other_id": second.id}


def _could_swap(scene: FloorScene, one: SceneRoom, other: SceneRoom) -> bool:
    return not any(is_circulation(room) or room.kind == "main" for room in (one, other))


def _could_join(scene: FloorScene, one: SceneRoom, other: SceneRoom) -> bool:
    if {one.id, other.id} in (set(door.rooms) for door in scene.doors):
        return False
    walls = shared_walls(edge_array(Polygon(one.polygon, one.holes)), edge_array(Polygon(other.polygon, other.holes)))
    return total_length(walls) > 1.0


def documents(folder: Path) -> dict[str, bytes]:
    """Return the documents that a change of structure replaces, without the number of the revision."""
    names = [folder / "building.json", *folder.glob("floors/*/*.json")]
    kept = [file for file in names if file.stem in ("building", "topology", "layout", "scene")]
    return {str(file): _without_revision(file.read_bytes()) for file in kept}


def _without_revision(data: bytes) -> bytes:
    return b"\n".join(line for line in data.split(b"\n") if not line.startswith(b' "revision":'))


def differences(before: FloorScene, after: FloorScene, named: list[str], asked: dict[str, Any]) -> list[str]:
    """Return what changed that should not have, and an area that is not as asked."""
    wrong = []
    old = {room.id: room for room in before.rooms}
    for room in after.rooms:
        if room.id not in named and room.polygon != old[room.id].polygon:
            wrong.append(f"{room.id} has another polygon")
        if room == old[room.id] and room.id not in asked.values():
            objects = [[item for item in scene.objects if item.room == room.id] for scene in (before, after)]
            wrong += [f"{room.id} has other objects"] if objects[0] != objects[1] else []
    if asked["what"] == "area":
        now = next(room.area for room in after.rooms if room.id == asked["room_id"])
        wanted = old[asked["room_id"]].area + asked["area"]
        wrong += [f"{now:.2f} m2 instead of {wanted:.2f}"] if abs(now - wanted) > 0.01 * wanted else []
    return wrong


def judged(editor: SceneEditor, asked: dict[str, Any]) -> tuple[str, list[str], list[str]]:
    """Carry out a request and take it back; return what became of it, the words of the reply, and what is wrong."""
    folder, floor = editor.store.folder, int(asked["room_id"].partition("/")[0][1:])
    before, was = documents(folder), editor.state.scenes[floor]
    try:
        reply = editor.call("ReshapeFloor", asked)
    except MansionError as error:
        return "refused", [error.info.message], [] if error.info.code in REASONS else [str(error)]
    wrong = differences(was, editor.state.scenes[floor], reply.room_ids, asked)
    editor.store.refresh(kept_files)
    wrong += [str(fault) for fault in verify_building(folder)]
    editor.call("Undo")
    wrong += [] if documents(folder) == before else ["undone, the documents are not what they were"]
    return "done", [reply.message], wrong


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("buildings", type=Path)
    parser.add_argument("-n", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--verbose", action="store_true")
    args = parser.parse_args()
    counts: Counter[str] = Counter()
    seconds: list[float] = []
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        editors = []
        for file in sorted(args.buildings.glob("*/building.json")):
            copy = Path(shutil.copytree(file.parent, Path(folder) / file.parent.name))
            editors.append(open_editor(copy, physics="static", who="benchmark"))
        for building, asked in requests(editors, args.n, random.Random(args.seed)):
            started = time.perf_counter()
            became, words, wrong = judged(editors[building], asked)
            seconds.append(time.perf_counter() - started)
            counts[became] += 1
            counts[f"{asked['what']} {became}"] += 1
            faults += len(wrong)
            if args.verbose or wrong:
                told = f"{became} after {seconds[-1]:.1f} s"
                print(editors[building].store.folder.name, asked, told, *words, *wrong, sep="\n    ", flush=True)
    print(f"{args.n} requests over {len(editors)} buildings: {dict(sorted(counts.items()))}, {faults} faults")
    print(f"median {sorted(seconds)[len(seconds) // 2]:.1f} s with check and undo, longest {max(seconds):.1f} s")


if __name__ == "__main__":
    main()
