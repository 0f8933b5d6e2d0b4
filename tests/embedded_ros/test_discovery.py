"""What a node announces is what a real Jazzy node announces, seen by a bare Cyclone participant."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from typing import Any

import pytest
from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopicDcpsParticipant,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.core import Policy
from cyclonedds.domain import Domain, DomainParticipant

from .conftest import DOMAIN

NODE = """
import rclpy, sys
from rclpy.qos import QoSProfile, DurabilityPolicy
from std_msgs.msg import String
from std_srvs.srv import Trigger
rclpy.init(args=[])
node = rclpy.create_node("probe_node", namespace="/demo")
latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
node.create_publisher(String, "latched", latched)
node.create_service(Trigger, "ping", lambda request, response: response)
node.create_subscription(String, "incoming", print, 10)
node.create_client(Trigger, "pong")
print("ready")
rclpy.spin(node)
"""

CONFIG = (
    "<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
    '<Peers><Peer address="localhost"/></Peers></Discovery></Domain></CycloneDDS>'
)


def _qos(qos: Any) -> dict[str, Any]:
    found: dict[str, Any] = {"autodispose": None}
    for policy in qos:
        match = re.match(r"Policy\.(\w+)(?:\.(\w+))?", repr(policy))
        scope, kind = match.groups() if match else ("", "")
        if scope in ("Durability", "Liveliness", "Reliability"):
            found[scope.lower()] = kind
        elif isinstance(policy, Policy.Userdata):
            found["user_data"] = policy.data.decode()
        elif isinstance(policy, Policy.Lifespan):
            found["lifespan_ns"] = policy.lifespan if policy.lifespan < 2**63 - 1 else None
        elif isinstance(policy, Policy.WriterDataLifecycle):
            found["autodispose"] = policy.autodispose
        elif isinstance(policy, Policy.DataRepresentation):
            xcdr1_only = policy.use_cdrv0_representation and not policy.use_xcdrv2_representation
            found["representation"] = "XCDR1" if xcdr1_only else repr(policy)
    return found


def _normal_user_data(text: str, prefix: str) -> str:
    """The GUID prefix of the recorded participant replaced, ids kept as numbers."""

    def number(match: re.Match[str]) -> str:
        octets = match[2].strip().split(".")
        assert len(octets) == 16
        assert ".".join(octets[:12]) == prefix
        assert len(match[2].split(".")[0]) == 2, "the first byte is padded with a space"
        return f"{match[1]}={int(''.join(o.zfill(2) for o in octets[12:]), 16)};"

    return re.sub(r"(clientid|serviceid)=([^;]*);", number, text)


def _prefix(guid: str) -> str:
    return ".".join(f"{octet:x}" for octet in bytes.fromhex(guid)[:12])


def _observe() -> tuple[dict[str, str], list[dict[str, Any]]]:
    """Participants other than the observer, and their endpoints, once there are 24."""
    participant = DomainParticipant(DOMAIN)
    readers = {
        "writer": BuiltinDataReader(participant, BuiltinTopicDcpsPublication),
        "reader": BuiltinDataReader(participant, BuiltinTopicDcpsSubscription),
    }
    people = BuiltinDataReader(participant, BuiltinTopicDcpsParticipant)
    own = participant.guid
    participants: dict[str, str] = {}
    endpoints: dict[str, dict[str, Any]] = {}
    end = time.monotonic() + 10
    while time.monotonic() < end and len(endpoints) < 24:
        for sample in people.take(N=50):
            if sample.key != own:
                user_data = sample.qos[Policy.Userdata]
                participants[sample.key.hex] = user_data.data.decode() if user_data else ""
        for kind, reader in readers.items():
            for sample in reader.take(N=100):
                if sample.participant_key == own:
                    continue
                endpoints[sample.key.hex] = {
                    "kind": kind,
                    "topic": sample.topic_name,
                    "type": sample.type_name,
                    "guid": sample.key.hex,
                    "type_id": sample.type_id,
                    **_qos(sample.qos),
                }
        time.sleep(0.02)
    return participants, list(endpoints.values())


@pytest.fixture
def domain() -> Any:
    """The domain of the tests in this process, unless rclpy has made it already."""
    try:
        return Domain(DOMAIN, CONFIG)
    except Exception:
        return None


def test_a_node_announces_what_was_recorded(
    recorded: Callable[[str], Any], program: Callable[..., Any], domain: Any
) -> None:
    expected = recorded("discovery")
    probe = program(NODE)
    assert probe.line() == "ready"
    participants, endpoints = _observe()
    assert list(participants.values()) == ["enclave=/;"]
    guid = next(iter(participants))
    old = expected["participants"][0]["guid"]
    same = ("kind", "topic", "type", "durability", "liveliness", "reliability", "lifespan_ns")

    def view(entry: dict[str, Any], prefix: str) -> tuple[Any, ...]:
        user_data = _normal_user_data(entry["user_data"], prefix)
        return (*(entry.get(key) for key in same), user_data)

    found = sorted((view(e, _prefix(guid)) for e in endpoints), key=repr)
    wanted = (view(e, _prefix(old)) for e in expected["endpoints"])
    assert found == sorted(wanted, key=repr)
    assert {e["representation"] for e in endpoints} == {"XCDR1"}
    assert {e["autodispose"] for e in endpoints if e["kind"] == "writer"} == {False}
    assert {e["type_id"] for e in endpoints} == {None}
    # Entity numbers in GUIDs are given in order of creation; the recorded ones start at 4.
    numbers = {(e["kind"], e["topic"]): int(e["guid"][24:30], 16) + 3 for e in endpoints}
    assert numbers == {
        (e["kind"], e["topic"]): int(e["guid"][24:30], 16) for e in expected["endpoints"]
    }


def test_the_discovery_sample_lists_the_endpoints_in_the_recorded_order(
    recorded: Callable[[str], Any], program: Callable[..., Any], ros: Any
) -> None:
    expected = recorded("discovery")["ros_discovery_info"][0]
    probe = program(NODE)
    assert probe.line() == "ready"
    watcher = ros.create_node("watcher", start_parameter_services=False)
    try:
        assert watcher.wait_for_node("/demo/probe_node", 10.0)
        from rclpy._dds import graph

        deadline = time.monotonic() + 10
        node = None
        while time.monotonic() < deadline:
            known = graph.nodes(watcher._participant)
            node = next((n for n in known if n.name == "probe_node"), None)
            if node is not None and len(node.readers) == 10 and len(node.writers) == 12:
                break
            time.sleep(0.05)
        assert node is not None
        wanted = expected["nodes"][0]
        assert node.namespace == wanted["namespace"]
        for found, listed in ((node.readers, "readers"), (node.writers, "writers")):
            numbers = sorted(int(g.hex()[24:30], 16) + 3 for g in found)
            assert numbers == [int(g[24:30], 16) for g in wanted[listed]]
    finally:
        watcher.destroy_node()
