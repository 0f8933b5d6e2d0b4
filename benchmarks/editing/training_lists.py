"""The editing agent on its three training lists: instructions as researchers write them, some to be refused.

    python benchmarks/editing/training_lists.py BUILDINGS [--list 1] [--each 15] [--seed 0] [--physics mujoco]

The parser was mended on each list after its first run, so that only the first run of a list forecasts other words; a
run today guards what was learnt. `training_list_N.toml` holds the instructions and what must be true afterwards; names
of tables, rooms and objects come from a building. Each is given to several buildings; `cases.py` says how it is
judged. Objects that an instruction does not mention may not be removed.
"""

import tomllib
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from cases import Case, Scenes, objects, options, read, run
from instructions import Maker
from kinds import level
from statements import Names, Statement, names_in, statement

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.scene import FloorScene, SceneObject

MOST_ON, SPACE = 6, 0.45
"""Things on a table, and its area in square metres, so that there is room for more."""


class Namer(Maker):
    """Draws what the names of an instruction stand for in a building."""

    def request(self, request: dict[str, Any]) -> Names | None:
        """Return what the names of an instruction stand for, None where the building does not suit it."""
        self.called, self.floor = request.get("called", {}), request.get("floor", {})
        if request.get("tall") and not self.tall:
            return None
        if request.get("lift") and not any(c.type == "elevator" for c in self.scenes[0].cores):
            return None
        words = [request["say"], *request.get("true", []), *request.get("given", [])]
        for _ in range(6):
            names = self.draw(" ".join([*words, *request.get("before", [])]))
            if names is None:
                return None
            if all(statement(w, names).holds(self.scenes) for w in request.get("given", [])):
                return names
        return None

    def suits(self, name: str, scene: FloorScene, item: SceneObject) -> bool:
        """Whether an object is called as a name asks, alone in its room, and on the floor that it asks for."""
        word, floor = self.called.get(name), self.floor.get(name)
        if word is not None and (
            word not in item.category or sum(o.room == item.room and word in o.category for o in scene.objects) > 1
        ):
            return False
        if floor in ("sole", "ground") and (sum(o.category == item.category for o in scene.objects) > 1):
            return False
        if floor == "second":
            return scene.floor == 2 and len(self.scenes) == 2
        return floor != "ground" or scene.floor == level(self.scenes, "ground")

    def suited(self, name: str, pairs: list[tuple[FloorScene, SceneObject]]) -> list[tuple[FloorScene, SceneObject]]:
        """Return those that suit a name."""
        return [(scene, item) for scene, item in pairs if self.suits(name, scene, item)]

    def draw(self, text: str) -> Names | None:
        """Return a table, room or thing for each name, None where the building has none."""
        wanted = names_in(text)
        loose = {"O": 1, "O2": 2} if "O" in wanted else {}
        names = Names(self.scenes)
        tables = self.suited("T", self.tables(2 if "O2" in wanted else 1 if loose else 0))
        others = self.suited("T2", self.tables(1 if "U" in wanted else 0))
        if "T" in wanted:
            if not tables:
                return None
            names.take("T", self.pick(tables), self)
            for name, item in zip(("O", "O2"), self.loose(names.items["T"]), strict=False):
                names.items[name], names.words[name] = item, item.name
        if "T2" in wanted:
            mine = names.items["T"]
            own = names.items.get("O")
            left = [(s, c) for s, c in others if c.id != mine.id and self.differs(c, own)]
            if not left:
                return None
            names.take("T2", self.pick(left), self)
            there = [o.category for o in objects(self.scenes) if o.parent == mine.id]
            free = [o for o in self.loose(names.items["T2"]) if o.category not in there]
            if "U" in wanted and not free:
                return None
            for item in free[:1]:
                names.items["U"], names.words["U"] = item, item.name
        everything = [(s, o) for s in self.scenes for o in s.objects]
        for name, able in (("F", self.fridges), ("C", self.able("open")), ("L", self.able("on")), ("P", everything)):
            if name in wanted:
                able = self.suited(name, able)
                if not able:
                    return None
                names.take(name, self.pick(able), self)
        return names if self.rooms(wanted, names) else None

    def rooms(self, wanted: list[str], names: Names) -> bool:
        """Draw the rooms; whether there are such."""
        for name in ("R", "R2", "B", "Q", "Z"):
            if name not in wanted:
                continue
            able = {"Q": self.able("open", alone=False), "Z": self.able("on", alone=False)}.get(name)
            there = None if able is None else {item.room for _, item in able}
            rooms = [
                (scene, room.id)
                for scene in self.scenes
                for room in scene.rooms
                if room.kind not in ("stair", "elevator")
                and (name != "B" or room.area > 25.0)
                and (there is None or room.id in there)
                and self.called.get(name, "") in room.room_type
                and room.id not in names.rooms.values()
            ]
            if not rooms:
                return False
            names.take_room(name, *self.pick(rooms), self.tall)
        return True

    def tables(self, loaded: int) -> list[tuple[FloorScene, SceneObject]]:
        """Tables with room for more and so many loose things."""
        return [
            (scene, table)
            for scene, table in self.carriers
            if sum(o.parent == table.id for o in scene.objects) <= MOST_ON
            and table.size[0] * table.size[1] >= SPACE
            and len(self.loose(table)) >= loaded
        ]

    def loose(self, table: SceneObject) -> list[SceneObject]:
        """Small things on a table that are the only ones of their kind there."""
        mine = [o for o in objects(self.scenes) if o.parent == table.id]
        carried = {o.parent for o in objects(self.scenes)}
        kinds = Counter(o.category for o in mine)
        return [
            o for o in mine if o.pickupable and max(o.size) < 0.3 and kinds[o.category] == 1 and o.id not in carried
        ]

    def differs(self, table: SceneObject, own: SceneObject | None) -> bool:
        """Whether a table holds nothing of a thing's kind, and its own loose thing is of another."""
        mine = [o.category for o in objects(self.scenes) if o.parent == table.id]
        return own is None or own.category not in mine

    def able(self, state: str, alone: bool = True) -> list[tuple[FloorScene, SceneObject]]:
        """Things that open, or switch; those that are the only ones of their name in their room."""
        return [
            (s, o)
            for s in self.scenes
            for o in s.objects
            if (o.openable if state == "open" else o.toggleable)
            and (not alone or o.mount in ("floor", "surface"))
            and (not alone or sum(x.room == o.room and x.name == o.name for x in s.objects) == 1)
        ]


