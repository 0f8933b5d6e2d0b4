"""Check a namespace."""

from __future__ import annotations

from typing import Literal

from rclpy._names import namespace_fault
from rclpy.exceptions import InvalidNamespaceException

__all__ = ["validate_namespace"]


def validate_namespace(namespace: str) -> Literal[True]:
    """Give True for a valid name.

    Raises
    ------
    InvalidNamespaceException
        With the reason and the place.
    """
    fault = namespace_fault(namespace)
    if fault is not None:
        raise InvalidNamespaceException(namespace, *fault)
    return True
