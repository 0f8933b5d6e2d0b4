"""Ask for random places by relation, and judge each result apart from the tools.

    python benchmarks/editing/relations.py BUILDING [BUILDING ...] [--wishes 200] [--seed 0] [--physics static]

A wish is an object (a new one, or one of the building that moves), a relation and a landmark; `--wishes` of them are
drawn for all buildings together. One that is placed must hold by the corners of the footprints alone, which is computed
here, by `relation_holds`, and add no fault to ``mansion check``. One that is refused must name a reason.
"""

import argparse
import math
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from mansion_assets.catalogue import Asset
from mansion_bringup.edit_hooks import new_faults
from mansion_bringup.editor import open_editor
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import engine_named
from mansion_editing.tools.relations import relation_holds
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject, SceneRoom

FLOOR_SIDES = ("beside", "left", "right", "behind", "front", "under", "between", "around", "")
SURFACE_SIDES = ("beside", "left", "right", "behind", "front", "between")
WALL_SIDES = ("above", "beside", "left", "right", "")
SPOTS = ("wall", "corner", "window", "door", "middle")
SLACK = 0.03
"""Metres that the judge here forgives."""


class Wishes:
    """Draws wishes for one building."""

    def __init__(self, editor: SceneEditor, rng: np.random.Generator) -> None:
        self.editor, self.rng = editor, rng
        assets = list(editor.catalogue.assets.values())
        self.floor = [a for a in assets if a.mount == "floor" and a.footprint < 1.2]
        self.small = [a for a in assets if a.mount == "surface" and max(a.size[:2]) < 0.35]
        self.hanging = [a for a in assets if a.mount in ("wall", "ceiling") and a.size[0] < 1.5]
        self.rooms = [
            (room, [o for o in editor.state.scenes[f].objects if o.room == room.id]) for f, room in editor.state.rooms()
        ]
        self.rooms = [(room, items) for room, items in self.rooms if len(items) > 3]

    def draw(self, values: Any) -> Any:
        """Draw one of a sequence."""
        return values[int(self.rng.integers(len(values)))]

    def make(self) -> tuple[str, dict[str, Any]]:
        """Return a tool and its arguments."""
        kind = self.draw(("floor", "floor", "floor", "small", "hanging"))
        room, items = self.draw(self.rooms)
        standing = [o for o in items if o.mount == "floor" and o.size[2] > 0.03]
        laid = [o for o in items if o.mount == "surface"]
        if kind == "small" and not laid:
            kind = "floor"
        if not standing:
            standing = items
        if kind == "small":
            return self._with_object(self._on_surface(laid), self.small, laid)
        if kind == "hanging":
            hung = [o for o in items if o.mount in ("wall", "ceiling")]
            return self._with_object(self._in_room(room, standing, WALL_SIDES), self.hanging, hung)
        return self._with_object(self._in_room(room, standing, FLOOR_SIDES), self.floor, standing)

    def _in_room(self, room: SceneRoom, marks: list[SceneObject], sides: tuple[str, ...]) -> dict[str, Any]:
        args: dict[str, Any] = {"receptacle_id": room.id, "side": self.draw(sides)}
        if args["side"]:
            args["near"] = self.draw(marks).id
        if args["side"] == "under":
            tables = [o for o in marks if any(word in o.category for word in ("table", "desk", "sink", "bed"))]
            args["near"] = self.draw(tables or marks).id
        if args["side"] == "between" and len(marks) > 1:
            args["other"] = self.draw([o for o in marks if o.id != args["near"]]).id
        if self.rng.random() < 0.2 and "near" in args:
            args["within"] = float(self.draw((0.1, 0.3, 0.5, 1.0, 2.0)))
        share = 0.1 if args["side"] else 0.8
        args["spot"] = self.draw(SPOTS) if sides is FLOOR_SIDES and self.rng.random() < share else ""
        if sides is FLOOR_SIDES and self.rng.random() < 0.2:
            args["facing"] = self.draw(marks).id
        return args

    def _on_surface(self, laid: list[SceneObject]) -> dict[str, Any]:
        near = self.draw(laid)
        args: dict[str, Any] = {"receptacle_id": near.parent, "near": near.id, "side": self.draw(SURFACE_SIDES)}
        rest = [o for o in laid if o.parent == near.parent and o.id != near.id]
        if args["side"] == "between" and rest:
            args["other"] = self.draw(rest).id
        if self.rng.random() < 0.2:
            args["within"] = float(self.draw((0.05, 0.1, 0.3)))
        return args

    def _with_object(
        self, args: dict[str, Any], assets: list[Asset], own: list[SceneObject]
    ) -> tuple[str, dict[str, Any]]:
        free = [o.id for o in own if o.id not in args.values()]
        if free and self.rng.random() < 0.25:
            return "MoveObject", {**args, "object_id": self.draw(free)}
        if args["side"] == "under":
            assets = [a for a in assets if a.size[2] < 0.5 and a.footprint < 0.3]
        return "PlaceOnSurface", {**args, "asset_id": self.draw(assets).key}


