"""Who uses the graph in `graph_soak.py`: robots, an editor and a builder, each a thread with a client of its own."""

import itertools
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any, Final

from mansion_bringup.client import MansionClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import SkillStatus

__all__ = ["BUILD", "EDIT", "LOAD", "QUESTION", "SKILL", "Call", "Ledger", "Visitor", "builds", "edits", "errands"]

SKILL, QUESTION, EDIT, LOAD, BUILD = "skill", "question", "edit", "load", "build"
"""Kinds of calls: of the skill server, questions to the scene editor, its edits, loading, building."""

REFUSALS: Final = {
    ErrorCode.INFEASIBLE,
    ErrorCode.CONFLICT,
    ErrorCode.NOT_FOUND,
    *(status.value for status in SkillStatus if status is not SkillStatus.CANCELED),
}
"""Codes by which a call is refused for what it asks; any other error counts as a failed call."""

PATIENCE: Final = 30.0
"""Seconds for a call; one without an answer by then is lost."""

BUILD_PATIENCE: Final = 300.0

WAYS: Final = ("Up", "Down")

BRIEFS: Final = (
    "a small flat for two",
    "a two-storey house for a family",
    "a small office for six people",
    "a flower shop with a storeroom",
)

INSTRUCTIONS: Final = (
    "put a red mug on a desk on the second floor",
    "put two books on a table on the third floor",
    "put a plant into the largest room of the fourth floor",
    "paint a desk on the second floor white",
)


@dataclass(frozen=True)
class Call:
    """A call to make: of which kind, of which service, with what, and by which robot where it is a skill."""

    kind: str
    service: str
    arguments: dict[str, Any]
    session: str = ""


Calls = Iterator[Call]


class Ledger:
    """What became of all calls; safe to use from several threads."""

    def __init__(self) -> None:
        self._guard = threading.Lock()
        # By kind and service.
        self.seconds: dict[tuple[str, str], list[float]] = {}
        self.refused = 0
        self.failed: list[str] = []

    def note(self, call: Call, seconds: float, error: str, *, refused: bool) -> None:
        """Note a call with the time that it took, and its error where it had one."""
        with self._guard:
            self.seconds.setdefault((call.kind, call.service), []).append(seconds)
            if refused:
                self.refused += 1
            elif error:
                self.failed.append(f"{call.session} {call.service} {call.arguments} after {seconds:.2f} s: {error}")

    def take(self) -> "Ledger":
        """Return what was noted since the last time, and begin anew."""
        with self._guard:
            taken = Ledger()
            taken.seconds, self.seconds = self.seconds, {}
            taken.refused, self.refused = self.refused, 0
            taken.failed, self.failed = self.failed, []
        return taken

    def of_kind(self, kind: str) -> list[float]:
        """Return the seconds of all calls of a kind."""
        return [value for (found, _), values in self.seconds.items() if found == kind for value in values]

    def add(self, other: "Ledger") -> None:
        """Add what another ledger has."""
        for key, seconds in other.seconds.items():
            self.seconds.setdefault(key, []).extend(seconds)
        self.refused += other.refused
        self.failed += other.failed


class Visitor(threading.Thread):
    """A thread that makes calls, pausing between them, until it is stopped.

    Parameters
    ----------
    name : str
    client : MansionClient
        Of its own; closed at the end.
    ledger : Ledger
    calls : callable
        Given a way to make a call that returns the reply (``None`` where it was refused), makes calls without end;
        whatever it yields is called too.
    pace : tuple of float
        Least and greatest time from the start of a call to that of the next, seconds. A call that takes longer is
        followed by the next at once.
    """

    def __init__(
        self,
        name: str,
        client: MansionClient,
        ledger: Ledger,
        calls: "Callable[[Visitor, Random], Calls]",
        pace: tuple[float, float],
    ) -> None:
        super().__init__(name=name, daemon=True)
        self.stopped = threading.Event()
        self.fault = ""
        self.reply: Any = None
        self._client, self._ledger, self._calls, self._pace = client, ledger, calls, pace
        self._rng = Random(name)

    def run(self) -> None:
        """Make calls until stopped."""
        with self._client:
            try:
                for call in self._calls(self, self._rng):
                    begin = time.monotonic()
                    self.reply = self._made(call)
                    spent = time.monotonic() - begin
                    if self.stopped.wait(max(0.0, self._rng.uniform(*self._pace) - spent)):
                        return
            except Exception as error:
                self.fault = f"{self.name} ended: {type(error).__name__}: {error}"

    def _made(self, call: Call) -> Any:
        """Make a call, note it, and return the reply; ``None`` where there is none."""
        reply, error, refused = None, "", False
        begin = time.perf_counter()
        patience = BUILD_PATIENCE if call.kind == BUILD else PATIENCE
        service = f"{call.session}/{call.service}" if call.session else call.service
        try:
            reply = self._client.call(service, call.arguments, timeout=patience, wait=PATIENCE)
        except MansionError as problem:
            error, refused = str(problem), problem.code in REFUSALS
        seconds = time.perf_counter() - begin
        if reply is not None and call.session and reply.get("session", call.session) != call.session:
            error = f"the answer is for the session {reply['session']!r}"
        self._ledger.note(call, seconds, error, refused=refused)
        return reply


