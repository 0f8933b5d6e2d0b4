"""The interface of agents: what an agent is told, what it answers, and what each kind may know."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol

from mansion_msgs_py.skills import LandmarkInfo
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import Pose2D, SkillResult, SkillStatus

__all__ = ["Access", "Agent", "Briefing", "Pictures", "MapEntry", "Observation", "SeenObject", "Stop"]


@dataclass(frozen=True)
class Access:
    """What an agent may know besides the instruction, its own state and what its skills answered.

    Attributes
    ----------
    names : bool
        Ids of the objects in view; without it they are ``#1``, ``#2``, ... as marked in the picture, and so are ids in
        answers of skills.
    categories : bool
        What the objects in view are.
    object_map : bool
        All objects of the building with their rooms.
    plan : bool
        The plan that proves the task solvable.
    pictures : bool
        What the camera sees.
    """

    names: bool = True
    categories: bool = True
    object_map: bool = False
    plan: bool = False
    pictures: bool = False


@dataclass(frozen=True)
class Briefing:
    """What an agent is told before its first step.

    Attributes
    ----------
    floors : tuple of int
        Floors of the building, ascending.
    labels : tuple of str
        What the lift's buttons say, in the order of `floors`.
    lessons : tuple of str
        What the same agent learned in earlier episodes.
    plan : tuple of SkillCall
        Empty unless `Access.plan`.
    """

    instruction: str
    floors: tuple[int, ...]
    labels: tuple[str, ...]
    max_steps: int
    seed: int = 0
    lessons: tuple[str, ...] = ()
    plan: tuple[SkillCall, ...] = ()


@dataclass(frozen=True)
class SeenObject:
    """An object in the camera's picture; `distance` in metres, `bearing` in degrees, left is positive.

    Attributes
    ----------
    ref : str
        What skills take for it.
    category, color, room, parent : str
        Empty where the agent may not know them.
    """

    ref: str
    category: str
    distance: float
    bearing: float
    color: str = ""
    room: str = ""
    parent: str = ""
    within_reach: bool = False
    pickupable: bool = False
    receptacle: bool = False
    openable: bool = False
    is_open: bool | None = None


@dataclass(frozen=True)
class MapEntry:
    """An object of the building's object map."""

    id: str
    category: str
    color: str
    floor: int | None
    room: str
    parent: str


class Pictures(Protocol):
    """Pictures of the moment, PNG, made when they are asked for; empty where nothing can draw them."""

    def view(self) -> bytes:
        """What the camera sees, the objects in view marked with their numbers."""

    def landmarks(self) -> list[bytes]:
        """The floor's landmarks as pages of numbered pictures, in the order of the observation."""

    def lift_panel(self) -> bytes:
        """The buttons of the lift."""

    def stairs(self) -> bytes:
        """The stairs with arrows where they lead."""


@dataclass(frozen=True)
class Observation:
    """What an agent perceives before a step.

    Attributes
    ----------
    step, max_steps : int
        Skills called so far, and how many may be.
    pitch : float
        How far the camera is tilted up, degrees.
    held : str
        What the hand holds, as `SeenObject.ref` would name it; empty for nothing.
    visible : tuple of SeenObject
        Nearest first.
    last_call, last : SkillCall, SkillResult, optional
        The last skill and its answer.
    object_map : callable
        Makes the object map; an empty one unless `Access.object_map`.
    """

    instruction: str
    step: int
    max_steps: int
    floor: int
    floors: tuple[int, ...]
    pose: Pose2D
    pitch: float = 0.0
    room: str = ""
    held: str = ""
    landmarks: tuple[LandmarkInfo, ...] = ()
    visible: tuple[SeenObject, ...] = ()
    last_call: SkillCall | None = None
    last: SkillResult | None = None
    pictures: Pictures | None = None
    object_map: Callable[[], list[MapEntry]] = field(default=list)

    @property
    def succeeded(self) -> bool:
        """Whether the last skill did what it should."""
        return self.last is not None and self.last.status is SkillStatus.SUCCESS


@dataclass(frozen=True)
class Stop:
    """The agent ends the episode; `done` when it believes that the task is."""

    reason: str
    done: bool = False


class Agent(Protocol):
    """Carries out a task one skill at a time."""

    @property
    def name(self) -> str:
        """As the command line calls it."""

    @property
    def access(self) -> Access:
        """What it may know; whoever runs the episode keeps the rest from it."""

    def reset(self, briefing: Briefing) -> None:
        """Begin an episode."""

    def act(self, observation: Observation) -> SkillCall | Stop:
        """Choose the next skill, or stop."""

    def lessons(self) -> list[str]:
        """What the episode taught, for `Briefing.lessons` of later ones."""

    def notes(self) -> dict[str, Any]:
        """Facts about the last choice for the log: thoughts, repairs, tokens."""
