"""The ``ros_discovery_info`` sample: which nodes a participant has, and their endpoints.

It is ``rmw_dds_common/msg/ParticipantEntitiesInfo``, written and read here without its class: every
process handles one for each change of every other, and GUIDs as NumPy arrays would cost the most.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass, field

from rosidl_embedded.cdr_codec import HEADER

__all__ = ["NodeEndpoints", "decode_announcement", "encode_announcement"]

_COUNT = struct.Struct("<I")
_GUID_SIZE = 16


@dataclass(eq=False)
class NodeEndpoints:
    """One node and the GUIDs of its endpoints, in the order of creation."""

    namespace: str
    name: str
    readers: list[bytes] = field(default_factory=list)
    writers: list[bytes] = field(default_factory=list)


def _put_count(buffer: bytearray, count: int) -> None:
    buffer += bytes(-len(buffer) % 4)
    buffer += _COUNT.pack(count)


def encode_announcement(guid: bytes, nodes: Iterable[NodeEndpoints]) -> bytearray:
    """The CDR of a participant's nodes."""
    buffer = bytearray(HEADER + guid)
    listed = list(nodes)
    _put_count(buffer, len(listed))
    for node in listed:
        for text in (node.namespace, node.name):
            data = text.encode()
            _put_count(buffer, len(data) + 1)
            buffer += data + b"\0"
        for guids in (node.readers, node.writers):
            _put_count(buffer, len(guids))
            buffer += b"".join(guids)
    return buffer


def decode_announcement(data: bytes) -> list[NodeEndpoints]:
    """The nodes of an announcement; ValueError if it is damaged."""
    offset = len(HEADER) + _GUID_SIZE

    def count() -> int:
        nonlocal offset
        offset += -offset % 4
        value: int = _COUNT.unpack_from(data, offset)[0]
        offset += 4
        return value

    def take(size: int) -> bytes:
        nonlocal offset
        if offset + size > len(data):
            raise ValueError("the announcement ends early")
        offset += size
        return data[offset - size : offset]

    try:
        nodes = []
        for _ in range(count()):
            names = [take(count())[:-1].decode("utf-8", "replace") for _ in range(2)]
            lists = []
            for _ in range(2):
                block = take(count() * _GUID_SIZE)
                lists.append([block[i : i + _GUID_SIZE] for i in range(0, len(block), _GUID_SIZE)])
            nodes.append(NodeEndpoints(names[0], names[1], lists[0], lists[1]))
    except struct.error as problem:
        raise ValueError(f"the announcement is damaged: {problem}") from problem
    return nodes
