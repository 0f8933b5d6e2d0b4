"""Endpoint handles of services and clients: requests and replies, each after a header that tells who asked."""

from __future__ import annotations

import itertools
import struct
import threading
import time
from dataclasses import dataclass
from typing import Any

from rclpy._dds.announcement import NodeEndpoints
from rclpy._dds.endpoints import Endpoint
from rclpy._dds.participant import Participant
from rclpy._entities import Handle, type_data
from rclpy.qos import QoSProfile

from rosidl_embedded.cdr_codec import HEADER
from rosidl_embedded.registry import codec_of, deserialize, type_name

__all__ = ["Client", "Service", "rmw_request_id_t"]

_REQUEST_HEADER = struct.Struct("<Qq")

_PAYLOAD = len(HEADER) + _REQUEST_HEADER.size

_READER_WAIT = 1.0
"""Seconds that a response waits for the client's reader to be discovered."""


@dataclass(slots=True)
class rmw_request_id_t:
    """Who asked: the writer of the request and the client's sequence number."""

    writer_guid: bytes
    sequence_number: int
    publication_handle: int = 0


@dataclass(slots=True)
class rmw_service_info_t:
    """A request's id and its times in nanoseconds since 1970."""

    request_id: rmw_request_id_t
    source_timestamp: int
    received_timestamp: int


def _append(message: Any, data: bytearray) -> None:
    """Write a message after its header."""
    try:
        codec_of(type(message)).encode(message, data)
    except (struct.error, AttributeError, TypeError) as problem:
        raise TypeError(f"cannot serialize a {type(message).__name__}: {problem}") from problem


def _channel(
    topic: str, message: Any, profile: QoSProfile, identity: str
) -> tuple[str, str, QoSProfile, str, bool]:
    """Return what an endpoint that carries one half of a service is made of."""
    return topic, type_name(message), profile, type_data(message, identity), True


class Service(Handle):
    """The reader of a service's requests and the writer of its replies."""

    def __init__(
        self,
        participant: Participant,
        node: NodeEndpoints,
        srv_type: Any,
        name: str,
        profile: QoSProfile,
    ) -> None:
        super().__init__(participant, node)
        self._request, response = srv_type.Request, srv_type.Response
        identity = f"serviceid={participant.next_service_id()};"
        self.writer = self._writer(*_channel(f"rr{name}Reply", response, profile, identity))
        self.reader = self._reader(*_channel(f"rq{name}Request", self._request, profile, identity))
        self._known: set[int] = set()
        participant.announce()

    def take_request(self) -> tuple[Any, rmw_service_info_t] | None:
        """The next request and who asked, None if there is none."""
        sample = self.reader.take()
        if sample is None or len(sample.data) < _PAYLOAD:
            return None
        guid, number = _REQUEST_HEADER.unpack_from(sample.data, len(HEADER))
        request = deserialize(sample.data, self._request, _PAYLOAD)
        identity = rmw_request_id_t(guid.to_bytes(8, "little"), number, sample.publication_handle)
        return request, rmw_service_info_t(identity, sample.source_timestamp, time.time_ns())

    def send_response(self, response: Any, header: Any) -> None:
        """Answer a request; a client that is gone is left without."""
        identity = getattr(header, "request_id", header)
        data = bytearray(HEADER)
        data += identity.writer_guid[:8]
        data += identity.sequence_number.to_bytes(8, "little", signed=True)
        _append(response, data)
        if self._wait_for_reader(identity.publication_handle):
            self._write(self.writer, data, "send response")

    def _wait_for_reader(self, writer_handle: int) -> bool:
        """Wait until the asking client's reader is known, lest the reply gets lost."""
        if not writer_handle or writer_handle in self._known:
            return True
        deadline = time.monotonic() + _READER_WAIT
        while not self.closed:
            data = self.reader.matched_user_data(writer_handle)
            if data is None:
                return False
            client = data.get("clientid")
            if client is None or self._has_reader(client):
                if len(self._known) > 4096:
                    self._known.clear()
                self._known.add(writer_handle)
                return True
            if time.monotonic() > deadline:
                return True
            time.sleep(0.002)
        return False

    def _has_reader(self, client: str) -> bool:
        for handle in self.writer.matched_handles():
            data = self.writer.matched_user_data(handle)
            if data is not None and data.get("clientid") == client:
                return True
        return False


class Client(Handle):
    """The writer of requests and the reader of the replies to them."""

    def __init__(
        self,
        participant: Participant,
        node: NodeEndpoints,
        srv_type: Any,
        name: str,
        profile: QoSProfile,
    ) -> None:
        super().__init__(participant, node)
        request, self._response = srv_type.Request, srv_type.Response
        identity = f"clientid={participant.next_service_id()};"
        self.writer = self._writer(*_channel(f"rq{name}Request", request, profile, identity))
        self.reader = self._reader(*_channel(f"rr{name}Reply", self._response, profile, identity))
        self._numbers = itertools.count(1)
        self._lock = threading.Lock()
        participant.announce()

    def next_sequence_number(self) -> int:
        """The number of the next request."""
        return next(self._numbers)

    def send_request(self, request: Any, number: int) -> None:
        data = bytearray(HEADER)
        data += _REQUEST_HEADER.pack(self.writer.instance_handle, number)
        _append(request, data)
        self._write(self.writer, data, "send request")

    def take_response(self) -> tuple[int, Any] | None:
        """The next reply to this client: sequence number and message (or the exception that reading
        it raised); None if there is none."""
        while (sample := self.reader.take()) is not None:
            if len(sample.data) < _PAYLOAD:
                continue
            guid, number = _REQUEST_HEADER.unpack_from(sample.data, len(HEADER))
            if guid != self.writer.instance_handle:
                continue
            try:
                return number, deserialize(sample.data, self._response, _PAYLOAD)
            except ValueError as problem:
                return number, problem
        return None

    def is_server_available(self) -> bool:
        """Whether both endpoints of one server are matched."""
        readers = self._service_ids(self.writer)
        if not readers:
            return False
        writers = self._service_ids(self.reader)
        # Servers that give no id are taken on trust, as rmw_cyclonedds_cpp does.
        return bool(readers & writers)

    @staticmethod
    def _service_ids(endpoint: Endpoint) -> set[str]:
        found = set()
        for handle in endpoint.matched_handles():
            data = endpoint.matched_user_data(handle)
            if data is not None:
                found.add(data.get("serviceid", ""))
        return found
