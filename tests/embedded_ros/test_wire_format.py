"""Bytes, hashes and names are those recorded from ROS 2 Jazzy."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from rclpy.serialization import deserialize_message, serialize_message

from rosidl_embedded.registry import definition_of, get_message, get_service, type_hash

VECTORS = json.loads((Path(__file__).parent / "data" / "vectors.json").read_text(encoding="utf-8"))


def _records() -> dict[str, Any]:
    found = dict(VECTORS["messages"])
    for name, service in VECTORS["services"].items():
        found[f"{name}_Request"] = service["request"]
        found[f"{name}_Response"] = service["response"]
    return found


RECORDS = _records()


def fill(cls: Any, value: dict[str, Any]) -> Any:
    """A message with the recorded values; samples exceed bounds, so they are not checked."""
    message = cls(check_fields=False)
    for field in definition_of(cls).fields:
        setattr(message, field.name, _convert(field.type, value[field.name]))
    return message


def _convert(kind: Any, value: Any) -> Any:
    if kind.kind != "single":
        return [_convert(kind.element, item) for item in value]
    if kind.is_message:
        return fill(get_message(kind.base), value)
    if kind.base == "byte":
        return value.encode("latin-1") if isinstance(value, str) else bytes([value])
    return value


@pytest.mark.parametrize("name", RECORDS)
def test_messages_serialize_to_the_recorded_bytes(name: str) -> None:
    cls = get_message(name)
    for sample in RECORDS[name]["samples"]:
        assert serialize_message(fill(cls, sample["value"])).hex() == sample["cdr"]


@pytest.mark.parametrize("name", RECORDS)
def test_the_recorded_bytes_deserialize_to_the_recorded_values(name: str) -> None:
    cls = get_message(name)
    for sample in RECORDS[name]["samples"]:
        message = deserialize_message(bytes.fromhex(sample["cdr"]), cls)
        assert message == fill(cls, sample["value"])
        assert serialize_message(message).hex() == sample["cdr"]


@pytest.mark.parametrize("name", RECORDS)
def test_a_new_message_has_the_recorded_defaults(name: str) -> None:
    assert serialize_message(get_message(name)()).hex() == RECORDS[name]["samples"][0]["cdr"]


@pytest.mark.parametrize("name", RECORDS)
def test_type_names_hashes_and_fields_are_the_recorded_ones(name: str) -> None:
    cls: Any = get_message(name)
    record = RECORDS[name]
    assert definition_of(cls).dds_type == record["dds_type"]
    assert type_hash(cls) == record["hash"]
    assert cls.get_fields_and_field_types() == record["fields"]


@pytest.mark.parametrize("name", VECTORS["services"])
def test_service_hashes_are_the_recorded_ones(name: str) -> None:
    assert type_hash(get_service(name)) == VECTORS["services"][name]["hash"]


@pytest.mark.parametrize("name", RECORDS)
def test_truncated_data_raises_a_value_error(name: str) -> None:
    cls = get_message(name)
    data = bytes.fromhex(RECORDS[name]["samples"][1]["cdr"])
    for end in range(0, len(data), max(1, len(data) // 40)):
        with pytest.raises(ValueError, match=r"cannot read|not little-endian"):
            deserialize_message(data[:end], cls)


def test_announcements_are_the_message_of_rmw_dds_common() -> None:
    from rclpy._dds.announcement import NodeEndpoints, decode_announcement, encode_announcement

    from rmw_dds_common.msg import Gid, NodeEntitiesInfo, ParticipantEntitiesInfo

    guids = [bytes(range(i, i + 16)) for i in range(5)]
    nodes = [
        NodeEndpoints("/", "first", guids[:2], guids[2:]),
        NodeEndpoints("/deep/er", "second", [], guids[:1]),
    ]
    message = ParticipantEntitiesInfo(
        gid=Gid(data=list(guids[4])),
        node_entities_info_seq=[
            NodeEntitiesInfo(
                node_namespace=node.namespace,
                node_name=node.name,
                reader_gid_seq=[Gid(data=list(g)) for g in node.readers],
                writer_gid_seq=[Gid(data=list(g)) for g in node.writers],
            )
            for node in nodes
        ],
    )
    data = serialize_message(message)
    assert encode_announcement(guids[4], nodes) == data
    decoded = decode_announcement(data)
    assert [vars(n) for n in decoded] == [vars(n) for n in nodes]
    for end in range(20, len(data)):
        with pytest.raises(ValueError, match="announcement"):
            decode_announcement(data[:end])
