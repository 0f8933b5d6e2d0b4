"""What a node knows of the graph: nodes, topics, services and their endpoints."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from rclpy._dds import graph
from rclpy._node_names import NodeNames
from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum
from rclpy.type_hash import TypeHash
from rclpy.validate_full_topic_name import validate_full_topic_name

if TYPE_CHECKING:
    from rclpy._dds.participant import Participant

__all__ = ["NodeGraph"]

_NamesAndTypes = list[tuple[str, list[str]]]


def _collect(
    found: Iterable[graph.EndpointInfo],
    name_of: Callable[[str], str | None],
    type_of: Callable[[str], str] = graph.demangle_type,
) -> _NamesAndTypes:
    types: dict[str, set[str]] = {}
    for endpoint in found:
        name = name_of(endpoint.topic)
        if name is not None:
            types.setdefault(name, set()).add(type_of(endpoint.type_name))
    return [(name, sorted(types[name])) for name in sorted(types)]


def _unchanged(name: str) -> str:
    return name


def _topics(found: Iterable[graph.EndpointInfo], no_demangle: bool) -> _NamesAndTypes:
    if no_demangle:
        return _collect(found, _unchanged, _unchanged)
    return _collect(found, graph.demangle_topic)


class NodeGraph(NodeNames):
    """Mixed into ``Node``."""

    _participant: Participant

    def get_node_names(self) -> list[str]:
        """Names of the nodes, without namespaces."""
        return [node.name for node in graph.nodes(self._participant)]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Names of the nodes with their namespaces."""
        return [
            f"{node.namespace.rstrip('/')}/{node.name}" for node in graph.nodes(self._participant)
        ]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Name and namespace of each node."""
        return [(node.name, node.namespace) for node in graph.nodes(self._participant)]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Name, namespace and enclave of each node."""
        return [(n.name, n.namespace, n.enclave) for n in graph.nodes(self._participant)]

    def get_topic_names_and_types(self, no_demangle: bool = False) -> list[tuple[str, list[str]]]:
        """Each topic with its types; with ``no_demangle`` the names that DDS sees."""
        found = graph.endpoints(self._participant, True) + graph.endpoints(self._participant, False)
        return _topics(found, no_demangle)

    def get_service_names_and_types(self) -> list[tuple[str, list[str]]]:
        """Each service that has a server or a client, with its types."""
        found = graph.endpoints(self._participant, True) + graph.endpoints(self._participant, False)
        return _collect(found, graph.demangle_service)

    def _of_node(
        self, node_name: str, node_namespace: str, writers: bool
    ) -> list[graph.EndpointInfo]:
        known = graph.nodes(self._participant)
        namespace = node_namespace or "/"
        matches = [n for n in known if n.name == node_name and n.namespace == namespace]
        if not matches:
            full = f"{namespace.rstrip('/')}/{node_name}"
            raise NodeNameNonExistentError(f"Cannot find node '{full}' in the graph")
        guids = frozenset().union(*((n.writers if writers else n.readers) for n in matches))
        return [e for e in graph.endpoints(self._participant, writers) if e.guid in guids]

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Topics that a node publishes.

        Raises
        ------
        NodeNameNonExistentError
        """
        return _topics(self._of_node(node_name, node_namespace, True), no_demangle)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Topics that a node subscribes.

        Raises
        ------
        NodeNameNonExistentError
        """
        return _topics(self._of_node(node_name, node_namespace, False), no_demangle)

    def get_service_names_and_types_by_node(
        self, node_name: str, node_namespace: str
    ) -> list[tuple[str, list[str]]]:
        """Services that a node offers.

        Raises
        ------
        NodeNameNonExistentError
        """
        found = self._of_node(node_name, node_namespace, False)
        requests = [e for e in found if e.topic.startswith("rq/")]
        return _collect(requests, graph.demangle_service)

    def get_client_names_and_types_by_node(
        self, node_name: str, node_namespace: str
    ) -> list[tuple[str, list[str]]]:
        """Services that a node has clients of.

        Raises
        ------
        NodeNameNonExistentError
        """
        found = self._of_node(node_name, node_namespace, False)
        replies = [e for e in found if e.topic.startswith("rr/")]
        return _collect(replies, graph.demangle_service)

    def _count(self, dds_topic: str, writers: bool) -> int:
        return sum(e.topic == dds_topic for e in graph.endpoints(self._participant, writers))

    def count_publishers(self, topic_name: str) -> int:
        """How many publishers a topic has."""
        return self._count(f"rt{self._full(topic_name)}", True)

    def count_subscribers(self, topic_name: str) -> int:
        """How many subscriptions a topic has."""
        return self._count(f"rt{self._full(topic_name)}", False)

    def count_clients(self, service_name: str) -> int:
        """How many clients a service has."""
        return self._count(f"rr{self._full(service_name, True)}Reply", False)

    def count_services(self, service_name: str) -> int:
        """How many servers a service has."""
        return self._count(f"rq{self._full(service_name, True)}Request", False)

    def _full(self, name: str, service: bool = False) -> str:
        resolve = self.resolve_service_name if service else self.resolve_topic_name
        full = resolve(name)
        validate_full_topic_name(full, is_service=service)
        return full

    def get_publishers_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """The publishers of a topic."""
        return self._endpoint_infos(topic_name, no_mangle, True)

    def get_subscriptions_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """The subscriptions of a topic."""
        return self._endpoint_infos(topic_name, no_mangle, False)

    def _endpoint_infos(
        self, topic_name: str, no_mangle: bool, writers: bool
    ) -> list[TopicEndpointInfo]:
        dds_topic = topic_name if no_mangle else f"rt{self._full(topic_name)}"
        owners: dict[bytes, graph.NodeInfo] = {}
        for node in graph.nodes(self._participant):
            owners.update(dict.fromkeys(node.writers if writers else node.readers, node))
        kind = TopicEndpointTypeEnum.PUBLISHER if writers else TopicEndpointTypeEnum.SUBSCRIPTION
        infos = []
        for endpoint in graph.endpoints(self._participant, writers, dds_topic):
            if endpoint.topic != dds_topic or endpoint.profile is None:
                continue
            owner = owners.get(endpoint.guid)
            type_name = endpoint.type_name if no_mangle else graph.demangle_type(endpoint.type_name)
            infos.append(
                TopicEndpointInfo(
                    node_name=owner.name if owner else "_NODE_NAME_UNKNOWN_",
                    node_namespace=owner.namespace if owner else "_NODE_NAMESPACE_UNKNOWN_",
                    topic_type=type_name,
                    topic_type_hash=TypeHash._from_string(endpoint.type_hash),
                    endpoint_type=kind,
                    endpoint_gid=list(endpoint.guid),
                    qos_profile=endpoint.profile,
                )
            )
        return infos

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Wait until a node is in the graph; False at the timeout (seconds)."""
        name = fully_qualified_node_name
        full = name if name.startswith("/") else f"/{name}"
        end = time.monotonic() + timeout
        while full not in self.get_fully_qualified_node_names():
            if time.monotonic() >= end:
                return False
            time.sleep(0.05)
        return True
