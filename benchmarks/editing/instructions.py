"""The editing agent on instructions over many buildings; what must be true afterwards is checked from scene.json alone.

    python benchmarks/editing/instructions.py BUILDINGS [--each 10] [--seed 0] [--physics mujoco]

BUILDINGS is a folder of building folders. Each instruction is made from what a building holds together with the facts
that it asks for; `cases.py` says how it is judged.
"""

from collections import Counter

import numpy as np
from cases import CARRIERS, COLD, SMALL, Case, Scenes, count, options, read, room_words, run

from mansion_msgs_py.scene import FloorScene, SceneObject


class Maker:
    """Makes the cases of one building."""

    def __init__(self, scenes: Scenes, rng: np.random.Generator) -> None:
        self.scenes, self.rng = scenes, rng
        self.tall = len(scenes) > 1
        rooms = [o.room + o.category for s in scenes for o in s.objects]
        single = {key for key, number in Counter(rooms).items() if number == 1}
        self.carriers = [
            (s, o) for s in scenes for o in s.objects if o.category in CARRIERS and o.room + o.category in single
        ]
        self.fridges = [
            (s, o) for s in scenes for o in s.objects if o.category == "fridge" and o.room + o.category in single
        ]

    def pick(self, values: list[object]) -> object:
        """Draw one."""
        return values[int(self.rng.integers(len(values)))]

    def make(self, number: int) -> Case:
        """Make the case of that number."""
        kinds = [self.place, self.cold, self.count_of, self.both, self.absent, self.switch, self.path, self.move]
        for shift in range(len(kinds)):
            case = kinds[(number + shift) % len(kinds)]()
            if case is not None:
                return case
        raise SystemExit("a building without anything to edit")

    def where(self, scene: FloorScene, item: SceneObject) -> str:
        """Name a carrier and its room."""
        return f"the {item.name} in {room_words(scene, item.room, self.tall)}"

    def loaded(self) -> list[tuple[FloorScene, SceneObject, SceneObject]]:
        """Tables with a loose thing that is the only one of its kind there."""
        return [
            (s, c, o)
            for s, c in self.carriers
            for o in s.objects
            if o.parent == c.id
            and o.pickupable
            and max(o.size) < 0.35
            and sum(x.category == o.category and x.parent == c.id for x in s.objects) == 1
            and not any(x.parent == o.id for x in s.objects)
        ]

    def closets(self) -> list[tuple[FloorScene, SceneObject]]:
        """Furniture that opens and is the only one of its kind in its room."""
        return [
            (s, o)
            for s in self.scenes
            for o in s.objects
            if o.openable
            and o.mount == "floor"
            and sum(x.room == o.room and x.category == o.category for x in s.objects) == 1
        ]

    def place(self) -> Case | None:
        """A small thing on a table."""
        if not self.carriers:
            return None
        scene, carrier = self.pick(self.carriers)
        word = self.pick(list(SMALL))
        lead = self.pick(["make sure there is a", "put a", "there should be a", "please add a"])
        have = count(self.scenes, carrier.id, SMALL[word])
        return Case(
            f"{lead} {word} on {self.where(scene, carrier)}",
            max(0, 1 - have),
            lambda scenes: count(scenes, carrier.id, SMALL[word]) >= 1,
            "place",
        )

    def cold(self) -> Case | None:
        """A cold thing in a fridge, and a way to a room."""
        if not self.fridges:
            return None
        scene, fridge = self.pick(self.fridges)
        word = self.pick(list(COLD))
        target_scene = self.pick(self.scenes)
        room = self.pick([r for r in target_scene.rooms if r.kind not in ("stair", "elevator")])
        have = count(self.scenes, fridge.id, COLD[word])
        return Case(
            f"make sure there is a cold {word} in {self.where(scene, fridge)} and a way to "
            f"{room_words(target_scene, room.id, self.tall)}",
            max(0, 1 - have),
            lambda scenes: count(scenes, fridge.id, COLD[word]) >= 1,
            "cold",
        )

    def count_of(self) -> Case | None:
        """Several things of a colour."""
        if not self.carriers:
            return None
        scene, carrier = self.pick(self.carriers)
        colour = self.pick(["red", "blue", "white"])
        have = sum(
            o.parent == carrier.id and o.category == "mug" and o.material.endswith(colour) for o in scene.objects
        )

        def holds(scenes: Scenes) -> bool:
            return (
                sum(
                    o.parent == carrier.id and o.category == "mug" and o.material.endswith(colour)
                    for s in scenes
                    for o in s.objects
                )
                >= 2
            )

        text = f"ensure two {colour} mugs on {self.where(scene, carrier)}"
        return Case(text, max(0, 2 - have), holds, "count")

    def both(self) -> Case | None:
        """Two things at one place."""
        if not self.carriers:
            return None
        scene, carrier = self.pick(self.carriers)
        one, other = (str(w) for w in self.rng.choice(["apple", "pen", "book", "mug"], 2, replace=False))
        least = sum(count(self.scenes, carrier.id, SMALL[w]) < 1 for w in (one, other))
        return Case(
            f"put a {one} and a {other} on {self.where(scene, carrier)}",
            least,
            lambda scenes: all(count(scenes, carrier.id, SMALL[w]) >= 1 for w in (one, other)),
            "both",
        )

    def absent(self) -> Case | None:
        """Things gone from a carrier."""
        loaded = [
            (s, c, o)
            for s, c in self.carriers
            for o in s.objects
            if o.parent == c.id and not any(x.parent == o.id for x in s.objects)
        ]
        if not loaded:
            return None
        scene, carrier, item = self.pick(loaded)
        have = count(self.scenes, carrier.id, item.category)
        return Case(
            f"remove all {item.name}s from {self.where(scene, carrier)}",
            have,
            lambda scenes: (
                not any(o.parent == carrier.id and o.category == item.category for s in scenes for o in s.objects)
            ),
            "absent",
        )

    def switch(self) -> Case | None:
        """Something opened."""
        able = self.closets()
        if not able:
            return None
        scene, item = self.pick(able)
        return Case(
            f"open {self.where(scene, item)}",
            0 if item.states.get("open") else 1,
            lambda scenes: any(o.id == item.id and o.states.get("open") is True for s in scenes for o in s.objects),
            "open",
        )

    def path(self) -> Case | None:
        """A way between two rooms; buildings that pass the check have it."""
        ends = [
            (s, self.pick([r for r in s.rooms if r.kind not in ("stair", "elevator")]))
            for s in (self.pick(self.scenes), self.pick(self.scenes))
        ]
        names = [room_words(s, r.id, self.tall) for s, r in ends]
        return Case(f"make sure the robot can get from {names[0]} to {names[1]}", 0, lambda scenes: True, "path")

    def move(self) -> Case | None:
        """A thing moved from one carrier to another."""
        loaded = self.loaded()
        if not loaded or len(self.carriers) < 2:
            return None
        scene, source, item = self.pick(loaded)
        target_scene, target = self.pick([(s, c) for s, c in self.carriers if c.id != source.id])

        def holds(scenes: Scenes) -> bool:
            there = count(scenes, target.id, item.category)
            return there > before and count(scenes, source.id, item.category) == 0

        before = count(self.scenes, target.id, item.category)
        return Case(
            f"move the {item.name} from {self.where(scene, source)} to {self.where(target_scene, target)}",
            1,
            holds,
            "move",
        )


def main() -> None:
    """Run the cases and print the score."""
    run(
        options(__doc__, 10).parse_args(), lambda editor, folder, rng, number, turn: Maker(read(folder), rng).make(turn)
    ).show()


if __name__ == "__main__":
    main()
