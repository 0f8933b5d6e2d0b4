"""Writers and readers that carry ready-made CDR."""

from __future__ import annotations

import ctypes as ct
import threading
from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, NamedTuple

from rclpy._dds.library import (
    ANY_STATE,
    BuiltinEndpoint,
    DDSError,
    Iovec,
    SampleInfo,
    check,
    dds,
)
from rclpy._dds.qos_mapping import CQos, read_user_data
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy._dds.participant import Participant

__all__ = ["Endpoint", "Reader", "Sample", "Writer"]

_DATA = 2


class Sample(NamedTuple):
    """One received sample: CDR with its header, nanoseconds since 1970, handle of the writer."""

    data: bytes
    source_timestamp: int
    publication_handle: int


class Endpoint(ABC):
    """What writers and readers share: their entity, GUID and matched peers."""

    kind: str

    def __init__(
        self,
        participant: Participant,
        topic_name: str,
        type_name: str,
        profile: QoSProfile,
        user_data: str,
        with_request_header: bool = False,
    ) -> None:
        self.participant = participant
        self.topic_name = topic_name
        self.type_name = type_name
        self.profile = profile
        self._topic = participant.acquire_topic(topic_name, type_name, with_request_header)
        with CQos(profile, user_data) as qos:
            entity = self._create(self._topic, qos)
        if entity < 0:
            participant.release_topic(topic_name, type_name)
        self.entity = check(entity, f"create a {self.kind} of {topic_name!r}")
        guid = (ct.c_uint8 * 16)()
        check(dds.dds_get_guid(self.entity, ct.byref(guid)), "read a GUID")
        self.guid = bytes(guid)
        handle = ct.c_uint64()
        check(dds.dds_get_instance_handle(self.entity, ct.byref(handle)), "read a handle")
        self.instance_handle = handle.value

    @abstractmethod
    def _create(self, topic: int, qos: int) -> int:
        """Make the DDS entity; negative for an error."""

    @property
    def closed(self) -> bool:
        return self.entity <= 0

    def close(self) -> None:
        """Delete the entity; a second call does nothing."""
        entity, self.entity = self.entity, 0
        if entity > 0:
            dds.dds_delete(entity)
            self.participant.release_topic(self.topic_name, self.type_name)

    def _matched(self, function: str) -> list[int]:
        count = 16
        while not self.closed:
            handles = (ct.c_uint64 * count)()
            found = getattr(dds, function)(self.entity, handles, count)
            if found < 0:
                break
            if found <= count:
                return list(handles[:found])
            count = found + 8
        return []

    @abstractmethod
    def matched_handles(self) -> list[int]:
        """Instance handles of the matched endpoints."""

    @abstractmethod
    def matched_user_data(self, handle: int) -> dict[str, str] | None:
        """USER_DATA of a matched endpoint, None if it is gone."""

    def _user_data(self, pointer: int | None) -> dict[str, str] | None:
        if not pointer:
            return None
        endpoint = BuiltinEndpoint.from_address(pointer)
        try:
            return read_user_data(endpoint.qos)
        finally:
            dds.dds_builtintopic_free_endpoint(pointer)


class Writer(Endpoint):
    """A data writer of CDR samples."""

    kind = "writer"

    def _create(self, topic: int, qos: int) -> int:
        entity: int = dds.dds_create_writer(self.participant.publisher, topic, qos, None)
        self._sertype = ct.c_void_p()
        if entity > 0:
            check(dds.dds_get_entity_sertype(entity, ct.byref(self._sertype)), "read a type")
        return entity

    def write(self, data: bytearray) -> None:
        """Write one sample; ``data`` is padded in place to a multiple of 4 bytes.

        Raises
        ------
        DDSError
            If the writer is deleted, the data does not fit its type, or it waited too long.
        """
        data += b"\0" * (-len(data) % 4)
        vector = Iovec(ct.addressof(ct.c_char.from_buffer(data)), len(data))
        sample = dds.ddsi_serdata_from_ser_iov(self._sertype, _DATA, 1, ct.byref(vector), len(data))
        if not sample:
            raise DDSError(-3, f"write to {self.topic_name!r}: the data is no {self.type_name}")
        check(dds.dds_writecdr(self.entity, sample), f"write to {self.topic_name!r}")

    def matched_handles(self) -> list[int]:
        return self._matched("dds_get_matched_subscriptions")

    def matched_user_data(self, handle: int) -> dict[str, str] | None:
        return self._user_data(dds.dds_get_matched_subscription_data(self.entity, handle))


class Reader(Endpoint):
    """A data reader of CDR samples, with a read condition for wait sets."""

    kind = "reader"

    def _create(self, topic: int, qos: int) -> int:
        entity: int = dds.dds_create_reader(self.participant.subscriber, topic, qos, None)
        self._lock = threading.Lock()
        self._buffer = (ct.c_void_p * 1)()
        self._info = (SampleInfo * 1)()
        self._vector = Iovec()
        if entity > 0:
            self.condition = check(
                dds.dds_create_readcondition(entity, ANY_STATE), "create a read condition"
            )
        return entity

    def take(self) -> Sample | None:
        """The oldest sample, None if there is none."""
        with self._lock:
            while self.entity > 0:
                self._buffer[0] = None
                if dds.dds_takecdr(self.entity, self._buffer, 1, self._info, ANY_STATE) < 1:
                    return None
                pointer = self._buffer[0]
                info = self._info[0]
                try:
                    if not info.valid_data:
                        continue
                    data = self._copy(pointer)
                finally:
                    dds.ddsi_serdata_unref(pointer)
                return Sample(data, info.source_timestamp, info.publication_handle)
        return None

    def _copy(self, pointer: int | None) -> bytes:
        size = dds.ddsi_serdata_size(pointer)
        vector = self._vector
        reference = dds.ddsi_serdata_to_ser_ref(pointer, 0, size, ct.byref(vector))
        try:
            return ct.string_at(vector.base, vector.size)
        finally:
            dds.ddsi_serdata_to_ser_unref(reference, ct.byref(vector))

    def matched_handles(self) -> list[int]:
        return self._matched("dds_get_matched_publications")

    def matched_user_data(self, handle: int) -> dict[str, str] | None:
        return self._user_data(dds.dds_get_matched_publication_data(self.entity, handle))
