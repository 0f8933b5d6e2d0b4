"""``skill_server``: the skills as services, the robots' topics, and the lifts."""

import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from time import monotonic
from typing import Any

import msgspec
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from rosgraph_msgs.msg import Clock

from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import ServiceInterface, service, topic
from mansion_msgs_py.nodes.allowed_folders import declare_allowed_folders
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service, add_json_subscription, qos_profile
from mansion_msgs_py.skills import Loaded, SessionArgs
from mansion_msgs_py.world import LiftRequest, SkillProgress, SkillResult, SkillStatus, WorldEvent
from mansion_skills.engine import Engine
from mansion_skills.engine.executor import WorldClock
from mansion_skills.engine.motion import drive_for
from mansion_skills.engine.session import Session
from mansion_skills.nodes.camera_topics import CameraSettings, CameraTopics
from mansion_skills.nodes.robot_names import RobotNames, robot_namespace
from mansion_skills.nodes.robot_stack import PERIOD, RobotStack
from mansion_skills.nodes.transforms import MISSING, TransformPublisher
from mansion_skills.skills.registry import SKILLS
from mansion_skills.vision.offscreen import rendering_fault
from mansion_skills.world.overlay import DEFAULT_SESSION

__all__ = ["PARAMETERS", "SkillServer", "declare_parameters", "main"]

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
        "namespace of map, odom, scan, cmd_vel, tf and clock: / for the global names; if empty, the global names "
        "under /mansion and the node's own namespace elsewhere",
        None,
    ),
    ("frame_prefix", "", "prefix of every frame, such as site_b/", None),
    ("camera", True, "publish what the robots see while someone listens", None),
    ("camera_width", 300, "pixels", PIXELS),
    ("camera_height", 300, "pixels", PIXELS),
    ("camera_fov", 90.0, "horizontal field of view of the camera, degrees", (1.0, 170.0)),
    ("camera_rate", 10.0, "most images per second", (0.1, 100.0)),
    ("publish_clock", False, "publish the world's clock on /clock", None),
)
"""Name, default, description and range."""

UNTRIED, READY = "not tried yet", "ready"
"""What is known of making pictures here; anything else is why there are none."""

THREADS = 12
"""Enough for a full queue of skills beside cancel, questions and timers."""


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


