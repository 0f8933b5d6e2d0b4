"""``skill_server``: the skills as services, the robots' topics, and the lifts."""

import threading
from collections.abc import Callable, Sequence
from time import monotonic
from typing import Any

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.clock import Clock as RosClock
from rclpy.clock import ClockType
from rclpy.node import Node
from rosgraph_msgs.msg import Clock

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import ServiceInterface, service, topic
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import (
    JsonPublisher,
    add_json_service,
    add_json_subscription,
    qos_profile,
)
from mansion_msgs_py.skills import Loaded, SessionArgs
from mansion_msgs_py.world import LiftRequest, SkillProgress, SkillResult, SkillStatus, WorldEvent
from mansion_skills.engine import Engine
from mansion_skills.engine.driving import drive_for
from mansion_skills.engine.pace import Pace
from mansion_skills.engine.seat import Seat
from mansion_skills.nodes.camera_topics import CameraSettings, CameraTopics
from mansion_skills.nodes.robot_stack import PERIOD, RobotStack
from mansion_skills.nodes.server_parameters import declare_parameters
from mansion_skills.skills.registry import SKILLS
from mansion_skills.world.overlay import DEFAULT_SESSION

__all__ = ["SkillServer", "main"]

THREADS = 12
"""Enough for a full queue of skills beside cancel, questions and timers."""


