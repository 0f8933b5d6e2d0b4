"""The table of topics and services: names below the namespace, types, payloads and QoS, written once.

A node asks for its interface by name (``service("plan_program")``). The services of the skills are declared beside each
skill; `mansion_bringup.interfaces` adds them and makes ``docs/interfaces.md`` from the whole table.
"""

from mansion_msgs_py import building_interfaces, editing_interfaces, skill_interfaces
from mansion_msgs_py.interface_types import (
    DEFAULT_NAMESPACE,
    JSON_CALL,
    LATCHED,
    LATEST,
    SENSOR,
    STREAM,
    STRING,
    TRIGGER,
    Qos,
    ServiceInterface,
    TopicInterface,
)

__all__ = [
    "DEFAULT_NAMESPACE",
    "JSON_CALL",
    "LATCHED",
    "LATEST",
    "SENSOR",
    "SERVICES",
    "STREAM",
    "STRING",
    "TOPICS",
    "TRIGGER",
    "Qos",
    "ServiceInterface",
    "TopicInterface",
    "service",
    "topic",
]

TOPICS: tuple[TopicInterface, ...] = (*building_interfaces.TOPICS, *skill_interfaces.TOPICS, *editing_interfaces.TOPICS)

SERVICES: tuple[ServiceInterface, ...] = (
    *building_interfaces.SERVICES,
    *skill_interfaces.SERVICES,
    *editing_interfaces.SERVICES,
)


def topic(name: str) -> TopicInterface:
    """Return the topic of that name; KeyError when the table has none."""
    return _TOPICS[name]


def service(name: str) -> ServiceInterface:
    """Return the service of that name; KeyError when the table has none."""
    return _SERVICES[name]


_TOPICS = {entry.name: entry for entry in TOPICS}
_SERVICES = {entry.name: entry for entry in SERVICES}
