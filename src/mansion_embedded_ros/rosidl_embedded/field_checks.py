"""Checks and conversions of values assigned to message fields.

Each function takes the value, the field's type and name, and whether to check, and gives what the
field stores. A refused value raises ``AssertionError``, as in Jazzy.
"""

from __future__ import annotations

import math
from array import array
from collections import UserList, UserString
from collections.abc import Sequence, Set
from functools import cache
from operator import index
from typing import Any

from rosidl_embedded.definition import PRIMITIVES, FieldType

__all__ = [
    "check_message",
    "check_number",
    "check_sequence",
    "check_string",
    "to_array",
    "to_ndarray",
]

_FLOAT32_MAX = 3.402823466e38


def check_message(value: Any, cls: type, name: str, check: bool) -> Any:
    if check and not isinstance(value, cls):
        raise AssertionError(f"The '{name}' field must be a sub message of type '{cls.__name__}'")
    return value


def check_string(value: Any, kind: FieldType, name: str, check: bool) -> Any:
    if check:
        if not isinstance(value, str):
            raise AssertionError(f"The '{name}' field must be of type 'str'")
        if kind.string_bound and len(value) > kind.string_bound:
            raise AssertionError(
                f"The '{name}' field must be string value not longer than {kind.string_bound}"
            )
    return value


def check_number(value: Any, base: str, name: str, check: bool) -> Any:
    """A bool, a byte (``bytes`` of length 1), a float, or an integer within its range."""
    if not check:
        return value
    if base == "bool":
        if not isinstance(value, bool) and type(value).__name__ not in ("bool_", "bool"):
            raise AssertionError(f"The '{name}' field must be of type 'bool'")
        return bool(value)
    if base == "byte":
        if not isinstance(value, bytes | bytearray | memoryview) or len(value) != 1:
            raise AssertionError(
                f"The '{name}' field must be of type 'bytes' or 'ByteString' with length 1"
            )
        return bytes(value)
    if base.startswith("float"):
        if not isinstance(value, float):
            raise AssertionError(f"The '{name}' field must be of type 'float'")
        if base == "float32" and not _is_float32(value):
            raise AssertionError(
                f"The '{name}' field must be a float in [-{_FLOAT32_MAX}, {_FLOAT32_MAX}]"
            )
        return value
    try:
        number = index(value)
    except TypeError:
        raise AssertionError(f"The '{name}' field must be of type 'int'") from None
    low, high = _integer_range(base)
    if not low <= number <= high:
        kind = "an unsigned integer" if low == 0 else "an integer"
        raise AssertionError(f"The '{name}' field must be {kind} in [{low}, {high}]")
    return number


def check_sequence(value: Any, kind: FieldType, name: str, check: bool) -> Any:
    """A list of strings, bools, bytes or messages, within its bound or of its length."""
    if not check:
        return value
    _require_sequence(value, kind, name)
    _require_length(value, kind, name)
    element = kind.element
    if element.is_message:
        from rosidl_embedded.registry import get_message

        cls = get_message(element.base)
        for item in value:
            check_message(item, cls, name, True)
    elif element.base == "string":
        for item in value:
            check_string(item, element, name, True)
    else:
        for item in value:
            check_number(item, element.base, name, True)
    return value


def to_array(value: Any, kind: FieldType, name: str, check: bool) -> Any:
    """An ``array.array`` of the field's element type, from any sequence of numbers."""
    code, _, _ = PRIMITIVES[kind.base]
    if isinstance(value, array):
        if check:
            if value.typecode != code:
                raise AssertionError(
                    f"The '{name}' array.array() must have the type code of '{code}'"
                )
            _require_length(value, kind, name)
        return value
    if check:
        _require_length(value, kind, name)
    if hasattr(value, "dtype"):
        return _array_from_numpy(value, code, kind, name)
    if isinstance(value, bytes | bytearray | memoryview) and code in "bB":
        return array(code, bytes(value))
    if check:
        _require_sequence(value, kind, name)
    try:
        return array(code, value)
    except (TypeError, OverflowError) as problem:
        raise AssertionError(
            f"The '{name}' field must be a sequence of '{kind.base}': {problem}"
        ) from None


def _array_from_numpy(value: Any, code: str, kind: FieldType, name: str) -> Any:
    import numpy

    flat = numpy.ravel(value)
    wanted = numpy.dtype(code)
    if flat.dtype != wanted:
        if flat.dtype.kind == "f" and wanted.kind != "f":
            raise AssertionError(f"The '{name}' field must be a sequence of '{kind.base}'")
        converted = flat.astype(wanted)
        if wanted.kind != "f" and not numpy.array_equal(converted, flat):
            raise AssertionError(f"The '{name}' field has values outside of '{kind.base}'")
        flat = converted
    result = array(code)
    result.frombytes(numpy.ascontiguousarray(flat).tobytes())
    return result


def to_ndarray(value: Any, kind: FieldType, name: str = "", check: bool = False) -> Any:
    """A ``numpy.ndarray`` of the field's length and element type; zeros for ``None``."""
    import numpy

    dtype = numpy.dtype(PRIMITIVES[kind.base][0])
    if value is None:
        return numpy.zeros(kind.size, dtype)
    if isinstance(value, numpy.ndarray):
        if value.dtype != dtype:
            raise AssertionError(f"The '{name}' numpy.ndarray() must have the dtype of '{dtype}'")
        if value.size != kind.size:
            raise AssertionError(f"The '{name}' numpy.ndarray() must have a size of {kind.size}")
        return value.reshape(kind.size)
    if check:
        _require_sequence(value, kind, name)
    if len(value) != kind.size:
        raise AssertionError(
            f"The '{name}' field must be a set or sequence with length {kind.size}"
        )
    try:
        return numpy.array(value, dtype=dtype)
    except (TypeError, ValueError, OverflowError) as problem:
        raise AssertionError(
            f"The '{name}' field must be a sequence of '{kind.base}': {problem}"
        ) from None


def _require_sequence(value: Any, kind: FieldType, name: str) -> None:
    if not isinstance(value, Sequence | Set | UserList) or isinstance(value, str | UserString):
        raise AssertionError(
            f"The '{name}' field must be a set or sequence and each value of type '{kind.base}'"
        )


def _require_length(value: Any, kind: FieldType, name: str) -> None:
    if kind.kind == "array" and len(value) != kind.size:
        raise AssertionError(f"The '{name}' field must be a sequence with length {kind.size}")
    if kind.kind == "sequence" and kind.size and len(value) > kind.size:
        raise AssertionError(f"The '{name}' field must be a sequence with length <= {kind.size}")


def _is_float32(value: float) -> bool:
    return abs(value) <= _FLOAT32_MAX or math.isnan(value) or math.isinf(value)


@cache
def _integer_range(base: str) -> tuple[int, int]:
    bits = PRIMITIVES[base][1] * 8
    if base.startswith("u"):
        return 0, 2**bits - 1
    return -(2 ** (bits - 1)), 2 ** (bits - 1) - 1
