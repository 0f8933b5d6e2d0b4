"""Check a fully qualified topic or service name."""

from __future__ import annotations

from typing import Literal

from rclpy._names import full_name_fault
from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException

__all__ = ["validate_full_topic_name"]


def validate_full_topic_name(name: str, *, is_service: bool = False) -> Literal[True]:
    """Give True for a valid name.

    Raises
    ------
    InvalidTopicNameException, InvalidServiceNameException
        With the reason and the place.
    """
    fault = full_name_fault(name)
    if fault is not None:
        if is_service:
            raise InvalidServiceNameException(name, *fault)
        raise InvalidTopicNameException(name, *fault)
    return True
