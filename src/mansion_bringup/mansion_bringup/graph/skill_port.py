"""The robot of an episode over the services of a skill server."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from mansion_bringup.client import MansionClient
from mansion_bringup.discovery import kept_to_this_machine
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import TRIGGER
from mansion_msgs_py.skills import Landmarks, SessionArgs, VisibleObjects
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import SkillResult
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.queries import VisibleArgs
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.episode_folder import SESSION, WORLD, WorldReplica
from mansion_tasks.episodes.port import SkillPort, as_result, called_skill, invalid_call

__all__ = ["GraphPort", "graph_port"]

SERVER = NodeProcess("mansion_skills", "skill_server", "load_building")
LOST = (ErrorCode.UNAVAILABLE, ErrorCode.TIMEOUT)


class GraphPort(SkillPort):
    """Calls skills as services; judges the world by what the server saved.

    Parameters
    ----------
    client : MansionClient
        A client of a graph whose skill server is on this machine.
    """

    def __init__(self, client: MansionClient) -> None:
        self._client = client
        self._replica: WorldReplica | None = None

    def load(self, folder: Path) -> None:
        """See `SkillPort.load`."""
        self._client.call("load_building", LoadBuilding(path=str(folder), session=SESSION, world=WORLD))
        self._replica = WorldReplica(folder)

    def call(self, call: SkillCall) -> SkillResult:
        """See `SkillPort.call`.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the server is gone: that says nothing of the skill.
        """
        skill = called_skill(call)
        if isinstance(skill, SkillResult):
            return skill
        name = skill.interface.name
        try:
            if skill.interface.type == TRIGGER:
                if call.arguments:
                    return invalid_call(skill.name, f"{skill.name} takes no arguments")
                answer = self._client.call(f"{SESSION}/{name}", reply=_reply_type(skill))
            else:
                arguments = {**call.arguments, "session": SESSION}
                answer = self._client.call(name, arguments, reply=_reply_type(skill))
            return as_result(skill, answer)
        except MansionError as error:
            if error.code in LOST:
                raise MansionError(ErrorCode.UNAVAILABLE, error.info.message) from None
            if "skill" in error.info.details:
                return decode(SkillResult, encode(error.info.details))
            return invalid_call(skill.name, str(error))

    def visible(self) -> VisibleObjects:
        """See `SkillPort.visible`."""
        asked = VisibleArgs(session=SESSION)
        found: VisibleObjects = self._client.call("skills/list_visible", asked, reply=VisibleObjects)
        return found

    def landmarks(self) -> Landmarks:
        """See `SkillPort.landmarks`."""
        asked = SessionArgs(session=SESSION)
        found: Landmarks = self._client.call("skills/list_landmarks", asked, reply=Landmarks)
        return found

    def world(self) -> tuple[World, RobotBody]:
        """See `SkillPort.world`."""
        if self._replica is None:
            raise MansionError(ErrorCode.NOT_LOADED, "the port has no building; load one first")
        self._replica.follow()
        return self._replica.world, self._replica.robot


def _reply_type(skill: Skill) -> Any:
    return Any if skill.query else SkillResult


@contextmanager
def graph_port() -> Iterator[SkillPort]:
    """Start a private skill server in a domain of its own, yield the way to it, and end it."""
    options = GraphOptions(
        domain_id=free_domain(),
        parameters={"skill_server": {"robot_stack": "false", "durable": "false"}},
        # Which buildings the tasks are in is not known yet.
        allow=(Path(os.path.sep),),
        quiet=True,
    )
    with kept_to_this_machine(), GraphProcesses(options, [SERVER]) as graph:
        graph.wait_ready(180.0)
        with MansionClient(domain_id=options.domain_id, timeout=120.0) as client:
            yield GraphPort(client)
