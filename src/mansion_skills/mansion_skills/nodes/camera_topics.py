"""One robot's camera as topics: images, their camera model, what labels mean, and the frame they are taken in."""

from array import array
from dataclasses import dataclass
from math import cos, radians, sin
from typing import Any

import numpy as np
from builtin_interfaces.msg import Time
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.nodes.shell import JsonPublisher, qos_profile
from mansion_msgs_py.skills import CameraNames
from mansion_skills.engine.session import Session
from mansion_skills.nodes.robot_names import RobotNames
from mansion_skills.nodes.transforms import TransformPublisher
from mansion_skills.skills.visibility import CAMERA_HEIGHT
from mansion_skills.vision import Camera, Intrinsics

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
    """Publishes a session's camera while someone listens, for as long as the node lives.

    Parameters
    ----------
    names : RobotNames
    settings : CameraSettings
    """

    def __init__(self, node: Node, names: RobotNames, settings: CameraSettings) -> None:
        self._node = node
        self._topics = names
        self._frame = names.frame(FRAME)
        self._settings = settings
        self._session: Session | None = None
        self._camera: Camera | None = None
        self._failed = False
        self._announced = 0
        self._rgb = self._make(Image, "camera/image")
        self._depth = self._make(Image, "camera/depth")
        self._labels = self._make(Image, "camera/segmentation")
        self._points = self._make(PointCloud2, "camera/points")
        self._info = self._make(CameraInfo, "camera/camera_info")
        self._names = JsonPublisher(node, names.interface("camera/names"))
        self._tf = TransformPublisher(node, names.interface("/tf"))

    def _make(self, kind: type, name: str) -> Any:
        entry = self._topics.interface(name)
        return self._node.create_publisher(kind, entry.name, qos_profile(entry.qos))

    def show(self, session: Session) -> None:
        """Show the camera of a session's robot from now on."""
        self.close()
        self._session, self._failed, self._announced = session, False, 0

    def close(self) -> None:
        """Free the camera."""
        if self._camera is not None:
            self._camera.close()
            self._camera = None

    def publish(self) -> None:
        """Take a picture and publish the topics that have subscribers."""
        rgb, depth, labels, points, info = (
            publisher.get_subscription_count() > 0
            for publisher in (self._rgb, self._depth, self._labels, self._points, self._info)
        )
        session = self._session
        camera = self._opened(session) if rgb or depth or labels or points or info else None
        if camera is None or session is None:
            return
        stamp = self._node.get_clock().now().to_msg()
        base = self._topics.frame("base_link")
        self._tf.publish([_optical_frame(base, self._frame, session.robot.pitch, stamp)])
        if info:
            self._info.publish(camera_info(camera.intrinsics, self._frame, stamp))
        if not (rgb or depth or labels or points):
            return
        try:
            frame = camera.render(rgb=rgb or points, depth=depth or points, segmentation=labels)
        except MansionError as error:
            self._fail(error)
            return
        if labels and self._announced != len(frame.names):
            self._announced = len(frame.names)
            building = session.world.building.building_id
            names = CameraNames(names=list(frame.names), session=session.name, building_id=building)
            self._names.publish(names)
        for wanted, publisher, encoding, pixels in (
            (rgb, self._rgb, "rgb8", frame.rgb),
            (depth, self._depth, "32FC1", frame.depth),
            (labels, self._labels, "32SC1", frame.segmentation),
        ):
            if wanted:
                publisher.publish(image(pixels, encoding, self._frame, stamp))
        if points:
            cloud = point_cloud(frame.depth, frame.rgb, camera.intrinsics, self._frame, stamp)
            self._points.publish(cloud)

    def _opened(self, session: Session | None) -> Camera | None:
        if self._camera is None and session is not None and not self._failed:
            size = self._settings
            try:
                self._camera = Camera(session, size.width, size.height, size.fov)
            except MansionError as error:
                self._fail(error)
        return self._camera

    def _fail(self, error: MansionError) -> None:
        """Say once why there are no pictures, and make no more of them until the building is loaded again."""
        self._failed = True
        self._node.get_logger().error(f"there will be no camera images: {error}")
        self.close()


