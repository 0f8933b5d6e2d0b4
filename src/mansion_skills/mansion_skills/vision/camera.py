"""The camera of one session's robot."""

from typing import TYPE_CHECKING

from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore
from mansion_msgs_py.wording import choices
from mansion_skills.engine.session import Session
from mansion_skills.skills.visibility import CAMERA_HEIGHT
from mansion_skills.vision.annotated_pictures import Button, floor_title, panel_picture, tile_pages, with_arrows
from mansion_skills.vision.frame import Frame, Intrinsics, Names, Picture
from mansion_skills.vision.loaded_floors import Floors
from mansion_skills.vision.offscreen import GlThread
from mansion_skills.vision.panorama import VIEW, core_viewpoint, stitch, view_yaws
from mansion_skills.vision.renderer import CameraPose, Parts
from mansion_skills.world.floor_view import Landmark, landmark_named

if TYPE_CHECKING:
    from mansion_skills.robot import Robot

__all__ = ["Camera"]

LARGEST = (640, 480)
"""Pixels of the largest picture other than the frames."""

CORE_VIEW = Intrinsics(480, 480, 90.0)
"""The camera that looks into a stair or a lift."""

CORE_DISTANCE = {"elevator": 1.4, "stair": 0.3}
"""How far before a core's standard pose that camera stands at most, where there is room; metres."""

COLOURS = Parts(depth=False, segmentation=False)


