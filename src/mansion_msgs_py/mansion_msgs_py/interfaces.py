"""The table of topics and services: names below the namespace, types, payloads and QoS, written once.

A node asks for its interface by name (``service("plan_program")``), and ``docs/interfaces.md`` is made from the table.
"""

from dataclasses import dataclass
from typing import Any, Final, Literal

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.skills import (
    GoToLandmarkArgs,
    Loaded,
    TakeStairsArgs,
    UseElevatorArgs,
    WhereAmI,
)
from mansion_msgs_py.stages import BuildJob, BuildReply, FurnishRequest, PlanReply
from mansion_msgs_py.world import LiftState, Progress, RobotState, SkillResult

__all__ = [
    "DEFAULT_NAMESPACE",
    "JSON_CALL",
    "LATCHED",
    "SERVICES",
    "STREAM",
    "STRING",
    "TOPICS",
    "TRIGGER",
    "Qos",
    "ServiceInterface",
    "TopicInterface",
    "markdown_table",
    "service",
    "topic",
]

DEFAULT_NAMESPACE: Final = "/mansion"

STRING: Final = "std_msgs/msg/String"
TRIGGER: Final = "std_srvs/srv/Trigger"
JSON_CALL: Final = "diagnostic_msgs/srv/AddDiagnostics"


@dataclass(frozen=True)
class Qos:
    """Quality of service, without a ROS import: all interfaces keep the last `depth` samples."""

    depth: int = 10
    reliability: Literal["reliable", "best_effort"] = "reliable"
    durability: Literal["volatile", "transient_local"] = "volatile"

    def __str__(self) -> str:
        return f"{self.reliability}, {self.durability.replace('_', ' ')}, depth {self.depth}"


LATCHED: Final = Qos(depth=64, durability="transient_local")
"""For results that a late joiner must get: one sample a floor, 64 floors."""

STREAM: Final = Qos(depth=10)


@dataclass(frozen=True)
class TopicInterface:
    """A topic: `name` below the namespace, or absolute when it starts with a slash."""

    name: str
    node: str
    description: str
    payload: Any = None
    type: str = STRING
    qos: Qos = STREAM


@dataclass(frozen=True)
class ServiceInterface:
    """A service; `arguments` is ``None`` for a Trigger."""

    name: str
    node: str
    description: str
    arguments: Any
    reply: Any
    example: str = ""

    @property
    def type(self) -> str:
        """The ROS service type."""
        return TRIGGER if self.arguments is None else JSON_CALL


TOPICS: tuple[TopicInterface, ...] = (
    TopicInterface(
        "build_requests",
        "building_director",
        "A request to build; the answer comes as latched results.",
        BuildRequest,
    ),
    TopicInterface(
        "program", "program_planner", "The program of each building.", BuildingProgram, qos=LATCHED
    ),
    TopicInterface(
        "floor_layout", "floor_solver", "The layout of each floor.", FloorLayout, qos=LATCHED
    ),
    TopicInterface(
        "floor_scene",
        "object_placer",
        "The furnished floor, one message a floor.",
        FloorScene,
        qos=LATCHED,
    ),
    TopicInterface("progress", "building_director", "How far a job is.", Progress),
    TopicInterface(
        "robot_state", "skill_server", "Where a robot is, after each skill.", RobotState
    ),
    TopicInterface("lift_state", "skill_server", "Each lift, once a second.", LiftState),
)

SERVICES: tuple[ServiceInterface, ...] = (
    ServiceInterface(
        "plan_program",
        "program_planner",
        "Program, room graphs and solver problems of a request.",
        BuildRequest,
        PlanReply,
        '{"description": "a two-storey library"}',
    ),
    ServiceInterface(
        "solve_floor",
        "floor_solver",
        "The layout of one floor.",
        FloorProblem,
        FloorLayout,
        '{"boundary": [[0,0],[6,0],[6,4],[0,4]], "nodes": [{"id": "hall", "type": "main"}]}',
    ),
    ServiceInterface(
        "furnish_floor",
        "object_placer",
        "The furnished scene of one floor.",
        FurnishRequest,
        FloorScene,
    ),
    ServiceInterface(
        "build_building",
        "building_director",
        "A whole building, written to a folder.",
        BuildJob,
        BuildReply,
        '{"description": "a small flat", "output": "/tmp/flat"}',
    ),
    ServiceInterface(
        "load_building",
        "skill_server",
        "Put the robot into a building on disk.",
        LoadBuilding,
        Loaded,
        '{"path": "/tmp/flat"}',
    ),
    ServiceInterface(
        "skills/call_elevator",
        "skill_server",
        "Bring the lift to the robot's floor and open its doors.",
        None,
        SkillResult,
    ),
    ServiceInterface(
        "skills/use_elevator",
        "skill_server",
        "Ride the called lift to another floor.",
        UseElevatorArgs,
        SkillResult,
        '{"target_floor": 3}',
    ),
    ServiceInterface(
        "skills/take_stairs",
        "skill_server",
        "Walk one floor up or down.",
        TakeStairsArgs,
        SkillResult,
        '{"direction": "Up"}',
    ),
    ServiceInterface(
        "skills/go_to_landmark",
        "skill_server",
        "Go to a room or a core of this floor.",
        GoToLandmarkArgs,
        SkillResult,
        '{"landmark": "elevator"}',
    ),
    ServiceInterface(
        "skills/where_am_i",
        "skill_server",
        "Floor, room, pose and held object.",
        None,
        WhereAmI,
    ),
)


def topic(name: str) -> TopicInterface:
    """Return the topic of that name; KeyError when the table has none."""
    return _TOPICS[name]


def service(name: str) -> ServiceInterface:
    """Return the service of that name; KeyError when the table has none."""
    return _SERVICES[name]


_TOPICS = {entry.name: entry for entry in TOPICS}
_SERVICES = {entry.name: entry for entry in SERVICES}


def _payload_name(kind: Any) -> str:
    if kind is None:
        return ""
    return getattr(kind, "__name__", str(kind)) if kind is not dict else "object"


def markdown_table() -> str:
    """Return the table of all interfaces as Markdown."""
    lines = [
        "| service | type | arguments | reply | node | what it does |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    lines += [
        f"| `{s.name}` | `{s.type}` | {_payload_name(s.arguments)} | {_payload_name(s.reply)} "
        f"| `{s.node}` | {s.description} |"
        for s in SERVICES
    ]
    lines += [
        "",
        "| topic | type | payload | node | QoS | what it carries |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    lines += [
        f"| `{t.name}` | `{t.type}` | {_payload_name(t.payload)} | `{t.node}` | {t.qos} "
        f"| {t.description} |"
        for t in TOPICS
    ]
    return "\n".join(lines) + "\n"
