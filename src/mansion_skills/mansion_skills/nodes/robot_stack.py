"""One robot's topics for robot stacks: map, frames, odometry, laser, drive commands and pictures."""

from array import array
from math import radians
from time import monotonic

import numpy as np
from geometry_msgs.msg import PoseArray, PoseStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from rclpy.callback_groups import CallbackGroup
from rclpy.node import Node
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from mansion_msgs_py.interfaces import topic
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_msgs_py.world import Pose2D
from mansion_skills.engine.driving import Drive
from mansion_skills.engine.seat import Seat
from mansion_skills.navigation.floor_map import RESOLUTION
from mansion_skills.navigation.search import cast_rays, stamp_disc
from mansion_skills.nodes.frames import between, pose, transform
from mansion_skills.nodes.markers import floor_markers
from mansion_skills.world.overlay import DEFAULT_SESSION

__all__ = ["RobotStack"]

RAYS = 360
RANGE = (0.05, 12.0)
"""Shortest and longest range of the laser, metres."""

LASER_HEIGHT = 0.2
PERIOD = 0.1
"""Seconds between two scans."""


class RobotStack:
    """Publishers and the drive subscription of one session.

    The default session uses the absolute names (``/map``, ``/scan``, ...) and those below the node's namespace; any
    other one has its name in front (``/r2/map``, ``/mansion/r2/robot_pose``).
    """

    def __init__(self, node: Node, seat: Seat, group: CallbackGroup) -> None:
        self._node = node
        self.seat = seat
        self._prefix = "" if seat.session == DEFAULT_SESSION else seat.session
        self.drive = Drive()
        self.closed = False
        self._floor: int | None = None
        self._mapped: tuple[int, int] | None = None
        self._viewers = 0
        self._shown: list[tuple[float, float]] | None = None
        self._stale_markers = True
        self._pose = self._make(PoseStamped, "robot_pose")
        self._landmarks = self._make(PoseArray, "landmarks")
        self._markers = self._make(MarkerArray, "markers")
        self._path = self._make(Path, "path")
        self._map = self._make(OccupancyGrid, "/map")
        self._tf = self._make(TFMessage, "/tf")
        self._tf_static = self._make(TFMessage, "/tf_static")
        self._odom = self._make(Odometry, "/odom")
        self._scan = self._make(LaserScan, "/scan")
        entry = topic("/cmd_vel")
        self._commands = node.create_subscription(
            Twist,
            self._name(entry.name),
            self._command,
            qos_profile(entry.qos),
            callback_group=group,
        )

    def _name(self, name: str) -> str:
        if not self._prefix:
            return name
        return f"/{self._prefix}{name}" if name.startswith("/") else f"{self._prefix}/{name}"

    def _make(self, kind: type, name: str) -> object:
        entry = topic(name)
        return self._node.create_publisher(kind, self._name(name), qos_profile(entry.qos))

    def close(self) -> None:
        """Take the topics away; the caller holds the world's lock."""
        self.closed = True
        for publisher in (
            self._pose,
            self._landmarks,
            self._markers,
            self._path,
            self._map,
            self._tf,
            self._tf_static,
            self._odom,
            self._scan,
        ):
            self._node.destroy_publisher(publisher)
        self._node.destroy_subscription(self._commands)

    def _command(self, message: Twist) -> None:
        self.drive.command(message.linear.x, message.angular.z, monotonic())

    def _elevation(self) -> float:
        return self.seat.world.building.entry(self.seat.robot.floor).elevation

    def publish_all(self) -> None:
        """Publish what a change has touched, but the pose, which goes out 20 times a second; the world is locked."""
        stamp = self._node.get_clock().now().to_msg()
        robot = self.seat.robot
        if self._floor is None:
            self._publish_static(stamp)
        if self._floor != robot.floor:
            self._floor = robot.floor
            self._publish_landmarks(stamp)
        self._publish_map(stamp)
        self._stale_markers = True
        if self._shown is not robot.path:
            self._publish_path(stamp)

    def _publish_path(self, stamp: object) -> None:
        robot = self.seat.robot
        self._shown = robot.path
        path = Path()
        path.header.frame_id, path.header.stamp = "map", stamp
        for x, y in robot.path:
            point = PoseStamped()
            point.header = path.header
            point.pose = pose(Pose2D(x=x, y=y), self._elevation())
            path.poses.append(point)
        self._path.publish(path)

    def follow(self, floor: int) -> None:
        """Publish the map when another robot changed something on this one's floor."""
        if floor == self.seat.robot.floor:
            self._publish_map(self._node.get_clock().now().to_msg())
            self._stale_markers = True

    def publish_markers(self) -> None:
        """Publish markers when they are out of date and somebody looks; the caller holds the world's lock."""
        viewers = self._markers.get_subscription_count()
        wanted = viewers > 0 and (self._stale_markers or viewers > self._viewers)
        self._viewers = viewers
        if wanted:
            self._stale_markers = False
            stamp = self._node.get_clock().now().to_msg()
            self._markers.publish(floor_markers(self.seat.world, self.seat.robot.floor, stamp))

    def _publish_static(self, stamp: object) -> None:
        building = self.seat.world.building
        frames = [
            transform(
                "map",
                f"floor_{floor}".replace("-", "m"),
                Pose2D(x=0.0, y=0.0),
                building.entry(floor).elevation,
                stamp,
            )
            for floor in building.floors
        ]
        frames.append(
            transform("base_link", "base_scan", Pose2D(x=0.0, y=0.0), LASER_HEIGHT, stamp)
        )
        self._tf_static.publish(TFMessage(transforms=frames))

    def _publish_landmarks(self, stamp: object) -> None:
        marks = PoseArray()
        marks.header.frame_id, marks.header.stamp = "map", stamp
        z = self._elevation()
        marks.poses = [
            pose(mark.pose, z) for mark in self.seat.world.view(self.seat.robot.floor).landmarks
        ]
        self._landmarks.publish(marks)

    def _publish_map(self, stamp: object) -> None:
        grid = self.seat.world.view(self.seat.robot.floor).map
        if self._mapped == (self.seat.robot.floor, grid.version):
            return
        self._mapped = (self.seat.robot.floor, grid.version)
        message = OccupancyGrid()
        message.header.frame_id, message.header.stamp = "map", stamp
        message.info.map_load_time = stamp
        message.info.resolution = RESOLUTION
        message.info.width, message.info.height = grid.frame.columns, grid.frame.rows
        message.info.origin = pose(Pose2D(x=grid.frame.x0, y=grid.frame.y0), self._elevation())
        message.data = array("b", grid.occupancy().tobytes())
        self._map.publish(message)

    def publish_pose(self) -> None:
        """Publish pose, frames and odometry; the caller holds the world's lock."""
        stamp = self._node.get_clock().now().to_msg()
        robot, z = self.seat.robot, self._elevation()
        where = PoseStamped()
        where.header.frame_id, where.header.stamp = "map", stamp
        where.pose = pose(robot.pose, z)
        self._pose.publish(where)
        shift = between(robot.pose, robot.odometry)
        self._tf.publish(
            TFMessage(
                transforms=[
                    transform("map", "odom", shift, z, stamp),
                    transform("odom", "base_link", robot.odometry, 0.0, stamp),
                ]
            )
        )
        odometry = Odometry()
        odometry.header.frame_id, odometry.header.stamp = "odom", stamp
        odometry.child_frame_id = "base_link"
        odometry.pose.pose = pose(robot.odometry)
        odometry.twist.twist.linear.x = self.drive.forward
        odometry.twist.twist.angular.z = self.drive.turning
        self._odom.publish(odometry)

    def publish_scan(self) -> None:
        """Publish a scan when somebody listens; the caller holds the world's lock."""
        if self._scan.get_subscription_count() == 0:
            return
        robot = self.seat.robot
        grid = self.seat.world.view(robot.floor).map
        occupied = grid.occupied
        others = self.seat.world.others(robot.session, robot.floor)
        if others:
            occupied = occupied.copy()
            for x, y in others:
                row = (y - grid.frame.y0) / RESOLUTION - 0.5
                stamp_disc(
                    occupied, row, (x - grid.frame.x0) / RESOLUTION - 0.5, robot.radius / RESOLUTION
                )
        angles = radians(robot.pose.yaw) + np.linspace(-np.pi, np.pi, RAYS, endpoint=False)
        row = (robot.pose.y - grid.frame.y0) / RESOLUTION
        column = (robot.pose.x - grid.frame.x0) / RESOLUTION
        ranges = cast_rays(occupied, row, column, angles, RANGE[1] / RESOLUTION) * RESOLUTION
        message = LaserScan()
        message.header.frame_id = "base_scan"
        message.header.stamp = self._node.get_clock().now().to_msg()
        message.angle_min, message.angle_max = -np.pi, np.pi - 2 * np.pi / RAYS
        message.angle_increment = 2 * np.pi / RAYS
        message.scan_time, message.range_min, message.range_max = PERIOD, RANGE[0], RANGE[1]
        ranges[ranges >= RANGE[1] - 1e-9] = np.inf
        message.ranges = array("f", ranges.astype(np.float32).tobytes())
        self._scan.publish(message)
