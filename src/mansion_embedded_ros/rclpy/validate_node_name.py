"""Check a node name."""

from __future__ import annotations

from typing import Literal

from rclpy._names import node_name_fault
from rclpy.exceptions import InvalidNodeNameException

__all__ = ["validate_node_name"]


def validate_node_name(node_name: str) -> Literal[True]:
    """Give True for a valid name.

    Raises
    ------
    InvalidNodeNameException
        With the reason and the place.
    """
    fault = node_name_fault(node_name)
    if fault is not None:
        raise InvalidNodeNameException(node_name, *fault)
    return True