def image(pixels: Any, encoding: str, frame: str, stamp: Time) -> Image:
    """Return an array as an image message; its bytes are in this machine's order, which is little-endian."""
    message = Image()
    message.header.frame_id, message.header.stamp = frame, stamp
    message.height, message.width = pixels.shape[:2]
    message.encoding = encoding
    message.is_bigendian = 0
    message.step = pixels.strides[0]
    message.data = array("B", pixels.tobytes())
    return message


def camera_info(intrinsics: Intrinsics, frame: str, stamp: Time) -> CameraInfo:
    """Return the camera model: a pinhole without distortion."""
    focal, (cx, cy) = intrinsics.focal, intrinsics.center
    message = CameraInfo()
    message.header.frame_id, message.header.stamp = frame, stamp
    message.height, message.width = intrinsics.height, intrinsics.width
    message.distortion_model = "plumb_bob"
    message.d = [0.0] * 5
    message.k = [focal, 0.0, cx, 0.0, focal, cy, 0.0, 0.0, 1.0]
    message.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    message.p = [focal, 0.0, cx, 0.0, 0.0, focal, cy, 0.0, 0.0, 0.0, 1.0, 0.0]
    return message


def point_cloud(depth: Any, rgb: Any, intrinsics: Intrinsics, frame: str, stamp: Time) -> PointCloud2:
    """Return what the camera sees as points with colours, a row of the image a row of the cloud.

    Parameters
    ----------
    depth : (height, width) array of float32
        Metres along the optical axis; where nothing is, the sky, the point is NaN.
    rgb : (height, width, 3) array of uint8
    """
    height, width = depth.shape
    cx, cy = intrinsics.center
    rows, columns = np.indices((height, width), dtype=np.float32)
    away = np.where(np.isfinite(depth), depth, np.nan).astype(np.float32)
    cloud = np.empty((height, width), dtype=[(axis, "<f4") for axis in "xyz"] + [("rgb", "<u4")])
    cloud["x"] = (columns - cx) * away / intrinsics.focal
    cloud["y"] = (rows - cy) * away / intrinsics.focal
    cloud["z"] = away
    red, green, blue = (rgb[..., channel].astype(np.uint32) for channel in range(3))
    cloud["rgb"] = red << 16 | green << 8 | blue
    message = PointCloud2()
    message.header.frame_id, message.header.stamp = frame, stamp
    message.height, message.width = height, width
    # "rgb" is a float by PCL's convention, though its bits are four bytes of colour.
    message.fields = [
        PointField(name=name, offset=4 * index, datatype=PointField.FLOAT32, count=1)
        for index, name in enumerate(("x", "y", "z", "rgb"))
    ]
    message.is_bigendian, message.is_dense = False, False
    message.point_step, message.row_step = cloud.itemsize, cloud.itemsize * width
    message.data = array("B", cloud.tobytes())
    return message


def _optical_frame(base: str, frame: str, pitch: float, stamp: Time) -> TransformStamped:
    """Return the optical frame in the robot's, for a camera that is tilted up by `pitch` degrees."""
    message = TransformStamped()
    message.header.frame_id, message.header.stamp = base, stamp
    message.child_frame_id = frame
    message.transform.translation.z = CAMERA_HEIGHT
    # Looking along x is (-0.5, 0.5, -0.5, 0.5); tilting up is a turn about -y before it.
    half = radians(-pitch) / 2
    c, s = 0.5 * cos(half), 0.5 * sin(half)
    rotation = message.transform.rotation
    rotation.x, rotation.y, rotation.z, rotation.w = -c - s, c + s, s - c, c - s
    return message
