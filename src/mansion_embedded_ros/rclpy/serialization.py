"""Messages as bytes: CDR with its encapsulation header."""

from __future__ import annotations

from rosidl_embedded.registry import deserialize, serialize

__all__ = ["deserialize_message", "serialize_message"]


def serialize_message(message) -> bytes:
    """Serialize a message.

    Raises
    ------
    TypeError
        If it is no message, or a field holds what its type cannot carry.
    """
    return bytes(serialize(message))


def deserialize_message(serialized_message: bytes, message_type):
    """The message that the bytes hold.

    Raises
    ------
    ValueError
        If they hold none of this type.
    """
    return deserialize(serialized_message, message_type)
