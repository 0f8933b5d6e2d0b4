"""The six services through which others see and set a node's parameters."""

from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from rclpy.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameters
from rclpy.validate_topic_name import TOPIC_SEPARATOR_STRING

__all__ = ["TOPIC_SEPARATOR_STRING", "ParameterService"]


class ParameterService:
    """Made by a node for itself."""

    def __init__(self, node):
        self._node: Any = node
        name = node.get_name()
        services = (
            (DescribeParameters, "describe_parameters", self._describe_parameters_callback),
            (GetParameters, "get_parameters", self._get_parameters_callback),
            (GetParameterTypes, "get_parameter_types", self._get_parameter_types_callback),
            (ListParameters, "list_parameters", self._list_parameters_callback),
            (SetParameters, "set_parameters", self._set_parameters_callback),
            (
                SetParametersAtomically,
                "set_parameters_atomically",
                self._set_parameters_atomically_callback,
            ),
        )
        for kind, short, callback in services:
            full = TOPIC_SEPARATOR_STRING.join((name, short))
            node.create_service(kind, full, callback, qos_profile=qos_profile_parameters)

    def _describe_parameters_callback(self, request, response):
        for name in request.names:
            try:
                descriptor = self._node.describe_parameter(name)
            except ParameterNotDeclaredException:
                response.descriptors = []
                return response
            response.descriptors.append(descriptor)
        return response

    def _get_parameters_callback(self, request, response):
        for name in request.names:
            try:
                parameter = self._node.get_parameter(name)
            except ParameterNotDeclaredException:
                # One unknown name empties the answer, as in rclcpp.
                response.values = []
                return response
            except ParameterUninitializedException:
                parameter = Parameter(name)
            response.values.append(parameter.get_parameter_value())
        return response

    def _get_parameter_types_callback(self, request, response):
        for name in request.names:
            try:
                value = self._node.get_parameter_type(name).value
            except ParameterNotDeclaredException:
                response.types = []
                return response
            response.types.append(value)
        return response

    def _list_parameters_callback(self, request, response):
        try:
            response.result = self._node.list_parameters(request.prefixes, request.depth)
        except (TypeError, ValueError) as problem:
            self._node.get_logger().error(f"Failed to list parameters: {problem}")
        return response

    def _set_parameters_callback(self, request, response):
        for message in request.parameters:
            response.results.append(self._set([message], atomically=False))
        return response

    def _set_parameters_atomically_callback(self, request, response):
        response.result = self._set(request.parameters, atomically=True)
        return response

    def _set(self, messages, atomically: bool) -> SetParametersResult:
        try:
            parameters = [Parameter.from_parameter_msg(message) for message in messages]
            if atomically:
                return self._node.set_parameters_atomically(parameters)
            return self._node.set_parameters(parameters)[0]
        except ParameterNotDeclaredException as problem:
            return SetParametersResult(successful=False, reason=str(problem.args[0]))
        except (RuntimeError, TypeError, ValueError) as problem:
            return SetParametersResult(successful=False, reason=str(problem))
