"""The interface table is the one place for names, types and QoS."""

from mansion_msgs_py.interfaces import TOPICS, service, topic
from mansion_msgs_py.payloads import PAYLOADS


def test_results_are_latched_deep_enough_for_a_building() -> None:
    for name in ("program", "floor_layout", "floor_scene"):
        qos = topic(name).qos
        assert (qos.reliability, qos.durability, qos.depth) == ("reliable", "transient_local", 64)


def test_a_service_with_arguments_is_no_trigger() -> None:
    assert service("solve_floor").type == "diagnostic_msgs/srv/AddDiagnostics"


def test_every_typed_topic_carries_a_listed_payload() -> None:
    for entry in TOPICS:
        assert entry.payload is None or entry.payload.__name__ in PAYLOADS
