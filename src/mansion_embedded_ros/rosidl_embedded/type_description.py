"""RIHS01 type hashes: SHA-256 of a type description in JSON (REP-2011, REP-2016)."""

from __future__ import annotations

import hashlib
import json
from functools import cache
from typing import Any

from rosidl_embedded.definition import (
    Field,
    FieldType,
    MessageDefinition,
    message_definition,
    service_definition,
)

__all__ = ["message_hash", "service_hash", "type_description"]

# Values of type_description_interfaces/msg/FieldType
_TYPE_ID = {
    "int8": 2,
    "uint8": 3,
    "int16": 4,
    "uint16": 5,
    "int32": 6,
    "uint32": 7,
    "int64": 8,
    "uint64": 9,
    "float32": 10,
    "float64": 11,
    "bool": 15,
    "byte": 16,
    "string": 17,
}
_NESTED, _BOUNDED_STRING = 1, 21
_ARRAY, _BOUNDED_SEQUENCE, _SEQUENCE = 48, 96, 144

_EMPTY = Field("structure_needs_at_least_one_member", FieldType("uint8"))


def _field(name: str, kind: FieldType) -> dict[str, Any]:
    if kind.is_message:
        type_id = _NESTED
    elif kind.string_bound:
        type_id = _BOUNDED_STRING
    else:
        type_id = _TYPE_ID[kind.base]
    if kind.kind == "array":
        type_id += _ARRAY
    elif kind.kind == "sequence":
        type_id += _BOUNDED_SEQUENCE if kind.size else _SEQUENCE
    return {
        "name": name,
        "type": {
            "type_id": type_id,
            "capacity": kind.size,
            "string_capacity": kind.string_bound,
            "nested_type_name": kind.base if kind.is_message else "",
        },
    }


def _individual(definition: MessageDefinition) -> dict[str, Any]:
    fields = definition.fields or (_EMPTY,)
    return {
        "type_name": definition.name,
        "fields": [_field(f.name, f.type) for f in fields],
    }


def _referenced(fields: tuple[Field, ...], found: dict[str, dict[str, Any]]) -> None:
    for field in fields:
        if field.type.is_message and field.type.base not in found:
            definition = message_definition(field.type.base)
            found[definition.name] = _individual(definition)
            _referenced(definition.fields, found)


@cache
def _describe(name: str) -> tuple[dict[str, Any], tuple[dict[str, Any], ...]]:
    kind, short = name.split("/")[1:]
    if kind == "srv" and not short.endswith(("_Request", "_Response", "_Event")):
        service = service_definition(name)
        fields = tuple(
            Field(f"{part}_message", FieldType(f"{name}_{part.capitalize()}"))
            for part in ("request", "response", "event")
        )
        own = MessageDefinition(service.name, fields, (), service.text)
    else:
        own = message_definition(name)
    found: dict[str, dict[str, Any]] = {}
    _referenced(own.fields, found)
    return _individual(own), tuple(found[key] for key in sorted(found))


def type_description(name: str) -> dict[str, Any]:
    """The type description of an interface, as in ``type_description_interfaces/TypeDescription``.

    Parameters
    ----------
    name
        Full name of a message, a service, or a service's ``_Request``, ``_Response``, ``_Event``.
    """
    own, referenced = _describe(name)
    return {"type_description": own, "referenced_type_descriptions": list(referenced)}


@cache
def _rihs01(name: str) -> str:
    text = json.dumps(type_description(name), ensure_ascii=True, separators=(", ", ": "))
    return "RIHS01_" + hashlib.sha256(text.encode()).hexdigest()


def message_hash(name: str) -> str:
    """``RIHS01_`` and 64 hexadecimal digits, of a message or a part of a service."""
    return _rihs01(name)


def service_hash(name: str) -> str:
    """The hash of a whole service type."""
    return _rihs01(name)
