"""A session of the running graph as an MCAP file: every message as it came, in CDR, with the definition of its type."""

import os
import re
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import IO, Any, Final

from rclpy.node import Node

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.topic_echo import FoundTopic, find_topic, message_class
from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_tasks.recordings.mcap_file import message_definition

__all__ = ["GraphRecording", "definition_of"]

_ALIASES: Final = {"double": "float64", "float": "float32", "boolean": "bool", "octet": "byte"}
"""Types that IDL spells otherwise than ``.msg`` files."""

_SEQUENCE: Final = re.compile(r"sequence<(?P<inner>.+?)(?:, (?P<most>\d+))?>")
_ARRAY: Final = re.compile(r"(?P<inner>[^\[]+)(?P<length>\[\d+\])")

_LEFT_OUT: Final = ("/parameter_events", "/rosout")
_ON_DEMAND: Final = "/camera/"
"""Part of the names of topics that are only published while they have subscribers."""

QUEUE: Final = 1000
"""Messages of a topic that may wait to be written."""


def definition_of(kind: Any) -> str:
    """Return the definition of a message class and of all types in it, from the description in the class.

    Parameters
    ----------
    kind : type
        A generated message class. Its constants are left out.
    """
    fields: dict[str, tuple[str, ...]] = {}
    _collect(kind, fields)
    return message_definition(_name(kind), fields)


def _collect(kind: Any, fields: dict[str, tuple[str, ...]]) -> None:
    """Add the fields of a class, and those of the classes in it."""
    import importlib

    own = kind.get_fields_and_field_types()
    fields[_name(kind)] = tuple(f"{_spelt(each)} {name}" for name, each in own.items())
    for each in own.values():
        inner = _spelt(each).split("[")[0]
        if "/" in inner and inner not in fields:
            package, _, name = inner.partition("/")
            _collect(getattr(importlib.import_module(f"{package}.msg"), name), fields)


def _name(kind: Any) -> str:
    return f"{kind.__module__.split('.')[0]}/{kind.__name__}"


def _spelt(kind: str) -> str:
    """Return a type as ``.msg`` files spell it."""
    if found := _SEQUENCE.fullmatch(kind):
        most = f"<={found['most']}" if found["most"] else ""
        return f"{_spelt(found['inner'])}[{most}]"
    if found := _ARRAY.fullmatch(kind):
        return f"{_spelt(found['inner'])}{found['length']}"
    if found := re.fullmatch(r"(w?string)<(\d+)>", kind):
        return f"{found[1]}<={found[2]}"
    return _ALIASES.get(kind, kind)


class GraphRecording(Closing):
    """Records topics of a graph from its making to `close`; a ``with`` block ends the file.

    Parameters
    ----------
    client : MansionClient
    output : Path
        The file, which appears complete when the recording ends.
    topics : sequence of str
        What to record; all that is published when empty, but pictures, which are only made for those who ask.
    clock : callable
        Nanoseconds for the times of messages.
    """

    def __init__(
        self, client: MansionClient, output: Path, topics: Sequence[str] = (), clock: Callable[[], int] = time.time_ns
    ) -> None:
        self._client, self._output, self._wanted, self._clock = client, output, tuple(topics), clock
        self._lock = threading.Lock()
        self._last = 0
        self._recorded: set[str] = set()
        self._closed = False
        self.counts: dict[str, int] = {}
        self.missing: dict[str, str] = {}
        output.parent.mkdir(parents=True, exist_ok=True)
        self._part = output.with_name(f".{output.name}.{os.getpid()}")
        self._stream: IO[bytes] = self._part.open("wb")
        self._writer = _started(self._stream)

    def look(self) -> None:
        """Begin to record what has come to be published since the last look."""
        for found in self._published():
            if found.name in self._recorded:
                continue
            try:
                kind = message_class(found)
            except MansionError as error:
                self.missing[found.name] = error.info.message
                continue
            finally:
                self._recorded.add(found.name)
            self._subscribe(found, kind)

    def _published(self) -> list[FoundTopic]:
        node: Node = self._client.node
        names: Sequence[str] = self._wanted or [
            name
            for name, _ in sorted(node.get_topic_names_and_types())
            if name not in _LEFT_OUT and _ON_DEMAND not in name and node.count_publishers(name)
        ]
        return [found for name in names if (found := find_topic(node, name)) is not None]

    def _subscribe(self, found: FoundTopic, kind: Any) -> None:
        package, name = _name(kind).split("/")
        with self._lock:
            schema = self._writer.register_schema(
                name=f"{package}/msg/{name}", encoding="ros2msg", data=definition_of(kind).encode()
            )
            channel = self._writer.register_channel(topic=found.name, message_encoding="cdr", schema_id=schema)

        def keep(data: bytes) -> None:
            with self._lock:
                if self._closed:
                    return
                self._last = max(self._last, self._clock())
                number = self.counts.get(found.name, 0)
                self.counts[found.name] = number + 1
                self._writer.add_message(
                    channel_id=channel, log_time=self._last, publish_time=self._last, sequence=number, data=bytes(data)
                )

        profile = qos_profile(found.qos)
        profile.depth = max(profile.depth, QUEUE)
        self._client.node.create_subscription(kind, found.name, keep, profile, raw=True)

    def close(self) -> None:
        """End the file and put it in its place; to close it again does nothing."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
            self._writer.finish()
            self._stream.close()
        self._part.replace(self._output)


def _started(stream: IO[bytes]) -> Any:
    from mcap.writer import Writer

    writer = Writer(stream)
    writer.start(profile="ros2", library="mansion")
    return writer
