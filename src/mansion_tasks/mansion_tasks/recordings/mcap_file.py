"""An MCAP file of ROS 2 messages in CDR, as Foxglove and ``ros2 bag`` read them."""

from typing import IO, TYPE_CHECKING, Any

from mansion_msgs_py.closing import Closing
from mansion_tasks.recordings.definitions import message_definition

if TYPE_CHECKING:
    from mcap.records import Schema

__all__ = ["McapFile"]


class McapFile(Closing):
    """Writes messages that are given as dictionaries; a ``with`` block ends the file.

    Parameters
    ----------
    stream : binary file
        What to write to; it stays open.
    """

    def __init__(self, stream: IO[bytes]) -> None:
        from mcap_ros2.writer import Writer

        self._writer = Writer(stream)
        self._schemas: dict[str, Schema] = {}
        self._numbers: dict[str, int] = {}

    def close(self) -> None:
        """Write the summary at the end; to close it again does nothing."""
        self._writer.finish()

    def describe(self, name: str, facts: dict[str, str]) -> None:
        """Add a record of facts about the whole."""
        self._writer.add_metadata(name, facts)

    def write(self, topic: str, kind: str, message: dict[str, Any], time: int) -> None:
        """Add a message.

        Parameters
        ----------
        topic : str
        kind : str
            ``package/Type``, one of `definitions.FIELDS`.
        message : dict
            Its fields.
        time : int
            Nanoseconds on the recording's clock; never less than of the message before.
        """
        if kind not in self._schemas:
            package, _, name = kind.partition("/")
            self._schemas[kind] = self._writer.register_msgdef(f"{package}/msg/{name}", message_definition(kind))
        number = self._numbers.get(topic, 0)
        self._numbers[topic] = number + 1
        self._writer.write_message(topic, self._schemas[kind], message, time, time, number)
