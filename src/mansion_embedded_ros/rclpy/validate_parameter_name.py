"""Check a parameter name."""

from __future__ import annotations

from typing import Literal

from rclpy.exceptions import InvalidParameterException

__all__ = ["validate_parameter_name"]


def validate_parameter_name(name: str) -> Literal[True]:
    """Give True for a name that is not empty.

    Raises
    ------
    InvalidParameterException
        For an empty name.
    """
    if not name:
        raise InvalidParameterException(name)
    return True