def case_of(request: dict[str, Any], names: Names, scenes: Scenes) -> Case:
    """Return an instruction with its names filled in, and what must be true."""
    text = names.fill(request["say"])
    if "names" in request:
        return Case(text, 0, lambda s: True, "refused", refusal=request["names"])
    facts: list[Statement] = [statement(words, names) for words in request["true"]]
    least = sum(fact.missing(scenes) for fact in facts)
    gone = sum(fact.surplus(scenes) for fact in facts)
    moves = sum(f"{o} on {t} == 0" in request["true"] for o, t in (("O", "T"), ("U", "T2")))
    if moves and any(words.startswith("O on T2") for words in request["true"]):
        least, gone = least - moves, gone - moves
    return Case(text, least, lambda s: all(fact.holds(s) for fact in facts), "met", gone=gone)


def prepare(editor: SceneEditor, request: dict[str, Any], names: Names) -> None:
    """Make true what must be so beforehand."""
    for words in request.get("before", []):
        for tool, arguments in names.actions(words, editor.state.catalogue):
            editor.call(tool, arguments)


def main() -> None:
    """Run the cases and print the score."""
    parser = options(__doc__, 15)
    parser.add_argument("--list", type=int, choices=[1, 2, 3], default=1, help="which list")
    args = parser.parse_args()
    name = f"training_list_{args.list}.toml"
    data = tomllib.loads(Path(__file__).with_name(name).read_text())
    requests = [*data["request"], *data["refused"]]
    asked: Counter[int] = Counter()

    def make(editor: SceneEditor, folder: Path, rng: np.random.Generator, number: int, turn: int) -> Case | None:
        order = sorted(range(len(requests)), key=lambda k: (asked[k], (k + 7 * number) % len(requests)))
        for k in order:
            request = requests[k]
            names = Namer(read(folder), rng).request(request)
            if names is None:
                continue
            prepare(editor, request, names)
            asked[k] += 1
            return case_of(request, names, read(folder))
        return None

    run(args, make).show()
    print(f"{len(asked)} of {len(requests)} instructions were given to a building")


if __name__ == "__main__":
    main()