class SkillServer(Node):
    """Serves ``load_building`` and the skills; saves the world after each."""

    def __init__(self) -> None:
        super().__init__("skill_server")
        value = declare_parameters(self)
        self._robot_state = JsonPublisher(self, topic("robot_state"))
        self._lift_state = JsonPublisher(self, topic("lift_state"))
        self._progress = JsonPublisher(self, topic("skill_progress"))
        self._events = JsonPublisher(self, topic("world_events"))
        self._world_clock = self._clock_publisher() if value["publish_clock"] else None
        self.engine = Engine(
            Pace(realtime=value["motion"] == "realtime", factor=value["real_time_factor"]),
            radius=value["robot_radius"],
            durable=value["durable"],
            changed=self._changed,
            progress=self._report,
        )
        self._with_stack = value["robot_stack"]
        self._stacks: dict[str, RobotStack] = {}
        self._camera = (
            CameraSettings(value["camera_width"], value["camera_height"], value["camera_fov"])
            if value["camera"]
            else None
        )
        self._cameras: dict[str, CameraTopics] = {}
        self._looking = threading.Lock()
        self._group = ReentrantCallbackGroup()
        self._served: set[str] = set()
        self._serve_skills("")
        self._json("skills/cancel", self.engine.cancel)
        self._json("skills/take_control", self.engine.take_control)
        self._json("skills/release_control", self.engine.release_control)
        add_json_subscription(
            self, topic("lift_requests"), self._lift_request, callback_group=self._group
        )
        self._wall = RosClock(clock_type=ClockType.STEADY_TIME)
        self._repeat(1.0, self._publish_lifts)
        self._last = monotonic()
        self._repeat(PERIOD / 2, self._drive)
        self._odd = False
        self._repeat(0.5, self._publish_markers)
        if self._camera is not None:
            # Not more often than asked, and one after the other: pictures are made in their own callback.
            self._repeat(1.0 / value["camera_rate"], self._publish_pictures)
        # Last, because who starts the node takes this service for the sign that all of it is there.
        self._json("load_building", self.load)
        if value["building"]:
            self.load(LoadBuilding(path=value["building"], session=value["session"]))

    def _repeat(self, period: float, callback: Callable[[], None]) -> None:
        """Call back by the wall's clock: by /clock, which this node may publish itself, it would never begin."""
        self.create_timer(period, callback, MutuallyExclusiveCallbackGroup(), self._wall)

    def _clock_publisher(self) -> Any:
        entry = topic("/clock")
        return self.create_publisher(Clock, entry.name, qos_profile(entry.qos))

    def _json(self, name: str, handler: Callable[[Any], Any], prefix: str = "") -> None:
        entry = service(name)
        if prefix:
            entry = ServiceInterface(
                f"{prefix}/{name}",
                entry.node,
                entry.description,
                entry.arguments,
                entry.reply,
            )
        add_json_service(self, entry, handler, callback_group=self._group)

    def _serve_skills(self, session: str) -> None:
        """Serve all skills; below a session's name they are that session's."""
        for name in SKILLS:
            self._json(f"skills/{name}", self._runner(name, session), session)
        if session:
            self._json("skills/cancel", self._bound(self.engine.cancel, session), session)

    def load(self, arguments: LoadBuilding) -> Loaded:
        """Put the session's robot into a building, where a former run of the session left it."""
        loaded = self.engine.load(arguments)
        session = loaded.session
        if session != DEFAULT_SESSION and session not in self._served:
            self._served.add(session)
            self._serve_skills(session)
        seat = self.engine.seat(session)
        if self._with_stack:
            former = self._stacks.pop(session, None)
            if former is not None:
                with former.seat.shared.lock:
                    former.close()
            self._stacks[session] = RobotStack(self, seat, self._group)
        if self._camera is not None:
            with self._looking:
                before = self._cameras.pop(session, None)
                if before is not None:
                    before.close()
                self._cameras[session] = CameraTopics(self, seat, self._camera)
        with seat.shared.lock:
            self._show(seat)
            self._publish_world_lifts(seat)
        return loaded

    def _runner(self, name: str, session: str) -> Callable[[Any], Any]:
        def run(arguments: Any) -> Any:
            return _reply(
                self.engine.run(name, arguments if arguments is not None else SessionArgs())
            )

        return self._bound(run, session) if session else run

    @staticmethod
    def _bound(call: Callable[[Any], Any], session: str) -> Callable[[Any], Any]:
        def run(arguments: Any) -> Any:
            known = arguments if arguments is not None else SessionArgs()
            known.session = session
            return call(known)

        return run

    def _changed(self, seat: Seat, event: WorldEvent) -> None:
        self._events.publish(event)
        self._show(seat)
        self._publish_changed_lifts(seat)

    def _show(self, seat: Seat) -> None:
        self._robot_state.publish(seat.world.robot_state(seat.robot))
        stack = self._stacks.get(seat.session)
        if stack is not None:
            stack.publish_all()
        for other in list(self._stacks.values()):
            if other is not stack and other.seat.shared is seat.shared and not other.closed:
                other.follow(seat.robot.floor)

    def _report(self, progress: SkillProgress) -> None:
        self._progress.publish(progress)
        seat = self.engine.seat(progress.session)
        self._publish_changed_lifts(seat)
        stack = self._stacks.get(progress.session)
        if stack is not None and not stack.closed and self.engine.pace.realtime:
            stack.publish_pose()

    def _publish_changed_lifts(self, seat: Seat) -> None:
        changes = seat.world.lift_changes
        while changes:
            self._lift_state.publish(changes.popleft())

    def _publish_world_lifts(self, seat: Seat) -> None:
        for state in seat.world.lift_states():
            self._lift_state.publish(state)

    def _publish_lifts(self) -> None:
        for shared in self.engine.worlds:
            with shared.lock:
                states = shared.world.lift_states()
            for state in states:
                self._lift_state.publish(state)

    def _publish_markers(self) -> None:
        for stack in list(self._stacks.values()):
            with stack.seat.shared.lock:
                if not stack.closed:
                    stack.publish_markers()

    def _publish_pictures(self) -> None:
        with self._looking:
            for camera in self._cameras.values():
                camera.publish()

    def destroy_node(self) -> None:
        """Free the cameras, then what every node has."""
        with self._looking:
            for camera in self._cameras.values():
                camera.close()
            self._cameras.clear()
        super().destroy_node()

    def _lift_request(self, request: LiftRequest) -> None:
        try:
            self.engine.request_lift(request)
        except MansionError as error:
            self.get_logger().warning(f"lift_requests: {error}")
        for seat in self.engine.seats:
            with seat.shared.lock:
                self._publish_changed_lifts(seat)
                self._publish_world_lifts(seat)

    def _drive(self) -> None:
        """Twenty times a second: drive as commanded, publish poses, and every other time scans."""
        now = monotonic()
        seconds, self._last = min(now - self._last, 0.5), now
        self.engine.tick()
        self._odd = not self._odd
        for stack in list(self._stacks.values()):
            seat = stack.seat
            with seat.shared.lock:
                if stack.closed:
                    continue
                moved = drive_for(seat, stack.drive, seconds, now)
                if not moved and stack.drive.moved:
                    stack.drive.moved = False
                    seat.save()
                    self._robot_state.publish(seat.world.robot_state(seat.robot))
                stack.publish_pose()
                if self._odd:
                    stack.publish_scan()
        if self._world_clock is not None and (worlds := self.engine.worlds):
            nanoseconds = int(worlds[0].world.time * 1e9)
            message = Clock()
            message.clock.sec, message.clock.nanosec = divmod(nanoseconds, 10**9)
            self._world_clock.publish(message)


def _reply(result: Any) -> Any:
    if isinstance(result, SkillResult) and result.status is not SkillStatus.SUCCESS:
        raise MansionError(
            result.status.value,
            f"{result.message}; what would do: {result.satisfied_by}",
            details=to_builtins(result),
        )
    return result


def main(args: Sequence[str] | None = None) -> None:
    """Run the node."""
    run_node(SkillServer, args, threads=THREADS)


if __name__ == "__main__":
    main()
