"""Programs that work until they are killed, and what must hold afterwards."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Final

from mansion_assets.catalogue import load_catalogue
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_bringup.worlds import build_for_world, check_for_world
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import decode
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.world import Progress, WorldState
from mansion_skills.engine import Engine
from mansion_skills.skills.registry import SKILLS
from mansion_skills.world.overlay import overlay_path
from mansion_world.making import WorldProgress, make_world
from mansion_world.mixture import load_mixture
from mansion_world.requests import Sampled
from sample_building import write_building

__all__ = ["NEXT_CALL", "SUBJECTS", "Subject", "killed"]

NEXT_CALL: Final = 5.0
"""Seconds within which the next call has an answer, or goes on."""

TO_END: Final = 10.0
"""Seconds that the other processes of a killed one get to end."""

FLATS: Final = Path(__file__).parents[2] / "examples" / "small_world.toml"
REMAINS: Final = re.compile(r"\..+\.[0-9a-f]{16}|\..+\.(partial|lock|old)|pending\.json|former")


@dataclass(frozen=True)
class Subject:
    """What is killed.

    Attributes
    ----------
    program : str
        Python that works in the folder ``sys.argv[1]``; it prints ``ready``, then a line for all that it acknowledges.
    span : float
        Seconds after ``ready`` within which it is killed.
    prepare : callable
        Makes what the program begins with.
    faults : callable
        Makes the next call in the folder, given what was acknowledged, and yields what is wrong.
    """

    program: str
    span: float
    prepare: Callable[[Path], object]
    faults: Callable[[Path, list[str]], Iterator[str]]


def killed(subject: Subject, folder: Path, share: float) -> list[str]:
    """Run a subject, kill it, and return what is wrong then.

    Parameters
    ----------
    subject : Subject
    folder : Path
        Made, and left as it is.
    share : float
        When to kill, as a share of the subject's span.
    """
    folder.mkdir(parents=True)
    subject.prepare(folder)
    command = [sys.executable, "-c", subject.program, str(folder)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    # A file: the end of a pipe would not come before that of every process that was left.
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(command, stdout=output, env=environment, start_new_session=True)
        try:
            while not (ready := _printed(output)) and process.poll() is None:
                time.sleep(0.01)
            time.sleep(subject.span * share)
            process.kill()
            process.wait()
            faults = [] if ready else ["the program did not begin"]
            faults += [] if _ended(process.pid) else ["a process is left"]
            faults += subject.faults(folder, _printed(output)[1:])
        finally:
            for pid in _session(process.pid):
                os.kill(pid, signal.SIGKILL)
    return faults + [
        f"{path.relative_to(folder)} is left" for path in folder.rglob("*") if REMAINS.fullmatch(path.name)
    ]


def _printed(output: IO[bytes]) -> list[str]:
    """Return the whole lines that a program has printed."""
    return os.pread(output.fileno(), 1_000_000, 0).decode().split("\n")[:-1]


def _ended(session: int) -> bool:
    """Wait until no process of a session is left."""
    deadline = time.monotonic() + TO_END
    while _session(session) and time.monotonic() < deadline:
        time.sleep(0.05)
    return not _session(session)


def _session(session: int) -> list[int]:
    """Return the processes of a session that have not ended."""
    found = []
    for file in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, owner = file.read_text().rpartition(")")[2].split()[:4]
        except (FileNotFoundError, ProcessLookupError):
            continue
        if int(owner) == session and state != "Z":
            found.append(int(file.parent.name))
    return found


class _Clock:
    """How long the next call takes."""

    def __init__(self) -> None:
        self._started = time.monotonic()
        self._first: float | None = None

    def answered(self) -> None:
        """Note the first answer, or the first sign that the call goes on."""
        self._first = self._first or time.monotonic() - self._started

    def faults(self) -> Iterator[str]:
        """Yield that the next call took too long, where it did."""
        self.answered()
        if self._first is not None and self._first > NEXT_CALL:
            yield f"the next call took {self._first:.1f} s"


EDITS: Final = """
import itertools, sys
from pathlib import Path
from mansion_assets.catalogue import load_catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.storage import BuildingStore

editor = SceneEditor(BuildingStore(Path(sys.argv[1], "building")), load_catalogue(), StaticEngine(), who="killed")
print("ready", flush=True)
for number in itertools.count():
    editor.call("RenameRoom", {"room_id": "F1/kitchen", "name": f"Canteen {number}"})
    editor.call("SetFinish", {"room_id": "F2/office", "part": "walls", "color": ("green", "blue")[number % 2]})
    if number % 3 == 2:
        editor.call("Undo")
    print(len(editor.store.log()), flush=True)
