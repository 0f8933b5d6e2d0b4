"""The camera of one session's robot."""

from math import cos, radians, sin
from types import TracebackType
from typing import TYPE_CHECKING

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore
from mansion_msgs_py.wording import choices
from mansion_skills.engine.seat import Seat
from mansion_skills.skills.seeing import CAMERA_HEIGHT
from mansion_skills.vision.drawing import floor_title
from mansion_skills.vision.floors import Floors
from mansion_skills.vision.frame import Frame, Intrinsics, Picture
from mansion_skills.vision.gl import GlThread
from mansion_skills.vision.lift_panel import Button, panel_picture
from mansion_skills.vision.names import Names
from mansion_skills.vision.pages import tile_pages
from mansion_skills.vision.panorama import VIEW, stitch, view_yaws
from mansion_skills.vision.renderer import Eye, Parts
from mansion_skills.vision.stair_arrows import with_arrows
from mansion_skills.world.landmarks import Landmark, landmark_named

if TYPE_CHECKING:
    from mansion_skills.robot import Robot

__all__ = ["Camera"]

LARGEST = (640, 480)
"""Pixels of the largest picture beside the frames."""

CORE_VIEW = Intrinsics(480, 480, 90.0)
"""The camera that looks into a stair or a lift."""

STEP_BACK = {"elevator": 1.0, "stair": 0.3}
"""How far behind a core's standard pose that camera stands, where there is room; metres."""

COLOURS = Parts(depth=False, segmentation=False)


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

    @property
    def loaded_floors(self) -> list[int]:
        """The floors that are loaded now, ascending."""
        return self._floors.loaded if self._floors is not None else []

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
        """Return the whole round from where a robot stands at a landmark, stitched from six views.

        Parameters
        ----------
        room_id : str
            A room, a stair or a lift, as ``go_to_landmark`` takes it; of any floor when the id names one.

        Returns
        -------
        (256, 1024, 3) array of uint8

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when there is no such landmark.
        """
        seat = self._seat()
        with seat.shared.lock:
            landmark = _landmark(seat, room_id)
        return self._round(seat, landmark)

    def _round(self, seat: Seat, landmark: Landmark) -> Picture:
        pose = landmark.pose
        # From a core's standard pose the robot looks away from it; the core belongs into the middle.
        middle = pose.yaw if landmark.kind == "room" else pose.yaw + 180.0
        eyes = [Eye(pose.x, pose.y, CAMERA_HEIGHT, yaw) for yaw in view_yaws(middle)]
        frames = self._thread.run(self._draw, seat, landmark.floor, eyes, VIEW, COLOURS)
        return stitch([frame.rgb for frame in frames])

    def landmark_pages(self, per_page: int = 9, floor: int | None = None) -> list[Picture]:
        """Return panoramas of a floor's landmarks as labelled tiles, at most `per_page` of them in a picture.

        Parameters
        ----------
        per_page : int
            1 to 16.
        floor : int, optional
            The robot's when it is left out.
        """
        seat = self._seat()
        with seat.shared.lock:
            number = seat.robot.floor if floor is None else floor
            building = seat.world.building
            if number not in building.floors:
                known = ", ".join(map(str, building.floors))
                raise MansionError(
                    ErrorCode.NOT_FOUND,
                    f"there is no floor {number}; floors: {known}",
                    path="$.floor",
                )
            landmarks = seat.world.view(number).landmarks
            title = f"Landmarks of floor {floor_title(number, building.label(number))}"
        entries = [(landmark.name, self._round(seat, landmark)) for landmark in landmarks]
        return tile_pages(entries, title, per_page)

    def lift_panel(self) -> Picture:
        """Return the nearest lift and its buttons: the floors that it serves, the current one marked.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` on a floor without a lift.
        """
        seat = self._seat()
        with seat.shared.lock:
            core = _nearest_core(seat, "elevator")
            building, floor = seat.world.building, seat.robot.floor
        buttons = [Button(f, building.label(f), f in core.floors) for f in building.floors]
        return panel_picture(core.id, buttons, floor, self._into(seat, core))

    def stairs_view(self) -> Picture:
        """Return the view into the nearest stair, with an arrow for each direction that exists.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` on a floor without a stair.
        """
        seat = self._seat()
        with seat.shared.lock:
            core = _nearest_core(seat, "stair")
            building, floor = seat.world.building, seat.robot.floor
        words = {
            step: f"{word} to {building.label(floor + step)}"
            for word, step in (("Up", 1), ("Down", -1))
            if floor + step in core.floors
        }
        return with_arrows(self._into(seat, core), words.get(1), words.get(-1))

    def _into(self, seat: Seat, core: SceneCore) -> Picture:
        """Return the view into a core from some way before it."""
        x, y, yaw = core.entrance
        ux, uy = cos(radians(yaw)), sin(radians(yaw))
        grid = seat.world.view(seat.robot.floor).map
        away = 0.0
        while away < STEP_BACK[core.type] and grid.is_free(
            x + (away + 0.1) * ux, y + (away + 0.1) * uy
        ):
            away += 0.1
        eye = Eye(x + away * ux, y + away * uy, CAMERA_HEIGHT, yaw + 180.0)
        call = (self._draw, seat, seat.robot.floor, [eye], CORE_VIEW, COLOURS)
        return self._thread.run(*call)[0].rgb

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


def _landmark(seat: Seat, name: str) -> Landmark:
    """Return a landmark of the robot's floor, or of any other when none there has the name."""
    world, robot = seat.world, seat.robot
    others = [floor for floor in world.building.floors if floor != robot.floor]
    for floor in [robot.floor, *others]:
        found = landmark_named(name, world.view(floor).landmarks, floor, robot.place)
        if found is not None:
            return found
    marks = [mark.name for floor in world.building.floors for mark in world.view(floor).landmarks]
    near = choices(name, marks, "rooms, stairs and lifts")
    raise MansionError(ErrorCode.NOT_FOUND, f"there is no landmark {name!r}; {near}")


def _nearest_core(seat: Seat, kind: str) -> SceneCore:
    found = seat.world.core_near(seat.robot, kind, float("inf"))
    if found is None:
        raise MansionError(ErrorCode.NOT_FOUND, f"floor {seat.robot.floor} has no {kind}")
    return found
