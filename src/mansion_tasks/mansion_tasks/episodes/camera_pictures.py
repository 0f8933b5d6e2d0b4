"""Pictures for agents from the robot's camera, the objects in view marked with numbers."""

from collections.abc import Callable, Mapping, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.late_imports import importing
from mansion_skills.engine.session import Session, SharedWorld
from mansion_skills.vision.annotated_pictures import tile_pages
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.observations import Snapshot

if TYPE_CHECKING:
    from mansion_skills.vision import Camera

__all__ = ["CameraPictures", "SnapshotPictures", "marked_view", "png"]

MIN_PIXELS = 12
"""Pixels of an object that gets a mark."""


def png(picture: Any) -> bytes:
    """Return a Pillow image as PNG."""
    stream = BytesIO()
    picture.save(stream, "PNG", compress_level=6)
    return stream.getvalue()


def _label(drawing: Any, place: tuple[float, float], text: str, *, size: int = 14) -> None:
    """Draw a text in white on a black box, its upper left corner at `place`."""
    from PIL import ImageFont

    font = ImageFont.load_default(size)
    box = drawing.textbbox(place, text, font=font)
    drawing.rectangle((box[0] - 2, box[1] - 2, box[2] + 2, box[3] + 2), fill=(0, 0, 0))
    drawing.text(place, text, fill=(255, 255, 255), font=font)


def marked_view(
    rgb: npt.NDArray[np.uint8], segmentation: npt.NDArray[np.int32], names: Sequence[str], marks: Mapping[str, str]
) -> bytes:
    """Return a camera's picture with a number on each object of `marks` that it shows.

    Parameters
    ----------
    rgb, segmentation : arrays
        (height, width, 3) and (height, width); labels are indices into `names`.
    marks : mapping
        Id to number.
    """
    from PIL import Image, ImageDraw

    picture = Image.fromarray(rgb)
    drawing = ImageDraw.Draw(picture)
    numbers = {name: index for index, name in enumerate(names)}
    for name, mark in marks.items():
        rows, columns = np.nonzero(segmentation == numbers.get(name, -2))
        if len(rows) < MIN_PIXELS:
            continue
        column = int(np.sort(columns)[len(columns) // 2])
        row = int(np.median(rows[columns == column]))
        _label(drawing, (column - 8.0, row - 8.0), mark)
    return png(picture)


VIEW = (640, 480)


class CameraPictures(Closing):
    """A camera that goes from world to world; a ``with`` block frees it.

    Where nothing can render, without MuJoCo, OpenGL or a model of the floor, the pictures are empty.
    """

    def __init__(self) -> None:
        self._camera: Camera | None = None
        self._world: World | None = None
        self._unavailable = False
        self._pages: dict[int, list[bytes]] = {}

    def close(self) -> None:
        """Free the camera."""
        if self._camera is not None:
            self._camera.close()
        self._camera = self._world = None
        self._pages.clear()

    def __call__(self, snapshot: Snapshot) -> "SnapshotPictures":
        """Return the pictures of a snapshot."""
        return SnapshotPictures(self, snapshot)

    def camera(self, world: World, robot: RobotBody) -> "Camera | None":
        """Return a camera on a robot, ``None`` where there can be none."""
        if self._unavailable:
            return None
        if self._camera is None or self._world is not world:
            self.close()
            try:
                with importing:
                    from mansion_skills.vision import Camera

                session = Session(robot.session, SharedWorld(world), robot, durable=False)
                self._camera, self._world = Camera(session, *VIEW), world
            except (MansionError, ImportError):
                self._unavailable = True
        return self._camera

    def landmark_pages(self, camera: "Camera", snapshot: Snapshot) -> list[bytes]:
        """Return a floor's landmarks as pages of numbered tiles, drawn once an episode; none where one fails."""
        floor = snapshot.robot.floor
        if floor not in self._pages:
            entries = []
            for entry in snapshot.landmarks.landmarks:
                kind = "" if entry.kind == "room" else f" {entry.kind}"
                try:
                    picture = camera.panorama(entry.name)
                except MansionError:
                    return []
                entries.append((f"{snapshot.anonymizer.place(entry.name)}{kind}", picture))
            pages = tile_pages(entries, f"Landmarks of floor {floor}")
            self._pages[floor] = [_picture(page) for page in pages]
        return self._pages[floor]


class SnapshotPictures:
    """See `mansion_tasks.agents.interface.Pictures`."""

    def __init__(self, pictures: CameraPictures, snapshot: Snapshot) -> None:
        self._camera_of_episode, self._snapshot = pictures, snapshot
        self._view: bytes | None = None

    def _camera(self) -> "Camera | None":
        return self._camera_of_episode.camera(self._snapshot.world, self._snapshot.robot)

    def view(self) -> bytes:
        """See `Pictures.view`; drawn once, though it is shown with both questions of a step."""
        if self._view is None:
            self._view = self._draw_view()
        return self._view

    def _draw_view(self) -> bytes:
        camera, snapshot = self._camera(), self._snapshot
        if camera is None:
            return b""
        try:
            frame = camera.render(depth=False)
        except MansionError:
            return b""
        marks = {item.id: snapshot.anonymizer.object(item.id) for item in snapshot.visible.objects}
        return marked_view(frame.rgb, frame.segmentation, frame.names, marks)

    def landmarks(self) -> list[bytes]:
        """See `Pictures.landmarks`."""
        camera = self._camera()
        return [] if camera is None else self._camera_of_episode.landmark_pages(camera, self._snapshot)

    def lift_panel(self) -> bytes:
        """See `Pictures.lift_panel`."""
        return self._drawn(lambda camera: camera.lift_panel())

    def stairs(self) -> bytes:
        """See `Pictures.stairs`."""
        return self._drawn(lambda camera: camera.stairs_view())

    def _drawn(self, draw: "Callable[[Camera], npt.NDArray[np.uint8]]") -> bytes:
        """Return a picture that the camera draws; empty without a camera, or where it cannot be drawn."""
        camera = self._camera()
        try:
            return b"" if camera is None else _picture(draw(camera))
        except MansionError:
            return b""


def _picture(pixels: npt.NDArray[np.uint8]) -> bytes:
    from PIL import Image

    return png(Image.fromarray(pixels))
