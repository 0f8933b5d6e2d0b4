"""The parameters of ``skill_server``: read once, at its start."""

from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node

from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["PARAMETERS", "declare_parameters"]

MOTIONS = ("fast", "realtime")
PIXELS = (16, 4096)

PARAMETERS: tuple[tuple[str, Any, str, tuple[float, float] | None], ...] = (
    ("building", "", "folder of a building to load at start", None),
    ("session", "", "session that loads it; the default robot when empty", None),
    ("motion", "fast", "fast: skills complete at once; realtime: they take their time", None),
    ("real_time_factor", 1.0, "seconds of the world for a second on the wall, with realtime motion", (0.01, 1000.0)),
    ("robot_radius", ROBOT_RADIUS, "metres", (0.05, 1.0)),
    ("durable", True, "sync every save to the disk", None),
    ("robot_stack", True, "publish map, frames, odometry, scan and markers", None),
    (
        "robot_namespace",
        "",
        "of map, odom, scan, cmd_vel, tf and clock: / for the global names; when empty, those in the namespace "
        "/mansion, and below the node's own namespace in any other",
        None,
    ),
    ("frame_prefix", "", "in front of every frame, as in site_b/", None),
    ("camera", True, "publish what the robots see while someone listens", None),
    ("camera_width", 300, "pixels", PIXELS),
    ("camera_height", 300, "pixels", PIXELS),
    ("camera_fov", 90.0, "of the camera, across, degrees", (1.0, 170.0)),
    ("camera_rate", 10.0, "images a second at most", (0.1, 100.0)),
    ("publish_clock", False, "publish the world's clock on /clock", None),
)
"""Name, default, description and range."""


def declare_parameters(node: Node) -> dict[str, Any]:
    """Declare the parameters and return their values.

    They are read only: to set one on the running server would change nothing.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a motion that there is not; rclpy itself refuses other types and values out of range.
    """
    value = {
        name: node.declare_parameter(name, default, _descriptor(text, default, limits)).value
        for name, default, text, limits in PARAMETERS
    }
    if value["motion"] not in MOTIONS:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"the parameter motion is {value['motion']!r}; {' and '.join(MOTIONS)} are accepted",
        )
    return value


def _descriptor(text: str, default: Any, limits: tuple[float, float] | None) -> ParameterDescriptor:
    descriptor = ParameterDescriptor(description=text, read_only=True)
    if limits is None:
        return descriptor
    lower, upper = limits
    if isinstance(default, int):
        descriptor.integer_range = [IntegerRange(from_value=int(lower), to_value=int(upper), step=1)]
    else:
        descriptor.floating_point_range = [FloatingPointRange(from_value=lower, to_value=upper)]
    return descriptor
