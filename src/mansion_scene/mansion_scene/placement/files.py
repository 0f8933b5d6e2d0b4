"""Placement of files of rooms (``mansion place``), in one process or several."""

import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

import msgspec

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.files import read_payload, write_atomic
from mansion_msgs_py.placement import Discarded, PlacementResult, PlacementRoom
from mansion_msgs_py.workers import worker_pool
from mansion_msgs_py.world import Progress
from mansion_scene.placement import PlacementOptions, place_room, warm

__all__ = ["load_rooms", "place_file", "place_timed", "placements"]


def load_rooms(path: Path) -> list[PlacementRoom]:
    """Read a JSON list of rooms.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where the file cannot be read, ``INVALID_PAYLOAD`` with the JSON path of a fault in it.
    """
    return read_payload(list[PlacementRoom], path, "a JSON list of rooms with their objects")


def place_timed(room: PlacementRoom, seed: int, options: PlacementOptions) -> PlacementResult:
    """Place a room and note the CPU seconds; the result of an invalid room has all objects discarded."""
    begin = time.process_time()
    try:
        result = place_room(room, seed=seed, options=options)
    except MansionError as error:
        reason = f"room refused, {error.info.path}: {error.info.message}"
        lost = [Discarded(name=o.name, count=o.quantity, reason=reason) for o in room.objects]
        result = PlacementResult(room_id=room.room_id, placements=[], discarded=lost)
    return msgspec.structs.replace(result, seconds=round(time.process_time() - begin, 4))


def _place_encoded(seed: int, options: PlacementOptions, data: bytes) -> bytes:
    return encode_bytes(place_timed(decode(PlacementRoom, data), seed, options))


def placements(
    rooms: Sequence[PlacementRoom], *, seed: int = 0, jobs: int = 1, options: PlacementOptions | None = None
) -> Iterator[PlacementResult]:
    """Yield the placements of rooms in their order; the same for any number of processes, apart from ``seconds``."""
    chosen = options or PlacementOptions()
    if jobs <= 1 or len(rooms) < 2:
        warm()
        for room in rooms:
            yield place_timed(room, seed, chosen)
        return
    work = partial(_place_encoded, seed, chosen)
    with worker_pool(min(jobs, len(rooms)), "spawn", warm) as pool:
        for data in pool.map(work, [encode_bytes(room) for room in rooms]):
            yield decode(PlacementResult, data)


def place_file(
    rooms: Path,
    output: Path,
    *,
    seed: int = 0,
    jobs: int = 1,
    options: PlacementOptions | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> list[PlacementResult]:
    """Place every room of a file and write the placements.

    Parameters
    ----------
    rooms, output : Path
        JSON lists of `PlacementRoom` and `PlacementResult`; the output appears whole or not at all.
    seed : int
        Every room draws from this seed and its own id.
    jobs : int
        Processes.
    options : PlacementOptions, optional
    progress : callable, optional
        Called after each room.

    Returns
    -------
    list of PlacementResult
        Placements in the order of the rooms.

    Raises
    ------
    MansionError
        When the rooms cannot be read.
    """
    asked = load_rooms(rooms)
    results: list[PlacementResult] = []
    for result in placements(asked, seed=seed, jobs=jobs, options=options):
        results.append(result)
        if progress is not None:
            left = sum(entry.count for entry in result.discarded)
            text = f"{result.room_id}: {len(result.placements)} placed, {left} left out"
            progress(Progress(stage="place", message=text, done=len(results), total=len(asked)))
    write_atomic(output, b"[" + b",\n".join(encode_bytes(result) for result in results) + b"]\n")
    return results
