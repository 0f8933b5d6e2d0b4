"""The table of topics and services: names below the namespace, types, payloads and QoS, written once.

A node asks for its interface by name (``service("plan_program")``). The services of the skills are declared beside each
skill; `mansion_bringup.interfaces` adds them and makes ``docs/interfaces.md`` from the whole table.
"""

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.editing.changes import DiffReport, EditResult
from mansion_msgs_py.editing.instructions import AgentReport, InstructArgs, ProvisionArgs
from mansion_msgs_py.editing.objects import (
    MoveObjectArgs,
    PaintObjectArgs,
    PlaceInContainerArgs,
    PlaceOnSurfaceArgs,
    RemoveObjectArgs,
    SetStateArgs,
    SwapObjectsArgs,
)
from mansion_msgs_py.editing.open_buildings import CanceledEdits, CancelEdit, EditorInfo, OpenEditorArgs, ToolArgs
from mansion_msgs_py.editing.questions import (
    AssetHits,
    CheckPathArgs,
    CheckSurfaceArgs,
    ListObjectsArgs,
    ObjectList,
    PathReport,
    ReceptacleReport,
    SearchAssetsArgs,
    SearchContentsArgs,
)
from mansion_msgs_py.editing.rooms import (
    ClearRoomArgs,
    FurnishRoomArgs,
    RenameRoomArgs,
    ReshapeFloorArgs,
    SetFinishArgs,
)
from mansion_msgs_py.interface_types import (
    CAMERA,
    DEFAULT_NAMESPACE,
    JSON_CALL,
    LATCHED,
    LATEST,
    SENSOR,
    STREAM,
    STRING,
    TRIGGER,
    Qos,
    ServiceInterface,
    TopicInterface,
)
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.skills import CameraNames, Control, ControlArgs, Loaded, SessionArgs
from mansion_msgs_py.stages import (
    BuildJob,
    BuildReply,
    CancelBuild,
    CanceledBuilds,
    CanceledPlans,
    CancelPlan,
    FurnishRequest,
    PlanReply,
)
from mansion_msgs_py.world import LiftRequest, LiftState, Progress, RobotState, SkillProgress, SkillResult, WorldEvent

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
    "service",
    "topic",
]

