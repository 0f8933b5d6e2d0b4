"""Parameters: their types and values, and reading them from text and YAML files."""

from __future__ import annotations

import array
from collections.abc import Sequence
from enum import Enum
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterType, ParameterValue

__all__ = [
    "PARAMETER_SEPARATOR_STRING",
    "Parameter",
    "get_parameter_value",
    "parameter_dict_from_yaml_file",
    "parameter_value_to_python",
]

PARAMETER_SEPARATOR_STRING = "."

if TYPE_CHECKING:
    AllowableParameterValue = (
        None
        | bool
        | int
        | float
        | str
        | list[bytes]
        | Sequence[bool]
        | Sequence[int]
        | Sequence[float]
        | Sequence[str]
    )


class Parameter:
    """A name with a typed value."""

    class Type(Enum):
        """The types of ``rcl_interfaces/msg/ParameterType``."""

        NOT_SET = ParameterType.PARAMETER_NOT_SET
        BOOL = ParameterType.PARAMETER_BOOL
        INTEGER = ParameterType.PARAMETER_INTEGER
        DOUBLE = ParameterType.PARAMETER_DOUBLE
        STRING = ParameterType.PARAMETER_STRING
        BYTE_ARRAY = ParameterType.PARAMETER_BYTE_ARRAY
        BOOL_ARRAY = ParameterType.PARAMETER_BOOL_ARRAY
        INTEGER_ARRAY = ParameterType.PARAMETER_INTEGER_ARRAY
        DOUBLE_ARRAY = ParameterType.PARAMETER_DOUBLE_ARRAY
        STRING_ARRAY = ParameterType.PARAMETER_STRING_ARRAY

        @classmethod
        def from_parameter_value(cls, parameter_value: AllowableParameterValue) -> Parameter.Type:
            """The type of a Python value.

            Raises
            ------
            TypeError
                If no parameter can hold it.
            """
            if parameter_value is None:
                return cls.NOT_SET
            for kind, python_type in _SCALARS:
                if isinstance(parameter_value, python_type):
                    return cls[kind]
            if isinstance(parameter_value, list | tuple | array.array):
                if all(isinstance(v, bytes) for v in parameter_value):
                    return cls.BYTE_ARRAY
                for kind, python_type in _SCALARS:
                    if all(_is(v, python_type) for v in parameter_value):
                        return cls[f"{kind}_ARRAY"]
            raise TypeError(f"The given value is not one of the allowed types '{parameter_value}'.")

        def check(self, parameter_value: AllowableParameterValue) -> bool:
            """Whether a value is of this type."""
            if self is Parameter.Type.NOT_SET:
                return parameter_value is None
            name = self.name.removesuffix("_ARRAY")
            python_type: Any = bytes if name == "BYTE" else dict(_SCALARS)[name]
            if self.name.endswith("_ARRAY"):
                return isinstance(parameter_value, list | tuple | array.array) and all(
                    _is(v, python_type) for v in parameter_value
                )
            return _is(parameter_value, python_type)

    @classmethod
    def from_parameter_msg(cls, param_msg):
        """The parameter of a message."""
        kind = Parameter.Type(value=param_msg.value.type)
        return cls(param_msg.name, kind, parameter_value_to_python(param_msg.value))

    def __init__(self, name, type_=None, value=None):
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError(f"type must be an instance of '{Parameter.Type!r}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._type_ = type_
        self._name = name
        self._value = value

    @property
    def name(self):
        return self._name

    @property
    def type_(self):
        return self._type_

    @property
    def value(self):
        return self._value

    def __eq__(self, other):
        if not isinstance(other, Parameter):
            return NotImplemented
        return (self._name, self._type_, self._value) == (other._name, other._type_, other._value)

    __hash__ = object.__hash__

    def __repr__(self):
        return f"Parameter(name={self._name!r}, type_={self._type_}, value={self._value!r})"

    def get_parameter_value(self):
        """The value as ``rcl_interfaces/ParameterValue``."""
        message = ParameterValue(type=self.type_.value)
        if self.type_ is not Parameter.Type.NOT_SET:
            setattr(message, _field(self.type_), self.value)
        return message

    def to_parameter_msg(self):
        """The parameter as ``rcl_interfaces/Parameter``."""
        return ParameterMsg(name=self.name, value=self.get_parameter_value())


_SCALARS: tuple[tuple[str, type], ...] = (
    ("BOOL", bool),
    ("INTEGER", int),
    ("DOUBLE", float),
    ("STRING", str),
)


def _is(value: Any, python_type: type) -> bool:
    # A bool is an int in Python, but no integer parameter.
    return isinstance(value, python_type) and not (python_type is int and isinstance(value, bool))


def _field(kind: Parameter.Type) -> str:
    return f"{kind.name.lower()}_value"


def parameter_value_to_python(parameter_value: ParameterValue):
    """The Python value of a ``ParameterValue``, None if it is not set.

    Raises
    ------
    RuntimeError
        For a type that does not exist.
    """
    try:
        kind = Parameter.Type(parameter_value.type)
    except ValueError:
        raise RuntimeError(f"unexpected parameter type {parameter_value.type}") from None
    if kind is Parameter.Type.NOT_SET:
        return None
    value = getattr(parameter_value, _field(kind))
    return list(value) if kind.name.endswith("_ARRAY") else value


def _from_yaml(value: Any) -> ParameterValue:
    if isinstance(value, list) and any(isinstance(v, float) for v in value):
        numbers = all(isinstance(v, int | float) and not isinstance(v, bool) for v in value)
        value = [float(v) for v in value] if numbers else value
    if isinstance(value, list) and not value:
        return ParameterValue(type=ParameterType.PARAMETER_STRING_ARRAY)
    try:
        return Parameter("_", None, value).get_parameter_value()
    except TypeError:
        return Parameter("_", None, str(value)).get_parameter_value()


def get_parameter_value(string_value: str) -> ParameterValue:
    """The value that a text means as YAML: ``true``, ``3``, ``[1.0, 2.0]``, anything else a string."""
    import yaml

    try:
        value = yaml.safe_load(string_value)
    except yaml.YAMLError:
        value = string_value
    if value is None or isinstance(value, dict):
        value = string_value
    return _from_yaml(value)


def parameter_dict_from_yaml_file(
    parameter_file: str,
    use_wildcard: bool = False,
    target_nodes: list[str] | None = None,
    namespace: str = "",
) -> dict[str, ParameterMsg]:
    """The parameters of a YAML file by name.

    Parameters
    ----------
    use_wildcard
        Whether the section ``/**`` counts.
    target_nodes
        Full names of the nodes whose sections count; None takes all.
    namespace
        Put before the names of the parameters.

    Raises
    ------
    RuntimeError
        If the file is no parameter file.
    """
    import yaml
    from rclpy._parameter_file import flatten

    with open(parameter_file, encoding="utf-8") as file:
        content = yaml.safe_load(file)
    if not isinstance(content, dict):
        raise RuntimeError(f"{parameter_file} is no parameter file: it holds no mapping of nodes")
    sections = list(content)
    if target_nodes is not None:
        wanted = {name.lstrip("/") for name in target_nodes}
        sections = [s for s in sections if s == "/**" or str(s).lstrip("/") in wanted]
        missing = wanted - {str(s).lstrip("/") for s in sections}
        if missing and not (use_wildcard and "/**" in sections):
            raise RuntimeError(f"Param file does not contain parameters for {sorted(missing)}")
    found: dict[str, ParameterMsg] = {}
    for section in sorted(sections, key=lambda s: s != "/**"):
        if section == "/**" and not use_wildcard:
            continue
        body = content[section]
        if not isinstance(body, dict) or "ros__parameters" not in body:
            raise RuntimeError(
                f"YAML file is not a valid ROS parameter file for node {section}: it has no "
                "'ros__parameters'"
            )
        for name, value in flatten(body["ros__parameters"], namespace).items():
            found[name] = ParameterMsg(name=name, value=_from_yaml(value))
    return found