def judged(editor: SceneEditor, item: SceneObject, args: dict[str, Any]) -> str:
    """Return what is wrong with a placed object, empty when nothing is."""
    if args["receptacle_id"] not in (item.room, item.parent):
        return "is elsewhere"
    names = ("side", "near", "other", "within", "spot", "facing")
    wish = {name: args[name] for name in names if name in args}
    if any(args.get(name) for name in names) and not relation_holds(editor.state, item, **wish):
        return "relation_holds denies it"
    if args.get("near"):
        _, near = editor.state.get(args["near"])
        if not _on_side(item, near, args["side"]):
            return f"is not {args['side']}"
        if _distance(item, near) > args.get("within", 99.0) + SLACK:
            return "is too far away"
    if args.get("facing") and _off_aim(item, editor.state.get(args["facing"])[1]) > 31.0:
        return "looks elsewhere"
    return ""


def _corners(item: SceneObject, steps: int = 9) -> np.ndarray[Any, Any]:
    """Return points all over a footprint."""
    grid = np.linspace(-0.5, 0.5, steps)
    u, v = (a.ravel() for a in np.meshgrid(grid * item.size[0], grid * item.size[1]))
    turn = math.radians(item.rotation)
    c, s = math.cos(turn), math.sin(turn)
    return np.stack([item.position[0] + c * u - s * v, item.position[1] + s * u + c * v], axis=1)


def _in_frame(near: SceneObject, points: np.ndarray[Any, Any]) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    dx, dy = points[:, 0] - near.position[0], points[:, 1] - near.position[1]
    c, s = math.cos(math.radians(near.rotation)), math.sin(math.radians(near.rotation))
    return c * dx + s * dy, c * dy - s * dx


def _on_side(item: SceneObject, near: SceneObject, side: str) -> bool:
    u, v = _in_frame(near, _corners(item))
    w, d = near.size[0] / 2, near.size[1] / 2
    within = bool((np.abs(u) <= w + SLACK).all() and (np.abs(v) <= d + SLACK).all())
    foot, top = item.position[2] - item.size[2] / 2, near.position[2] + near.size[2] / 2
    verdicts = {
        "left": bool((u <= -w + SLACK).all()),
        "right": bool((u >= w - SLACK).all()),
        "behind": bool((v <= -d + SLACK).all()),
        "front": bool((v >= d - SLACK).all()),
        "under": foot < 0.05 and (within or item.size[2] < 0.05),
        "above": foot >= top - SLACK and bool((np.abs(u) <= w + SLACK).any()),
    }
    apart = item.mount in ("wall", "ceiling") or not ((np.abs(u) < w - SLACK) & (np.abs(v) < d - SLACK)).any()
    return verdicts.get(side, bool(apart))


def _distance(item: SceneObject, near: SceneObject) -> float:
    u, v = _in_frame(near, _corners(item, 41))
    away = np.hypot(np.maximum(np.abs(u) - near.size[0] / 2, 0), np.maximum(np.abs(v) - near.size[1] / 2, 0))
    return float(away.min())


def _off_aim(item: SceneObject, target: SceneObject) -> float:
    """Return the least angle between the front and the way to any part of a target, degrees."""
    points = _corners(target, 41)
    ways = np.degrees(np.arctan2(-(points[:, 0] - item.position[0]), points[:, 1] - item.position[1]))
    return float(np.abs((ways - item.rotation + 180.0) % 360.0 - 180.0).min())


def main() -> None:
    """Run the wishes and print the counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("buildings", type=Path, nargs="+")
    parser.add_argument("--wishes", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--physics", default="static")
    parser.add_argument("--show", action="store_true", help="print each refusal")
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    counts: Counter[str] = Counter()
    by_side: Counter[tuple[str, str]] = Counter()
    seconds: list[float] = []
    for number, folder in enumerate(options.buildings):
        editor = open_editor(folder, who="relations")
        editor.autosave = False
        editor.engine = engine_named(options.physics)
        wishes = Wishes(editor, rng)
        for _ in range(number, options.wishes, len(options.buildings)):
            tool, args = wishes.make()
            word, fault = _try(editor, tool, args, seconds, show=options.show)
            counts[word] += 1
            by_side[args["side"] or args["spot"] or "facing or none", word] += 1
            if fault:
                print(f"WRONG {tool} {args}: {fault}")
    for word, count in counts.most_common():
        print(f"{count:5d}  {word} ({100 * count / options.wishes:.1f}%)")
    for (side, word), count in sorted(by_side.items()):
        print(f"       {side}: {word} {count}")
    print(f"CPU seconds: median {np.median(seconds):.2f}, most {max(seconds):.2f}")


def _try(editor: SceneEditor, tool: str, args: dict[str, Any], seconds: list[float], *, show: bool) -> tuple[str, str]:
    before = dict(editor.state.scenes)
    started = time.process_time()
    try:
        done = editor.call(tool, args)
    except MansionError as error:
        if show:
            print(f"{tool} {args}: {error.info.message}")
        known = error.info.code in (ErrorCode.INFEASIBLE, ErrorCode.INVALID_PAYLOAD) and error.info.message
        return ("refused with the reason", "") if known else ("refused otherwise", str(error))
    finally:
        seconds.append(time.process_time() - started)
    if not done.object_ids:
        return "placed", ""
    _, item = editor.state.get(done.object_ids[0])
    fault = judged(editor, item, args) or "; ".join(new_faults(before, editor.state.scenes))
    editor.call("Undo")
    return ("placed wrongly", fault) if fault else ("placed", "")


if __name__ == "__main__":
    main()
