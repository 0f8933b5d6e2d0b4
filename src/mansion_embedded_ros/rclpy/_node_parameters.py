"""The parameters of a node: declared and set; `ParameterQueries` gets and describes them."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import (
    ParameterDescriptor,
    ParameterEvent,
    ParameterValue,
    SetParametersResult,
)
from rclpy._node_names import NodeNames
from rclpy._parameter_callbacks import OnSet, PostSet, PreSet
from rclpy._parameter_queries import ParameterQueries
from rclpy._parameter_rules import double_fault, integer_fault, read_declaration
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
)
from rclpy.parameter import Parameter
from rclpy.validate_parameter_name import validate_parameter_name

if TYPE_CHECKING:
    from rclpy.clock import Clock

__all__ = ["NodeParameters"]


class NodeParameters(NodeNames, ParameterQueries):
    """Mixed into ``Node``."""

    PARAM_REL_TOL = 1e-6

    _clock: Clock
    _parameter_event_publisher: Any

    def _init_parameters(self, allow_undeclared: bool, overrides: dict[str, Parameter]) -> None:
        self._parameters: dict[str, Parameter] = {}
        self._descriptors: dict[str, ParameterDescriptor] = {}
        self._allow_undeclared_parameters = allow_undeclared
        self._parameter_overrides = overrides
        self._on_set_parameters_callbacks: list[OnSet] = []
        self._pre_set_parameters_callbacks: list[PreSet] = []
        self._post_set_parameters_callbacks: list[PostSet] = []
        self._parameters_lock = threading.RLock()

    # Declaring

    def declare_parameter(
        self,
        name: str,
        value: Any = None,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter:
        """Declare and initialize a parameter.

        Parameters
        ----------
        value
            Default value, or a ``Parameter.Type`` for a parameter of that type without a value.

        Raises
        ------
        ParameterAlreadyDeclaredException, InvalidParameterException, InvalidParameterValueException,
        InvalidParameterTypeException
        """
        if descriptor is None:
            descriptor = ParameterDescriptor()
        entry: Any = (name, value, descriptor)
        return self.declare_parameters("", [entry], ignore_override)[0]

    def declare_parameters(
        self,
        namespace: str,
        parameters: list[
            tuple[str] | tuple[str, Parameter.Type] | tuple[str, Any, ParameterDescriptor]
        ],
        ignore_override: bool = False,
    ) -> list[Parameter]:
        """Declare several parameters, each as name, default value and descriptor.

        ``namespace`` is put before the names with a dot.
        """
        with self._parameters_lock:
            return self._declare(namespace, parameters, ignore_override)

    def _declare(
        self, namespace: str, parameters: Sequence[Any], ignore_override: bool
    ) -> list[Parameter]:
        wanted: list[tuple[Parameter, ParameterDescriptor]] = []
        for given in parameters:
            parameter, descriptor = read_declaration(namespace, given)
            if parameter.name in self._parameters:
                raise ParameterAlreadyDeclaredException([parameter.name])
            if not ignore_override and parameter.name in self._parameter_overrides:
                parameter = self._parameter_overrides[parameter.name]
            wanted.append((parameter, descriptor))
        results = []
        for parameter, descriptor in wanted:
            validate_parameter_name(parameter.name)
            kind = Parameter.Type(descriptor.type)
            if parameter.type_ is Parameter.Type.NOT_SET:
                self._parameters[parameter.name] = parameter
                self._descriptors[parameter.name] = descriptor
                results.append(parameter)
                continue
            if not descriptor.dynamic_typing and parameter.type_ is not kind:
                raise InvalidParameterTypeException(parameter, kind.name)  # type: ignore[arg-type]
            self._descriptors[parameter.name] = descriptor
            result = self._apply([parameter], declaring=True)
            if not result.successful:
                del self._descriptors[parameter.name]
                raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)
            results.append(self._parameters[parameter.name])
        return results

    def undeclare_parameter(self, name: str):
        """Forget a parameter.

        Raises
        ------
        ParameterNotDeclaredException, ParameterImmutableException
        """
        with self._parameters_lock:
            if name not in self._parameters:
                raise ParameterNotDeclaredException(name)
            if self._descriptors[name].read_only:
                raise ParameterImmutableException(name)
            removed = self._parameters.pop(name)
            del self._descriptors[name]
        self._publish_event(deleted=[removed])

    # Setting

    def set_parameters(self, parameter_list: list[Parameter]) -> list[SetParametersResult]:
        """Set parameters one by one; a refused one leaves the others set.

        Raises
        ------
        ParameterNotDeclaredException
        """
        results = []
        for parameter in parameter_list:
            self._require_declared([parameter])
            results.append(self.set_parameters_atomically([parameter]))
        return results

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all parameters or none.

        Raises
        ------
        ParameterNotDeclaredException
        """
        parameters = list(parameter_list)
        with self._parameters_lock:
            for before in list(self._pre_set_parameters_callbacks):
                parameters = before(parameters)
                if not parameters:
                    return SetParametersResult(
                        successful=False,
                        reason="parameter list cannot be empty, this might be due to "
                        "pre_set_parameters_callback modifying the original parameters list.",
                    )
            self._require_declared(parameters)
            return self._apply(parameters, declaring=False)

    def _require_declared(self, parameters: list[Parameter]) -> None:
        if not all(isinstance(p, Parameter) for p in parameters):
            raise TypeError("parameter must be instance of type 'rclpy.parameter.Parameter'")
        unknown = [p.name for p in parameters if p.name not in self._parameters]
        if (
            unknown
            and not self._allow_undeclared_parameters
            and not self._pre_set_parameters_callbacks
        ):
            raise ParameterNotDeclaredException(unknown)

    def _apply(self, parameters: list[Parameter], declaring: bool) -> SetParametersResult:
        result = self._check(parameters, declaring)
        if result.successful:
            for callback in list(self._on_set_parameters_callbacks):
                result = callback(parameters)
                if not isinstance(result, SetParametersResult):
                    raise TypeError(
                        "an on-set-parameters callback must give a SetParametersResult, not "
                        f"{type(result).__name__}"
                    )
                if not result.successful:
                    return result
            self._store(parameters, declaring)
            for after in list(self._post_set_parameters_callbacks):
                after(parameters)
        return result

    def _store(self, parameters: list[Parameter], declaring: bool) -> None:
        new, changed, deleted = [], [], []
        for parameter in parameters:
            old = self._parameters.get(parameter.name)
            if parameter.type_ is Parameter.Type.NOT_SET and old is not None:
                deleted.append(old)
                if self._descriptors[parameter.name].dynamic_typing:
                    self._parameters[parameter.name] = parameter
                else:
                    del self._parameters[parameter.name], self._descriptors[parameter.name]
                continue
            (new if old is None or old.type_ is Parameter.Type.NOT_SET else changed).append(
                parameter
            )
            if parameter.name not in self._descriptors:
                self._descriptors[parameter.name] = ParameterDescriptor(
                    name=parameter.name, dynamic_typing=True
                )
            self._parameters[parameter.name] = parameter
            descriptor = self._descriptors[parameter.name]
            if descriptor.dynamic_typing:
                descriptor.type = parameter.type_.value
        self._publish_event(new, changed, deleted)

    def _publish_event(
        self,
        new: Sequence[Parameter] = (),
        changed: Sequence[Parameter] = (),
        deleted: Sequence[Parameter] = (),
    ) -> None:
        publisher = self._parameter_event_publisher
        if publisher is None or not (new or changed or deleted):
            return
        publisher.publish(
            ParameterEvent(
                stamp=self._clock.now().to_msg(),
                node=self.get_fully_qualified_name(),
                new_parameters=[p.to_parameter_msg() for p in new],
                changed_parameters=[p.to_parameter_msg() for p in changed],
                deleted_parameters=[p.to_parameter_msg() for p in deleted],
            )
        )

    def _check(self, parameters: list[Parameter], declaring: bool) -> SetParametersResult:
        for parameter in parameters:
            descriptor = self._descriptors.get(parameter.name)
            if descriptor is None:
                if not self._allow_undeclared_parameters:
                    return _refused(f"parameter '{parameter.name}' is not declared")
                continue
            reason = self._fault(parameter, descriptor, declaring)
            if reason:
                return _refused(reason)
        return SetParametersResult(successful=True)

    def _fault(
        self, parameter: Parameter, descriptor: ParameterDescriptor, declaring: bool
    ) -> str | None:
        name = parameter.name
        if descriptor.read_only and not declaring:
            return f"Trying to set a read-only parameter: {name}."
        if parameter.type_ is Parameter.Type.NOT_SET:
            if descriptor.dynamic_typing:
                return None
            return "Static parameter cannot be undeclared"
        expected = Parameter.Type(descriptor.type)
        if not descriptor.dynamic_typing and parameter.type_ is not expected:
            return (
                f"Wrong parameter type, expected '{expected}' got '{parameter.type_}'"
                if not declaring
                else f"expected '{expected}'"
            )
        if parameter.type_ is Parameter.Type.INTEGER and descriptor.integer_range:
            return integer_fault(parameter, descriptor.integer_range[0])
        if parameter.type_ is Parameter.Type.DOUBLE and descriptor.floating_point_range:
            return double_fault(parameter, descriptor.floating_point_range[0], self.PARAM_REL_TOL)
        return None

    def set_descriptor(
        self,
        name: str,
        descriptor: ParameterDescriptor,
        alternative_value: ParameterValue | None = None,
    ) -> ParameterValue:
        """Replace the descriptor of a parameter; its value must fit, else the alternative is set.

        Raises
        ------
        ParameterNotDeclaredException, ParameterImmutableException, InvalidParameterValueException
        """
        with self._parameters_lock:
            if name not in self._parameters:
                if not self._allow_undeclared_parameters:
                    raise ParameterNotDeclaredException(name)
                return self.get_parameter(name).get_parameter_value()
            old = self._descriptors[name]
            if old.read_only:
                raise ParameterImmutableException(name)
            current = self._parameters[name]
            descriptor.name = name
            if descriptor.dynamic_typing:
                descriptor.type = current.type_.value
            elif descriptor.type == 0:
                descriptor.type = old.type
            candidate = current
            if alternative_value is not None and self._fault(current, descriptor, True):
                candidate = Parameter.from_parameter_msg(_named_value(name, alternative_value))
            reason = self._fault(candidate, descriptor, True)
            if reason:
                raise InvalidParameterValueException(name, candidate.value, reason)
            self._descriptors[name] = descriptor
            if candidate is not current:
                self._apply([candidate], declaring=True)
            return self._parameters[name].get_parameter_value()


def _refused(reason: str) -> SetParametersResult:
    return SetParametersResult(successful=False, reason=reason)


def _named_value(name: str, value: ParameterValue) -> Any:
    from rcl_interfaces.msg import Parameter as ParameterMsg

    return ParameterMsg(name=name, value=value)
