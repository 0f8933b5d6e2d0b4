"""What must be true after an instruction of a training list: read from words, judged from the scenes alone."""

import math
import re
from collections.abc import Iterator
from typing import Any, Protocol

from cases import ORDINALS, Scenes, count, objects, room_words
from kinds import EACH, EVERY, WITHIN, EachStatement, EveryStatement, WithinStatement, of_kind

from mansion_assets.catalogue import Catalogue
from mansion_msgs_py.scene import FloorScene, SceneObject

NEAR = 0.9
_ALSO = {"vase": ("vase", "flower_vase")}
_NAME = re.compile(r"\b(T2|T|O2|O|U|F|C|L|P|R2|R|B|Q|Z)\b")
_SLOT = re.compile(r"\{(\w+)(?:\.(\w+))?\}")
_COUNT = re.compile(r"(?:(\w+) )?(~?\w+) (on|near|in) (\w+) (>=|==|\+=) (-?\d+)$")
_ONLY = re.compile(r"only ([\w,]+) on (\w+)$")
_STATE = re.compile(r"(\w+) (all )?(open|closed|on|off)$")


def names_in(text: str) -> list[str]:
    """Return the names that an instruction and its statements use, in braces or alone."""
    return sorted(set(_NAME.findall(text)))


class Place(Protocol):
    """Says where an object is."""

    def where(self, scene: FloorScene, item: SceneObject) -> str: ...


class Names:
    """What names stand for: objects, rooms, and the words for each."""

    def __init__(self, scenes: Scenes) -> None:
        self.scenes = scenes
        self.items: dict[str, SceneObject] = {}
        self.rooms: dict[str, str] = {}
        self.words: dict[str, str] = {}

    def take(self, name: str, pair: tuple[FloorScene, SceneObject], place: Place) -> None:
        """Let a name stand for an object."""
        scene, item = pair
        self.items[name] = item
        self.words[name] = place.where(scene, item)
        parts = {
            "id": item.id,
            "name": item.name,
            "level": f"floor {scene.floor}",
            "room": room_words(scene, item.room, len(self.scenes) > 1),
            **self.plainly(scene, item.room),
        }
        self.words.update({f"{name}.{part}": words for part, words in parts.items()})

    def take_room(self, name: str, scene: FloorScene, room: str, tall: bool) -> None:
        """Let a name stand for a room."""
        self.rooms[name] = room
        self.words[name] = room_words(scene, room, tall)
        parts = self.plainly(scene, room)
        self.words.update({f"{name}.{part}": words for part, words in parts.items()})

    def plainly(self, scene: FloorScene, room: str) -> dict[str, str]:
        """Return a room's name and floor as they are spoken."""
        place, nth = room.split("/", 1)[1].replace("_", " "), ORDINALS[scene.floor]
        at = f"the {place} on the {nth} floor" if len(self.scenes) > 1 else f"the {place}"
        return {"place": place, "nth": nth, "num": str(scene.floor), "at": at, "in": f"in {at}"}

    def fill(self, text: str) -> str:
        """Return an instruction in plain words."""

        def words(match: re.Match[str]) -> str:
            return self.words[match[0].strip("{}")]

        out = _SLOT.sub(words, text)
        return out[0].upper() + out[1:] if not out.startswith("F") else out

    def category(self, word: str) -> str:
        """Return the category that a word of a statement means."""
        return self.items[word].category if word in self.items else word

    def categories(self, word: str) -> tuple[str, ...]:
        """Return the category of a word and those that people call so too."""
        return _ALSO.get(word, (self.category(word),))

    def actions(self, words: str, catalogue: Catalogue) -> Iterator[tuple[str, dict[str, Any]]]:
        """Yield the calls that make a statement true: ``put pen T``, ``C open``, ``Q all open``."""
        if words.startswith("put "):
            _, thing, place = words.split()
            asset = catalogue.by_category(thing)[0].key
            yield "PlaceOnSurface", {"asset_id": asset, "receptacle_id": self.items[place].id}
            return
        every = EVERY.match(words)
        fact = EveryStatement(every) if every else StateStatement(words, self)
        for item in fact.mine(self.scenes):
            yield "SetState", {"object_id": item.id, fact.state: fact.value}


class Statement(Protocol):
    """Something that is true of scenes or not."""

    def holds(self, scenes: Scenes) -> bool:
        """Whether it is true."""
        ...

    def missing(self, scenes: Scenes) -> int:
        """Return the least number of edits that make it true."""
        ...

    def surplus(self, scenes: Scenes) -> int:
        """Return how many things must go for it."""
        ...


