"""Hostile input for every service, payload and command, in this process: cases by number, the same for a seed."""

import contextlib
import io
import json
import os
import random
import shutil
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final
from unittest.mock import patch

from fuzz_guards import Outcome, WriteGuard, outcome_of
from hostile_values import TEXTS, drawn, garbled, spoiled
from mansion_assets.catalogue import load_catalogue
from mansion_bringup.cli import main as command_line
from mansion_bringup.edit_hooks import new_faults, records
from mansion_bringup.interfaces import PAYLOADS, SERVICES
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.pipeline.stages import LocalStages
from mansion_editing.editor import TOOLS, SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.provisioning.provision import provision
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.allowed_folders import AllowedFolders
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import decode, encode, to_builtins
from mansion_msgs_py.editing.instructions import InstructArgs, ProvisionArgs
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FloorProblem
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.skills import ControlArgs, SessionArgs
from mansion_msgs_py.stages import BuildJob, FurnishRequest
from mansion_msgs_py.world import LiftRequest
from mansion_scene.refurnishing import furnish_room
from mansion_skills.engine import Engine
from mansion_skills.skills.registry import SKILLS

__all__ = ["Case", "Fuzzer", "Stock", "make_stock"]

ANEW: Final = 200
"""Cases after which the building is copied anew, and editor and robots begin again."""

BRIEFS: Final = (
    "a small flat for two",
    "A two-storey clinic with an elevator, 90 m2 per floor",
    "a four-storey office with a cafeteria on the ground floor, each floor has three meeting rooms of 20 m2",
    "three bedrooms, a kitchen next to the living room, no bathroom upstairs",
    "an l-shaped school for 200 pupils with a gym, two labs and a library on the top floor",
)
INSTRUCTIONS: Final = (
    "make sure there is a cola in the fridge",
    "put two red mugs on the table in the kitchen and remove the chair next to the bed",
    "how many chairs are in the living room?",
    "rename the kitchen to Canteen, then undo that",
    "move the lamp 30 cm to the left of the desk",
    "make the bathroom larger by 2 m2",
)


@dataclass(frozen=True)
class Stock:
    """What real payloads there are to spoil.

    Attributes
    ----------
    folder : Path
        Of a sound building.
    problems, requests : tuple
        Of the solver and of the placer, as JSON-compatible objects.
    words : tuple of str
        Ids, kinds and names that the building knows.
    """

    folder: Path
    problems: tuple[Any, ...]
    requests: tuple[Any, ...]
    words: tuple[str, ...]


def make_stock(folder: Path) -> Stock:
    """Build a small house of two storeys, and keep what its stages asked of each other."""
    request = identified(BuildRequest(description="a two-storey house with two bedrooms upstairs", seed=3))
    build_building(request, folder)
    building = BuildingFolder(folder)
    plan = LocalStages().plan(request)
    requests = []
    for index, floor in enumerate(plan.program.floors):
        furnish = FurnishRequest(
            building_id=plan.program.building_id,
            floor=floor,
            floors=[entry.index for entry in plan.program.floors],
            labels=[entry.label for entry in plan.program.floors],
            connectivity=plan.program.vertical_connectivity,
            topology=plan.topologies[index],
            layout=building.layout(floor.index),
        )
        requests.append(to_builtins(furnish))
    words = [
        "",
        "default",
        "red",
        "oak",
        "mujoco",
        "open",
        "top",
        "elevator",
        "stairs",
        "me",
        "ann",
        "Fetch a pen.",
        "cola_can_1",
    ]
    for scene in building.scenes():
        words += [room.id for room in scene.rooms] + [room.room_type for room in scene.rooms]
        words += [door.id for door in scene.doors]
        words += [name for entry in scene.objects[::3] for name in (entry.id, entry.asset, entry.category)]
    problems = tuple(to_builtins(problem) for problem in plan.problems)
    return Stock(folder, problems, tuple(requests), tuple(dict.fromkeys(words)))


@dataclass(frozen=True)
class Case:
    """An input, and what takes it: a service, ``file NAME`` of a building folder, a payload or a command."""

    number: int
    target: str
    data: bytes


