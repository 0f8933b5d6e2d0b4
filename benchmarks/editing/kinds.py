"""Statements about kinds of things: each of a room, every one on a floor, one within another."""

import re

from cases import Scenes, objects

from mansion_msgs_py.scene import SceneObject

EVERY = re.compile(r"every (\w+) (top|ground) (on|off|open|closed)$")
EACH = re.compile(r"each (\w+) in (\w+) has (\w+)$")
WITHIN = re.compile(r"(\w+) within (\w+) on (\w+)$")


def of_kind(category: str, words: tuple[str, ...]) -> bool:
    """Whether a category is one of some words; a word after ``~`` need only be a part of it."""
    return any(word[1:] in category if word.startswith("~") else word == category for word in words)


def level(scenes: Scenes, word: str) -> int:
    """Return the number of the top or the ground floor."""
    floors = sorted(scene.floor for scene in scenes)
    return floors[-1] if word == "top" else floors[0]


class EveryStatement:
    """``every lamp top off``: all of a kind on a floor that switch, or open, are so."""

    def __init__(self, match: re.Match[str]) -> None:
        self.kind, self.floor, word = match.groups()
        self.state = "on" if word in ("on", "off") else "open"
        self.value = word in ("on", "open")

    def mine(self, scenes: Scenes) -> list[SceneObject]:
        """What it is said of."""
        floor = level(scenes, self.floor)
        return [
            item
            for scene in scenes
            if scene.floor == floor
            for item in scene.objects
            if self.kind in item.category and (item.toggleable if self.state == "on" else item.openable)
        ]

    def missing(self, scenes: Scenes) -> int:
        return sum(item.states.get(self.state, False) is not self.value for item in self.mine(scenes))

    def holds(self, scenes: Scenes) -> bool:
        return bool(self.mine(scenes)) and not self.missing(scenes)

    def surplus(self, scenes: Scenes) -> int:
        return 0


class EachStatement:
    """``each desk in R has pen``."""

    def __init__(self, match: re.Match[str], rooms: dict[str, str]) -> None:
        self.carrier, self.room, self.thing = match[1], rooms[match[2]], match[3]

    def missing(self, scenes: Scenes) -> int:
        mine = [
            o
            for o in objects(scenes)
            if o.room == self.room and o.category.endswith(self.carrier) and o.mount == "floor"
        ]
        having = {o.parent for o in objects(scenes) if o.category == self.thing}
        return sum(o.id not in having for o in mine)

    def holds(self, scenes: Scenes) -> bool:
        return not self.missing(scenes)

    def surplus(self, scenes: Scenes) -> int:
        return 0


class WithinStatement:
    """``apple within bowl on T``: 0, 1 or 2 things are missing."""

    def __init__(self, match: re.Match[str], items: dict[str, SceneObject]) -> None:
        self.thing, self.vessel, self.place = match[1], match[2], items[match[3]].id

    def missing(self, scenes: Scenes) -> int:
        everything = objects(scenes)
        vessels = {o.id for o in everything if o.category == self.vessel and o.parent == self.place}
        if any(o.category == self.thing and o.parent in vessels for o in everything):
            return 0
        return 1 if vessels else 2

    def holds(self, scenes: Scenes) -> bool:
        return not self.missing(scenes)

    def surplus(self, scenes: Scenes) -> int:
        return 0
