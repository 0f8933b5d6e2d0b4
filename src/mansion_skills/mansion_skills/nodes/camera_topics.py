"""One robot's camera as topics: images, their camera model, what labels mean, and the frame they are taken in."""

from array import array
from dataclasses import dataclass, replace
from math import cos, radians, sin
from typing import Any

from builtin_interfaces.msg import Time
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, Image
from tf2_msgs.msg import TFMessage

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import TopicInterface, topic
from mansion_msgs_py.nodes.shell import JsonPublisher, qos_profile
from mansion_msgs_py.skills import CameraNames
from mansion_skills.engine.seat import Seat
from mansion_skills.skills.seeing import CAMERA_HEIGHT
from mansion_skills.vision import Camera, Intrinsics
from mansion_skills.world.overlay import DEFAULT_SESSION

__all__ = ["FRAME", "CameraSettings", "CameraTopics"]

FRAME = "camera_optical_frame"
"""z forward, x to the right, y down (REP-103)."""


@dataclass(frozen=True)
class CameraSettings:
    """Pixels, and degrees across."""

    width: int = 300
    height: int = 300
    fov: float = 90.0


class CameraTopics:
    """Publishes a session's camera while someone listens; opens OpenGL when somebody first does.

    Names are as those of `RobotStack`: below the node's namespace, with the session's name in front when it is not
    the default one.
    """

    def __init__(self, node: Node, seat: Seat, settings: CameraSettings) -> None:
        self._node = node
        self._seat = seat
        self._settings = settings
        self._camera: Camera | None = None
        self._failed = False
        self._told = 0
        self._rgb = self._make(Image, "camera/image")
        self._depth = self._make(Image, "camera/depth")
        self._labels = self._make(Image, "camera/segmentation")
        self._info = self._make(CameraInfo, "camera/camera_info")
        self._names = JsonPublisher(node, self._entry("camera/names"))
        self._tf = self._make(TFMessage, "/tf")

    def _entry(self, name: str) -> TopicInterface:
        entry = topic(name)
        if self._seat.session == DEFAULT_SESSION:
            return entry
        absolute = f"/{self._seat.session}{name}"
        return replace(
            entry, name=absolute if name.startswith("/") else f"{self._seat.session}/{name}"
        )

    def _make(self, kind: type, name: str) -> Any:
        entry = self._entry(name)
        return self._node.create_publisher(kind, entry.name, qos_profile(entry.qos))

    def close(self) -> None:
        """Take the topics away and free the camera."""
        for publisher in (self._rgb, self._depth, self._labels, self._info, self._tf):
            self._node.destroy_publisher(publisher)
        self._node.destroy_publisher(self._names.publisher)
        if self._camera is not None:
            self._camera.close()
            self._camera = None

    def publish(self) -> None:
        """Take a picture and publish what somebody listens to."""
        rgb, depth, labels, info = (
            publisher.get_subscription_count() > 0
            for publisher in (self._rgb, self._depth, self._labels, self._info)
        )
        camera = self._opened() if rgb or depth or labels or info else None
        if camera is None:
            return
        stamp = self._node.get_clock().now().to_msg()
        self._tf.publish(TFMessage(transforms=[_optical_frame(self._seat.robot.pitch, stamp)]))
        if info:
            self._info.publish(camera_info(camera.intrinsics, stamp))
        if not (rgb or depth or labels):
            return
        try:
            frame = camera.render(rgb=rgb, depth=depth, segmentation=labels)
        except MansionError as error:
            self._fail(error)
            return
        if labels and self._told != len(frame.names):
            self._told = len(frame.names)
            building = self._seat.world.building.building_id
            names = CameraNames(
                names=list(frame.names), session=self._seat.session, building_id=building
            )
            self._names.publish(names)
        for wanted, publisher, encoding, pixels in (
            (rgb, self._rgb, "rgb8", frame.rgb),
            (depth, self._depth, "32FC1", frame.depth),
            (labels, self._labels, "32SC1", frame.segmentation),
        ):
            if wanted:
                publisher.publish(image(pixels, encoding, stamp))

    def _opened(self) -> Camera | None:
        if self._camera is None and not self._failed:
            size = self._settings
            try:
                self._camera = Camera(self._seat, size.width, size.height, size.fov)
            except MansionError as error:
                self._fail(error)
        return self._camera

    def _fail(self, error: MansionError) -> None:
        """Say once why there are no pictures, and make no more of them until the building is loaded anew."""
        self._failed = True
        self._node.get_logger().error(f"there will be no camera images: {error}")
        if self._camera is not None:
            self._camera.close()
            self._camera = None


def image(pixels: Any, encoding: str, stamp: Time) -> Image:
    """Return an array as an image message; its bytes are in this machine's order, which is little-endian."""
    message = Image()
    message.header.frame_id, message.header.stamp = FRAME, stamp
    message.height, message.width = pixels.shape[:2]
    message.encoding = encoding
    message.is_bigendian = 0
    message.step = pixels.strides[0]
    message.data = array("B", pixels.tobytes())
    return message


def camera_info(intrinsics: Intrinsics, stamp: Time) -> CameraInfo:
    """Return the camera model: a pinhole without distortion."""
    focal, (cx, cy) = intrinsics.focal, intrinsics.center
    message = CameraInfo()
    message.header.frame_id, message.header.stamp = FRAME, stamp
    message.height, message.width = intrinsics.height, intrinsics.width
    message.distortion_model = "plumb_bob"
    message.d = [0.0] * 5
    message.k = [focal, 0.0, cx, 0.0, focal, cy, 0.0, 0.0, 1.0]
    message.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    message.p = [focal, 0.0, cx, 0.0, 0.0, focal, cy, 0.0, 0.0, 0.0, 1.0, 0.0]
    return message


def _optical_frame(pitch: float, stamp: Time) -> TransformStamped:
    """Return the optical frame in ``base_link``, for a camera that is tilted up by `pitch` degrees."""
    message = TransformStamped()
    message.header.frame_id, message.header.stamp = "base_link", stamp
    message.child_frame_id = FRAME
    message.transform.translation.z = CAMERA_HEIGHT
    # Looking along x is (-0.5, 0.5, -0.5, 0.5); tilting up is a turn about -y before it.
    half = radians(-pitch) / 2
    c, s = 0.5 * cos(half), 0.5 * sin(half)
    rotation = message.transform.rotation
    rotation.x, rotation.y, rotation.z, rotation.w = -c - s, c + s, s - c, c - s
    return message
