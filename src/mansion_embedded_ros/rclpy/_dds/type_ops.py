"""Cyclone's topic descriptor for a message: the instructions with which it validates samples.

No XTypes information is attached, as in Jazzy, so endpoints match by type name. Offsets are those of
a C structure with the same members.
"""

from __future__ import annotations

import ctypes as ct
from dataclasses import dataclass
from functools import cache

from rclpy._dds.library import TopicDescriptor

from rosidl_embedded.definition import PRIMITIVES, FieldType, MessageDefinition, message_definition

__all__ = ["Descriptor", "topic_descriptor"]

_RTS, _ADR = 0x00 << 24, 0x01 << 24
_BYTES = {1: 0x01, 2: 0x02, 4: 0x03, 8: 0x04}
_STR, _SEQ, _ARR, _STU = 0x05, 0x07, 0x08, 0x0A
_SEQUENCE_SIZE, _POINTER_SIZE = 24, 8
_XCDR1 = 1


@dataclass(frozen=True, slots=True)
class Descriptor:
    """A C descriptor with the Python objects that own its memory."""

    struct: TopicDescriptor
    operations: ct.Array[ct.c_uint32]


def _layout(kind: FieldType) -> tuple[int, int]:
    """Size and alignment of one field in memory."""
    if kind.kind == "sequence":
        return _SEQUENCE_SIZE, 8
    if kind.is_message:
        size, align = _struct_layout(kind.base)
    elif kind.base == "string":
        size, align = _POINTER_SIZE, _POINTER_SIZE
    else:
        size = align = PRIMITIVES[kind.base][1]
    return size * max(kind.size, 1), align


@cache
def _struct_layout(name: str) -> tuple[int, int]:
    end, largest = 0, 1
    for field in message_definition(name).fields:
        size, align = _layout(field.type)
        end = -(-end // align) * align + size
        largest = max(largest, align)
    return max(-(-end // largest) * largest, 1), largest


class _Program:
    """Instructions; structures inside sequences become subroutines behind the main part."""

    def __init__(self) -> None:
        self.ops: list[int] = []
        self.pending: list[tuple[int, int, int, str]] = []

    def members(self, definition: MessageDefinition, base: int) -> None:
        offset = base
        if not definition.fields:
            self.ops += [_ADR | _BYTES[1] << 16, offset]
        for field in definition.fields:
            size, align = _layout(field.type)
            offset = base + -(-(offset - base) // align) * align
            self.field(field.type, offset)
            offset += size

    def field(self, kind: FieldType, offset: int) -> None:
        if kind.is_message:
            if kind.kind == "single":
                self.members(message_definition(kind.base), offset)
            else:
                self.nested(kind, offset)
            return
        element = _STR if kind.base == "string" else _BYTES[PRIMITIVES[kind.base][1]]
        if kind.kind == "sequence":
            self.ops += [_ADR | _SEQ << 16 | element << 8, offset]
        elif kind.kind == "array":
            self.ops += [_ADR | _ARR << 16 | element << 8, offset, kind.size]
        else:
            self.ops += [_ADR | element << 16, offset]

    def nested(self, kind: FieldType, offset: int) -> None:
        at = len(self.ops)
        size = _struct_layout(kind.base)[0]
        if kind.kind == "sequence":
            self.ops += [_ADR | _SEQ << 16 | _STU << 8, offset, size, 0]
            self.pending.append((at, at + 3, 4, kind.base))
        else:
            self.ops += [_ADR | _ARR << 16 | _STU << 8, offset, kind.size, 0, size]
            self.pending.append((at, at + 3, 5, kind.base))

    def finish(self) -> list[int]:
        self.ops.append(_RTS)
        subroutines: dict[str, int] = {}
        while self.pending:
            at, slot, following, name = self.pending.pop(0)
            if name not in subroutines:
                subroutines[name] = len(self.ops)
                self.members(message_definition(name), 0)
                self.ops.append(_RTS)
            self.ops[slot] = following << 16 | (subroutines[name] - at) & 0xFFFF
        return self.ops


@cache
def topic_descriptor(name: str, with_request_header: bool = False) -> Descriptor:
    """The descriptor of a message's topic type.

    Parameters
    ----------
    name
        Full name of a message or of a service's request or response.
    with_request_header
        Whether samples start with ``uint64 guid; int64 seq``, as those of services do.
    """
    definition = message_definition(name)
    program = _Program()
    start = 0
    if with_request_header:
        program.ops += [_ADR | _BYTES[8] << 16, 0, _ADR | _BYTES[8] << 16, 8]
        start = 16
    program.members(definition, start)
    ops = program.finish()
    memory = (ct.c_uint32 * len(ops))(*ops)
    size, align = _struct_layout(name)
    align = 8 if with_request_header else align
    struct = TopicDescriptor(
        m_size=-(-(start + size) // align) * align,
        m_align=align,
        m_typename=definition.dds_type.encode(),
        m_nops=len(ops),
        m_ops=ct.addressof(memory),
        m_meta=b"",
        restrict_data_representation=_XCDR1,
    )
    return Descriptor(struct, memory)
