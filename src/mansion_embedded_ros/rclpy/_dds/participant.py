"""The participant of a context: its topics, its nodes as others see them, and discovery."""

from __future__ import annotations

import ctypes as ct
import threading

from rclpy._dds.announcement import NodeEndpoints, encode_announcement
from rclpy._dds.domain import acquire_domain, release_domain
from rclpy._dds.endpoints import Reader, Writer
from rclpy._dds.library import check, dds
from rclpy._dds.qos_mapping import CQos
from rclpy._dds.type_ops import topic_descriptor
from rclpy._dds.waitset import Guard, WaitSet
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile

from rosidl_embedded.type_description import message_hash

__all__ = ["Participant"]

_DISCOVERY_TOPIC = "ros_discovery_info"
_DISCOVERY_TYPE = "rmw_dds_common/msg/ParticipantEntitiesInfo"
_GID_AT = 4
_PAUSE = 0.25
"""Seconds between two looks at the announcements of others: nobody waits for them in between."""


class Participant:
    """A DDS participant with one publisher and one subscriber, and the list of its nodes."""

    def __init__(self, domain_id: int) -> None:
        self.domain_id = domain_id
        self._lock = threading.RLock()
        self._topics: dict[tuple[str, str], list[int]] = {}
        self._nodes: list[NodeEndpoints] = []
        self._quiet = 0
        self._service_ids = 0
        self._announced: dict[bytes, bytes] = {}
        self.closed = False
        acquire_domain(domain_id)
        try:
            with CQos(user_data="enclave=/;") as qos:
                self.entity = check(
                    dds.dds_create_participant(domain_id, qos, None),
                    f"join domain {domain_id}",
                )
        except Exception:
            release_domain(domain_id)
            raise
        guid = (ct.c_uint8 * 16)()
        check(dds.dds_get_guid(self.entity, ct.byref(guid)), "read a GUID")
        self.guid = bytes(guid)
        self.publisher = check(
            dds.dds_create_publisher(self.entity, None, None), "create a publisher"
        )
        self.subscriber = check(
            dds.dds_create_subscriber(self.entity, None, None), "create a subscriber"
        )
        user_data = f"typehash={message_hash(_DISCOVERY_TYPE)};"
        transient = DurabilityPolicy.TRANSIENT_LOCAL
        self._writer = Writer(
            self,
            _DISCOVERY_TOPIC,
            _DISCOVERY_TYPE,
            QoSProfile(depth=1, durability=transient),
            user_data,
        )
        self._reader = Reader(
            self,
            _DISCOVERY_TOPIC,
            _DISCOVERY_TYPE,
            QoSProfile(history=HistoryPolicy.KEEP_ALL, durability=transient),
            user_data,
        )
        self._guard = Guard()
        self._stop = threading.Event()
        self._listener = threading.Thread(
            target=self._listen, name="ros_discovery_info", daemon=True
        )
        self._listener.start()

    def acquire_topic(self, name: str, type_name: str, with_request_header: bool) -> int:
        """The topic entity of a DDS topic name and ROS type; each call needs one release."""
        with self._lock:
            entry = self._topics.get((name, type_name))
            if entry is None:
                descriptor = topic_descriptor(type_name, with_request_header)
                entity = dds.dds_create_topic(
                    self.entity, ct.byref(descriptor.struct), name.encode(), None, None
                )
                entry = [check(entity, f"create topic {name!r} of {type_name}"), 0]
                self._topics[name, type_name] = entry
            entry[1] += 1
            return entry[0]

    def release_topic(self, name: str, type_name: str) -> None:
        with self._lock:
            entry = self._topics.get((name, type_name))
            if entry is None:
                return
            entry[1] -= 1
            if entry[1] == 0:
                del self._topics[name, type_name]
                dds.dds_delete(entry[0])

    def next_service_id(self) -> str:
        """The next id of a service or client, as USER_DATA writes it."""
        with self._lock:
            self._service_ids += 1
            number = self._service_ids
        octets = self.guid[:12] + number.to_bytes(4, "big")
        return f"{octets[0]:2x}." + ".".join(f"{octet:x}" for octet in octets[1:])

    def add_node(self, node: NodeEndpoints) -> None:
        with self._lock:
            self._nodes.append(node)
        self.announce()

    def remove_node(self, node: NodeEndpoints) -> None:
        with self._lock:
            if node in self._nodes:
                self._nodes.remove(node)
        self.announce()

    def pause_announcements(self, pause: bool) -> None:
        """While a node makes its first endpoints one announcement at the end is enough."""
        with self._lock:
            self._quiet += 1 if pause else -1
        if not pause:
            self.announce()

    def announce(self) -> None:
        """Publish which nodes have which endpoints."""
        with self._lock:
            if self._quiet or self.closed:
                return
            self._writer.write(encode_announcement(self.guid, self._nodes))

    def _listen(self) -> None:
        """Keep the latest announcement of each participant, a few times a second at most."""
        waitset = WaitSet()
        waitset.attach(self._reader.condition, 1)
        waitset.attach(self._guard.entity, 0)
        while not self._stop.is_set():
            tokens = waitset.wait(60_000_000_000)
            if 0 in tokens or self._stop.wait(_PAUSE):
                break
            self.announcements()
        waitset.close()

    def announcements(self) -> dict[bytes, bytes]:
        """The latest announcement of each participant, by its GUID, as CDR."""
        with self._lock:
            while (sample := self._reader.take()) is not None:
                gid = sample.data[_GID_AT : _GID_AT + 16]
                self._announced[gid] = sample.data
            if len(self._announced) > 256:
                self._forget_departed()
            return dict(self._announced)

    def _forget_departed(self) -> None:
        from rclpy._dds.graph import alive_participants

        alive = alive_participants(self)
        for gid in [g for g in self._announced if g not in alive]:
            del self._announced[gid]

    def close(self) -> None:
        """Leave the domain: all entities end, and others are told."""
        with self._lock:
            if self.closed:
                return
            self.closed = True
        self._stop.set()
        self._guard.trigger()
        if threading.current_thread() is not self._listener:
            self._listener.join(timeout=2.0)
        dds.dds_delete(self.entity)
        self._guard.close()
        release_domain(self.domain_id)
