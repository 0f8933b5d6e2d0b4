"""A recorded session of the graph as a Rerun recording: its messages, and the building as they say it changed."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from mansion_bringup.rerun_files.building_drawing import BuildingDrawing
from mansion_bringup.rerun_files.rrd_file import Clock, RrdFile
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.codec import convert, decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.world import ObjectState, SkillChange, WorldEvent
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.objects import ObjectTable, put_down, take_up
from mansion_skills.world.overlay import restore_shared
from mansion_skills.world.world import World

__all__ = ["StartingWorld", "convert_session", "starting_world"]

_EVENTS: Final = "/world_events"
_SCENES: Final = "/floor_scene"
_PATH: Final = "/path"
_MOTIONS: Final = ("pose", "yaw", "pitch")
"""What skills change that the poses of the messages show."""


@dataclass(frozen=True)
class StartingWorld:
    """A building as it is when a session begins; `doors` are those that are not as in their scene."""

    scenes: Sequence[FloorScene]
    objects: ObjectTable
    doors: Mapping[str, bool]


def starting_world(building: Path) -> StartingWorld:
    """Return a building as its folder has it now, with what robots left there.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is none, ``CONFLICT`` where what was left rests on another building.
    """
    world = World(LoadedBuilding(building))
    restore_shared(world)
    return StartingWorld([world.building.scene(each) for each in world.building.floors], world.objects, world.doors)


def convert_session(messages: Path, output: Path, begun: StartingWorld | None = None) -> None:
    """Write the messages of a session with the building in which it was, as a Rerun recording.

    Parameters
    ----------
    messages : Path
        The MCAP file of the session.
    output : Path
    begun : StartingWorld, optional
        The building; when absent that which the session has on ``floor_scene``, and none where it has none.
    """
    topics, start = _contents(messages)
    pictures = any("/camera/image" in topic for topic in topics)
    with RrdFile(output, output.stem, Clock.MACHINE, f"{output.stem}/{start}", pictures=pictures) as file:
        begun = begun or _announced(messages, topics)
        world = None if begun is None else _World(file, begun, start)
        for topic, time, message in _read(messages, topics, (_EVENTS, _PATH)):
            if topic.endswith(_EVENTS):
                _tell(file, world, decode(WorldEvent, message.data), time)
            elif world is not None:
                world.drive(message, time)
        file.add_messages(messages)
        file.finish()


def _contents(file: Path) -> tuple[list[str], int]:
    """Return the topics of an MCAP file, and the time of its first message."""
    from mcap.reader import make_reader

    with file.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    if summary is None or summary.statistics is None:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file} has no summary: the recording was not finished")
    return [channel.topic for channel in summary.channels.values()], summary.statistics.message_start_time


def _read(file: Path, topics: Sequence[str], endings: tuple[str, ...]) -> Iterator[tuple[str, int, Any]]:
    """Yield topic, time and content of the messages of some topics."""
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    wanted = [topic for topic in topics if topic.endswith(endings)]
    if not wanted:
        return
    with file.open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        for entry in reader.iter_decoded_messages(wanted):
            yield entry.channel.topic, entry.message.log_time, entry.decoded_message


def _announced(messages: Path, topics: Sequence[str]) -> StartingWorld | None:
    """Return the building that a session had last on ``floor_scene``."""
    found: dict[int, FloorScene] = {}
    for _, _, message in _read(messages, topics, (_SCENES,)):
        scene = decode(FloorScene, message.data)
        if any(each.building_id != scene.building_id for each in found.values()):
            found.clear()
        found.setdefault(scene.floor, scene)
    scenes = [found[floor] for floor in sorted(found)]
    return StartingWorld(scenes, ObjectTable(scenes), {}) if scenes else None


class _World:
    """The objects and doors of a building as world events change them, drawn."""

    def __init__(self, file: RrdFile, begun: StartingWorld, start: int) -> None:
        self._drawing = BuildingDrawing(file, begun.scenes)
        self._drawing.show_robot(ROBOT_RADIUS)
        self._objects, self._doors = begun.objects, dict(begun.doors)
        self._known = {door.id for scene in begun.scenes for door in scene.doors}
        self._drawing.update(self._objects, self._doors, start)

    def apply(self, event: WorldEvent, time: int) -> list[str]:
        """Change what an event says, and say what is drawn otherwise."""
        for change in event.changed:
            name, _, key = change.what.rpartition(".")
            if key == "open" and name in self._known:
                self._doors[name] = bool(change.after)
            elif key == "place" and name in self._objects:
                self._move(name, convert(ObjectState, change.after))
            elif name in self._objects:
                self._objects.set_state(name, key, change.after)
        return self._drawing.update(self._objects, self._doors, time)

    def _move(self, name: str, after: ObjectState) -> None:
        if after.held_by is not None:
            take_up(self._objects, name, after.held_by)
        elif after.floor is not None and after.position is not None:
            put_down(
                self._objects,
                name,
                floor=after.floor,
                room=after.room,
                position=after.position,
                rotation=after.rotation,
                parent=after.parent,
                mount=after.mount or self._objects.kinds[name].mount,
            )

    def drive(self, message: Any, time: int) -> None:
        """Draw a ``nav_msgs/Path``."""
        places = [each.pose.position for each in message.poses]
        if places:
            self._drawing.drive([(place.x, place.y) for place in places], places[0].z, time)


def _tell(file: RrdFile, world: _World | None, event: WorldEvent, time: int) -> None:
    """Write what an event says, and draw it where the building is known."""
    file.say(f"{event.skill} of {event.session}", time)
    if world is not None:
        for text in world.apply(event, time):
            file.say(text, time, "DEBUG")
    for change in event.changed:
        if change.what not in _MOTIONS and (world is None or not _drawn(change)):
            file.say(f"{change.what}: {change.before} -> {change.after}", time, "DEBUG")


def _drawn(change: SkillChange) -> bool:
    return isinstance(change.after, dict | bool)
