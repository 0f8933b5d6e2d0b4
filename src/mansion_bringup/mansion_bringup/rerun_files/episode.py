"""An episode as a Rerun recording: the messages of its MCAP file in the building that they come from."""

import tempfile
from pathlib import Path

from mansion_bringup.rerun_files.building_drawing import BuildingDrawing
from mansion_bringup.rerun_files.rrd_file import Clock, RrdFile
from mansion_msgs_py.world import SkillStatus
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.log import EpisodeLog, EpisodeStep
from mansion_tasks.episodes.port import SkillPort
from mansion_tasks.recordings.episode import RecordedEpisode, record_episode
from mansion_tasks.recordings.messages import nanoseconds

__all__ = ["record_episode_for_rerun"]


def record_episode_for_rerun(
    log: EpisodeLog, building: Path, port: SkillPort, output: Path, *, pictures: bool = False
) -> RecordedEpisode:
    """Run the skills of an episode again and write what happened as a Rerun recording, whole or not at all.

    See `mansion_tasks.recordings.episode.record_episode`, whose messages the recording has.
    """
    start = log.start
    identity = f"{start.building_id}/{start.task.id}/{start.agent}/{start.seed}"
    with (
        tempfile.TemporaryDirectory() as folder,
        RrdFile(output, f"{start.task.id}, {start.agent}", Clock.WORLD, identity, pictures=pictures) as file,
    ):
        messages = Path(folder, "episode.mcap")
        made = record_episode(log, building, port, messages, pictures=pictures, also=_Observer(log, file))
        file.add_messages(messages)
        file.finish()
    return made


class _Observer:
    """Draws the world as it is at the start of an episode and after each step."""

    def __init__(self, log: EpisodeLog, file: RrdFile) -> None:
        self._log, self._file = log, file
        self._drawing: BuildingDrawing | None = None
        self._time = 0.0
        self._driven: object = None

    def __call__(self, number: int, world: World, robot: RobotBody) -> None:
        self._time = max(self._time, world.time)
        now = nanoseconds(self._time)
        if self._drawing is None:
            self._drawing = BuildingDrawing(self._file, [world.building.scene(each) for each in world.building.floors])
            self._drawing.show_robot(robot.radius)
            self._file.say(self._log.start.task.instruction, now)
        else:
            step = self._log.steps[number - 1]
            self._file.say(_told(step), now, "INFO" if step.status is SkillStatus.SUCCESS else "WARN")
        height = world.building.entry(robot.floor).elevation
        for text in self._drawing.update(world.objects, world.doors, now):
            self._file.say(text, now, "DEBUG")
        if robot.path and robot.path is not self._driven:
            self._driven = robot.path
            self._drawing.drive(robot.path, height, now)
        self._drawing.hold(world.objects.held_by(robot.session), robot.pose, height, now)


def _told(step: EpisodeStep) -> str:
    given = ", ".join(f"{name}={value}" for name, value in step.call.arguments.items())
    return f"{step.call.skill}({given}): {step.status}. {step.message}"
