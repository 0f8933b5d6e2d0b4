"""The camera of one session's robot."""

from types import TracebackType
from typing import TYPE_CHECKING

from mansion_skills.engine.seat import Seat
from mansion_skills.skills.seeing import CAMERA_HEIGHT
from mansion_skills.vision.floors import Floors
from mansion_skills.vision.frame import Frame, Intrinsics, Picture
from mansion_skills.vision.gl import GlThread
from mansion_skills.vision.names import Names
from mansion_skills.vision.renderer import Eye, Parts

if TYPE_CHECKING:
    from mansion_skills.robot import Robot

__all__ = ["Camera"]

LARGEST = (640, 480)
"""Pixels of the largest picture beside the frames."""


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
        self._size = max(width, LARGEST[0]), max(height, LARGEST[1])
        self._thread = GlThread(*self._size)
        self._floors: Floors | None = None

    def _seat(self) -> Seat:
        source = self._source
        return source if isinstance(source, Seat) else source.engine.seat(source.session)

    def _world_floors(self, seat: Seat) -> Floors:
        """Return the loaded floors; others when the session has loaded another building, or the same anew."""
        if self._floors is None or self._floors.world is not seat.world:
            if self._floors is not None:
                self._floors.close()
            building = seat.world.building
            names = Names(building.scene(floor) for floor in building.floors)
            self._floors = Floors(seat.world, names, *self._size)
        return self._floors

    def _draw(
        self, seat: Seat, floor: int, eyes: list[Eye], intrinsics: Intrinsics, parts: Parts
    ) -> list[Frame]:
        """Draw several views of one moment."""
        floors = self._world_floors(seat)
        with seat.shared.lock:
            floors.follow(floor, seat.robot)
        return [floors.draw(floor, eye, intrinsics, parts) for eye in eyes]

    def render(self, *, rgb: bool = True, depth: bool = True, segmentation: bool = True) -> Frame:
        """Return what the robot sees; a part that is not asked for is an empty array, and saves time."""
        seat = self._seat()
        with seat.shared.lock:
            robot = seat.robot
            floor, x, y = robot.floor, robot.pose.x, robot.pose.y
            eye = Eye(x, y, CAMERA_HEIGHT, robot.pose.yaw, robot.pitch)
        parts = Parts(rgb, depth, segmentation)
        return self._thread.run(self._draw, seat, floor, [eye], self.intrinsics, parts)[0]

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
        if self._floors is not None:
            self._thread.run(self._floors.close)
            self._floors = None
        self._thread.close()

    def __enter__(self) -> "Camera":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
