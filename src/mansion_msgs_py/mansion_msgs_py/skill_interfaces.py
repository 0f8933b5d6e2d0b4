"""Topics of the skill server, and its services beside the skills, which `mansion_skills.skills` declares."""

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.interface_types import CAMERA, LATEST, SENSOR, STREAM, Qos, ServiceInterface, TopicInterface
from mansion_msgs_py.skills import CameraNames, Control, ControlArgs, Loaded, SessionArgs
from mansion_msgs_py.world import LiftRequest, LiftState, RobotState, SkillProgress, SkillResult, WorldEvent

__all__ = ["SERVICES", "TOPICS"]

TOPICS: tuple[TopicInterface, ...] = (
    TopicInterface("robot_state", "skill_server", "Where a robot is, after each change.", RobotState),
    TopicInterface("lift_state", "skill_server", "Each lift, once a second and on change.", LiftState),
    TopicInterface(
        "lift_requests",
        "skill_server",
        "Ask for a lift or end a session, as Open-RMF does (read by the node).",
        LiftRequest,
    ),
    TopicInterface("skill_progress", "skill_server", "How far a running skill is.", SkillProgress),
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
        "Of the image with the same stamp.",
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

SERVICES: tuple[ServiceInterface, ...] = (
    ServiceInterface(
        "load_building",
        "skill_server",
        "Put the robot into a building on disk.",
        LoadBuilding,
        Loaded,
        '{"path": "/tmp/flat"}',
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
