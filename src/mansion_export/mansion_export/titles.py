"""What pictures of a building and of its floors are titled with."""

from collections.abc import Sequence

from mansion_msgs_py.scene import FloorScene

__all__ = ["building_title", "floor_name", "floor_title"]

_COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def building_title(scenes: Sequence[FloorScene]) -> str:
    """Return what a building is and how many floors it has.

    Examples
    --------
    ``Office, four floors``; ``Villa, two floors and a basement``.
    """
    if not scenes:
        return "Building"
    kind = scenes[0].building_type or scenes[0].building_id
    name = kind.removesuffix("_building").replace("_", " ").strip() or "building"
    name = name[0].upper() + name[1:]
    below = sum(scene.floor < 1 for scene in scenes)
    above = len(scenes) - below
    counts = [f"{_count(above)} floor{'s' * (above != 1)}"] if above else []
    if below:
        counts.append("a basement" if below == 1 else f"{_count(below)} basements")
    return f"{name}, {' and '.join(counts)}"


def floor_name(scene: FloorScene) -> str:
    """Return ``ground floor``, ``floor 3`` or ``basement 1``."""
    if scene.label == "G" or (scene.floor == 1 and scene.floors > 1):
        return "ground floor"
    if scene.floor < 1:
        return f"basement {1 - scene.floor}"
    return f"floor {scene.label}"


def floor_title(scene: FloorScene) -> str:
    """Return the building's kind and the floor: ``Office: ground floor``; a single floor is the building."""
    kind = building_title([scene]).rsplit(", ", 1)[0]
    return kind if scene.floors == 1 else f"{kind}: {floor_name(scene)}"


def _count(number: int) -> str:
    return _COUNTS[number] if number < len(_COUNTS) else str(number)