def errands(building: Path, session: str) -> "Callable[[Visitor, Random], Calls]":
    """Return what a robot calls: it rides and walks about, takes what it sees and puts it down, and asks."""

    def calls(visitor: Visitor, rng: Random) -> Calls:
        def skill(name: str, **arguments: Any) -> Call:
            return Call(SKILL, f"skills/{name}", arguments, session)

        load = Call(LOAD, "load_building", {"path": str(building), "session": session})
        for number in itertools.count():
            if number % 50 == 0:
                yield load
            yield skill("list_landmarks")
            marks = [mark["name"] for mark in (visitor.reply or {}).get("landmarks", ())]
            yield skill("go_to_landmark", landmark=rng.choice(marks or ["stairs"]))
            yield skill("list_visible")
            seen = (visitor.reply or {}).get("objects", [])
            yield from _handled(seen, skill, rng)
            yield _question(seen, rng)
            yield skill("rotate", degrees=rng.uniform(-180.0, 180.0))
            yield skill("move_ahead", distance=rng.uniform(-0.5, 1.0))
            yield skill("plan_route", target=rng.choice(marks or ["stairs"]))
            yield from _other_storey(skill, rng)

    return calls


def _handled(seen: list[dict[str, Any]], skill: Callable[..., Call], rng: Random) -> Calls:
    """Go to something seen, use it as it can be used, and put down what is in the hand."""
    for thing in rng.sample(seen, min(2, len(seen))):
        name = thing["id"]
        yield skill("go_near_object", object=name)
        if thing["pickupable"]:
            yield skill("pick_up", object=name)
        if thing["openable"]:
            yield skill(rng.choice(("open_object", "close_object")), object=name)
        if thing["toggleable"]:
            yield skill(rng.choice(("toggle_on", "toggle_off")), object=name)
        if thing["receptacle"]:
            yield skill("place", target=name, relation="on")
    yield skill("place", target="floor")


def _other_storey(skill: Callable[..., Call], rng: Random) -> Calls:
    """Go to another storey, by lift or by stairs."""
    if rng.random() < 0.5:
        yield skill("go_to_landmark", landmark="elevator")
        yield skill("call_elevator")
        yield skill("use_elevator", target_floor=rng.randint(1, 4))
    else:
        yield skill("go_to_landmark", landmark="stairs")
        yield skill("take_stairs", direction=rng.choice(WAYS))


def _question(seen: list[dict[str, Any]], rng: Random) -> Call:
    """Return a question to the scene editor."""
    holders = [thing["id"] for thing in seen if thing["receptacle"]]
    asked = [
        Call(QUESTION, "scene/check_path", {"end": f"F{rng.randint(1, 4)}/stair_1"}),
        Call(QUESTION, "scene/search_assets", {"query": rng.choice(("a mug", "something to sit on", "a red book"))}),
        Call(QUESTION, "scene/list_objects", {"keyword": rng.choice(("desk", "chair", "lamp", "plant"))}),
    ]
    if holders:
        asked.append(Call(QUESTION, "scene/check_surface", {"id": rng.choice(holders)}))
    return rng.choice(asked)


def edits(visitor: Visitor, rng: Random) -> Calls:
    """Yield what an editor calls: it looks for a surface, puts something there, paints it, and takes it all back."""
    for number in itertools.count():
        yield Call(QUESTION, "scene/list_objects", {"keyword": rng.choice(("desk", "table", "shelf")), "limit": 500})
        found = [item["id"] for item in (visitor.reply or {}).get("objects", ())]
        yield Call(QUESTION, "scene/search_assets", {"query": rng.choice(("a mug", "a book", "a laptop")), "top_k": 3})
        assets = [hit["asset_id"] for hit in (visitor.reply or {}).get("assets", ())]
        yield Call(QUESTION, "scene/check_path", {})
        if not (found and assets):
            continue
        surface, done = rng.choice(found), 0
        for service, arguments in (
            ("place_on_surface", {"asset_id": rng.choice(assets), "receptacle_id": surface}),
            ("paint_object", {"object_id": surface, "color": rng.choice(("red", "white", "green"))}),
            ("move_object", {"object_id": surface, "turn": 180.0}),
        ):
            yield Call(EDIT, f"scene/{service}", arguments)
            done += visitor.reply is not None
        if number % 4 == 0:
            yield Call(EDIT, "scene/instruct", {"instruction": INSTRUCTIONS[number // 4 % len(INSTRUCTIONS)]})
            done += bool((visitor.reply or {}).get("edits"))
        for _ in range(done):
            yield Call(EDIT, "scene/undo", {})


def builds(folder: Path) -> "Callable[[Visitor, Random], Calls]":
    """Return what a builder calls: small buildings, each into one of a few folders."""

    def calls(visitor: Visitor, rng: Random) -> Calls:
        for number, brief in enumerate(itertools.cycle(BRIEFS)):
            output = str(folder / str(number % len(BRIEFS)))
            yield Call(BUILD, "build_building", {"description": brief, "seed": number, "output": output})

    return calls
