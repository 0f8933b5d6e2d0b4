"""A lift as Open-RMF sees it: cabin, doors, mode, and the session that holds it.

A session holds the lift until it ends; other calls wait in the order in which they came. The cabin runs at one speed
and the doors take a fixed time; both advance with the world's clock.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

from mansion_msgs_py.world import LiftCall, LiftDoor, LiftMode, LiftMotion, LiftState

__all__ = ["DOOR_TIME", "SPEED", "Lift"]

SPEED = 1.0
"""Metres a second."""

DOOR_TIME = 2.0
"""Seconds that the doors take to open or close."""

_STILL = 1e-9


@dataclass
class Lift:
    """One lift of the building.

    Attributes
    ----------
    elevations : dict
        Floor number to height of its finished floor, metres.
    labels : dict
        Floor number to label.
    position : float
        Height of the cabin's floor, metres.
    opening : float
        How far the doors stand open, 0 to 1.
    target : int, optional
        The floor that the holding session asked for.
    door : LiftDoor
        State of the doors at `target`; without a session they close.
    queue : list of LiftCall
        Calls that wait until the session ends.
    """

    name: str
    elevations: dict[int, float]
    labels: dict[int, str]
    position: float
    opening: float = 0.0
    target: int | None = None
    door: LiftDoor = LiftDoor.OPEN
    session: str = ""
    mode: LiftMode = LiftMode.AGV
    queue: list[LiftCall] = field(default_factory=list)
    _reported: str = "rest"

    @property
    def floor(self) -> int:
        """The floor that the cabin is at or nearest to; the lower one half way."""
        return min(sorted(self.elevations), key=lambda f: abs(self.elevations[f] - self.position))

    def is_open_at(self, floor: int) -> bool:
        """Whether the cabin stands on `floor` with its doors open."""
        return self._is_at(floor) and self.opening >= 1.0

    def call(self, call: LiftCall) -> int:
        """Ask for the lift; return the call's place in the queue, 0 when its session holds the lift now."""
        if self.session in ("", call.session) and not (self.session == "" and self.queue):
            self._take(call)
            return 0
        waiting = [entry.session for entry in self.queue]
        if call.session in waiting:
            self.queue[waiting.index(call.session)] = call
        else:
            self.queue.append(call)
        if self.session == "":
            self._take(self.queue.pop(0))
        return 0 if self.session == call.session else self.place_of(call.session)

    def place_of(self, session: str) -> int:
        """Return a session's place in the queue from 1, or 0 when it does not wait."""
        waiting = [entry.session for entry in self.queue]
        return waiting.index(session) + 1 if session in waiting else 0

    def release(self, session: str) -> bool:
        """End a session, or take back its call; return whether it held the lift or waited for it."""
        waited = self.place_of(session) > 0
        self.queue = [entry for entry in self.queue if entry.session != session]
        if self.session != session:
            return waited
        self.session, self.target = "", None
        if self.queue:
            self._take(self.queue.pop(0))
        return True

    def _take(self, call: LiftCall) -> None:
        self.session, self.target = call.session, call.floor
        self.door, self.mode = call.door, call.mode

    def _is_at(self, floor: int) -> bool:
        return abs(self.position - self.elevations[floor]) < _STILL

    def _phase(self) -> tuple[str, float]:
        """Return what the lift does now and for how many seconds."""
        target = self.target
        if target is not None and not self._is_at(target):
            if self.opening > 0.0:
                return "close", self.opening * DOOR_TIME
            return "run", abs(self.elevations[target] - self.position) / SPEED
        wants_open = target is not None and self.door is LiftDoor.OPEN
        if wants_open and self.opening < 1.0:
            return "open", (1.0 - self.opening) * DOOR_TIME
        if not wants_open and self.opening > 0.0:
            return "close", self.opening * DOOR_TIME
        return "rest", 0.0

    def seconds_to_rest(self) -> float:
        """Return how long the lift needs until nothing moves any more."""
        phase, seconds = self._phase()
        if phase == "rest":
            return 0.0
        after = self._copy()
        after._step(phase, seconds, seconds)
        return seconds + after.seconds_to_rest()

    def seconds_for(self, start: int, end: int) -> float:
        """Return what a ride takes from doors open on one floor to doors open on another."""
        return abs(self.elevations[end] - self.elevations[start]) / SPEED + 2 * DOOR_TIME

    def _copy(self) -> "Lift":
        return Lift(
            self.name, self.elevations, self.labels, self.position, self.opening, self.target, self.door, self.session
        )

    def _step(self, phase: str, seconds: float, total: float) -> None:
        done = seconds >= total - _STILL
        if phase == "run":
            assert self.target is not None
            goal = self.elevations[self.target]
            sign = 1.0 if goal > self.position else -1.0
            self.position = goal if done else self.position + sign * SPEED * seconds
        elif phase == "open":
            self.opening = 1.0 if done else self.opening + seconds / DOOR_TIME
        elif phase == "close":
            self.opening = 0.0 if done else self.opening - seconds / DOOR_TIME

    def advance(self, seconds: float, time: float, building_id: str) -> Iterable[LiftState]:
        """Let time pass and yield the lift's state at each change of doors, motion or session.

        Parameters
        ----------
        seconds : float
        time : float
            The world's clock at the beginning.
        """
        while True:
            phase, total = self._phase()
            if phase != self._reported:
                yield self.state(building_id, time)
            self._reported = phase
            if phase == "rest" or seconds <= 0.0:
                return
            part = min(seconds, total)
            self._step(phase, part, total)
            seconds, time = seconds - part, time + part

    def state(self, building_id: str, time: float) -> LiftState:
        """Return the lift's state with Open-RMF's field names."""
        phase, _ = self._phase()
        motion = LiftMotion.STOPPED
        if phase == "run" and self.target is not None:
            up = self.elevations[self.target] > self.position
            motion = LiftMotion.UP if up else LiftMotion.DOWN
        moving = phase in ("open", "close") or 0.0 < self.opening < 1.0
        still = LiftDoor.OPEN if self.opening >= 1.0 else LiftDoor.CLOSED
        return LiftState(
            lift_name=self.name,
            available_floors=[self.labels[floor] for floor in sorted(self.elevations)],
            current_floor=self.labels[self.floor],
            destination_floor=self.labels[self.floor if self.target is None else self.target],
            door_state=LiftDoor.MOVING if moving else still,
            motion_state=motion,
            lift_time=round(time, 6),
            position=self.position,
            available_modes=[LiftMode.HUMAN, LiftMode.AGV],
            current_mode=self.mode,
            session_id=self.session,
            building_id=building_id,
        )

    def restore(self, saved: LiftState, queue: Iterable[LiftCall]) -> None:
        """Take over the state that a former run saved; what was moving starts to move again."""
        by_label = {label: floor for floor, label in self.labels.items()}
        if saved.destination_floor not in by_label:
            return
        low, high = min(self.elevations.values()), max(self.elevations.values())
        self.position = min(max(saved.position, low), high)
        self.session = saved.session_id
        self.target = by_label[saved.destination_floor] if saved.session_id else None
        self.opening = 1.0 if saved.door_state is LiftDoor.OPEN else 0.0
        self.mode = LiftMode(saved.current_mode)
        self.queue = [call for call in queue if call.floor in self.elevations]
