"""Pictures from the rooms of a building as it was built, apart from any robot's session."""

import weakref
from pathlib import Path
from typing import Any, Final, Literal, TypeAlias, TypeVar

import numpy.typing as npt

from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import choices
from mansion_skills.vision import Camera
from mansion_skills.vision.viewpoint import stand_at
from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["PARTS", "Part", "Viewpoints", "close_with"]

Part: TypeAlias = Literal["rgb", "depth", "segmentation", "panorama"]
"""What of a view is wanted."""

PARTS: Final = ("rgb", "depth", "segmentation", "panorama")


T = TypeVar("T")


def close_with(owner: T, view: Closing) -> "weakref.finalize[[], T]":
    """Close a view once, when its owner is gone or what is returned is called.

    At the end of the process its thread has ended already, and there is nothing to close.
    """
    closing = weakref.finalize(owner, view.close)
    closing.atexit = False
    return closing


class Viewpoints(Closing):
    """A camera that is put wherever a picture is wanted.

    Parameters
    ----------
    folder : Path
        The building's folder.
    width, height : int
        Pixels.
    fov : float
        Across, degrees.
    """

    def __init__(self, folder: Path, width: int, height: int, fov: float) -> None:
        self._sandbox = Sandbox(folder)
        self._camera = Camera(self._sandbox.session, width, height, fov)

    def look(self, place: str, floor: int | None, turn: float, part: Part) -> npt.NDArray[Any]:
        """Return a view; see `Building.look`."""
        if part not in PARTS:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD, f"there is no picture {part!r}; {choices(part, PARTS, 'pictures')}"
            )
        self._sandbox.reset()
        stand_at(self._sandbox.session, place, floor, turn)
        if part == "panorama":
            robot = self._sandbox.world.robot_state(self._sandbox.robot)
            return self._camera.panorama(place or str(robot.room))
        wanted = {name: name == part for name in PARTS[:3]}
        found: npt.NDArray[Any] = getattr(self._camera.render(**wanted), part)
        return found

    def close(self) -> None:
        """Free the camera."""
        self._camera.close()
