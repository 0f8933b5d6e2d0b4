"""Message and service classes by full name, made when first asked for, and their codecs."""

from __future__ import annotations

import threading
from struct import error
from typing import Any

from rosidl_embedded.cdr_codec import HEADER, Codec, compile_codec
from rosidl_embedded.definition import (
    MessageDefinition,
    ServiceDefinition,
    message_definition,
    service_definition,
)
from rosidl_embedded.message_class import CHECK_FIELDS, build_message_class, module_name
from rosidl_embedded.type_description import message_hash, service_hash

__all__ = [
    "codec_of",
    "deserialize",
    "get_interface",
    "get_message",
    "get_service",
    "serialize",
    "type_name",
]

_classes: dict[str, type] = {}
_codecs: dict[type, Codec] = {}
_lock = threading.RLock()


def get_message(name: str) -> type:
    """The class of ``std_msgs/msg/String``, or of ``std_srvs/srv/Trigger_Request``."""
    cls = _classes.get(name)
    if cls is None:
        with _lock:
            cls = _classes.get(name)
            if cls is None:
                cls = _classes[name] = build_message_class(message_definition(name))
    return cls


class _ServiceMeta(type):
    """Service classes are containers; nobody makes instances of them."""

    def __call__(cls, *args: Any, **kwargs: Any) -> Any:
        raise NotImplementedError("Service classes can not be instantiated")


def get_service(name: str) -> type:
    """The class of ``std_srvs/srv/Trigger`` with ``Request``, ``Response`` and ``Event``."""
    cls = _classes.get(name)
    if cls is None:
        with _lock:
            definition = service_definition(name)
            namespace = {
                "__module__": module_name(name),
                "_definition": definition,
                "Request": get_message(definition.request.name),
                "Response": get_message(definition.response.name),
                "Event": get_message(definition.event.name),
            }
            cls = _classes.setdefault(name, _ServiceMeta(name.split("/")[2], (), namespace))
    return cls


def get_interface(name: str) -> type:
    """The class of a message or service by its full name, ``package/msg/Name``."""
    return get_service(name) if _is_service(name) else get_message(name)


def _is_service(name: str) -> bool:
    _, kind, short = name.split("/")
    return kind == "srv" and not short.endswith(("_Request", "_Response", "_Event"))


def definition_of(cls: Any) -> MessageDefinition | ServiceDefinition | None:
    """The definition behind an interface class, None for any other object."""
    found = getattr(cls, "_definition", None)
    return found if isinstance(found, MessageDefinition | ServiceDefinition) else None


def type_name(cls: Any) -> str:
    """``std_msgs/msg/String`` for its class."""
    definition = definition_of(cls)
    if definition is None:
        raise TypeError(f"{cls!r} is no message or service class")
    return definition.name


def type_hash(cls: Any) -> str:
    """The RIHS01 hash of an interface class."""
    definition = definition_of(cls)
    if isinstance(definition, ServiceDefinition):
        return service_hash(definition.name)
    return message_hash(type_name(cls))


def codec_of(cls: Any) -> Codec:
    """The compiled codec of a message class."""
    codec = _codecs.get(cls)
    if codec is None:
        definition = definition_of(cls)
        if not isinstance(definition, MessageDefinition):
            raise TypeError(f"{cls!r} is no message class")
        codec = _codecs[cls] = compile_codec(definition, CHECK_FIELDS)
    return codec


def serialize(message: Any) -> bytearray:
    """The message as CDR with its encapsulation header.

    Raises
    ------
    TypeError
        If a field holds a value that its type cannot carry.
    """
    buffer = bytearray(HEADER)
    cls = type(message)
    try:
        codec_of(cls).encode(message, buffer)
    except (error, AttributeError, TypeError) as problem:
        raise TypeError(f"cannot serialize a {cls.__name__}: {problem}") from problem
    return buffer


def deserialize(data: bytes | bytearray | memoryview, cls: type, offset: int = 4) -> Any:
    """A message of class ``cls`` from CDR; ``offset`` is where its fields start."""
    view = memoryview(data)
    if len(view) < 4 or view[0] != 0 or view[1] != 1:
        raise ValueError("the data is not little-endian plain CDR (encapsulation 00 01)")
    try:
        return codec_of(cls).decode(view, offset)[0]
    except (error, ValueError) as problem:
        raise ValueError(f"cannot read a {cls.__name__}: {problem}") from problem
