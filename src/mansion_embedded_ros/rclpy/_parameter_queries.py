"""What can be asked about the parameters of a node."""

from __future__ import annotations

import math
import threading
from typing import Any

from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor
from rclpy._parameter_callbacks import ParameterCallbacks
from rclpy.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter

__all__ = ["ParameterQueries"]


class ParameterQueries(ParameterCallbacks):
    """Mixed into ``Node`` below `NodeParameters`, which keeps what is asked here."""

    _parameters: dict[str, Parameter]
    _descriptors: dict[str, ParameterDescriptor]
    _allow_undeclared_parameters: bool
    _parameters_lock: threading.RLock

    def has_parameter(self, name: str) -> bool:
        """Whether a parameter is declared."""
        return name in self._parameters

    # Getting

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """The parameters of these names; see :meth:`get_parameter`."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter(name) for name in names]

    def get_parameter(self, name: str) -> Parameter:
        """A parameter.

        Raises
        ------
        ParameterNotDeclaredException, ParameterUninitializedException
        """
        with self._parameters_lock:
            parameter = self._parameters.get(name)
            if parameter is None:
                if self._allow_undeclared_parameters:
                    return Parameter(name, Parameter.Type.NOT_SET, None)
                raise ParameterNotDeclaredException(name)
            if (
                parameter.type_ is Parameter.Type.NOT_SET
                and not self._descriptors[name].dynamic_typing
            ):
                raise ParameterUninitializedException(name)
            return parameter

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """A parameter, or the alternative if it is not declared or has no value."""
        if alternative_value is None:
            alternative_value = Parameter(name, Parameter.Type.NOT_SET)
        found = self._parameters.get(name)
        if found is None or found.type_ is Parameter.Type.NOT_SET:
            return alternative_value
        return found

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Any]:
        """Parameters whose names start with ``prefix.``, by the rest of the name."""
        start = f"{prefix}{PARAMETER_SEPARATOR_STRING}" if prefix else ""
        with self._parameters_lock:
            return {
                name[len(start) :]: parameter
                for name, parameter in self._parameters.items()
                if name.startswith(start)
            }

    def get_parameter_type(self, name: str) -> Parameter.Type:
        """The type of a parameter."""
        if name in self._parameters:
            return self._parameters[name].type_
        if self._allow_undeclared_parameters:
            return Parameter.Type.NOT_SET
        raise ParameterNotDeclaredException(name)

    def get_parameter_types(self, names: list[str]) -> list[Parameter.Type]:
        """The types of these parameters."""
        return [self.get_parameter_type(name) for name in names]

    def list_parameters(self, prefixes: list[str], depth: int) -> ListParametersResult:
        """Names under the prefixes (all for none), at most ``depth`` dots deep (0: any)."""
        names = []
        with self._parameters_lock:
            for name in self._parameters:
                rests = [name] if not prefixes else []
                rests += [name[len(p) + 1 :] for p in prefixes if name.startswith(f"{p}.")]
                rests += ["" for p in prefixes if name == p]
                limit = depth or math.inf
                if any(rest.count(PARAMETER_SEPARATOR_STRING) < limit for rest in rests):
                    names.append(name)
        above = {n.rpartition(".")[0] for n in names if PARAMETER_SEPARATOR_STRING in n}
        return ListParametersResult(names=names, prefixes=sorted(above))

    def describe_parameter(self, name: str) -> ParameterDescriptor:
        """The descriptor of a parameter."""
        with self._parameters_lock:
            if name in self._descriptors:
                return self._descriptors[name]
        if self._allow_undeclared_parameters:
            return ParameterDescriptor()
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: list[str]) -> list[ParameterDescriptor]:
        """The descriptors of these parameters."""
        return [self.describe_parameter(name) for name in names]
