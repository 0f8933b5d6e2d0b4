"""Measures of a finished building: its rows of the manifest, split, difficulty and hash."""

import hashlib
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from mansion_geometry.randomness import item_seed
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.scene import FloorScene
from mansion_world.near_duplicates import graph_fingerprint, room_likeness
from mansion_world.records import BuildingRow, Difficulty, DoneTask, MadeTasks, Record, RoomRow, Split, TaskRow
from mansion_world.sampling import WorldRequest
from mansion_world.world_folder import building_path

__all__ = ["LICENCE", "difficulty_of", "folder_digest", "is_hashed", "measure_building", "split_of", "task_row"]

LICENCE: Final = "Apache-2.0"
"""Licence of what Mansion writes of a building: geometry, furniture by asset id, plans, pictures and tasks."""

_NOT_HASHED: Final = "report.json"
"""The one file of a building that holds times."""

_SHARES: Final[tuple[tuple[Split, float], ...]] = (("test", 0.1), ("val", 0.1), ("train", 0.8))

_LEVELS: Final[tuple[tuple[Difficulty, float], ...]] = (("easy", 12.0), ("medium", 30.0), ("hard", 75.0))
"""Difficulty below a score; `expert` from there on."""

_FLOOR: Final = 4.0
_OBJECTS: Final = 60.0
_METRES: Final = 10.0


def split_of(seed: int, description: str) -> Split:
    """Return the split of a building, by a hash of its sentence: requests in the same words are never apart.

    It depends on nothing else, so that a larger world only adds to each split.
    """
    place = item_seed(seed, "split", description) / 2**64
    for split, share in _SHARES:
        if place < share:
            return split
        place -= share
    return _SHARES[-1][0]


def difficulty_of(floors: int, rooms: int, objects: int, metres: float = 0.0) -> Difficulty:
    """Return the difficulty of a building as measured.

    The score is the number of rooms, plus 4 for each floor above the first, 1 for each 60 objects and 1 for each 10 m
    that a task takes the robot on average: below 12 easy, below 30 medium, below 75 hard.

    Examples
    --------
    >>> difficulty_of(1, 5, 124), difficulty_of(1, 5, 124, metres=80.0), difficulty_of(8, 120, 3000)
    ('easy', 'medium', 'expert')
    """
    score = rooms + _FLOOR * (floors - 1) + objects / _OBJECTS + metres / _METRES
    return next((level for level, bound in _LEVELS if score < bound), "expert")


def is_hashed(name: str) -> bool:
    """Whether a file of a building folder is part of the building: neither times nor what a robot left."""
    return name != _NOT_HASHED and not name.startswith("state/")


def folder_digest(folder: Path) -> tuple[str, int, int]:
    """Return hash, bytes and number of the files of a building folder, ``report.json`` left out."""
    whole = hashlib.sha256()
    size = count = 0
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        name = file.relative_to(folder).as_posix()
        if not is_hashed(name):
            continue
        data = file.read_bytes()
        whole.update(f"{name}\0{hashlib.sha256(data).hexdigest()}\n".encode())
        size, count = size + len(data), count + 1
    return whole.hexdigest(), size, count


def measure_building(seed: int, request: WorldRequest, folder: Path, made: MadeTasks) -> Record:
    """Return the record of the building in `folder`, which was built from `request` for the world of `seed`."""
    read = BuildingFolder(folder)
    building, scenes = read.building, read.scenes()
    row = _building_row(seed, request, folder, made, building, scenes)
    return Record(
        building=row,
        rooms=_room_rows(row, read),
        graph=graph_fingerprint([read.topology(floor) for floor in read.floors]),
        likeness=room_likeness(scenes),
        tasks=[task_row(row, done) for done in made.tasks],
    )


def _building_row(
    seed: int, request: WorldRequest, folder: Path, made: MadeTasks, building: Building, scenes: Sequence[FloorScene]
) -> BuildingRow:
    """Return the row of a building in the manifest."""
    digest, size, count = folder_digest(folder)
    objects = sum(len(scene.objects) for scene in scenes)
    rooms = sum(len(scene.rooms) for scene in scenes)
    metres = round(sum(done.metres for done in made.tasks) / len(made.tasks), 2) if made.tasks else 0.0
    return BuildingRow(
        index=request.index,
        id=building.building_id,
        path=building_path(request.index, request.name),
        split=split_of(seed, request.request.description),
        difficulty=difficulty_of(len(scenes), rooms, objects, metres),
        kind=request.kind,
        sub_kind=request.sub_kind,
        outline=request.outline,
        style=building.program.style,
        description=request.request.description,
        wording=request.wording,
        seed=request.request.seed,
        attempt=request.attempt,
        floors=len(scenes),
        rooms=rooms,
        landmarks=max(len(scene.rooms) + len(scene.cores) for scene in scenes),
        objects=objects,
        area=round(sum(floor.area for floor in building.floors), 2),
        floor_areas=[floor.area for floor in building.floors],
        wishes=len(building.wishes),
        wishes_met=sum(wish.status == "met" for wish in building.wishes),
        files=count,
        bytes=size,
        sha256=digest,
        versions=building.versions,
        licence=LICENCE,
        tasks=len(made.tasks),
        task_metres=metres,
        tasks_undone=made.undone,
        no_tasks=made.why_none,
        clutter=request.clutter,
    )


def task_row(row: BuildingRow, done: DoneTask) -> TaskRow:
    """Return the row of a task of a building."""
    task = done.task
    return TaskRow(
        index=row.index,
        building=row.id,
        split=row.split,
        id=task.id,
        kind=task.kind,
        instruction=task.instruction,
        difficulty=task.difficulty,
        floors=task.floors_spanned,
        metres=round(done.metres, 2),
        seconds=round(done.seconds, 1),
        steps=len(task.oracle),
        max_steps=task.max_steps,
        things=len({name for goal in task.goals for name in goal.objects[:1]}),
    )


def _room_rows(row: BuildingRow, read: BuildingFolder) -> list[RoomRow]:
    rows = []
    for scene in read.scenes():
        held = Counter(item.room for item in scene.objects)
        rows += [
            RoomRow(
                index=row.index,
                building=row.id,
                split=row.split,
                floor=scene.floor,
                id=room.id,
                type=room.room_type,
                area=room.area,
                objects=held[room.id],
            )
            for room in scene.rooms
        ]
    return rows
