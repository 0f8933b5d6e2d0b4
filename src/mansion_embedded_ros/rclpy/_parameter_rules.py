"""What a declaration means, and whether a value lies in the range of its descriptor."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter

__all__ = ["double_fault", "integer_fault", "read_declaration"]


def read_declaration(namespace: str, given: Sequence[Any]) -> tuple[Parameter, ParameterDescriptor]:
    """The parameter and the descriptor of its own that a tuple of ``declare_parameters`` means.

    Raises
    ------
    TypeError, ValueError
    """
    if not isinstance(given, list | tuple) or not 1 <= len(given) <= 3:
        raise TypeError(f"a parameter is declared by 1 to 3 values, not {given!r}")
    name = given[0]
    if not isinstance(name, str):
        raise TypeError(f"First element {name!r} at index 0 in parameters list is not a str.")
    full = f"{namespace}{PARAMETER_SEPARATOR_STRING}{name}" if namespace else name
    value = given[1] if len(given) > 1 else None
    descriptor = given[2] if len(given) > 2 else ParameterDescriptor()
    if not isinstance(descriptor, ParameterDescriptor):
        raise TypeError(f"Third element {descriptor!r} in the tuple is no ParameterDescriptor")
    kind = descriptor.type
    descriptor = ParameterDescriptor(
        **{f: getattr(descriptor, f) for f in descriptor.get_fields_and_field_types()}
    )
    descriptor.name = full
    if isinstance(value, Parameter.Type):
        if value is Parameter.Type.NOT_SET:
            raise ValueError(f"Cannot declare parameter {full!r} of type NOT_SET")
        descriptor.type = value.value
        if descriptor.dynamic_typing:
            raise ValueError(
                f"When declaring a parameter only providing its type, 'dynamic_typing' must be "
                f"False: {full!r}"
            )
        return Parameter(full), descriptor
    parameter = Parameter(full, None, value)
    if not descriptor.dynamic_typing:
        if value is None and kind == 0:
            raise ValueError(
                f"Cannot declare a statically typed parameter {full!r} with neither a default "
                "value nor a type: give one, or a descriptor with dynamic_typing"
            )
        if value is not None:
            descriptor.type = parameter.type_.value
    return parameter, descriptor


def integer_fault(parameter: Parameter, limits: Any) -> str | None:
    """Why an integer is refused by an ``IntegerRange``, None if it is not."""
    low, high, step, value = limits.from_value, limits.to_value, limits.step, parameter.value
    if not low <= value <= high:
        return _outside(parameter, limits)
    if step and value != high and (value - low) % step:
        return (
            f"The parameter value for {parameter.name} is not a valid step. "
            f"Min: {low}, max: {high}, value: {value}, step: {step}"
        )
    return None


def double_fault(parameter: Parameter, limits: Any, tolerance: float) -> str | None:
    """Why a number is refused by a ``FloatingPointRange``, None if it is not."""
    low, high, step, value = limits.from_value, limits.to_value, limits.step, parameter.value

    def close(a: float, b: float) -> bool:
        return math.isclose(a, b, rel_tol=tolerance)

    if close(value, low) or close(value, high):
        return None
    if not low <= value <= high:
        return _outside(parameter, limits)
    if step > 0.0 and not close(low + round((value - low) / step) * step, value):
        return (
            f"The parameter value for {parameter.name} is not close enough to a valid step. "
            f"Min: {low}, max: {high}, value: {value}, step: {step}"
        )
    return None


def _outside(parameter: Parameter, limits: Any) -> str:
    return (
        f"Parameter {parameter.name} out of range Min: {limits.from_value}, "
        f"Max: {limits.to_value}, value: {parameter.value}"
    )
