"""MCAP files of ROS 2 messages in CDR, as Foxglove and ``ros2 bag`` read them, with the message definitions.

The definitions are written out here so that an episode is recorded without ROS 2; a test compares them with ROS's own.
"""

from typing import IO, TYPE_CHECKING, Any, Final

from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import ErrorCode, MansionError

if TYPE_CHECKING:
    from mcap.records import Schema

__all__ = ["FIELDS", "McapFile", "RULE", "message_definition"]

RULE: Final = "=" * 80
"""The line between a definition and those of the types that it uses."""

FIELDS: Final[dict[str, tuple[str, ...]]] = {
    "builtin_interfaces/Time": ("int32 sec", "uint32 nanosec"),
    "geometry_msgs/Point": ("float64 x", "float64 y", "float64 z"),
    "geometry_msgs/Pose": ("geometry_msgs/Point position", "geometry_msgs/Quaternion orientation"),
    "geometry_msgs/PoseStamped": ("std_msgs/Header header", "geometry_msgs/Pose pose"),
    "geometry_msgs/Quaternion": ("float64 x", "float64 y", "float64 z", "float64 w"),
    "geometry_msgs/Transform": ("geometry_msgs/Vector3 translation", "geometry_msgs/Quaternion rotation"),
    "geometry_msgs/TransformStamped": (
        "std_msgs/Header header",
        "string child_frame_id",
        "geometry_msgs/Transform transform",
    ),
    "geometry_msgs/Vector3": ("float64 x", "float64 y", "float64 z"),
    "nav_msgs/MapMetaData": (
        "builtin_interfaces/Time map_load_time",
        "float32 resolution",
        "uint32 width",
        "uint32 height",
        "geometry_msgs/Pose origin",
    ),
    "nav_msgs/OccupancyGrid": ("std_msgs/Header header", "nav_msgs/MapMetaData info", "int8[] data"),
    "nav_msgs/Path": ("std_msgs/Header header", "geometry_msgs/PoseStamped[] poses"),
    "rosgraph_msgs/Clock": ("builtin_interfaces/Time clock",),
    "sensor_msgs/CompressedImage": ("std_msgs/Header header", "string format", "uint8[] data"),
    "std_msgs/Header": ("builtin_interfaces/Time stamp", "string frame_id"),
    "std_msgs/String": ("string data",),
    "tf2_msgs/TFMessage": ("geometry_msgs/TransformStamped[] transforms",),
}
"""Fields of each type, in order."""


def message_definition(name: str, fields: dict[str, tuple[str, ...]] = FIELDS) -> str:
    """Return the definition of a type followed by those of all types in it, as MCAP's encoding ``ros2msg`` has them.

    Parameters
    ----------
    name : str
        ``package/Type``.
    fields : dict
        Fields of it and of all types in it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a type that `fields` does not have.

    Examples
    --------
    >>> print(message_definition("rosgraph_msgs/Clock").replace(RULE, "==="))
    builtin_interfaces/Time clock
    ===
    MSG: builtin_interfaces/Time
    int32 sec
    uint32 nanosec
    """
    parts = []
    for each in _with_inner(name, fields):
        heading = [] if each == name else [RULE, f"MSG: {each}"]
        parts.append("\n".join([*heading, *fields[each]]))
    return "\n".join(parts)


def _with_inner(name: str, fields: dict[str, tuple[str, ...]]) -> list[str]:
    """Return a type and all types in it, each once."""
    found = [name]
    for each in found:
        if each not in fields:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no definition of the message type {each!r}")
        for field in fields[each]:
            kind = field.split(" ")[0].split("[")[0]
            if "/" in kind and kind not in found:
                found.append(kind)
    return found


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
            ``package/Type``, a key of `FIELDS`.
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
