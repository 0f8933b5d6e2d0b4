"""The graph of nodes, topics and services, as discovery shows it at the moment."""

from __future__ import annotations

import ctypes as ct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rclpy._dds.announcement import decode_announcement
from rclpy._dds.library import (
    ALIVE,
    BUILTIN_PARTICIPANT,
    BUILTIN_PUBLICATION,
    BUILTIN_SUBSCRIPTION,
    BuiltinEndpoint,
    BuiltinParticipant,
    SampleInfo,
    check,
    dds,
)
from rclpy._dds.qos_mapping import read_profile, read_user_data
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy._dds.participant import Participant

__all__ = [
    "EndpointInfo",
    "NodeInfo",
    "alive_participants",
    "demangle_service",
    "demangle_topic",
    "demangle_type",
    "endpoints",
    "nodes",
]

_BATCH = 64


@dataclass(frozen=True, slots=True)
class EndpointInfo:
    """A discovered endpoint; profile and type hash only if they were asked for."""

    guid: bytes
    topic: str
    type_name: str
    profile: QoSProfile | None
    type_hash: str


@dataclass(frozen=True, slots=True)
class NodeInfo:
    namespace: str
    name: str
    enclave: str
    readers: frozenset[bytes]
    writers: frozenset[bytes]


def _read_builtin(participant: Participant, topic: int, kind: Any) -> Iterator[Any]:
    """The live samples of a built-in topic, each valid until the next one is asked for."""
    reader = check(
        dds.dds_create_reader(participant.entity, topic, None, None), "read the discovery data"
    )
    try:
        samples = (ct.c_void_p * _BATCH)()
        infos = (SampleInfo * _BATCH)()
        condition = check(dds.dds_create_readcondition(reader, 2), "read the discovery data")
        while True:
            samples[0] = None
            count = dds.dds_read(condition, samples, infos, _BATCH, _BATCH)
            if count <= 0:
                return
            for i in range(count):
                if infos[i].valid_data and infos[i].instance_state == ALIVE:
                    yield kind.from_address(samples[i])
            dds.dds_return_loan(reader, samples, count)
    finally:
        dds.dds_delete(reader)


def alive_participants(participant: Participant) -> dict[bytes, str]:
    """The USER_DATA enclave of each participant in the domain, by GUID."""
    found = {}
    for sample in _read_builtin(participant, BUILTIN_PARTICIPANT, BuiltinParticipant):
        found[bytes(sample.key)] = read_user_data(sample.qos).get("enclave", "/")
    return found


def endpoints(
    participant: Participant, writers: bool, details_of: str | None = None
) -> list[EndpointInfo]:
    """All writers or readers in the domain, with the QoS of those on one DDS topic."""
    topic = BUILTIN_PUBLICATION if writers else BUILTIN_SUBSCRIPTION
    found = []
    for sample in _read_builtin(participant, topic, BuiltinEndpoint):
        name = sample.topic_name.decode()
        profile, type_hash = None, ""
        if name == details_of:
            profile = read_profile(sample.qos)
            type_hash = read_user_data(sample.qos).get("typehash", "")
        found.append(
            EndpointInfo(bytes(sample.key), name, sample.type_name.decode(), profile, type_hash)
        )
    return found


def nodes(participant: Participant) -> list[NodeInfo]:
    """Every node in the domain."""
    alive = alive_participants(participant)
    found: list[NodeInfo] = []
    for gid, data in participant.announcements().items():
        if gid not in alive:
            continue
        found.extend(
            NodeInfo(n.namespace, n.name, alive[gid], frozenset(n.readers), frozenset(n.writers))
            for n in decode_announcement(data)
        )
    return found


def demangle_topic(dds_topic: str) -> str | None:
    """``/a/b`` for ``rt/a/b``, None for anything that is no ROS topic."""
    return dds_topic[2:] if dds_topic.startswith("rt/") else None


def demangle_service(dds_topic: str) -> str | None:
    """``/a/ping`` for ``rq/a/pingRequest`` and ``rr/a/pingReply``."""
    if dds_topic.startswith("rq/") and dds_topic.endswith("Request"):
        return dds_topic[2 : -len("Request")]
    if dds_topic.startswith("rr/") and dds_topic.endswith("Reply"):
        return dds_topic[2 : -len("Reply")]
    return None


def demangle_type(dds_type: str) -> str:
    """``std_msgs/msg/String`` for ``std_msgs::msg::dds_::String_``; services lose their part."""
    parts = dds_type.split("::")
    if len(parts) < 2 or parts[-2] != "dds_" or not dds_type.endswith("_"):
        return dds_type
    name = parts[-1][:-1]
    if "srv" in parts:
        for suffix in ("_Request", "_Response"):
            name = name.removesuffix(suffix)
    return "/".join([*parts[:-2], name])
