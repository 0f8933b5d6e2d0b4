"""Who edits a building and moves its robots: this process, or a node graph (`mansion.graph`)."""

from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol

from mansion_msgs_py.editing.instructions import AgentReport
from mansion_msgs_py.late_imports import importing

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np
    import numpy.typing as npt

    from mansion.robot import RobotPort
    from mansion_editing.editor import SceneEditor
    from mansion_skills import Robot as LocalRobot
    from mansion_skills.engine import Engine
    from mansion_skills.skills.declaration import Skill

__all__ = ["Backend", "History", "InProcess", "Planner"]

Planner = Literal["rules", "llm"]
History = Literal["Undo", "Redo"]


class Backend(Protocol):
    """What changes one building folder; every change is checked and written before it returns."""

    def instruct(self, instruction: str, planner: Planner, physics: str | None) -> AgentReport:
        """Carry out an instruction."""

    def history(self, tool: History) -> str:
        """Take back this user's last edit or do it again, and say what it was."""

    def robot(self, session: str, *, reset: bool) -> "RobotPort":
        """Put a session's robot into the building."""


PHYSICS = "mujoco"
"""What settles objects where nothing else is asked for, as on the command line."""


class InProcess:
    """The scene editor and the skills as plain function calls.

    Parameters
    ----------
    folder : Path
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._editors: dict[str, SceneEditor] = {}
        self._engine: Engine | None = None

    def _editor(self, physics: str) -> "SceneEditor":
        with importing:
            from mansion_bringup.editor import ENGINE_EXTRAS, open_editor
            from mansion_bringup.extras import require_extra

        if physics not in self._editors:
            if physics in ENGINE_EXTRAS:
                require_extra(ENGINE_EXTRAS[physics])
            self._editors[physics] = open_editor(self._folder, physics=physics)
        return self._editors[physics]

    def instruct(self, instruction: str, planner: Planner, physics: str | None) -> AgentReport:
        """See `Backend.instruct`."""
        with importing:
            from mansion_bringup.editor import write_derived
            from mansion_bringup.extras import require_extra
            from mansion_editing.instructions.instruct import instruct

        if planner == "llm":
            require_extra("llm")
        editor = self._editor(physics or PHYSICS)
        report = instruct(editor, instruction, planner)
        write_derived(editor)
        return report

    def history(self, tool: History) -> str:
        """See `Backend.history`."""
        with importing:
            from mansion_bringup.editor import write_derived

        editor = self._editor("static")
        message = str(editor.call(tool).message)
        write_derived(editor)
        return message

    def robot(self, session: str, *, reset: bool) -> "RobotPort":
        """See `Backend.robot`."""
        with importing:
            from mansion_skills import Robot as LocalRobot
            from mansion_skills.engine import Engine

        # One engine, so that robots of one building meet in one world.
        self._engine = self._engine or Engine()
        return _LocalPort(LocalRobot(self._folder, session, reset=reset, engine=self._engine))


class _LocalPort:
    """A robot of this process."""

    def __init__(self, robot: "LocalRobot") -> None:
        self._robot = robot
        self._cameras: dict[tuple[int, int, float], Any] = {}

    def run(self, skill: "Skill", arguments: "Mapping[str, Any]") -> Any:
        """See `RobotPort.run`."""
        return self._robot.skill(skill.name, **arguments)

    def look(self, width: int | None, height: int | None, fov: float | None) -> "npt.NDArray[np.uint8]":
        """See `RobotPort.look`."""
        with importing:
            from mansion_bringup.extras import require_extra

        require_extra("sim")
        with importing:
            from mansion.viewpoints import close_with
            from mansion_skills.vision import Camera

        key = (width or 640, height or 480, fov or 90.0)
        if key not in self._cameras:
            camera = Camera(self._robot, *key)
            close_with(self, camera)
            self._cameras[key] = camera
        picture: npt.NDArray[np.uint8] = self._cameras[key].render(depth=False, segmentation=False).rgb
        return picture
