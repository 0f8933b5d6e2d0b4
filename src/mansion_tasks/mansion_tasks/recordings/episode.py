"""An episode as an MCAP file: its skills are run again, and the state of the world after each is recorded."""

from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.interface_types import DEFAULT_NAMESPACE
from mansion_msgs_py.world import Pose2D
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.camera_pictures import CameraPictures
from mansion_tasks.episodes.log import EpisodeLog
from mansion_tasks.episodes.port import SkillPort
from mansion_tasks.episodes.replaying import OnStep, replay
from mansion_tasks.recordings.mcap_file import McapFile
from mansion_tasks.recordings.messages import image, nanoseconds, occupancy_grid, path, pose_stamped, stamp, transform

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

__all__ = ["CAMERA", "EPISODE_TOPICS", "RecordedEpisode", "record_episode"]

BASE, CAMERA = "base_link", f"{DEFAULT_NAMESPACE}/camera/image/compressed"

EPISODE_TOPICS: dict[str, str] = {
    "/clock": "rosgraph_msgs/Clock",
    "/map": "nav_msgs/OccupancyGrid",
    "/tf": "tf2_msgs/TFMessage",
    "/tf_static": "tf2_msgs/TFMessage",
    f"{DEFAULT_NAMESPACE}/robot_pose": "geometry_msgs/PoseStamped",
    f"{DEFAULT_NAMESPACE}/path": "nav_msgs/Path",
    f"{DEFAULT_NAMESPACE}/episode": "std_msgs/String",
    f"{DEFAULT_NAMESPACE}/skill_events": "std_msgs/String",
    CAMERA: "sensor_msgs/CompressedImage",
}
"""Type of each topic of a recorded episode."""

JPEG_QUALITY = 85


@dataclass(frozen=True)
class RecordedEpisode:
    """What a recording holds.

    Attributes
    ----------
    messages : dict of str to int
        Number of messages by topic.
    seconds : float
        On the world's clock.
    """

    messages: dict[str, int]
    seconds: float


def record_episode(
    log: EpisodeLog,
    building: Path,
    port: SkillPort,
    output: Path,
    *,
    pictures: bool = False,
    also: OnStep = lambda step, world, robot: None,
) -> RecordedEpisode:
    """Run the skills of an episode again and write what happened as an MCAP file, whole or not at all.

    Stamps are those of the world's clock. At the start and after each skill there are a pose, a clock and transforms;
    the map comes when the floor, a door or what stands on it changed, a path when the robot drove.

    Parameters
    ----------
    log : EpisodeLog
    building : Path
        Folder of its building, which stays as it is.
    port : SkillPort
    output : Path
    pictures : bool
        Also what the camera sees at each of these moments, for which the extra ``sim`` is needed.
    also : callable
        Called at each of these moments, as `replay` does.

    Raises
    ------
    MansionError
        ``CONFLICT`` where something else came of the skills than the log has: the building is another one.
        ``UNAVAILABLE`` where pictures are asked for and nothing can render them.
    """
    stream = BytesIO()
    with McapFile(stream) as file, CameraPictures() as camera:
        file.describe("mansion", _facts(log))
        recorder = _Recorder(log, file, camera if pictures else None)

        def observe(step: int, world: World, robot: RobotBody) -> None:
            recorder.observe(step, world, robot)
            also(step, world, robot)

        differences = replay(log, building, port, observe)
        if differences:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"the episode cannot be reproduced in {building}: {differences[0]}",
                details={"differences": differences},
            )
        recorder.finish()
    write_atomic(output, stream.getvalue())
    return RecordedEpisode(dict(sorted(recorder.counts.items())), recorder.time)


def _facts(log: EpisodeLog) -> dict[str, str]:
    start = log.start
    return {
        "building_id": start.building_id,
        "task": start.task.id,
        "instruction": start.task.instruction,
        "agent": start.agent,
        "seed": str(start.seed),
        "success": str(log.end.success).lower(),
    }


class _Recorder:
    """Writes the moments of one episode."""

    def __init__(self, log: EpisodeLog, file: McapFile, camera: CameraPictures | None) -> None:
        self._log, self._file, self._camera = log, file, camera
        self._mapped: tuple[int, int] | None = None
        self._driven: object = None
        self.time = 0.0
        self.counts: dict[str, int] = {}

    def observe(self, number: int, world: World, robot: RobotBody) -> None:
        """Write the world after a step, or, with number 0, before the first."""
        self.time = max(self.time, world.time)
        elevation = world.building.entry(robot.floor).elevation
        self._write("/clock", {"clock": stamp(self.time)})
        if number == 0:
            self._begin(world)
        else:
            self._write(f"{DEFAULT_NAMESPACE}/skill_events", {"data": encode(self._log.steps[number - 1])})
        version = world.view(robot.floor).map.version
        if self._mapped != (robot.floor, version):
            self._mapped = (robot.floor, version)
            self._write("/map", occupancy_grid(self.time, world, robot.floor))
        self._write("/tf", {"transforms": [transform(self.time, BASE, robot.pose, elevation)]})
        self._write(f"{DEFAULT_NAMESPACE}/robot_pose", pose_stamped(self.time, robot.pose, elevation))
        if robot.path and robot.path is not self._driven:
            self._driven = robot.path
            self._write(f"{DEFAULT_NAMESPACE}/path", path(self.time, robot.path, elevation))
        if self._camera is not None:
            self._write(CAMERA, image(self.time, _jpeg(_seen(self._camera, world, robot)), "jpeg", BASE))

    def finish(self) -> None:
        """Write how it ended."""
        self._write(f"{DEFAULT_NAMESPACE}/episode", {"data": encode(self._log.end)})

    def _begin(self, world: World) -> None:
        origin = Pose2D(x=0.0, y=0.0)
        frames = [
            transform(self.time, f"floor_{floor}".replace("-", "m"), origin, world.building.entry(floor).elevation)
            for floor in world.building.floors
        ]
        self._write("/tf_static", {"transforms": frames})
        self._write(f"{DEFAULT_NAMESPACE}/episode", {"data": encode(self._log.start)})

    def _write(self, topic: str, message: dict[str, Any]) -> None:
        self.counts[topic] = self.counts.get(topic, 0) + 1
        self._file.write(topic, EPISODE_TOPICS[topic], message, nanoseconds(self.time))


def _seen(pictures: CameraPictures, world: World, robot: RobotBody) -> "npt.NDArray[np.uint8]":
    camera = pictures.camera(world, robot)
    if camera is None:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            "nothing can render here: pictures need the extra 'sim' and an OpenGL; "
            "the episode can be recorded without --pictures",
        )
    return camera.render(depth=False, segmentation=False).rgb


def _jpeg(pixels: "npt.NDArray[np.uint8]") -> bytes:
    from PIL import Image

    stream = BytesIO()
    Image.fromarray(pixels).save(stream, "JPEG", quality=JPEG_QUALITY)
    return stream.getvalue()