"""


def _edit_faults(folder: Path, acknowledged: list[str]) -> Iterator[str]:
    clock = _Clock()
    store = BuildingStore(folder / "building")
    editor = SceneEditor(store, load_catalogue(), StaticEngine(), who="next")
    landed = store.log()
    if len(landed) < int(acknowledged[-1] if acknowledged else 0):
        yield f"{acknowledged[-1]} edits were acknowledged, {len(landed)} are there"
    if [entry.number for entry in landed] != list(range(1, len(landed) + 1)):
        yield "the log has gaps"
    revisions: Mapping[str, int] = {name: of for entry in landed for name, of in entry.revisions.items()}
    for floor, scene in store.scenes().items():
        if scene.revision != revisions.get(str(floor), scene.revision):
            yield f"floor {floor} has revision {scene.revision}, its last edit made {revisions[str(floor)]}"
    editor.call("RenameRoom", {"room_id": "F1/kitchen", "name": "Afterwards"})
    yield from clock.faults()


SKILL_CALLS: Final = """
import sys
from pathlib import Path
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import decode
from mansion_skills.engine import Engine
from mansion_skills.skills.registry import SKILLS

engine = Engine()
engine.load(LoadBuilding(path=str(Path(sys.argv[1], "building"))))
turn = decode(SKILLS["rotate"].arguments, b'{"degrees": 30}')
print("ready", flush=True)
while True:
    engine.run("Rotate", turn)
    print(engine.session("").world.step, flush=True)
"""


def _skill_faults(folder: Path, acknowledged: list[str]) -> Iterator[str]:
    clock = _Clock()
    building, engine = folder / "building", Engine()
    engine.load(LoadBuilding(path=str(building)))
    steps = engine.session("").world.step
    if steps < int(acknowledged[-1] if acknowledged else 0):
        yield f"{acknowledged[-1]} skills were acknowledged, {steps} are there"
    engine.run("Rotate", decode(SKILLS["rotate"].arguments, b'{"degrees": 30}'))
    state = decode(WorldState, overlay_path(building, "").read_bytes())
    if state.step != steps + 1:
        yield f"the next skill is step {state.step} after {steps}"
    yield from clock.faults()


BUILDS: Final = """
import itertools, sys
from pathlib import Path
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest

print("ready", flush=True)
for seed in itertools.count():
    build_building(BuildRequest(description="a small flat", seed=seed), Path(sys.argv[1], f"flat_{seed}"), jobs=2)
    print(seed, flush=True)
"""


def _build_faults(folder: Path, acknowledged: list[str]) -> Iterator[str]:
    for seed in acknowledged:
        if not (folder / f"flat_{seed}").is_dir():
            yield f"building {seed} was acknowledged and is not there"
    for whole in sorted(folder.glob("flat_*")):
        yield from (f"{whole.name}: {fault}" for fault in verify_building(whole))
    clock = _Clock()

    def go_on(progress: Progress) -> None:
        clock.answered()

    seed = len(acknowledged)
    build_building(BuildRequest(description="a small flat", seed=seed), folder / f"flat_{seed}", report=go_on)
    yield from clock.faults()
    yield from (f"flat_{seed}: {fault}" for fault in verify_building(folder / f"flat_{seed}"))


WORLDS: Final = f"""
import sys
from pathlib import Path
from mansion_bringup.worlds import build_for_world, check_for_world, world_workers
from mansion_world.making import make_world
from mansion_world.mixture import load_mixture
from mansion_world.requests import Sampled

print("ready", flush=True)
make_world(
    Path(sys.argv[1], "world"), 3, requests=Sampled(7, load_mixture(Path({str(FLATS)!r}))), build=build_for_world,
    check=check_for_world, workers=world_workers(1), report=lambda progress: print(progress.done, flush=True),
)
"""


def _world_faults(folder: Path, acknowledged: list[str]) -> Iterator[str]:
    clock, seen = _Clock(), list[int]()

    def go_on(progress: WorldProgress) -> None:
        clock.answered()
        seen.append(progress.done)

    made = make_world(
        folder / "world",
        3,
        requests=Sampled(7, load_mixture(FLATS)),
        build=build_for_world,
        check=check_for_world,
        workers=lambda: ThreadPoolExecutor(1),
        report=go_on,
    )
    yield from clock.faults()
    if seen and seen[0] < int(acknowledged[-1] if acknowledged else 0):
        yield f"{acknowledged[-1]} buildings were acknowledged, {seen[0]} are there"
    if made.done + made.missing != 3:
        yield f"{made.done} of 3 buildings are made"
    for index in sorted((folder / "world" / "buildings").glob("*/*/building.json")):
        yield from (f"{index.parent.name}: {fault}" for fault in verify_building(index.parent))
    if list((folder / "world" / "work").iterdir()):
        yield "unfinished work is left"


def _with_building(folder: Path) -> None:
    write_building(folder / "building")


SUBJECTS: Final[Mapping[str, Subject]] = {
    "edit": Subject(EDITS, 1.0, _with_building, _edit_faults),
    "skill": Subject(SKILL_CALLS, 0.5, _with_building, _skill_faults),
    "build": Subject(BUILDS, 8.0, lambda folder: None, _build_faults),
    "world": Subject(WORLDS, 15.0, lambda folder: None, _world_faults),
}
