"""The interface table is the one place for names, types and QoS."""

from pathlib import Path

from mansion_msgs_py.interfaces import SERVICES, TOPICS, markdown_table, service, topic
from mansion_msgs_py.payloads import PAYLOADS

DOCS = Path(__file__).parents[2] / "docs" / "interfaces.md"


def test_names_are_unique() -> None:
    names = [entry.name for entry in (*SERVICES, *TOPICS)]
    assert len(names) == len(set(names))


def test_results_are_latched_deep_enough_for_a_building() -> None:
    for name in ("program", "floor_layout", "floor_scene"):
        qos = topic(name).qos
        assert (qos.reliability, qos.durability, qos.depth) == ("reliable", "transient_local", 64)


def test_only_services_without_arguments_are_triggers() -> None:
    for entry in SERVICES:
        assert (entry.type == "std_srvs/srv/Trigger") == (entry.arguments is None)
    assert service("solve_floor").type == "diagnostic_msgs/srv/AddDiagnostics"


def test_every_typed_topic_carries_a_listed_payload() -> None:
    for entry in TOPICS:
        assert entry.payload is None or entry.payload.__name__ in PAYLOADS


def test_the_documented_table_is_the_one_in_the_code() -> None:
    assert markdown_table() in DOCS.read_text()
