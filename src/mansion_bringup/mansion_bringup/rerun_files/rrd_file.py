"""A Rerun recording (``.rrd``): the messages of an MCAP file, and what is drawn beside them on the same clock."""

import os
from enum import Enum
from pathlib import Path
from typing import Any, Final

from mansion_msgs_py.closing import Closing
from mansion_tasks.recordings.messages import MAP

__all__ = ["TIMELINE", "Clock", "RrdFile"]

TIMELINE: Final = "message_log_time"
"""The timeline on which Rerun puts the messages of an MCAP file."""

_PICTURES: Final = "/mansion/camera"


class Clock(Enum):
    """What the times of a recording are: of a world, from 0, or of the machine, since 1970."""

    WORLD = "duration_ns"
    MACHINE = "timestamp_ns"


class RrdFile(Closing):
    """Writes a recording; nothing appears under its name unless it is finished.

    Parameters
    ----------
    output : Path
    title : str
        What viewers call the recording.
    clock : Clock
    identity : str
        The same for recordings that a viewer is to show as one.
    pictures : bool
        Give what the camera sees a place on the screen.
    """

    def __init__(self, output: Path, title: str, clock: Clock, identity: str, *, pictures: bool = False) -> None:
        import rerun

        self._rerun: Any = rerun
        self._output, self._clock = output, clock
        output.parent.mkdir(parents=True, exist_ok=True)
        self._part = output.with_name(f".{output.name}.{os.getpid()}")
        self._stream: Any = rerun.RecordingStream("mansion", recording_id=identity)
        self._stream.set_log_time_enabled(False)
        self._stream.set_log_tick_enabled(False)
        self._stream.save(self._part, default_blueprint=self._screen(pictures=pictures))
        self._stream.send_recording_name(title)
        # Rerun gives each entity a frame of its own; these hang below that of the messages.
        self._stream.log("frame", rerun.Transform3D(parent_frame=MAP, child_frame="tf#/"), static=True, strict=True)

    def close(self) -> None:
        """Give up what is not finished; to close again does nothing."""
        self._stream.disconnect()
        self._part.unlink(missing_ok=True)

    def finish(self) -> None:
        """Put the recording in its place."""
        self._stream.flush()
        self._stream.disconnect()
        self._part.replace(self._output)

    def show(self, entity: list[str], shape: Any, *more: Any, time: int | None = None) -> None:
        """Draw something.

        Parameters
        ----------
        entity : list of str
            Names from the root to it.
        shape, *more
            Rerun's archetypes.
        time : int, optional
            Nanoseconds from which it is seen; always when absent.
        """
        self._set(time)
        self._stream.log(entity, shape, *more, static=time is None, strict=True)

    def say(self, text: str, time: int, level: str = "INFO") -> None:
        """Add a line to the texts."""
        self._set(time)
        self._stream.log("events", self._rerun.TextLog(text, level=level), strict=True)

    def add_messages(self, file: Path) -> None:
        """Add all messages of an MCAP file, by the names of their topics."""
        from rerun.chunk import McapReader

        self._stream.send_chunks(McapReader(file, timeline_type=self._clock.value).stream())

    def _set(self, time: int | None) -> None:
        import numpy as np

        if time is None:
            return
        if self._clock is Clock.WORLD:
            self._stream.set_time(TIMELINE, duration=np.timedelta64(time, "ns"))
        else:
            self._stream.set_time(TIMELINE, timestamp=np.datetime64(time, "ns"))

    def _screen(self, *, pictures: bool) -> Any:
        """Return how a viewer is to begin: the building, beside it the texts and what the camera sees."""
        from rerun import blueprint

        view = blueprint.Spatial3DView(name="building", contents=["+ /**", f"- {_PICTURES}/**"])
        beside: list[Any] = [blueprint.TextLogView(origin="/events", name="events")]
        if pictures:
            beside.insert(0, blueprint.Spatial2DView(origin=_PICTURES, name="camera"))
        columns = blueprint.Horizontal(view, blueprint.Vertical(*beside), column_shares=[3, 1])
        return blueprint.Blueprint(columns, blueprint.TimePanel(timeline=TIMELINE), collapse_panels=True)
