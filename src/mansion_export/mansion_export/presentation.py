"""How a building is presented to people: titles of floors and rooms, and the side that faces the viewer."""

import re
from collections.abc import Sequence

import numpy as np

from mansion_language.numbers import NUMBER_WORDS
from mansion_msgs_py.scene import Door, FloorScene, SceneRoom

__all__ = ["building_name", "building_title", "floor_name", "floor_title", "main_door", "quarter_turns", "room_title"]


def building_title(scenes: Sequence[FloorScene]) -> str:
    """Return what a building is and how many floors it has.

    Examples
    --------
    ``Office, four floors``; ``Villa, two floors and a basement``.
    """
    if not scenes:
        return "Building"
    below = sum(scene.floor < 1 for scene in scenes)
    above = len(scenes) - below
    counts = [f"{_count(above)} floor{'s' * (above != 1)}"] if above else []
    if below:
        counts.append("a basement" if below == 1 else f"{_count(below)} basements")
    return f"{building_name(scenes[0])}, {' and '.join(counts)}"


def building_name(scene: FloorScene) -> str:
    """Return what people call a building: as its brief does, or as its type: ``Office``, ``Fire station``."""
    kind = scene.called or scene.building_type or scene.building_id
    name = kind.removesuffix("_building").replace("_", " ").strip() or "building"
    name = re.sub(r"\b(tv|dj|it|ev)\b", lambda letters: letters[0].upper(), name)
    return name[0].upper() + name[1:]


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
    return NUMBER_WORDS[number] if number < len(NUMBER_WORDS) else str(number)


def room_title(room: SceneRoom) -> str:
    """Return the name that a person reads: the room's own, or its type in words; "own bathroom" is a bathroom."""
    name = room.name or room.id.rsplit("/", 1)[-1]
    words = re.sub(r"\b(men|women|children)s\b", r"\1's", name.replace("_", " ").strip(), flags=re.IGNORECASE)
    words = words.removeprefix("own ").removeprefix("its own ")
    return words[:1].upper() + words[1:]


def main_door(scene: FloorScene) -> Door | None:
    """Return the door that people come in by, the widest entrance; ``None`` where no door but a garage's leads out."""
    doors = [door for door in scene.doors if None in door.rooms and door.kind != "garage"]
    return max(doors, key=lambda door: (door.kind == "entrance", door.width), default=None)


def quarter_turns(scenes: Sequence[FloorScene]) -> int:
    """Return by how many quarters to turn a building so that its long side and its entrance face the viewer."""
    above = (scene for scene in scenes if scene.floor >= 1)
    ground = min(above, key=lambda scene: scene.floor, default=None)
    if ground is None:
        return 0
    points = np.array(ground.outline)
    low, high = points.min(0), points.max(0)
    turns = 1 if high[1] - low[1] > 1.1 * (high[0] - low[0]) else 0
    door = main_door(ground)
    if door is None:
        return turns
    x, y = np.mean(door.segment, axis=0)
    # Sides in the order in which quarter turns bring them round to the south.
    sides = [y - low[1], x - low[0], high[1] - y, high[0] - x]
    side = int(np.argmin(sides))
    return turns if (side - turns) % 4 in (0, 3) else turns + 2
