"""The table of topics and services: names below the namespace, types, payloads and QoS, written once.

A node asks for its interface by name (``service("plan_program")``), and ``docs/interfaces.md`` is made from the table.
"""

from dataclasses import dataclass
from typing import Any, Final, Literal

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.editing import (
    AgentReport,
    AssetHits,
    CheckPathArgs,
    CheckSurfaceArgs,
    DiffReport,
    EditorInfo,
    EditResult,
    InstructArgs,
    ListObjectsArgs,
    MoveObjectArgs,
    ObjectList,
    OpenEditorArgs,
    PathReport,
    PlaceInContainerArgs,
    PlaceOnSurfaceArgs,
    ReceptacleReport,
    RemoveObjectArgs,
    SearchAssetsArgs,
    SearchContentsArgs,
    SetStateArgs,
    ToolArgs,
)
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.skills import (
    Control,
    ControlArgs,
    DoorArgs,
    GoToLandmarkArgs,
    Landmarks,
    Loaded,
    LookArgs,
    MoveAheadArgs,
    MoveToArgs,
    NearObjectArgs,
    ObjectArgs,
    PlaceArgs,
    RotateArgs,
    Route,
    RouteArgs,
    SessionArgs,
    TakeStairsArgs,
    UseElevatorArgs,
    VisibleArgs,
    VisibleObjects,
    WhereAmI,
)
from mansion_msgs_py.stages import BuildJob, BuildReply, FurnishRequest, PlanReply
from mansion_msgs_py.world import (
    LiftRequest,
    LiftState,
    Progress,
    RobotState,
    SkillProgress,
    SkillResult,
    WorldEvent,
)

