"""One robot's topics for robot stacks: map, frames, odometry, inertial unit, laser, markers and velocity commands."""

from array import array
from collections.abc import Iterable
from math import radians
from time import monotonic
from typing import Any

import numpy as np
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, PoseArray, PoseStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from rclpy.callback_groups import CallbackGroup
from rclpy.node import Node
from sensor_msgs.msg import Imu, LaserScan
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from mansion_geometry.disc_cells import stamp_disc
from mansion_geometry.floor_grid import RESOLUTION
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_msgs_py.world import Pose2D
from mansion_skills.engine.motion import MotionState, VelocityCommand
from mansion_skills.engine.session import Session
from mansion_skills.navigation.grid_kernels import cast_rays
from mansion_skills.nodes.robot_names import RobotNames
from mansion_skills.nodes.transforms import TransformPublisher, between, heading, pose, transform
from mansion_skills.world.world import World

__all__ = ["PERIOD", "RobotStack", "floor_markers"]

ROOM = (0.35, 0.45, 0.6, 1.0)
DOOR_OPEN, DOOR_CLOSED = (0.2, 0.7, 0.3, 1.0), (0.8, 0.2, 0.2, 1.0)
OBJECT, PICKUPABLE = (0.65, 0.55, 0.4, 0.8), (0.95, 0.7, 0.1, 1.0)
ROBOT = (0.1, 0.3, 0.9, 1.0)

RAYS = 360

RANGE = (0.05, 12.0)
"""Minimum and maximum range of the laser, metres."""

LASER_HEIGHT = 0.2

IMU_HEIGHT = 0.1

GRAVITY = 9.81

PERIOD = 0.1
"""Seconds between two scans."""

SURE, UNSURE = 1e-4, 1e-6
"""Variances of the wheel odometry (1 cm, 0.6 degrees), and of motions that a robot on a flat floor cannot make."""


def floor_markers(world: World, floor: int, frame: str, stamp: Time) -> MarkerArray:
    """Return the markers of a floor in the frame of the building; they replace those of the floor before."""
    elevation = world.building.entry(floor).elevation
    clear = Marker(action=Marker.DELETEALL)
    clear.header.frame_id, clear.header.stamp = frame, stamp
    markers = [clear]

    def add(space: str, kind: int, color: tuple[float, float, float, float]) -> Marker:
        marker = Marker(ns=space, id=len(markers), type=kind, action=Marker.ADD)
        marker.header.frame_id, marker.header.stamp = frame, stamp
        marker.color = ColorRGBA(r=color[0], g=color[1], b=color[2], a=color[3])
        marker.pose.orientation = heading(0.0)
        markers.append(marker)
        return marker

    view = world.view(floor)
    for room in view.scene.rooms:
        outline = add("rooms", Marker.LINE_STRIP, ROOM)
        outline.scale.x = 0.05
        outline.points = _points([*room.polygon, room.polygon[0]], elevation + 0.02)
        name = add("room_names", Marker.TEXT_VIEW_FACING, ROOM)
        name.scale.z, name.text = 0.4, room.name or room.id
        x, y = (sum(p[i] for p in room.polygon) / len(room.polygon) for i in (0, 1))
        name.pose = pose(Pose2D(x=x, y=y), elevation + 0.5)
    for door in view.scene.doors:
        is_open = world.doors.get(door.id, door.is_open)
        line = add("doors", Marker.LINE_STRIP, DOOR_OPEN if is_open else DOOR_CLOSED)
        line.scale.x = 0.1
        line.points = _points(door.segment, elevation + 0.05)
    for state in world.objects.on_floor(floor):
        kind = world.objects.kinds[state.id]
        if state.position is None:
            continue
        box = add("objects", Marker.CUBE, PICKUPABLE if kind.pickupable else OBJECT)
        box.scale.x, box.scale.y, box.scale.z = (float(edge) for edge in kind.size)
        x, y, z = state.position
        box.pose = pose(Pose2D(x=x, y=y, yaw=state.rotation), elevation + z)
    for robot in world.robots.values():
        if robot.floor == floor:
            body = add("robots", Marker.CYLINDER, ROBOT)
            body.scale.x = body.scale.y = 2 * robot.radius
            body.scale.z = 1.2
            body.pose = pose(robot.pose, elevation + 0.6)
    return MarkerArray(markers=markers)


def _points(line: Iterable[tuple[float, float]], z: float) -> list[Point]:
    return [Point(x=float(x), y=float(y), z=z) for x, y in line]


