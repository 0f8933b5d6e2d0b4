"""The editing agent on instructions in many different words; what must be true afterwards is read from scene.json.

    python benchmarks/editing/varied.py BUILDINGS [--each 12] [--seed 0] [--physics mujoco]

As `instructions.py`, with the training list `training_phrasings.py`: things that ought to be somewhere, nothing left,
swapped, beside something, exactly so many, furniture that is not there yet, several wishes in one sentence.
"""

import math
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np
import training_phrasings
from cases import COLD, SMALL, Case, Scenes, article, count, objects, options, plural, read, room_words, run
from instructions import Maker

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.scene import FloorScene, SceneObject

THINGS = [w for w in SMALL if w not in ("laptop", "toilet paper")]
FURNITURE = ("armchair", "couch", "round table", "stool")
NUMBERS = ("", "one", "two", "three")


class Varied(Maker):
    """Makes the cases of one building; each kind goes through its phrasings one after the other."""

    def __init__(self, scenes: Scenes, rng: np.random.Generator, turns: Counter[str]) -> None:
        super().__init__(scenes, rng)
        self.turns = turns

    def say(self, kind: str, **words: str) -> str:
        """Fill the next phrasing of a kind."""
        forms = getattr(training_phrasings, kind)
        form = forms[self.turns[kind] % len(forms)]
        self.turns[kind] += 1
        big = {k[0].upper() + k[1:]: v[:1].upper() + v[1:] for k, v in words.items()}
        return str(form.format(**words, **big))

    def carrier(self) -> tuple[FloorScene, SceneObject, str]:
        """Draw a table and its words."""
        scene, item = self.pick(self.carriers)
        return scene, item, self.where(scene, item)

    def room(self) -> str:
        """Draw a room."""
        scene = self.pick(self.scenes)
        room = self.pick([r for r in scene.rooms if r.kind not in ("stair", "elevator")])
        return room_words(scene, room.id, self.tall)

    def words(self, number: int = 1) -> list[str]:
        """Draw different small things."""
        return [str(w) for w in self.rng.choice(THINGS, number, replace=False)]

    def place(self) -> Case | None:
        return self._put("PLACE")

    def hold(self) -> Case | None:
        return self._put("HOLD")

    def _put(self, kind: str) -> Case | None:
        if not self.carriers:
            return None
        _, item, y = self.carrier()
        (word,) = self.words()
        have = count(self.scenes, item.id, SMALL[word])
        text = self.say(kind, a=article(word), n=word, ns=plural(word), on=f"on {y}", y=y)
        return Case(text, max(0, 1 - have), lambda s: count(s, item.id, SMALL[word]) >= 1, kind)

    def two(self) -> Case | None:
        if not self.carriers:
            return None
        _, item, y = self.carrier()
        one, other = self.words(2)
        text = self.say("TWO", a=article(one), b=article(other), on=f"on {y}", y=y)
        least = sum(count(self.scenes, item.id, SMALL[w]) < 1 for w in (one, other))
        return Case(text, least, lambda s: all(count(s, item.id, SMALL[w]) for w in (one, other)), "TWO")

    def several(self) -> Case | None:
        if not self.carriers:
            return None
        _, item, y = self.carrier()
        colour, word = self.pick(["red", "blue", "white", "green"]), self.pick(["mug", "book"])

        def number(scenes: Scenes) -> int:
            mine = [o for o in objects(scenes) if o.parent == item.id and o.category == word]
            return sum(o.material.endswith(colour) for o in mine)

        text = self.say("SEVERAL", colour=colour, ns=plural(word), on=f"on {y}", y=y)
        return Case(text, max(0, 2 - number(self.scenes)), lambda s: number(s) >= 2, "SEVERAL")

    def cold(self) -> Case | None:
        if not self.fridges:
            return None
        scene, fridge = self.pick(self.fridges)
        word = self.pick(list(COLD))
        text = self.say("COLD", n=word, y=self.where(scene, fridge), room=self.room())
        have = count(self.scenes, fridge.id, COLD[word])
        return Case(text, max(0, 1 - have), lambda s: count(s, fridge.id, COLD[word]) >= 1, "COLD")

    def absent(self) -> Case | None:
        if not self.loaded():
            return None
        scene, table, item = self.pick(self.loaded())
        y = self.where(scene, table)
        text = self.say("ABSENT", n=item.name, ns=plural(item.name), on=f"on {y}", y=y)
        return Case(text, 1, lambda s: count(s, table.id, item.category) == 0, "ABSENT")

    def empty(self) -> Case | None:
        if not self.loaded():
            return None
        scene, table, _ = self.pick(self.loaded())
        text = self.say("EMPTY", y=self.where(scene, table))
        return Case(text, 1, lambda s: all(o.parent != table.id for o in objects(s)), "EMPTY")

    def state(self) -> Case | None:
        name = self.pick(["open", "on"])
        able = [
            (s, o)
            for s in self.scenes
            for o in s.objects
            if (o.openable if name == "open" else o.toggleable)
            and o.mount in ("floor", "surface")
            and sum(x.room == o.room and x.name == o.name for x in s.objects) == 1
        ]
        if not able:
            return None
        scene, item = self.pick(able)
        kind = name.upper()
        text = self.say(kind, y=self.where(scene, item))

        def holds(scenes: Scenes) -> bool:
            return any(o.id == item.id and o.states.get(name) is True for o in objects(scenes))

        return Case(text, 0 if item.states.get(name) else 1, holds, kind)

    def way(self) -> Case | None:
        return Case(self.say("WAY", a=self.room(), b=self.room()), 0, lambda s: True, "WAY")

    def move(self) -> Case | None:
        if not self.loaded() or len(self.carriers) < 2:
            return None
        scene, source, item = self.pick(self.loaded())
        there, target = self.pick([(s, c) for s, c in self.carriers if c.id != source.id])
        before = count(self.scenes, target.id, item.category)
        y, z = self.where(scene, source), self.where(there, target)

        def holds(scenes: Scenes) -> bool:
            left = count(scenes, source.id, item.category)
            return left == 0 and count(scenes, target.id, item.category) > before

        return Case(self.say("MOVE", n=item.name, y=y, z=z), 1, holds, "MOVE")

    def swap(self) -> Case | None:
        loaded = self.loaded()
        if not loaded:
            return None
        scene, table, item = self.pick(loaded)
        word = self.pick([w for w in THINGS if SMALL[w] != item.category])
        text = self.say("SWAP", n=item.name, y=self.where(scene, table), a=article(word))

        def holds(scenes: Scenes) -> bool:
            gone = count(scenes, table.id, item.category) == 0
            return gone and count(scenes, table.id, SMALL[word]) >= 1

        return Case(text, 1 + (count(self.scenes, table.id, SMALL[word]) < 1), holds, "SWAP")

    def exact(self) -> Case | None:
        if not self.carriers:
            return None
        _, item, y = self.carrier()
        word, number = self.pick(["mug", "apple", "pen"]), int(self.rng.integers(2, 4))
        text = self.say("EXACT", k=NUMBERS[number], ns=plural(word), on=f"on {y}", y=y)
        have = count(self.scenes, item.id, SMALL[word])
        return Case(text, abs(have - number), lambda s: count(s, item.id, SMALL[word]) == number, "EXACT")

    def beside(self) -> Case | None:
        if not self.loaded():
            return None
        scene, table, item = self.pick(self.loaded())
        (word,) = self.words()
        text = self.say("BESIDE", a=article(word), n=item.name, on=f"on {self.where(scene, table)}")

        def holds(scenes: Scenes) -> bool:
            mine = [o for o in objects(scenes) if o.parent == table.id]
            ours = [o for o in mine if o.category == SMALL[word] and o.id != item.id]
            return any(math.dist(o.position[:2], item.position[:2]) < 0.9 for o in ours)

        return Case(text, 0 if holds(self.scenes) else 1, holds, "BESIDE")

    def furnish(self) -> Case | None:
        scene = self.pick(self.scenes)
        large = [r for r in scene.rooms if r.kind not in ("stair", "elevator") and r.area > 25.0]
        if not large:
            return None
        room, colour = self.pick(large), self.pick(["blue", "green", "red"])
        noun, (word,) = self.pick(FURNITURE), self.words()
        category = "sofa" if noun == "couch" else noun.replace(" ", "_")
        text = self.say("FURNISH", colour=colour, f=noun, a=article(word), room=room_words(scene, room.id, self.tall))

        def seats(scenes: Scenes) -> list[SceneObject]:
            mine = [o for o in objects(scenes) if o.room == room.id]
            return [o for o in mine if o.category == category and o.material.endswith(colour)]

        def holds(scenes: Scenes) -> bool:
            return any(count(scenes, seat.id, SMALL[word]) >= 1 for seat in seats(scenes))

        return Case(text, 1 + (not seats(self.scenes)), holds, "FURNISH")

    def mixed(self) -> Case | None:
        able = self.closets()
        if not able or not self.carriers:
            return None
        other, box = self.pick(able)
        _, item, place = self.carrier()
        (word,) = self.words()
        text = self.say("MIXED", a=article(word), on=f"on {place}", y=self.where(other, box), room=self.room())

        def holds(scenes: Scenes) -> bool:
            opened = any(o.id == box.id and o.states.get("open") is True for o in objects(scenes))
            return opened and count(scenes, item.id, SMALL[word]) >= 1

        have = count(self.scenes, item.id, SMALL[word]) >= 1
        return Case(text, 2 - have - bool(box.states.get("open")), holds, "MIXED")

    def leading(self) -> Case | None:
        if not self.carriers:
            return None
        scene, item, _ = self.carrier()
        (word,) = self.words()
        room = room_words(scene, item.room, self.tall)
        text = self.say("LEADING", a=article(word), c=item.name, room=room)
        have = count(self.scenes, item.id, SMALL[word])
        return Case(text, max(0, 1 - have), lambda s: count(s, item.id, SMALL[word]) >= 1, "LEADING")

    def make(self, number: int) -> Case:
        """Make the case of that number; where a building has nothing for its kind, one of the next kind."""
        kinds: list[Callable[[], Case | None]] = [
            self.place, self.absent, self.cold, self.move, self.hold, self.state, self.two, self.swap, self.way,
            self.several, self.beside, self.furnish, self.place, self.exact, self.mixed, self.empty, self.leading,
        ]  # fmt: skip
        for shift in range(len(kinds)):
            case = kinds[(number + shift) % len(kinds)]()
            if case is not None:
                return case
        raise SystemExit("a building without anything to edit")


def main() -> None:
    """Run the cases and print the score."""
    args = options(__doc__, 12).parse_args()
    turns: Counter[str] = Counter()

    def make(editor: SceneEditor, folder: Path, rng: np.random.Generator, number: int, turn: int) -> Case:
        return Varied(read(folder), rng, turns).make(number * args.each + turn)

    run(args, make).show()
    forms = sum(min(turns[kind], len(getattr(training_phrasings, kind))) for kind in turns)
    print(f"{forms} phrasings")


if __name__ == "__main__":
    main()