__all__ = [
    "DEFAULT_NAMESPACE",
    "JSON_CALL",
    "LATCHED",
    "LATEST",
    "SENSOR",
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

LATEST: Final = Qos(depth=1, durability="transient_local")
"""For states of which a late joiner needs the last one only, ``/map`` among them (as Nav2's map_server does it)."""

SENSOR: Final = Qos(depth=5, reliability="best_effort")
"""rclpy's ``qos_profile_sensor_data``."""


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
        "The furnished floor, one message a floor; from `scene_editor` again after an edit.",
        FloorScene,
        qos=LATCHED,
    ),
    TopicInterface("progress", "building_director", "How far a job is.", Progress),
    TopicInterface(
        "robot_state", "skill_server", "Where a robot is, after each change.", RobotState
    ),
    TopicInterface(
        "lift_state", "skill_server", "Each lift, once a second and on change.", LiftState
    ),
    TopicInterface(
        "lift_requests",
        "skill_server",
        "Ask for a lift or end a session, as Open-RMF does (read by the node).",
        LiftRequest,
    ),
    TopicInterface("skill_progress", "skill_server", "How far a running skill is.", SkillProgress),
    TopicInterface("world_events", "skill_server", "What each skill changed.", WorldEvent),
    TopicInterface(
        "robot_pose",
        "skill_server",
        "The robot in `map`.",
        type="geometry_msgs/msg/PoseStamped",
        qos=LATEST,
    ),
    TopicInterface(
        "landmarks",
        "skill_server",
        "Poses of this floor's landmarks, in the order of `skills/list_landmarks`.",
        type="geometry_msgs/msg/PoseArray",
        qos=LATEST,
    ),
    TopicInterface(
        "markers",
        "skill_server",
        "Rooms, doors, objects and robots of this floor.",
        type="visualization_msgs/msg/MarkerArray",
        qos=LATEST,
    ),
    TopicInterface(
        "path",
        "skill_server",
        "The way of the last motion.",
        type="nav_msgs/msg/Path",
        qos=LATEST,
    ),
    TopicInterface(
        "/map",
        "skill_server",
        "Occupancy of this floor, 0.05 m; `origin.z` is its elevation.",
        type="nav_msgs/msg/OccupancyGrid",
        qos=LATEST,
    ),
    TopicInterface(
        "/tf",
        "skill_server",
        "`map` -> `odom` -> `base_link`.",
        type="tf2_msgs/msg/TFMessage",
        qos=Qos(depth=100),
    ),
    TopicInterface(
        "/tf_static",
        "skill_server",
        "`map` -> `floor_k`, `base_link` -> `base_scan`.",
        type="tf2_msgs/msg/TFMessage",
        qos=LATEST,
    ),
    TopicInterface("/odom", "skill_server", "Odometry.", type="nav_msgs/msg/Odometry", qos=STREAM),
    TopicInterface(
        "/scan",
        "skill_server",
        "A 2D laser, 360 rays, 10 Hz while someone listens.",
        type="sensor_msgs/msg/LaserScan",
        qos=SENSOR,
    ),
    TopicInterface(
        "/cmd_vel",
        "skill_server",
        "Drives the robot: forward and turning speed (read by the node).",
        type="geometry_msgs/msg/Twist",
        qos=STREAM,
    ),
    TopicInterface(
        "/clock",
        "skill_server",
        "The world's clock, with the parameter `publish_clock`.",
        type="rosgraph_msgs/msg/Clock",
        qos=Qos(depth=1, reliability="best_effort"),
    ),
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
        "scene/open",
        "scene_editor",
        "Open a building for editing under a name.",
        OpenEditorArgs,
        EditorInfo,
        '{"path": "/tmp/flat", "who": "ann"}',
    ),
    ServiceInterface(
        "scene/check_path",
        "scene_editor",
        "Tool CheckPath: does a way lead from one place to another.",
        CheckPathArgs,
        PathReport,
        '{"end": "F2/office_1"}',
    ),
    ServiceInterface(
        "scene/search_assets",
        "scene_editor",
        "Tool SearchAssets: new objects by words.",
        SearchAssetsArgs,
        AssetHits,
        '{"query": "cold drink", "properties": ["Pickable"]}',
    ),
    ServiceInterface(
        "scene/list_objects",
        "scene_editor",
        "Tool ListObjects: objects by room, keyword or id.",
        ListObjectsArgs,
        ObjectList,
        '{"keyword": "fridge"}',
    ),
    ServiceInterface(
        "scene/check_surface",
        "scene_editor",
        "Tool CheckSurface: what rests on a receptacle.",
        CheckSurfaceArgs,
        ReceptacleReport,
        '{"keyword": "desk"}',
    ),
    ServiceInterface(
        "scene/search_contents",
        "scene_editor",
        "Tool SearchContents: what lies in a container.",
        SearchContentsArgs,
        ReceptacleReport,
        '{"keyword": "fridge"}',
    ),
    ServiceInterface(
        "scene/place_in_container",
        "scene_editor",
        "Tool PlaceInContainer: a new object, settled by physics.",
        PlaceInContainerArgs,
        EditResult,
        '{"asset_id": "cola_can_1", "container_id": "F1/kitchen/fridge_1"}',
    ),
    ServiceInterface(
        "scene/place_on_surface",
        "scene_editor",
        "Tool PlaceOnSurface: a new object, settled by physics.",
        PlaceOnSurfaceArgs,
        EditResult,
        '{"asset_id": "cola_can_1", "receptacle_id": "F1/kitchen/table_1"}',
    ),
    ServiceInterface(
        "scene/remove_object",
        "scene_editor",
        "Tool RemoveObject: an object, or all that a receptacle carries.",
        RemoveObjectArgs,
        EditResult,
        '{"object_id": "F1/kitchen/mug_1"}',
    ),
    ServiceInterface(
        "scene/move_object",
        "scene_editor",
        "Move an object with what it carries.",
        MoveObjectArgs,
        EditResult,
        '{"object_id": "F1/kitchen/mug_1", "receptacle_id": "F1/kitchen/table_1"}',
    ),
    ServiceInterface(
        "scene/set_state",
        "scene_editor",
        "Open, close or switch an object in the scene.",
        SetStateArgs,
        EditResult,
        '{"object_id": "F1/kitchen/fridge_1", "open": true}',
    ),
    ServiceInterface(
        "scene/undo",
        "scene_editor",
        "Take back the last edit.",
        ToolArgs,
        EditResult,
        "{}",
    ),
    ServiceInterface(
        "scene/redo",
        "scene_editor",
        "Do again what was undone last.",
        ToolArgs,
        EditResult,
        "{}",
    ),
    ServiceInterface(
        "scene/diff",
        "scene_editor",
        "What waits to be saved.",
        ToolArgs,
        DiffReport,
        "{}",
    ),
    ServiceInterface(
        "scene/save",
        "scene_editor",
        "Land what waits as one transaction.",
        ToolArgs,
        EditResult,
        "{}",
    ),
    ServiceInterface(
        "scene/instruct",
        "scene_editor",
        "The editing agent: check an instruction's facts, provision what is missing.",
        InstructArgs,
        AgentReport,
        '{"instruction": "make sure there is a cola in the fridge"}',
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
        "skills/move_to",
        "skill_server",
        "Go to a point of this floor.",
        MoveToArgs,
        SkillResult,
        '{"x": 3.0, "y": 2.5, "yaw": 90}',
    ),
    ServiceInterface(
        "skills/go_near_object",
        "skill_server",
        "Go to where an object can be reached and face it.",
        NearObjectArgs,
        SkillResult,
        '{"object": "F1/lobby/mug_1"}',
    ),
    ServiceInterface(
        "skills/move_ahead",
        "skill_server",
        "Go straight ahead, or back.",
        MoveAheadArgs,
        SkillResult,
        '{"distance": 0.5}',
    ),
    ServiceInterface(
        "skills/rotate",
        "skill_server",
        "Turn on the spot, counter-clockwise.",
        RotateArgs,
        SkillResult,
        '{"degrees": 90}',
    ),
    ServiceInterface(
        "skills/look_up",
        "skill_server",
        "Tilt the camera up.",
        LookArgs,
        SkillResult,
        '{"degrees": 30}',
    ),
    ServiceInterface(
        "skills/look_down",
        "skill_server",
        "Tilt the camera down.",
        LookArgs,
        SkillResult,
        '{"degrees": 30}',
    ),
    ServiceInterface(
        "skills/open_door",
        "skill_server",
        "Open a door.",
        DoorArgs,
        SkillResult,
        '{"door": "F1/door_2"}',
    ),
    ServiceInterface(
        "skills/close_door",
        "skill_server",
        "Close a door.",
        DoorArgs,
        SkillResult,
        '{"door": "F1/door_2"}',
    ),
    ServiceInterface(
        "skills/open_object",
        "skill_server",
        "Open an object.",
        ObjectArgs,
        SkillResult,
        '{"object": "F1/kitchen/fridge_1"}',
    ),
    ServiceInterface(
        "skills/close_object",
        "skill_server",
        "Close an object.",
        ObjectArgs,
        SkillResult,
        '{"object": "F1/kitchen/fridge_1"}',
    ),
    ServiceInterface(
        "skills/pick_up",
        "skill_server",
        "Take an object into the hand.",
        ObjectArgs,
        SkillResult,
        '{"object": "F1/lobby/mug_1"}',
    ),
    ServiceInterface(
        "skills/place",
        "skill_server",
        "Put what is held on, in or in front of something.",
        PlaceArgs,
        SkillResult,
        '{"target": "F1/lobby/table_1", "relation": "on"}',
    ),
    ServiceInterface(
        "skills/toggle_on",
        "skill_server",
        "Switch an object on.",
        ObjectArgs,
        SkillResult,
        '{"object": "F1/lobby/floor_lamp_1"}',
    ),
    ServiceInterface(
        "skills/toggle_off",
        "skill_server",
        "Switch an object off.",
        ObjectArgs,
        SkillResult,
        '{"object": "F1/lobby/floor_lamp_1"}',
    ),
    ServiceInterface(
        "skills/where_am_i",
        "skill_server",
        "Floor, room, pose and held object.",
        None,
        WhereAmI,
    ),
    ServiceInterface(
        "skills/list_landmarks",
        "skill_server",
        "Rooms and cores of this floor.",
        SessionArgs,
        Landmarks,
        "{}",
    ),
    ServiceInterface(
        "skills/list_visible",
        "skill_server",
        "What the robot sees from where it stands.",
        VisibleArgs,
        VisibleObjects,
        '{"distance": 3.0}',
    ),
    ServiceInterface(
        "skills/plan_route",
        "skill_server",
        "The way to a room, core or object of any floor, leg by leg.",
        RouteArgs,
        Route,
        '{"target": "F3/office_1"}',
    ),
    ServiceInterface(
        "skills/cancel",
        "skill_server",
        "End the session's running skill; the robot stops where it is.",
        SessionArgs,
        SkillResult,
        "{}",
    ),
    ServiceInterface(
        "skills/take_control",
        "skill_server",
        "Become the only driver of a session.",
        ControlArgs,
        Control,
        '{"client": "me"}',
    ),
    ServiceInterface(
        "skills/release_control",
        "skill_server",
        "Let others drive again; needs the token.",
        ControlArgs,
        Control,
        '{"token": "..."}',
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