class Camera(Closing):
    """Pictures of the world as it is now from one robot's camera.

    Parameters
    ----------
    source : Robot or Session
        Session of the robot; of a `Robot`, its own.
    width, height : int
        Size of the frames, pixels.
    fov : float
        Horizontal field of view, degrees.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where MuJoCo or an OpenGL that renders offscreen is missing, ``NOT_FOUND`` when a floor of the
        building has no ``model.xml`` and none can be made here.

    Examples
    --------
    ::

        robot = Robot("out/office")
        with Camera(robot, 640, 480) as camera:
            frame = camera.render()
    """

    def __init__(self, source: "Robot | Session", width: int = 300, height: int = 300, fov: float = 90.0) -> None:
        self._source = source
        self.intrinsics = Intrinsics(width, height, fov)
        self._size = max(width, LARGEST[0]), max(height, LARGEST[1])
        self._thread = GlThread(*self._size)
        self._floors: Floors | None = None

    @property
    def loaded_floors(self) -> list[int]:
        """The floors that are loaded now, ascending."""
        return self._floors.loaded if self._floors is not None else []

    def _session(self) -> Session:
        source = self._source
        return source if isinstance(source, Session) else source.engine.session(source.session)

    def _world_floors(self, session: Session) -> Floors:
        """Return the loaded floors; others when the session has loaded another building, or the same one again."""
        if self._floors is None or self._floors.world is not session.world:
            if self._floors is not None:
                self._floors.close()
            building = session.world.building
            names = Names(building.scene(floor) for floor in building.floors)
            self._floors = Floors(session.world, names, *self._size)
        return self._floors

    def _draw(
        self, session: Session, floor: int, poses: list[CameraPose], intrinsics: Intrinsics, parts: Parts
    ) -> list[Frame]:
        """Draw several views of one moment."""
        floors = self._world_floors(session)
        with session.shared.lock:
            floors.synchronise(floor, session.robot)
        return [floors.draw(floor, pose, intrinsics, parts) for pose in poses]

    def render(self, *, rgb: bool = True, depth: bool = True, segmentation: bool = True) -> Frame:
        """Return what the robot sees; a part that is not asked for is an empty array, and saves time."""
        session = self._session()
        with session.shared.lock:
            robot = session.robot
            floor, x, y = robot.floor, robot.pose.x, robot.pose.y
            pose = CameraPose(x, y, CAMERA_HEIGHT, robot.pose.yaw, robot.pitch)
        parts = Parts(rgb, depth, segmentation)
        return self._thread.run(self._draw, session, floor, [pose], self.intrinsics, parts)[0]

    def panorama(self, room_id: str) -> Picture:
        """Return the panorama from a robot's pose at a landmark, stitched from six views.

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
        session = self._session()
        with session.shared.lock:
            landmark = _landmark(session, room_id)
        return self._panorama_of(session, landmark)

    def _panorama_of(self, session: Session, landmark: Landmark) -> Picture:
        x, y, middle = landmark.pose.x, landmark.pose.y, landmark.pose.yaw
        if landmark.kind != "room":
            grid = session.world.view(landmark.floor).map
            core = next(core for core in grid.scene.cores if core.id == landmark.name)
            x, y, middle = core_viewpoint(grid, core)
        poses = [CameraPose(x, y, CAMERA_HEIGHT, yaw) for yaw in view_yaws(middle)]
        frames = self._thread.run(self._draw, session, landmark.floor, poses, VIEW, COLOURS)
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
        session = self._session()
        with session.shared.lock:
            number = session.robot.floor if floor is None else floor
            building = session.world.building
            if number not in building.floors:
                known = ", ".join(map(str, building.floors))
                raise MansionError(ErrorCode.NOT_FOUND, f"there is no floor {number}; floors: {known}", path="$.floor")
            landmarks = session.world.view(number).landmarks
            title = f"Landmarks of floor {floor_title(number, building.label(number))}"
        entries = [(landmark.name, self._panorama_of(session, landmark)) for landmark in landmarks]
        return tile_pages(entries, title, per_page)

    def lift_panel(self) -> Picture:
        """Return the nearest lift and its buttons: the floors that it serves, the current one marked.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` on a floor without a lift.
        """
        session, floor, core, view = self._at_core("elevator")
        building = session.world.building
        buttons = [Button(f, building.label(f), f in core.floors) for f in building.floors]
        return panel_picture(core.id, buttons, floor, view)

    def stairs_view(self) -> Picture:
        """Return the view into the nearest stair, with an arrow for each direction that exists.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` on a floor without a stair.
        """
        session, floor, core, view = self._at_core("stair")
        words = {
            step: f"{word} to {session.world.building.label(floor + step)}"
            for word, step in (("Up", 1), ("Down", -1))
            if floor + step in core.floors
        }
        return with_arrows(view, words.get(1), words.get(-1))

    def _at_core(self, kind: str) -> tuple[Session, int, SceneCore, Picture]:
        """Return the session, the floor, its nearest core of a kind, and the view of that core."""
        session = self._session()
        with session.shared.lock:
            floor = session.robot.floor
            core = session.world.core_near(session.robot, kind, float("inf"))
            if core is None:
                raise MansionError(ErrorCode.NOT_FOUND, f"floor {floor} has no {kind}")
            x, y, yaw = core_viewpoint(session.world.view(floor).map, core, CORE_DISTANCE[kind])
        poses = [CameraPose(x, y, CAMERA_HEIGHT, yaw)]
        frames = self._thread.run(self._draw, session, floor, poses, CORE_VIEW, COLOURS)
        return session, floor, core, frames[0].rgb

    def close(self) -> None:
        """Free the OpenGL context; the camera is of no use afterwards."""
        if self._floors is not None:
            self._thread.run(self._floors.close)
            self._floors = None
        self._thread.close()


def _landmark(session: Session, name: str) -> Landmark:
    """Return a landmark of the robot's floor, or of any other when none there has the name."""
    world, robot = session.world, session.robot
    others = [floor for floor in world.building.floors if floor != robot.floor]
    for floor in [robot.floor, *others]:
        found = landmark_named(name, world.view(floor).landmarks, floor, robot.place)
        if found is not None:
            return found
    marks = [mark.name for floor in world.building.floors for mark in world.view(floor).landmarks]
    near = choices(name, marks, "rooms, stairs and lifts")
    raise MansionError(ErrorCode.NOT_FOUND, f"there is no landmark {name!r}; {near}")
