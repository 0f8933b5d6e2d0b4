"""Check a topic or service name before its expansion."""

from __future__ import annotations

from typing import Literal

from rclpy._names import topic_name_fault
from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException

__all__ = ["TOPIC_SEPARATOR_STRING", "validate_topic_name"]

TOPIC_SEPARATOR_STRING = "/"


def validate_topic_name(name: str, *, is_service: bool = False) -> Literal[True]:
    """Give True for a valid name.

    Raises
    ------
    InvalidTopicNameException, InvalidServiceNameException
        With the reason and the place.
    """
    fault = topic_name_fault(name)
    if fault is not None:
        if is_service:
            raise InvalidServiceNameException(name, *fault)
        raise InvalidTopicNameException(name, *fault)
    return True