class Fuzzer:
    """Makes cases by their numbers and runs them, in a folder outside of which nothing may be written.

    Parameters
    ----------
    stock : Stock
    root : Path
        Changed to; everything is written in it.
    seed : int
    guard : WriteGuard, optional
        Of this process, whose root holds `root`.
    """

    def __init__(self, stock: Stock, root: Path, seed: int, guard: WriteGuard | None = None) -> None:
        self._stock, self._root, self._seed = stock, root, seed
        self._guard = guard or WriteGuard(root)
        self._targets = _targets(self, stock)
        self._since = ANEW
        root.mkdir(parents=True, exist_ok=True)
        os.chdir(root)

    @property
    def targets(self) -> list[str]:
        """What takes cases."""
        return [target.name for target in self._targets]

    def case(self, number: int) -> Case:
        """Return the case of a number."""
        rng = random.Random(f"{self._seed}/{number}")
        total = sum(target.share for target in self._targets)
        target = rng.choices(self._targets, [target.share / total for target in self._targets])[0]
        value = target.draw(rng)
        if isinstance(value, bytes):
            return Case(number, target.name, value)
        kind = rng.random()
        if kind < 0.6:
            value = spoiled(value, rng, rng.choice([1, 1, 1, 2, 3, 8]))
        text = json.dumps(value)
        data = garbled(text, rng) if kind > 0.95 else text.encode()
        return Case(number, target.name, data)

    def run(self, case: Case) -> Outcome:
        """Run a case, and begin anew after a while or where it did harm."""
        if self._since >= ANEW:
            self.begin_anew()
        self._since += 1
        target = next(target for target in self._targets if target.name == case.target)
        outcome = outcome_of(lambda: target.take(case.data), self._guard)
        if not outcome.sound or target.spoils:
            self._since = ANEW
        return outcome

    def begin_anew(self) -> None:
        """Copy the building anew; editors and robots follow when they are asked for."""
        self._since = 0
        for entry in self._root.iterdir():
            shutil.rmtree(entry) if entry.is_dir() and not entry.is_symlink() else entry.unlink()
        self.building = self._root / "building"
        shutil.copytree(self._stock.folder, self.building, copy_function=_copy)
        self.allowed = AllowedFolders((self._root.resolve(),))
        self._editor: SceneEditor | None = None
        self._engine: Engine | None = None

    @property
    def editor(self) -> SceneEditor:
        """The editor of the building."""
        if self._editor is None:
            self._editor = self.opened(self.building)
        return self._editor

    def opened(self, folder: Path) -> SceneEditor:
        """Open an editor as the scene editor's node does."""
        store = BuildingStore(folder, validator=new_faults, records=records, allowed=self.allowed)
        return SceneEditor(store, load_catalogue(), StaticEngine(), who="fuzzer", furnisher=furnish_room)

    @property
    def engine(self) -> Engine:
        """The skill server's engine, with robots in the building."""
        if self._engine is None:
            self._engine = Engine(durable=False, allowed=self.allowed)
            self._engine.load(LoadBuilding(path=str(self.building)))
        return self._engine


def _copy(source: str, target: str) -> None:
    """Copy what is spoiled, and link the rest, which is only ever replaced whole."""
    shutil.copy(source, target) if source.endswith(".json") else os.link(source, target)


@dataclass(frozen=True)
class _Target:
    """What takes cases.

    Attributes
    ----------
    share : float
        Of all cases, beside those of other targets.
    draw : callable
        Returns a sound input, which is then spoiled, or bytes that are taken as they are.
    spoils : bool
        Whether it leaves a building that nothing else should go on with.
    """

    name: str
    share: float
    draw: Callable[[random.Random], Any]
    take: Callable[[bytes], Any]
    spoils: bool = False


def _targets(fuzzer: Fuzzer, stock: Stock) -> list[_Target]:
    return [*_services(fuzzer, stock), *_payloads(stock), *_files(fuzzer, stock), *_commands(fuzzer, stock)]


