"""Expand a topic name with its node's name and namespace."""

from __future__ import annotations

from rclpy._names import expand_name
from rclpy.exceptions import InvalidTopicNameException
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name

__all__ = ["expand_topic_name"]


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """The absolute name of a topic or service as a node means it.

    Raises
    ------
    InvalidTopicNameException, InvalidNodeNameException, InvalidNamespaceException
        If one of the three is not valid.
    """
    validate_topic_name(topic_name)
    validate_node_name(node_name)
    validate_namespace(node_namespace)
    try:
        return expand_name(topic_name, node_name, node_namespace)
    except ValueError as problem:
        raise InvalidTopicNameException(topic_name, str(problem), 0) from None