class SkillServer(MansionNode):
    """Serves ``load_building`` and the skills; saves the world after each.

    What a session publishes is made once and kept: a session that loads another building swaps what its topics show.
    """

    def __init__(self) -> None:
        super().__init__("skill_server")
        value = declare_parameters(self)
        allowed = declare_allowed_folders(self, value["building"])
        self._open_topics(value)
        self.engine = Engine(
            WorldClock(realtime=value["motion"] == "realtime", factor=value["real_time_factor"]),
            radius=value["robot_radius"],
            durable=value["durable"],
            allowed=allowed,
            changed=self._changed,
            progress=self._report,
        )
        self._prepare_robots(value)
        self._open_services()
        self._start_timers(value["camera_rate"])
        # Last, because who starts the node takes this service for the sign that all of it is there.
        self._json("load_building", self.load)
        if value["building"]:
            self.load(LoadBuilding(path=value["building"], session=value["session"]))

    def _open_topics(self, value: dict[str, Any]) -> None:
        """Open the topics that all sessions share."""
        self._namespace = robot_namespace(value["robot_namespace"], self.get_namespace())
        self._frame_prefix = value["frame_prefix"]
        self._robot_state = JsonPublisher(self, topic("robot_state"))
        self._lift_state = JsonPublisher(self, topic("lift_state"))
        self._progress = JsonPublisher(self, topic("skill_progress"))
        self._events = JsonPublisher(self, topic("world_events"))
        self._world_clock = self._clock_publisher() if value["publish_clock"] else None

    def _prepare_robots(self, value: dict[str, Any]) -> None:
        """Note what each robot gets beside its skills: the topics of a robot stack, and a camera."""
        self._with_stack = value["robot_stack"]
        if self._with_stack and not TransformPublisher.is_possible():
            self.get_logger().warning(MISSING)
        self._stacks: dict[str, RobotStack] = {}
        camera = CameraSettings(value["camera_width"], value["camera_height"], value["camera_fov"])
        self._camera = camera if value["camera"] else None
        self._cameras: dict[str, CameraTopics] = {}
        self._rendering = UNTRIED if value["camera"] else "switched off"
        self._looking = threading.Lock()

    def _open_services(self) -> None:
        """Offer the skills of the default session, and what concerns all sessions."""
        self._group = ReentrantCallbackGroup()
        self._served: set[str] = set()
        self._serve_skills("")
        self._json("skills/cancel", self.engine.cancel)
        self._json("skills/take_control", self.engine.take_control)
        self._json("skills/release_control", self.engine.release_control)
        add_json_subscription(self, topic("lift_requests"), self._lift_request, callback_group=self._group)

    def _start_timers(self, camera_rate: float) -> None:
        self.repeat(1.0, self._publish_lifts)
        self._last = monotonic()
        self.repeat(PERIOD / 2, self._drive)
        self._odd = False
        self.repeat(0.5, self._publish_markers)
        if self._camera is not None:
            # Not more often than asked, and one after the other: pictures are made in their own callback.
            self.repeat(1.0 / camera_rate, self._publish_pictures)

    def facts(self) -> Iterable[tuple[str, object]]:
        """Return the facts that the diagnostics report about the sessions and about what is left out."""
        for session in self.engine.sessions:
            where = f"{session.world.building.building_id} floor {session.robot.floor}"
            yield f"session {session.name or 'default'}", where
        yield "camera", self._rendering
        yield "transforms", "published" if TransformPublisher.is_possible() else "no tf2_msgs"

    def _clock_publisher(self) -> Any:
        entry = self._names(DEFAULT_SESSION).interface("/clock")
        return self.create_publisher(Clock, entry.name, qos_profile(entry.qos))

    def _names(self, session: str) -> RobotNames:
        return RobotNames(self._namespace, self._frame_prefix, session)

    def _json(self, name: str, handler: Callable[[Any], Any], prefix: str = "") -> None:
        self._serve(service(name), handler, prefix)

    def _serve(self, entry: ServiceInterface, handler: Callable[[Any], Any], prefix: str = "") -> None:
        named = replace(entry, name=f"{prefix}/{entry.name}") if prefix else entry
        add_json_service(self, named, handler, callback_group=self._group)

    def _serve_skills(self, session: str) -> None:
        """Serve all skills; below a session's name they are that session's."""
        for skill in SKILLS.values():
            self._serve(skill.interface, self._runner(skill.name, session), session)
        if session:
            self._json("skills/cancel", self._bound(self.engine.cancel, session), session)

    def load(self, arguments: LoadBuilding) -> Loaded:
        """Put the session's robot into a building, where a former run of the session left it."""
        loaded = self.engine.load(arguments)
        name = loaded.session
        if name != DEFAULT_SESSION and name not in self._served:
            self._served.add(name)
            self._serve_skills(name)
        session = self.engine.session(name)
        if self._with_stack and name not in self._stacks:
            self._stacks[name] = RobotStack(self, self._names(name), self._group)
        with session.shared.lock:
            if self._with_stack:
                self._stacks[name].show(session)
            self._show(session)
            self._publish_world_lifts(session)
        if self._camera is not None:
            self._show_pictures(session)
        return loaded

    def _show_pictures(self, session: Session) -> None:
        """Have the session's camera show a building, once it is known whether pictures can be made here."""
        with self._looking:
            if self._rendering == UNTRIED:
                self._rendering = "being tried"
                threading.Thread(target=self._try_rendering, name="rendering", daemon=True).start()
            elif self._rendering == READY:
                self._look_through(session)

    def _try_rendering(self) -> None:
        fault = rendering_fault()
        if not self.context.ok():
            return
        if fault:
            self._rendering = fault
            self.get_logger().warning(f"there will be no camera topics: {fault}")
            return
        with self._looking:
            self._rendering = READY
            for session in self.engine.sessions:
                self._look_through(session)

    def _look_through(self, session: Session) -> None:
        assert self._camera is not None
        if session.name not in self._cameras:
            names = self._names(session.name)
            self._cameras[session.name] = CameraTopics(self, names, self._camera)
        self._cameras[session.name].show(session)

    def _runner(self, name: str, session: str) -> Callable[[Any], Any]:
        def run(arguments: Any) -> Any:
            return _reply(self.engine.run(name, arguments if arguments is not None else SessionArgs()))

        return self._bound(run, session) if session else run

    @staticmethod
    def _bound(call: Callable[[Any], Any], session: str) -> Callable[[Any], Any]:
        def run(arguments: Any) -> Any:
            known = arguments if arguments is not None else SessionArgs()
            return call(msgspec.structs.replace(known, session=session))

        return run

    def _changed(self, session: Session, event: WorldEvent) -> None:
        self._events.publish(event)
        self._show(session)
        self._publish_changed_lifts(session)

    def _show(self, session: Session) -> None:
        self._robot_state.publish(session.world.robot_state(session.robot))
        for stack in list(self._stacks.values()):
            other = stack.session
            if other is session:
                stack.publish_all(session)
            elif other is not None and other.shared is session.shared:
                stack.follow(other, session.robot.floor)

    def _report(self, progress: SkillProgress) -> None:
        self._progress.publish(progress)
        session = self.engine.session(progress.session)
        self._publish_changed_lifts(session)

    def _publish_changed_lifts(self, session: Session) -> None:
        changes = session.world.lift_changes
        while changes:
            self._lift_state.publish(changes.popleft())

    def _publish_world_lifts(self, session: Session) -> None:
        for state in session.world.lift_states():
            self._lift_state.publish(state)

    def _publish_lifts(self) -> None:
        for shared in self.engine.worlds:
            with shared.lock:
                states = shared.world.lift_states()
            for state in states:
                self._lift_state.publish(state)

    def _publish_markers(self) -> None:
        for stack in list(self._stacks.values()):
            with self._shown(stack) as session:
                if session is not None:
                    stack.publish_markers(session)

    @staticmethod
    @contextmanager
    def _shown(stack: RobotStack) -> Iterator[Session | None]:
        """Lock the world that a stack shows; ``None`` when it shows another one by then."""
        session = stack.session
        if session is None:
            yield None
            return
        with session.shared.lock:
            yield session if stack.session is session else None

    def _publish_pictures(self) -> None:
        with self._looking:
            for camera in self._cameras.values():
                camera.publish()

    def destroy_node(self) -> None:
        """Free the cameras, then what every node has."""
        with self._looking:
            for camera in self._cameras.values():
                camera.close()
        super().destroy_node()

    def _lift_request(self, request: LiftRequest) -> None:
        try:
            self.engine.request_lift(request)
        except MansionError as error:
            self.get_logger().warning(f"lift_requests: {error}")
        for session in self.engine.sessions:
            with session.shared.lock:
                self._publish_changed_lifts(session)
                self._publish_world_lifts(session)

    def _drive(self) -> None:
        """Twenty times a second: drive as commanded, publish poses, and every other time scans."""
        now = monotonic()
        seconds, self._last = min(now - self._last, 0.5), now
        self.engine.tick()
        self._odd = not self._odd
        for stack in list(self._stacks.values()):
            with self._shown(stack) as session:
                if session is None:
                    continue
                moved = drive_for(session, stack.drive, seconds, now)
                if not moved and stack.drive.moved:
                    stack.drive.moved = False
                    self._save(session)
                    self._robot_state.publish(session.world.robot_state(session.robot))
                stack.publish_pose(session)
                if self._odd:
                    stack.publish_scan(session)
        if self._world_clock is not None and (worlds := self.engine.worlds):
            nanoseconds = int(worlds[0].world.time * 1e9)
            message = Clock()
            message.clock.sec, message.clock.nanosec = divmod(nanoseconds, 10**9)
            self._world_clock.publish(message)

    def _save(self, session: Session) -> None:
        """Save where a robot was driven; no caller waits for an answer that could report a failure."""
        try:
            session.save()
        except (MansionError, OSError) as error:
            self.get_logger().error(f"session {session.name}: its place is not saved: {error}")


def _reply(result: Any) -> Any:
    if isinstance(result, SkillResult) and result.status is not SkillStatus.SUCCESS:
        raise MansionError(
            result.status.value, f"{result.message}; to succeed: {result.satisfied_by}", details=to_builtins(result)
        )
    return result


def main(args: Sequence[str] | None = None) -> None:
    """Run the node."""
    run_node(SkillServer, args, threads=THREADS)


if __name__ == "__main__":
    main()
