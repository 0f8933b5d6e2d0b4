"""``skill_server``: the skills as services, one world for each session."""

import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_msgs_py.skills import LandmarkInfo, Loaded, SessionArgs
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills.building import LoadedBuilding
from mansion_skills.skills.between_floors import call_elevator, take_stairs, use_elevator
from mansion_skills.skills.places import go_to_landmark, where_am_i
from mansion_skills.world.overlay import DEFAULT_SESSION, load_overlay, overlay_path, save_overlay
from mansion_skills.world.world import World

__all__ = ["SkillServer", "main"]

Skill = Callable[[World, Any], Any]

SKILLS: dict[str, Skill] = {
    "skills/call_elevator": call_elevator,
    "skills/use_elevator": use_elevator,
    "skills/take_stairs": take_stairs,
    "skills/go_to_landmark": go_to_landmark,
    "skills/where_am_i": where_am_i,
}


class SkillServer(Node):
    """Serves ``load_building`` and the skills; saves the world after each."""

    def __init__(self) -> None:
        super().__init__("skill_server")
        self.declare_parameter(
            "building", "", ParameterDescriptor(description="folder of a building to load at start")
        )
        self._worlds: dict[str, World] = {}
        self._lock = threading.Lock()
        self._robot_state = JsonPublisher(self, topic("robot_state"))
        self._lift_state = JsonPublisher(self, topic("lift_state"))
        group = ReentrantCallbackGroup()
        add_json_service(self, service("load_building"), self.load, callback_group=group)
        for name, skill in SKILLS.items():
            add_json_service(self, service(name), self._runner(skill), callback_group=group)
        self.create_timer(1.0, self._publish_lifts)
        folder = self.get_parameter("building").value
        if folder:
            self.load(LoadBuilding(path=folder))

    def load(self, arguments: LoadBuilding) -> Loaded:
        """Put the session's robot into a building, where a former run of the session left it."""
        session = arguments.session or DEFAULT_SESSION
        building = LoadedBuilding(Path(arguments.path).expanduser())
        earlier = load_overlay(overlay_path(building.path, session))
        world = World(building, session, earlier)
        with self._lock:
            self._worlds[session] = world
        self._robot_state.publish(world.robot)
        return Loaded(
            building_id=building.building_id,
            floors=building.floors,
            labels=[building.label(floor) for floor in building.floors],
            state=world.robot,
            landmarks=[
                LandmarkInfo(name=entry.name, kind=entry.kind, floor=entry.floor, pose=entry.pose)
                for entry in world.landmarks
            ],
            session=session,
        )

    def _runner(self, skill: Skill) -> Callable[[Any], Any]:
        def run(arguments: Any) -> Any:
            known = arguments if arguments is not None else SessionArgs()
            session = known.session or DEFAULT_SESSION
            with self._lock:
                world = self._worlds.get(session)
                if world is None:
                    raise MansionError(
                        ErrorCode.NOT_LOADED,
                        f"session {session!r} has no building; call load_building first",
                    )
                result = skill(world, known)
                if isinstance(result, SkillResult) and result.status is SkillStatus.SUCCESS:
                    world.step += 1
                    save_overlay(overlay_path(world.building.path, session), world.state())
            self._robot_state.publish(world.robot)
            return _reply(result)

        return run

    def _publish_lifts(self) -> None:
        with self._lock:
            worlds = list(self._worlds.values())
        for world in worlds:
            for lift in world.lifts.values():
                self._lift_state.publish(lift.state(world.building.building_id, world.time))


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
    run_node(SkillServer, args)


if __name__ == "__main__":
    main()