def _services(fuzzer: Fuzzer, stock: Stock) -> list[_Target]:
    """Every service of the table, as its node serves it."""
    handlers: dict[str, tuple[float, Callable[[Any], Any]]] = {
        "plan_program": (6.0, LocalStages().plan),
        "solve_floor": (2.0, LocalStages().solve),
        "furnish_floor": (1.0, LocalStages().furnish),
        "build_building": (0.1, lambda job: _build(fuzzer, job)),
        "cancel_build": (0.1, lambda arguments: arguments),
        "cancel_plan": (0.1, lambda arguments: arguments),
        "load_building": (3.0, lambda arguments: fuzzer.engine.load(arguments)),
        "skills/cancel": (0.5, lambda arguments: fuzzer.engine.cancel(arguments)),
        "skills/take_control": (0.3, lambda arguments: _controlled(fuzzer, arguments)),
        "skills/release_control": (0.3, lambda arguments: fuzzer.engine.release_control(arguments)),
        "scene/open": (1.0, lambda arguments: fuzzer.opened(Path(arguments.path))),
        "scene/cancel": (0.1, lambda arguments: arguments),
        "scene/instruct": (4.0, lambda a: instruct(fuzzer.editor, a.instruction, "rules", partly=a.partly)),
        "scene/provision": (1.0, lambda arguments: provision(fuzzer.editor, arguments.task)),
    }
    for skill in SKILLS.values():
        handlers[skill.interface.name] = (1.0, _skill_runner(fuzzer, skill.name))
    for tool in TOOLS:
        name = "scene/" + "".join(f"_{c.lower()}" if c.isupper() else c for c in tool).lstrip("_")
        handlers[name] = (1.0, lambda arguments, tool=tool: fuzzer.editor.call(tool, arguments))  # type: ignore[misc]
    targets = []
    for entry in SERVICES:
        share, handler = handlers.pop(entry.name)
        kind = entry.arguments or SessionArgs
        targets.append(_Target(entry.name, share, _sample(kind, stock), _taker(kind, handler)))
    assert not handlers, f"no such services: {sorted(handlers)}"
    targets.append(
        _Target(
            "lift_requests",
            0.5,
            _sample(LiftRequest, stock),
            _taker(LiftRequest, lambda request: fuzzer.engine.request_lift(request)),
        )
    )
    return targets


def _skill_runner(fuzzer: Fuzzer, name: str) -> Callable[[Any], Any]:
    return lambda arguments: fuzzer.engine.run(name, arguments)


def _controlled(fuzzer: Fuzzer, arguments: ControlArgs) -> None:
    """Take the control of a session, and let go of it, or every later skill would be refused."""
    fuzzer.engine.take_control(arguments)
    fuzzer.engine.release_control(ControlArgs(session=arguments.session, force=True))


def _build(fuzzer: Fuzzer, job: BuildJob) -> None:
    output = Path(job.output or "built")
    fuzzer.allowed.check(output, "$.output")
    build_building(identified(job.request()), output, force=job.force)


def _taker(kind: Any, handler: Callable[[Any], Any]) -> Callable[[bytes], Any]:
    """Return what a service does with a text: decode it, call, and encode the answer."""

    def take(data: bytes) -> None:
        encode(handler(decode(kind, data)))

    return take


def _sample(kind: Any, stock: Stock) -> Callable[[random.Random], Any]:
    """Return what draws sound arguments of a service."""
    real: dict[Any, Callable[[random.Random], Any]] = {
        FloorProblem: lambda rng: rng.choice(stock.problems),
        FurnishRequest: lambda rng: rng.choice(stock.requests),
        BuildRequest: _request,
        BuildJob: lambda rng: (
            _request(rng) | {"description": BRIEFS[0], "output": rng.choice(["out/a", "building", "../b", "/etc/c"])}
        ),
        LoadBuilding: lambda rng: {
            "path": rng.choice(["building"] * 5 + [".", "/", "none"]),
            **_rarely(rng, session="b", reset=True),
        },
        InstructArgs: lambda rng: {"instruction": _reworded(rng.choice(INSTRUCTIONS), rng, stock.words)},
        ProvisionArgs: lambda rng: {"task": drawn(PAYLOADS["Task"], rng, stock.words)},
    }
    if kind in real:
        return real[kind]
    return lambda rng: _without_session(drawn(kind, rng, stock.words))


def _without_session(arguments: dict[str, Any]) -> dict[str, Any]:
    """Return arguments for the robot and the editor that there are."""
    return {name: value for name, value in arguments.items() if name not in ("session", "editor", "token")}


def _request(rng: random.Random) -> dict[str, Any]:
    fields = _rarely(rng, floors=2, area=150.0, seed=7, floor_area=70.0)
    return {"description": _reworded(rng.choice(BRIEFS), rng, ()), **fields}


def _rarely(rng: random.Random, **fields: Any) -> dict[str, Any]:
    return {name: value for name, value in fields.items() if rng.random() < 0.2}


def _reworded(text: str, rng: random.Random, words: Sequence[str]) -> str:
    """Return a text with some of its words exchanged, doubled or taken away."""
    parts = text.split()
    for _ in range(rng.choice([0, 1, 1, 2, 5])):
        at = rng.randrange(len(parts))
        other = rng.choice([*parts, *TEXTS[:30], *(words[:40]), "not", "and", "of", "-3", "1e9", "m2", "9999999999"])
        parts[at : at + rng.choice([0, 1, 2])] = [other] * rng.choice([1, 1, 1, 40])
        parts = parts or ["a"]
    return " ".join(parts)