class CountStatement:
    """``red mug on T >= 2``, ``pen near O >= 1``, ``blue armchair in B >= 1``."""

    def __init__(self, match: re.Match[str], names: Names) -> None:
        self.colour, word, self.relation, self.place, self.sign, number = match.groups()
        self.categories, self.number, self.names = names.categories(word), int(number), names
        if self.sign == "+=":
            self.sign, self.number = "==", self.have(names.scenes) + self.number

    def have(self, scenes: Scenes) -> int:
        """Count what is there."""
        if self.relation == "on" and not self.colour and self.categories[0][0] != "~":
            carrier = self.names.items[self.place].id
            return sum(count(scenes, carrier, category) for category in self.categories)
        found = [
            o
            for o in objects(scenes)
            if of_kind(o.category, self.categories) and o.material.endswith(self.colour or "")
        ]
        if self.relation == "in":
            return sum(o.room == self.names.rooms[self.place] for o in found)
        item = self.names.items[self.place]
        if self.relation == "on":
            return sum(o.parent == item.id for o in found)
        near = [o for o in found if o.parent == item.parent and o.id != item.id]
        return sum(math.dist(o.position[:2], item.position[:2]) < NEAR for o in near)

    def holds(self, scenes: Scenes) -> bool:
        have = self.have(scenes)
        return have == self.number if self.sign == "==" else have >= self.number

    def missing(self, scenes: Scenes) -> int:
        have = self.have(scenes)
        return abs(self.number - have) if self.sign == "==" else max(0, self.number - have)

    def surplus(self, scenes: Scenes) -> int:
        return max(0, self.have(scenes) - self.number) if self.sign == "==" else 0


class OnlyStatement:
    """``only mug,book on T``."""

    def __init__(self, match: re.Match[str], names: Names) -> None:
        self.allowed = {c for word in match[1].split(",") for c in names.categories(word)}
        self.place = names.items[match[2]].id

    def others(self, scenes: Scenes) -> list[str]:
        """Ids of what else is there."""
        mine = [o for o in objects(scenes) if o.parent == self.place]
        return [o.id for o in mine if o.category not in self.allowed]

    def holds(self, scenes: Scenes) -> bool:
        return not self.others(scenes)

    def missing(self, scenes: Scenes) -> int:
        return len(self.others(scenes))

    def surplus(self, scenes: Scenes) -> int:
        going = self.others(scenes)
        carried = [o for o in objects(scenes) if o.parent in going]
        return len(going) + len(carried)


class StateStatement:
    """``C open``, ``Q all closed``, ``Z all off``."""

    def __init__(self, words: str, names: Names) -> None:
        match = _STATE.match(words)
        if match is None:
            raise SystemExit(f"not a statement: {words!r}")
        self.place, self.whole, word = match[1], bool(match[2]), match[3]
        self.state, self.value = ("open" if word in ("open", "closed") else "on", word in ("open", "on"))
        self.names = names

    def mine(self, scenes: Scenes) -> list[SceneObject]:
        """What it is said of."""
        if not self.whole:
            return [o for o in objects(scenes) if o.id == self.names.items[self.place].id]
        room = self.names.rooms[self.place]
        able = [o for o in objects(scenes) if o.room == room]
        return [o for o in able if (o.openable if self.state == "open" else o.toggleable)]

    def missing(self, scenes: Scenes) -> int:
        return sum(o.states.get(self.state, False) is not self.value for o in self.mine(scenes))

    def holds(self, scenes: Scenes) -> bool:
        return bool(self.mine(scenes)) and not self.missing(scenes)

    def surplus(self, scenes: Scenes) -> int:
        return 0


class WayStatement:
    """``way R R2``: buildings that pass the check have it; the agent must only not refuse it."""

    def holds(self, scenes: Scenes) -> bool:
        return True

    def missing(self, scenes: Scenes) -> int:
        return 0

    def surplus(self, scenes: Scenes) -> int:
        return 0


def statement(words: str, names: Names) -> Statement:
    """Read a statement."""
    if words.startswith("way "):
        return WayStatement()
    every, each, within = EVERY.match(words), EACH.match(words), WITHIN.match(words)
    if every:
        return EveryStatement(every)
    if each:
        return EachStatement(each, names.rooms)
    if within:
        return WithinStatement(within, names.items)
    only = _ONLY.match(words)
    if only:
        return OnlyStatement(only, names)
    number = _COUNT.match(words)
    return CountStatement(number, names) if number else StateStatement(words, names)
