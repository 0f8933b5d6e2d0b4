"""The camera of one session's robot."""

from types import TracebackType
from typing import TYPE_CHECKING

from mansion_skills.engine.seat import Seat
from mansion_skills.vision.frame import Frame, Intrinsics, Picture

if TYPE_CHECKING:
    from mansion_skills.robot import Robot

__all__ = ["Camera"]


class Camera:
    """Pictures of the world as it is now, through the eyes of one robot.

    Parameters
    ----------
    source : Robot or Seat
        Whose eyes; of a `Robot`, its session's seat.
    width, height : int
        Of the frames, pixels.
    fov : float
        Across, degrees.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where MuJoCo or an OpenGL that renders offscreen is missing, ``NOT_FOUND`` when a floor of the
        building has no ``model.xml``.

    Examples
    --------
    ::

        robot = Robot("out/office")
        with Camera(robot, 640, 480) as camera:
            frame = camera.render()
    """

    def __init__(
        self, source: "Robot | Seat", width: int = 300, height: int = 300, fov: float = 90.0
    ) -> None:
        self._source = source
        self.intrinsics = Intrinsics(width, height, fov)

    def render(self, *, rgb: bool = True, depth: bool = True, segmentation: bool = True) -> Frame:
        """Return what the robot sees; a part that is not asked for is an empty array, and saves time."""
        raise NotImplementedError

    def panorama(self, room_id: str) -> Picture:
        """Return the whole round from a landmark's pose, stitched from several views."""
        raise NotImplementedError

    def landmark_pages(self, per_page: int = 9, floor: int | None = None) -> list[Picture]:
        """Return panoramas of a floor's landmarks as labelled tiles, at most `per_page` of them in a picture."""
        raise NotImplementedError

    def lift_panel(self) -> Picture:
        """Return the nearest lift and its buttons: the floors that it serves, the current one marked."""
        raise NotImplementedError

    def stairs_view(self) -> Picture:
        """Return the view into the nearest stair, with an arrow for each direction that exists."""
        raise NotImplementedError

    def close(self) -> None:
        """Free the OpenGL context; the camera is of no use afterwards."""

    def __enter__(self) -> "Camera":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