def _payloads(stock: Stock) -> list[_Target]:
    """Every payload type, decoded and encoded."""
    return [
        _Target(
            f"payload {name}",
            0.05,
            lambda rng, kind=kind: drawn(kind, rng, stock.words),
            lambda data, kind=kind: encode(decode(kind, data)),
        )  # type: ignore[misc]
        for name, kind in PAYLOADS.items()
    ]


def _files(fuzzer: Fuzzer, stock: Stock) -> list[_Target]:
    """The files of a building folder that somebody else wrote, read by what opens buildings."""
    names = sorted(
        str(file.relative_to(stock.folder)) for file in stock.folder.rglob("*.json") if "meshes" not in file.parts
    )

    def taker(name: str) -> Callable[[bytes], Any]:
        def take(data: bytes) -> None:
            file = fuzzer.building / name
            if not file.parent.is_dir():  # a job before has built something else there
                fuzzer.begin_anew()
            file.write_bytes(data)
            for read in (_checked, _loaded, _edited):
                with contextlib.suppress(MansionError):
                    read(fuzzer)

        return take

    def drawer(name: str) -> Callable[[random.Random], Any]:
        content = json.loads((stock.folder / name).read_bytes())
        return lambda rng: content

    shares = {name: 1.0 if Path(name).stem in _READ else 0.1 for name in names}
    return [_Target(f"file {name}", share, drawer(name), taker(name), spoils=True) for name, share in shares.items()]


_READ: Final = ("building", "scene", "layout", "topology", "report")
"""Files that a building is read from; the others are made for other programs."""


def _checked(fuzzer: Fuzzer) -> None:
    _command(fuzzer, "check", "building")


def _loaded(fuzzer: Fuzzer) -> None:
    engine = Engine(durable=False, allowed=fuzzer.allowed)
    engine.load(LoadBuilding(path=str(fuzzer.building), session="reader"))
    engine.run("WhereAmI", SessionArgs(session="reader"))
    engine.run("TakeStairs", decode(SKILLS["take_stairs"].arguments, b'{"session": "reader", "direction": "Up"}'))


def _edited(fuzzer: Fuzzer) -> None:
    editor = fuzzer.opened(fuzzer.building)
    room = next(room.id for scene in editor.state.scenes.values() for room in scene.rooms)
    editor.call("RenameRoom", {"room_id": room, "name": "Studio"})


_LINES: Final[tuple[tuple[float, tuple[str, ...]], ...]] = (
    (0.3, ("plan", "a small flat", "--seed", "3")),
    (0.1, ("check", "building", "--json", "--norms")),
    (0.1, ("edit", "building", "how many chairs are there?")),
    (0.2, ("skill", "GoToLandmark", '{"landmark": "stairs"}', "--building", "building")),
    (0.05, ("export", "building", "--to", "nav2", "-o", "exported")),
    (0.05, ("schema", "FloorScene")),
    (0.1, ("task", "generate", "building", "-n", "2", "-o", "tasks.json")),
    (0.02, ("build", "a small flat", "-o", "built", "--jobs", "1")),
)


def _commands(fuzzer: Fuzzer, stock: Stock) -> list[_Target]:
    """Commands that do their work in this process."""

    def drawer(line: tuple[str, ...]) -> Callable[[random.Random], bytes]:
        def draw(rng: random.Random) -> bytes:
            words = list(line)
            for _ in range(rng.choice([1, 1, 2])):
                at = rng.randrange(1, len(words))
                if words[at - 1] != "-o" and words[at] != "-o":
                    words[at] = rng.choice(
                        [
                            words[at][: len(words[at]) // 2],
                            str(rng.choice([0, -1, 1e300, "nan", 2**63])),
                            _file_free(rng),
                            *stock.words[:9],
                        ]
                    )
            return json.dumps(words).encode()

        return draw

    return [
        _Target(
            f"mansion {line[0]}",
            share,
            drawer(line),
            lambda data: _command(fuzzer, *json.loads(data)),
            spoils=line[0] == "build",
        )
        for share, line in _LINES
    ]


def _file_free(rng: random.Random) -> str:
    """Return a hostile text that names no place outside of the working folder, which a user's command may write."""
    return rng.choice([text for text in TEXTS if not text.startswith(("/", "~", "..", "a/.."))])


def _command(fuzzer: Fuzzer, *words: str) -> None:
    """Run a command line as a process of its own would, and hand on what would be a traceback there."""
    written = io.StringIO()
    with (
        patch.object(sys, "argv", ["mansion", *words]),
        contextlib.redirect_stdout(io.StringIO()),
        contextlib.redirect_stderr(written),
        contextlib.suppress(SystemExit),
    ):
        command_line()
    if "This is a fault of Mansion" in written.getvalue():
        raise RuntimeError(written.getvalue()[-4000:])