_SKILL_SERVER_TOPICS: tuple[TopicInterface, ...] = (
    TopicInterface("robot_state", "skill_server", "Where a robot is, after each change.", RobotState),
    TopicInterface("lift_state", "skill_server", "Each lift, once a second and on change.", LiftState),
    TopicInterface(
        "lift_requests",
        "skill_server",
        "Ask for a lift or end a session, as Open-RMF does (read by the node).",
        LiftRequest,
    ),
    TopicInterface("skill_progress", "skill_server", "Progress of a running skill.", SkillProgress),
    TopicInterface("world_events", "skill_server", "What each skill changed.", WorldEvent),
    TopicInterface(
        "robot_pose", "skill_server", "The robot in `map`.", type="geometry_msgs/msg/PoseStamped", qos=LATEST
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
    TopicInterface("path", "skill_server", "The way of the last motion.", type="nav_msgs/msg/Path", qos=LATEST),
    TopicInterface(
        "/map",
        "skill_server",
        "Occupancy of this floor, 0.05 m; `origin.z` is its elevation.",
        type="nav_msgs/msg/OccupancyGrid",
        qos=LATEST,
    ),
    TopicInterface(
        "/tf", "skill_server", "`map` -> `odom` -> `base_link`.", type="tf2_msgs/msg/TFMessage", qos=Qos(depth=100)
    ),
    TopicInterface(
        "/tf_static",
        "skill_server",
        "`map` -> `floor_k`, `base_link` -> `base_scan` and `imu_link`.",
        type="tf2_msgs/msg/TFMessage",
        qos=LATEST,
    ),
    TopicInterface(
        "/odom",
        "skill_server",
        "Odometry, 20 Hz: free of errors but for what its covariances say.",
        type="nav_msgs/msg/Odometry",
        qos=STREAM,
    ),
    TopicInterface(
        "/imu",
        "skill_server",
        "Heading, turning speed and acceleration with gravity, 20 Hz.",
        type="sensor_msgs/msg/Imu",
        qos=SENSOR,
    ),
    TopicInterface(
        "/scan",
        "skill_server",
        "A 2D laser, 360 rays, 10 Hz while someone listens.",
        type="sensor_msgs/msg/LaserScan",
        qos=SENSOR,
    ),
    TopicInterface(
        "camera/image",
        "skill_server",
        "What the robot sees, rgb8; this and the next four while someone listens.",
        type="sensor_msgs/msg/Image",
        qos=CAMERA,
    ),
    TopicInterface(
        "camera/depth",
        "skill_server",
        "Metres along the optical axis, 32FC1.",
        type="sensor_msgs/msg/Image",
        qos=CAMERA,
    ),
    TopicInterface(
        "camera/segmentation",
        "skill_server",
        "What each pixel shows, 32SC1: an index of `camera/names`, -1 the sky.",
        type="sensor_msgs/msg/Image",
        qos=CAMERA,
    ),
    TopicInterface(
        "camera/points",
        "skill_server",
        "What the camera sees as coloured points, in the order of the pixels; NaN is the sky.",
        type="sensor_msgs/msg/PointCloud2",
        qos=CAMERA,
    ),
    TopicInterface(
        "camera/camera_info",
        "skill_server",
        "Camera model of the image with the same stamp.",
        type="sensor_msgs/msg/CameraInfo",
        qos=CAMERA,
    ),
    TopicInterface(
        "camera/names",
        "skill_server",
        "What the labels mean, once somebody has listened to the segmentation.",
        CameraNames,
        qos=LATEST,
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

_SKILL_SERVER_SERVICES: tuple[ServiceInterface, ...] = (
    ServiceInterface(
        "load_building",
        "skill_server",
        "Put the robot into a building on disk.",
        LoadBuilding,
        Loaded,
        '{"path": "/tmp/flat"}',
        repeatable=True,
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


_BUILD_TOPICS: tuple[TopicInterface, ...] = (
    TopicInterface(
        "build_requests", "building_director", "A request to build; the answer comes as latched results.", BuildRequest
    ),
    TopicInterface("program", "program_planner", "The program of each building.", BuildingProgram, qos=LATCHED),
    TopicInterface("floor_layout", "floor_solver", "The layout of each floor.", FloorLayout, qos=LATCHED),
    TopicInterface(
        "floor_scene",
        "object_placer",
        "The furnished floor, one message a floor; from `scene_editor` again after an edit.",
        FloorScene,
        qos=LATCHED,
    ),
    TopicInterface("progress", "building_director", "Progress of a job.", Progress),
    TopicInterface(
        "/diagnostics",
        "every node",
        "What each node does and how many calls it served, once a second.",
        type="diagnostic_msgs/msg/DiagnosticArray",
    ),
)

_BUILD_SERVICES: tuple[ServiceInterface, ...] = (
    ServiceInterface(
        "plan_program",
        "program_planner",
        "Program, room graphs and solver problems of a request.",
        BuildRequest,
        PlanReply,
        '{"description": "a two-storey library"}',
        repeatable=True,
    ),
    ServiceInterface(
        "solve_floor",
        "floor_solver",
        "The layout of one floor.",
        FloorProblem,
        FloorLayout,
        '{"boundary": [[0,0],[6,0],[6,4],[0,4]], "nodes": [{"id": "hall", "type": "main"}]}',
        repeatable=True,
    ),
    ServiceInterface(
        "furnish_floor",
        "object_placer",
        "The furnished scene of one floor.",
        FurnishRequest,
        FloorScene,
        repeatable=True,
    ),
    ServiceInterface(
        "build_building",
        "building_director",
        "A whole building, written to a folder.",
        BuildJob,
        BuildReply,
        '{"description": "a small flat", "output": "/tmp/flat"}',
        repeatable=True,
    ),
    ServiceInterface(
        "cancel_build",
        "building_director",
        "Cancel running builds; their calls are answered with `CANCELED`.",
        CancelBuild,
        CanceledBuilds,
        '{"output": "/tmp/flat"}',
        repeatable=True,
    ),
    ServiceInterface(
        "cancel_plan",
        "program_planner",
        "Cancel the running plan; its call is answered with `CANCELED`.",
        CancelPlan,
        CanceledPlans,
        "{}",
        repeatable=True,
    ),
)


_EDITING_SERVICES: tuple[ServiceInterface, ...] = (
    ServiceInterface(
        "scene/open",
        "scene_editor",
        "Open a building for editing under a name.",
        OpenEditorArgs,
        EditorInfo,
        '{"path": "/tmp/flat", "who": "ann"}',
        repeatable=True,
    ),
    ServiceInterface(
        "scene/check_path",
        "scene_editor",
        "Tool CheckPath: does a way lead from one place to another.",
        CheckPathArgs,
        PathReport,
        '{"end": "F2/office_1"}',
        repeatable=True,
    ),
    ServiceInterface(
        "scene/search_assets",
        "scene_editor",
        "Tool SearchAssets: new objects by words.",
        SearchAssetsArgs,
        AssetHits,
        '{"query": "cold drink", "properties": ["Pickable"]}',
        repeatable=True,
    ),
    ServiceInterface(
        "scene/list_objects",
        "scene_editor",
        "Tool ListObjects: objects by room, keyword or id.",
        ListObjectsArgs,
        ObjectList,
        '{"keyword": "fridge"}',
        repeatable=True,
    ),
    ServiceInterface(
        "scene/check_surface",
        "scene_editor",
        "Tool CheckSurface: what rests on a receptacle.",
        CheckSurfaceArgs,
        ReceptacleReport,
        '{"keyword": "desk"}',
        repeatable=True,
    ),
    ServiceInterface(
        "scene/search_contents",
        "scene_editor",
        "Tool SearchContents: what lies in a container.",
        SearchContentsArgs,
        ReceptacleReport,
        '{"keyword": "fridge"}',
        repeatable=True,
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
        "scene/paint_object",
        "scene_editor",
        "Give an object another colour or material.",
        PaintObjectArgs,
        EditResult,
        '{"object_id": "F1/kitchen/table_1", "color": "red"}',
    ),
    ServiceInterface(
        "scene/swap_objects",
        "scene_editor",
        "Exchange the places of two objects with what they carry.",
        SwapObjectsArgs,
        EditResult,
        '{"object_id": "F1/kitchen/mug_1", "other_id": "F1/kitchen/bowl_1"}',
    ),
    ServiceInterface(
        "scene/rename_room",
        "scene_editor",
        "Tool RenameRoom: what people call a room from now on.",
        RenameRoomArgs,
        EditResult,
        '{"room_id": "F1/kitchen", "name": "Canteen"}',
    ),
    ServiceInterface(
        "scene/set_finish",
        "scene_editor",
        "Tool SetFinish: walls, floor or ceiling of a room.",
        SetFinishArgs,
        EditResult,
        '{"room_id": "F1/kitchen", "part": "walls", "color": "green"}',
    ),
    ServiceInterface(
        "scene/clear_room",
        "scene_editor",
        "Tool ClearRoom: take out all that is not fixed to the building.",
        ClearRoomArgs,
        EditResult,
        '{"room_id": "F1/kitchen"}',
    ),
    ServiceInterface(
        "scene/furnish_room",
        "scene_editor",
        "Tool FurnishRoom: other furniture, for what the room is or for another use.",
        FurnishRoomArgs,
        EditResult,
        '{"room_id": "F1/storage", "room_type": "private_office"}',
    ),
    ServiceInterface(
        "scene/reshape_floor",
        "scene_editor",
        "Tool ReshapeFloor: a room larger or smaller, a door, rooms that change places, one more stair or lift.",
        ReshapeFloorArgs,
        EditResult,
        '{"what": "area", "room_id": "F1/kitchen", "area": 2.0}',
    ),
    ServiceInterface("scene/undo", "scene_editor", "Take back the last edit.", ToolArgs, EditResult, "{}"),
    ServiceInterface("scene/redo", "scene_editor", "Do again what was undone last.", ToolArgs, EditResult, "{}"),
    ServiceInterface(
        "scene/diff", "scene_editor", "Changes that are not saved yet.", ToolArgs, DiffReport, "{}", repeatable=True
    ),
    ServiceInterface(
        "scene/save", "scene_editor", "Save these changes as one transaction.", ToolArgs, EditResult, "{}"
    ),
    ServiceInterface(
        "scene/cancel",
        "scene_editor",
        "Cancel the running edit; its call is answered with `CANCELED` and nothing of it is saved.",
        CancelEdit,
        CanceledEdits,
        "{}",
        repeatable=True,
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
        "scene/provision",
        "scene_editor",
        "Make a task possible: check what it needs, provide what is missing, check the ways.",
        ProvisionArgs,
        AgentReport,
        '{"task": {"id": "pen", "kind": "deliver", "instruction": "Fetch a pen from the desk.", '
        '"needs": [{"noun": "pen", "relation": "on", "receptacle": "desk", "role": "target"}]}}',
    ),
)


TOPICS: tuple[TopicInterface, ...] = (*_BUILD_TOPICS, *_SKILL_SERVER_TOPICS)

SERVICES: tuple[ServiceInterface, ...] = (*_BUILD_SERVICES, *_SKILL_SERVER_SERVICES, *_EDITING_SERVICES)


def topic(name: str) -> TopicInterface:
    """Return the topic of that name; KeyError when the table has none."""
    return _TOPICS[name]


def service(name: str) -> ServiceInterface:
    """Return the service of that name; KeyError when the table has none."""
    return _SERVICES[name]


_TOPICS = {entry.name: entry for entry in TOPICS}
_SERVICES = {entry.name: entry for entry in SERVICES}
