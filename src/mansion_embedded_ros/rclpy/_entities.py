"""Endpoint handles: what is on the wire for a publisher or a subscription."""

from __future__ import annotations

import time
from typing import Any, TypeVar

from rclpy._dds.announcement import NodeEndpoints
from rclpy._dds.endpoints import Endpoint, Reader, Writer
from rclpy._dds.library import DDSError
from rclpy._dds.participant import Participant
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy.qos import QoSProfile

from rosidl_embedded.registry import deserialize, serialize, type_hash, type_name

__all__ = ["Handle", "Publisher", "Subscription", "type_data"]

_Endpoint = TypeVar("_Endpoint", Writer, Reader)


def type_data(cls: Any, extra: str = "") -> str:
    """What an endpoint tells others of its type: the hash of REP 2016."""
    return f"{extra}typehash={type_hash(cls)};"


class Handle:
    """The endpoints of one entity of a node, listed with the node for others to see."""

    def __init__(self, participant: Participant, node: NodeEndpoints) -> None:
        self.participant = participant
        self._node = node
        self._endpoints: list[Endpoint] = []

    def __enter__(self) -> Handle:
        if self.closed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        return self

    def __exit__(self, *_: object) -> None:
        return None

    @property
    def closed(self) -> bool:
        return not self._endpoints

    def _writer(self, *args: Any) -> Writer:
        return self._add(Writer, self._node.writers, args)

    def _reader(self, *args: Any) -> Reader:
        return self._add(Reader, self._node.readers, args)

    def _add(self, kind: type[_Endpoint], listed: list[bytes], args: tuple[Any, ...]) -> _Endpoint:
        try:
            endpoint = kind(self.participant, *args)
        except DDSError as problem:
            self.destroy()
            raise RCLError(str(problem)) from problem
        self._endpoints.append(endpoint)
        listed.append(endpoint.guid)
        return endpoint

    def _write(self, writer: Writer, data: bytearray, action: str) -> None:
        if self.closed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        try:
            writer.write(data)
        except DDSError as problem:
            raise RCLError(f"Failed to {action}: {problem}") from problem

    def destroy(self) -> None:
        """End the endpoints and take them off the node's list."""
        endpoints, self._endpoints = self._endpoints, []
        for endpoint in endpoints:
            listed = self._node.readers if isinstance(endpoint, Reader) else self._node.writers
            if endpoint.guid in listed:
                listed.remove(endpoint.guid)
            endpoint.close()
        if endpoints:
            self.participant.announce()


class Publisher(Handle):
    """The writer of a topic."""

    def __init__(
        self,
        participant: Participant,
        node: NodeEndpoints,
        msg_type: Any,
        topic: str,
        profile: QoSProfile,
    ) -> None:
        super().__init__(participant, node)
        name = topic if profile.avoid_ros_namespace_conventions else f"rt{topic}"
        self.writer = self._writer(name, type_name(msg_type), profile, type_data(msg_type))
        participant.announce()

    def publish(self, msg: Any) -> None:
        self._write(self.writer, serialize(msg), "publish")

    def publish_raw(self, msg: bytes) -> None:
        self._write(self.writer, bytearray(msg), "publish")


class Subscription(Handle):
    """The reader of a topic."""

    def __init__(
        self,
        participant: Participant,
        node: NodeEndpoints,
        msg_type: Any,
        topic: str,
        profile: QoSProfile,
    ) -> None:
        super().__init__(participant, node)
        self._type = msg_type
        name = topic if profile.avoid_ros_namespace_conventions else f"rt{topic}"
        self.reader = self._reader(name, type_name(msg_type), profile, type_data(msg_type))
        participant.announce()

    def take_message(self, msg_type: Any, raw: bool) -> tuple[Any, dict[str, Any]] | None:
        """The next message (CDR bytes if ``raw``) and its info, None if there is none."""
        sample = self.reader.take()
        if sample is None:
            return None
        message = sample.data if raw else deserialize(sample.data, self._type)
        info = {
            "source_timestamp": sample.source_timestamp,
            "received_timestamp": time.time_ns(),
            "publication_sequence_number": None,
            "reception_sequence_number": None,
        }
        return message, info
