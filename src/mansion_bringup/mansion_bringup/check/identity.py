"""Are ids unique and named by their floor, every number finite, and payloads about one building."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from mansion_bringup.check.fault import Fault
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.scene import FloorScene

__all__ = ["check_identity"]


def check_identity(building_id: str, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield faults of names and numbers."""
    ids: Counter[str] = Counter()
    for scene in scenes:
        if scene.building_id != building_id:
            yield Fault("BUILDING_ID", f"floor {scene.floor}", f"belongs to {scene.building_id!r}")
        prefix = f"F{scene.floor}/"
        names = [room.id for room in scene.rooms] + [wall.id for wall in scene.walls]
        names += [door.id for door in scene.doors] + [window.id for window in scene.windows]
        names += [thing.id for thing in scene.objects]
        ids.update(names)
        for name in names:
            if not name.startswith(prefix):
                yield Fault("ID", name, f"does not begin with {prefix}")
        for path in _not_finite(to_builtins(scene), "$"):
            yield Fault("NUMBER", f"floor {scene.floor}", f"{path} is not finite")
    for name, count in sorted(ids.items()):
        if count > 1:
            yield Fault("ID", name, f"is used {count} times")


def _not_finite(value: Any, path: str) -> Iterator[str]:
    if isinstance(value, float):
        if not math.isfinite(value):
            yield path
    elif isinstance(value, dict):
        for key, entry in value.items():
            yield from _not_finite(entry, f"{path}.{key}")
    elif isinstance(value, list | tuple):
        for index, entry in enumerate(value):
            yield from _not_finite(entry, f"{path}[{index}]")
