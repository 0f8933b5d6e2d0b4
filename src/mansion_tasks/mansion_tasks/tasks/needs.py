"""The needs of a task: the objects or rooms of a building that meet one, and its description in English."""

from collections.abc import Iterator

from mansion_language.colours import colour_of
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.task import Need
from mansion_skills.world.building import LoadedBuilding
from mansion_tasks.language.matching import names_object, names_room
from mansion_tasks.language.vocabulary import article, ordinal, plain

__all__ = ["describe", "floor_phrase", "matching_objects", "matching_rooms"]

_MOUNTS = {"on": "surface", "in": "inside"}


def matching_rooms(need: Need, building: LoadedBuilding) -> list[str]:
    """Return the rooms that a need names, every room of its floor when it names none; no cores."""
    return [
        room.id
        for floor in building.floors
        if need.floor in (None, floor)
        for room in building.scene(floor).rooms
        if room.kind not in ("stair", "elevator") and (not need.room or names_room(need.room, room))
    ]


def matching_objects(need: Need, building: LoadedBuilding) -> list[str]:
    """Return the objects that meet a need, in the order of the scenes; what may be done with them is not judged."""
    rooms = set(matching_rooms(need, building))
    found = []
    for floor in building.floors:
        if need.floor not in (None, floor):
            continue
        items = {item.id: item for item in building.scene(floor).objects}
        found += [
            item.id for item in items.values() if item.room in rooms and _fits(need, item, items.get(item.parent or ""))
        ]
    return found


def _fits(need: Need, item: SceneObject, parent: SceneObject | None) -> bool:
    if not names_object(need.noun, item) or (need.color and colour_of(item.material) != plain(need.color)):
        return False
    if need.relation == "room":
        return True
    if parent is None or item.mount != _MOUNTS[need.relation]:
        return False
    if need.receptacle and not names_object(need.receptacle, parent):
        return False
    return not need.receptacle_color or colour_of(parent.material) == plain(need.receptacle_color)


def floor_phrase(floor: int, building: LoadedBuilding | None = None) -> str:
    """Return ``the third floor``; with the lift button's label where that says another object."""
    label = building.label(floor) if building is not None and floor in building.floors else ""
    if floor < 1:
        return f"floor {label or floor}"
    shown = "" if label in ("", str(floor)) else f" (button {label})"
    return f"the {ordinal(floor)} floor{shown}"


def describe(need: Need, building: LoadedBuilding | None = None) -> str:
    """Say a need in words, with definite articles for what a building has once.

    Examples
    --------
    >>> describe(Need(noun="laptop", relation="on", receptacle="desk", room="meeting room", floor=3))
    'a laptop on a desk in a meeting room on the third floor'
    >>> describe(Need(floor=4))
    'the fourth floor'
    """
    return " ".join(_parts(need, building))


def _parts(need: Need, building: LoadedBuilding | None) -> Iterator[str]:
    if need.noun:
        once = building is not None and len(matching_objects(need, building)) == 1
        yield article(plain(f"{need.color} {need.noun}"), known=once)
        if need.relation != "room" and need.receptacle:
            words = plain(f"{need.receptacle_color} {need.receptacle}")
            yield f"{need.relation} {article(words, known=False)}"
    if need.room:
        words = plain(need.room)
        once = building is not None and len(matching_rooms(need, building)) == 1
        where = words if words[-1:].isdigit() else article(words, known=once)
        yield f"in {where}" if need.noun else where
    if need.floor is not None:
        where = floor_phrase(need.floor, building)
        yield f"on {where}" if need.noun or need.room else where
