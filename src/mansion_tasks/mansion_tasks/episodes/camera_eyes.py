"""An agent's eyes: pictures of the moment from the robot's camera, made when they are asked for."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import MansionError
from mansion_skills.engine.session import Session, SharedWorld
from mansion_skills.vision.annotated_pictures import tile_pages
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.marking import marked_view, png
from mansion_tasks.episodes.observing import Moment

if TYPE_CHECKING:
    from mansion_skills.vision import Camera

__all__ = ["CameraEyes", "MomentEyes"]

VIEW = (640, 480)


class CameraEyes(Closing):
    """A camera that goes from world to world; a ``with`` block frees it.

    Where nothing can render (no MuJoCo, no OpenGL, a building without models), the pictures are empty.
    """

    def __init__(self) -> None:
        self._camera: Camera | None = None
        self._world: World | None = None
        self._blind = False
        self._pages: dict[int, list[bytes]] = {}

    def close(self) -> None:
        """Free the camera."""
        if self._camera is not None:
            self._camera.close()
        self._camera = self._world = None
        self._pages.clear()

    def __call__(self, moment: Moment) -> "MomentEyes":
        """Return the eyes of a moment."""
        return MomentEyes(self, moment)

    def camera(self, world: World, robot: RobotBody) -> "Camera | None":
        """Return a camera on a robot, ``None`` where there can be none."""
        if self._blind:
            return None
        if self._camera is None or self._world is not world:
            self.close()
            try:
                from mansion_skills.vision import Camera

                session = Session(robot.session, SharedWorld(world), robot, durable=False)
                self._camera, self._world = Camera(session, *VIEW), world
            except (MansionError, ImportError):
                self._blind = True
        return self._camera

    def landmark_pages(self, camera: "Camera", moment: Moment) -> list[bytes]:
        """Return a floor's landmarks as pages of numbered tiles, drawn once an episode; none where one fails."""
        floor = moment.robot.floor
        if floor not in self._pages:
            entries = []
            for entry in moment.landmarks.landmarks:
                kind = "" if entry.kind == "room" else f" {entry.kind}"
                try:
                    picture = camera.panorama(entry.name)
                except MansionError:
                    return []
                entries.append((f"{moment.mask.place(entry.name)}{kind}", picture))
            pages = tile_pages(entries, f"Landmarks of floor {floor}")
            self._pages[floor] = [_picture(page) for page in pages]
        return self._pages[floor]


class MomentEyes:
    """See `mansion_tasks.agents.interface.Eyes`."""

    def __init__(self, eyes: CameraEyes, moment: Moment) -> None:
        self._eyes, self._moment = eyes, moment
        self._view: bytes | None = None

    def _camera(self) -> "Camera | None":
        return self._eyes.camera(self._moment.world, self._moment.robot)

    def view(self) -> bytes:
        """See `Eyes.view`; drawn once, though it is shown with both questions of a step."""
        if self._view is None:
            self._view = self._draw_view()
        return self._view

    def _draw_view(self) -> bytes:
        camera, moment = self._camera(), self._moment
        if camera is None:
            return b""
        try:
            frame = camera.render(depth=False)
        except MansionError:
            return b""
        marks = {thing.id: moment.mask.object(thing.id) for thing in moment.visible.objects}
        return marked_view(frame.rgb, frame.segmentation, frame.names, marks)

    def landmarks(self) -> list[bytes]:
        """See `Eyes.landmarks`."""
        camera = self._camera()
        return [] if camera is None else self._eyes.landmark_pages(camera, self._moment)

    def lift_panel(self) -> bytes:
        """See `Eyes.lift_panel`."""
        camera = self._camera()
        try:
            return b"" if camera is None else _picture(camera.lift_panel())
        except MansionError:
            return b""

    def stairs(self) -> bytes:
        """See `Eyes.stairs`."""
        camera = self._camera()
        try:
            return b"" if camera is None else _picture(camera.stairs_view())
        except MansionError:
            return b""


def _picture(pixels: npt.NDArray[np.uint8]) -> bytes:
    from PIL import Image

    return png(Image.fromarray(pixels))
