"""A running node graph under the names of the front door: plan, build, load, and buildings that it edits and serves."""

import getpass
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np
import numpy.typing as npt

from mansion.backend import History, Planner
from mansion.briefs import Outline, request_of
from mansion.building import Building
from mansion.homes import Home
from mansion.plans import Plan
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.closing import Closing
from mansion_msgs_py.editing.changes import EditResult
from mansion_msgs_py.editing.instructions import AgentReport, InstructArgs
from mansion_msgs_py.editing.open_buildings import EditorInfo, OpenEditorArgs, ToolArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.skills import Loaded
from mansion_msgs_py.stages import BuildJob, BuildReply

if TYPE_CHECKING:
    from mansion.robot import RobotPort
    from mansion_bringup.client import MansionClient
    from mansion_bringup.graph.robot_client import CameraImages
    from mansion_skills.skills.declaration import Skill

__all__ = ["Graph", "connect"]

_DISCOVERY: Final = 5.0
"""Seconds for the nodes of a running graph to be found."""


def connect(*, domain_id: int | None = None, namespace: str = "/mansion", timeout: float = 600.0) -> "Graph":
    """Return the node graph that runs on this machine (``mansion up``), with the names of this module.

    Parameters
    ----------
    domain_id : int, optional
        ROS domain; ``ROS_DOMAIN_ID`` when absent.
    namespace : str
        Where the graph lives.
    timeout : float
        Seconds that a call may take.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where there is no rclpy, or no graph is running.

    Examples
    --------
    ::

        with mansion.connect() as graph:
            b = graph.build("a small flat for two", "/tmp/flat", seed=4)
            b.edit("put a red mug on the coffee table")
            print(b.robot().go_to("kitchen").message)
    """
    with importing:
        from mansion_bringup.graph.rclpy_available import check_rclpy

    check_rclpy()
    with importing:
        from mansion_bringup.client import MansionClient

    client = MansionClient(domain_id=domain_id, namespace=namespace, timeout=timeout)
    if not client.wait_served("build_building", _DISCOVERY):
        client.close()
        where = "" if domain_id is None else f" of domain {domain_id}"
        raise MansionError(
            ErrorCode.UNAVAILABLE, f"no graph runs below {namespace}{where}; start one with `mansion up`"
        )
    return Graph(client)


class Graph(Closing):
    """A running graph; folders are seen from its processes, on this machine.

    Parameters
    ----------
    client : MansionClient
        For what has no name here: ``graph.client.call("SERVICE", {...})``, ``graph.client.listen("TOPIC", print)``.
    """

    def __init__(self, client: "MansionClient") -> None:
        self.client = client

    def plan(
        self,
        description: str | BuildRequest,
        *,
        floors: int | None = None,
        area: float | None = None,
        floor_area: float | None = None,
        footprint: Outline | None = None,
        seed: int = 0,
        planner: Literal["rules", "llm"] = "rules",
        assets: str | Sequence[str] = (),
    ) -> Plan:
        """Plan a building without making it; see `mansion.plan`."""
        request = request_of(
            description, footprint, floors=floors, area=area, floor_area=floor_area, seed=seed, planner=planner,
            assets=assets,
        )  # fmt: skip
        return Plan(request, self.client.plan(request))

    def build(
        self,
        description: str | BuildRequest,
        folder: str | Path | None = None,
        *,
        floors: int | None = None,
        area: float | None = None,
        floor_area: float | None = None,
        footprint: Outline | None = None,
        seed: int = 0,
        planner: Literal["rules", "llm"] = "rules",
        assets: str | Sequence[str] = (),
        formats: str | Sequence[str] = (),
        force: bool = False,
    ) -> Building:
        """Build a furnished building from one sentence; see `mansion.build`.

        Parameters
        ----------
        folder : path, optional
            Below the director's ``output_root`` when absent, where it stays.
        """
        with importing:
            from mansion_bringup.exporting import format_names

        request = request_of(
            description, footprint, floors=floors, area=area, floor_area=floor_area, seed=seed, planner=planner,
            assets=assets,
        )  # fmt: skip
        output = None if folder is None else str(Path(folder).absolute())
        job = BuildJob.of(request, output=output, force=force, formats=format_names(formats))
        reply: BuildReply = self.client.call("build_building", job, reply=BuildReply)
        return self.load(reply.path)

    def load(self, folder: str | Path) -> Building:
        """Return the building in a folder, which the graph edits and moves robots in; see `mansion.load`."""
        home = Home(Path(folder).absolute())
        return Building(home, _OverGraph(self.client, home.folder))

    def close(self) -> None:
        """Leave the graph, which runs on; buildings from it can still be read."""
        self.client.close()


class _OverGraph:
    """`mansion.backend.Backend` by service calls."""

    def __init__(self, client: "MansionClient", folder: Path) -> None:
        self._client = client
        self._folder = folder
        self._opened = ""

    def _editor(self) -> str:
        """Return the name under which the scene editor has the folder open, having opened it before."""
        if not self._opened:
            name = f"{self._folder.name}_{os.getpid()}"
            opening = OpenEditorArgs(path=str(self._folder), editor=name, who=getpass.getuser())
            self._client.call("scene/open", opening, reply=EditorInfo)
            self._opened = name
        return self._opened

    def instruct(self, instruction: str, planner: Planner, physics: str | None) -> AgentReport:
        """See `Backend.instruct`."""
        if physics is not None:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                "in a graph the engine is set by the parameter `physics` of the node scene_editor; leave it out here",
                path="$.physics",
            )
        asked = InstructArgs(instruction=instruction, planner=planner, editor=self._editor())
        report: AgentReport = self._client.call("scene/instruct", asked, reply=AgentReport)
        self._await_files()
        return report

    def history(self, tool: History) -> str:
        """See `Backend.history`."""
        asked = ToolArgs(editor=self._editor())
        result: EditResult = self._client.call(f"scene/{tool.lower()}", asked, reply=EditResult)
        self._await_files()
        return result.message

    def _await_files(self) -> None:
        """Wait until what is made from the changed floors is written, or write it: the node does so after its reply."""
        with importing:
            from mansion_bringup.edit_hooks import kept_files
            from mansion_editing.storage import BuildingStore

        BuildingStore(self._folder).refresh(kept_files)

    def robot(self, session: str, *, reset: bool) -> "RobotPort":
        """See `Backend.robot`."""
        asked = LoadBuilding(path=str(self._folder), session=session, reset=reset)
        self._client.call("load_building", asked, reply=Loaded)
        return _GraphPort(self._client, session)


class _GraphPort:
    """A robot of the skill server."""

    def __init__(self, client: "MansionClient", session: str) -> None:
        self._client = client
        self._session = session
        self._images: CameraImages | None = None

    def run(self, skill: "Skill", arguments: Mapping[str, Any]) -> Any:
        """See `RobotPort.run`."""
        with importing:
            from mansion_bringup.graph.robot_client import call_skill

        return call_skill(self._client, skill, self._session, arguments)

    def look(self, width: int | None, height: int | None, fov: float | None) -> npt.NDArray[np.uint8]:
        """See `RobotPort.look`."""
        with importing:
            from mansion_bringup.graph.robot_client import CameraImages

        if (width, height, fov) != (None, None, None):
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                "in a graph parameters of the node skill_server say how large pictures are and how far they see; leave "
                "width, height and fov out",
            )
        if self._images is None:
            self._images = CameraImages(self._client, self._session)
        return self._images.next()
