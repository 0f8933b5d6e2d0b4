"""A node's own name, and the full names of topics and services as the node sees them."""

from __future__ import annotations

from rclpy._arguments import RosArguments
from rclpy._names import expand_name
from rclpy.exceptions import InvalidTopicNameException
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name

__all__ = ["NodeNames"]


class NodeNames:
    """Mixed into ``Node``."""

    _arguments: list[RosArguments]
    _name: str
    _namespace: str

    def _own_name(self, name: str, namespace: str) -> tuple[str, str]:
        validate_node_name(name)
        for arguments in self._arguments:
            changed = arguments.namespace(name)
            if changed is not None:
                namespace = changed
                break
        for arguments in self._arguments:
            changed = arguments.node_name(name)
            if changed != name:
                name = changed
                break
        if not namespace.startswith("/"):
            namespace = f"/{namespace}"
        validate_node_name(name)
        validate_namespace(namespace)
        return name, namespace

    def get_name(self) -> str:
        """The name without namespace."""
        return self._name

    def get_namespace(self) -> str:
        """The namespace, ``/`` for none."""
        return self._namespace

    def get_fully_qualified_name(self) -> str:
        """Namespace and name."""
        return f"{self._namespace.rstrip('/')}/{self._name}"

    def _resolve(self, name: str, only_expand: bool, service: bool) -> str:
        validate_topic_name(name, is_service=service)
        try:
            full = expand_name(name, self._name, self._namespace)
        except ValueError as problem:
            raise InvalidTopicNameException(name, str(problem), 0) from None
        validate_full_topic_name(full, is_service=service)
        if only_expand:
            return full
        for arguments in self._arguments:
            changed = arguments.remap(full, self._name, self._namespace, service)
            if changed is not None:
                return changed
        return full

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """The full name of a topic, remapped unless ``only_expand``."""
        return self._resolve(topic, only_expand, False)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """The full name of a service, remapped unless ``only_expand``."""
        return self._resolve(service, only_expand, True)