class RobotStack:
    """Publishers and the drive subscription of one session, for as long as the node lives.

    A session that loads another building keeps its topics: rclpy does not survive that a publisher is destroyed while
    an executor waits.

    Parameters
    ----------
    names : RobotNames
    group : CallbackGroup
        Callback group of velocity commands.
    """

    def __init__(self, node: Node, names: RobotNames, group: CallbackGroup) -> None:
        self._node = node
        self._names = names
        self.session: Session | None = None
        self.drive = VelocityCommand()
        self._floor: int | None = None
        self._mapped: tuple[int, int] | None = None
        self._viewers = 0
        self._shown: list[tuple[float, float]] | None = None
        self._stale_markers = True
        self._speed = (monotonic(), 0.0)
        self._pose = self._make(PoseStamped, "robot_pose")
        self._landmarks = self._make(PoseArray, "landmarks")
        self._markers = self._make(MarkerArray, "markers")
        self._path = self._make(Path, "path")
        self._map = self._make(OccupancyGrid, "/map")
        self._tf = TransformPublisher(node, names.interface("/tf"))
        self._tf_static = TransformPublisher(node, names.interface("/tf_static"))
        self._odom = self._make(Odometry, "/odom")
        self._imu = self._make(Imu, "/imu")
        self._scan = self._make(LaserScan, "/scan")
        entry = names.interface("/cmd_vel")
        node.create_subscription(Twist, entry.name, self._command, qos_profile(entry.qos), callback_group=group)

    def _make(self, kind: type, name: str) -> Any:
        entry = self._names.interface(name)
        return self._node.create_publisher(kind, entry.name, qos_profile(entry.qos))

    def show(self, session: Session) -> None:
        """Serve a session's robot from now on; the caller holds the lock of its world."""
        self.session = session
        self.drive.stop()
        self._floor = self._mapped = self._shown = None
        self.publish_all(session)

    def _command(self, message: Twist) -> None:
        self.drive.command(message.linear.x, message.angular.z, monotonic())

    def _now(self) -> Any:
        return self._node.get_clock().now().to_msg()

    def publish_all(self, session: Session) -> None:
        """Publish what a change has touched, but the pose, which goes out 20 times a second; the world is locked."""
        stamp = self._now()
        robot = session.robot
        if self._floor is None:
            self._publish_static(session, stamp)
        if self._floor != robot.floor:
            self._floor = robot.floor
            self._publish_landmarks(session, stamp)
        self._publish_map(session, stamp)
        self._stale_markers = True
        if self._shown is not robot.path:
            self._publish_path(session, stamp)

    def _publish_path(self, session: Session, stamp: Any) -> None:
        robot = session.robot
        self._shown = robot.path
        path = Path()
        path.header.frame_id, path.header.stamp = self._names.frame("map"), stamp
        for x, y in robot.path:
            point = PoseStamped()
            point.header = path.header
            point.pose = pose(Pose2D(x=x, y=y), _elevation(session))
            path.poses.append(point)
        self._path.publish(path)

    def follow(self, session: Session, floor: int) -> None:
        """Publish the map when another robot changed something on this one's floor."""
        if floor == session.robot.floor:
            self._publish_map(session, self._now())
            self._stale_markers = True

    def publish_markers(self, session: Session) -> None:
        """Publish markers when they are out of date and somebody looks; the caller holds the world's lock."""
        viewers = self._markers.get_subscription_count()
        wanted = viewers > 0 and (self._stale_markers or viewers > self._viewers)
        self._viewers = viewers
        if wanted:
            self._stale_markers = False
            frame = self._names.frame("map")
            self._markers.publish(floor_markers(session.world, session.robot.floor, frame, self._now()))

    def _publish_static(self, session: Session, stamp: Any) -> None:
        building, frame = session.world.building, self._names.frame
        origin = Pose2D(x=0.0, y=0.0)
        frames = [
            transform(
                frame("map"), frame(f"floor_{floor}".replace("-", "m")), origin, building.entry(floor).elevation, stamp
            )
            for floor in building.floors
        ]
        for sensor, height in (("base_scan", LASER_HEIGHT), ("imu_link", IMU_HEIGHT)):
            frames.append(transform(frame("base_link"), frame(sensor), origin, height, stamp))
        self._tf_static.publish(frames)

    def _publish_landmarks(self, session: Session, stamp: Any) -> None:
        marks = PoseArray()
        marks.header.frame_id, marks.header.stamp = self._names.frame("map"), stamp
        z = _elevation(session)
        marks.poses = [pose(mark.pose, z) for mark in session.world.view(session.robot.floor).landmarks]
        self._landmarks.publish(marks)

    def _publish_map(self, session: Session, stamp: Any) -> None:
        grid = session.world.view(session.robot.floor).map
        if self._mapped == (session.robot.floor, grid.version):
            return
        self._mapped = (session.robot.floor, grid.version)
        message = OccupancyGrid()
        message.header.frame_id, message.header.stamp = self._names.frame("map"), stamp
        message.info.map_load_time = stamp
        message.info.resolution = RESOLUTION
        message.info.width, message.info.height = grid.frame.columns, grid.frame.rows
        message.info.origin = pose(Pose2D(x=grid.frame.x0, y=grid.frame.y0), _elevation(session))
        message.data = array("b", grid.occupancy().tobytes())
        self._map.publish(message)

    def publish_pose(self, session: Session) -> None:
        """Publish pose, frames, odometry and the inertial unit; the caller holds the world's lock."""
        stamp, now, frame = self._now(), monotonic(), self._names.frame
        z = _elevation(session)
        motion = session.motion(now)
        forward = motion.forward + self.drive.forward
        turning = motion.turning + self.drive.turning
        where = PoseStamped()
        where.header.frame_id, where.header.stamp = frame("map"), stamp
        where.pose = pose(motion.pose, z)
        self._pose.publish(where)
        shift = between(motion.pose, motion.odometry)
        self._tf.publish(
            [
                transform(frame("map"), frame("odom"), shift, z, stamp),
                transform(frame("odom"), frame("base_link"), motion.odometry, 0.0, stamp),
            ]
        )
        self._publish_odometry(motion, forward, turning, stamp)
        self._publish_imu(motion, forward, turning, now, stamp)

    def _publish_odometry(self, motion: MotionState, forward: float, turning: float, stamp: Any) -> None:
        odometry = Odometry()
        odometry.header.frame_id, odometry.header.stamp = self._names.frame("odom"), stamp
        odometry.child_frame_id = self._names.frame("base_link")
        odometry.pose.pose = pose(motion.odometry)
        odometry.pose.covariance = planar_covariance()
        odometry.twist.twist.linear.x = forward
        odometry.twist.twist.angular.z = turning
        odometry.twist.covariance = planar_covariance()
        self._odom.publish(odometry)

    def _publish_imu(self, motion: MotionState, forward: float, turning: float, now: float, stamp: Any) -> None:
        before, speed = self._speed
        self._speed = (now, forward)
        message = Imu()
        message.header.frame_id, message.header.stamp = self._names.frame("imu_link"), stamp
        message.orientation = heading(motion.odometry.yaw)
        message.angular_velocity.z = turning
        acceleration = message.linear_acceleration
        acceleration.x = (forward - speed) / max(now - before, 1e-3)
        acceleration.y = forward * turning
        acceleration.z = GRAVITY
        for covariance, variances in (
            (message.orientation_covariance, (UNSURE, UNSURE, SURE)),
            (message.angular_velocity_covariance, (UNSURE, UNSURE, SURE)),
            (message.linear_acceleration_covariance, (SURE, SURE, SURE)),
        ):
            covariance[0], covariance[4], covariance[8] = variances
        self._imu.publish(message)

    def publish_scan(self, session: Session) -> None:
        """Publish a scan when there are subscribers; the caller holds the world's lock."""
        if self._scan.get_subscription_count() == 0:
            return
        robot = session.robot
        grid = session.world.view(robot.floor).map
        occupied = grid.occupied
        others = session.world.others(robot.session, robot.floor)
        if others:
            occupied = occupied.copy()
            for x, y in others:
                row, column = grid.frame.coordinates(x, y)
                stamp_disc(occupied, row - 0.5, column - 0.5, robot.radius / RESOLUTION)
        here = session.motion(monotonic()).pose
        angles = radians(here.yaw) + np.linspace(-np.pi, np.pi, RAYS, endpoint=False)
        row, column = grid.frame.coordinates(here.x, here.y)
        ranges = cast_rays(occupied, row, column, angles, RANGE[1] / RESOLUTION) * RESOLUTION
        message = LaserScan()
        message.header.frame_id = self._names.frame("base_scan")
        message.header.stamp = self._now()
        message.angle_min, message.angle_max = -np.pi, np.pi - 2 * np.pi / RAYS
        message.angle_increment = 2 * np.pi / RAYS
        message.scan_time, message.range_min, message.range_max = PERIOD, RANGE[0], RANGE[1]
        ranges[ranges >= RANGE[1] - 1e-9] = np.inf
        message.ranges = array("f", ranges.astype(np.float32).tobytes())
        self._scan.publish(message)


def planar_covariance() -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return the covariance of a robot on a flat floor: x, y, z, and the turns about them, row by row."""
    return np.diag([SURE, SURE, UNSURE, UNSURE, UNSURE, SURE]).ravel()


def _elevation(session: Session) -> float:
    return session.world.building.entry(session.robot.floor).elevation
