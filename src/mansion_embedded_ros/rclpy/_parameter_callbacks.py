"""Callbacks that change, refuse or follow the parameters of a node."""

from __future__ import annotations

from collections.abc import Callable

from rcl_interfaces.msg import SetParametersResult
from rclpy.parameter import Parameter

__all__ = ["OnSet", "ParameterCallbacks", "PostSet", "PreSet"]

OnSet = Callable[[list[Parameter]], SetParametersResult]
PreSet = Callable[[list[Parameter]], list[Parameter]]
PostSet = Callable[[list[Parameter]], None]


class ParameterCallbacks:
    """Mixed into ``Node``."""

    _on_set_parameters_callbacks: list[OnSet]
    _pre_set_parameters_callbacks: list[PreSet]
    _post_set_parameters_callbacks: list[PostSet]

    def add_pre_set_parameters_callback(
        self, callback: Callable[[list[Parameter]], list[Parameter]]
    ) -> None:
        """Have a callback change the list of parameters before it is checked."""
        self._pre_set_parameters_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(
        self, callback: Callable[[list[Parameter]], SetParametersResult]
    ) -> None:
        """Have a callback accept or refuse parameters; the one added last is asked first."""
        self._on_set_parameters_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Have a callback called with parameters that were set."""
        self._post_set_parameters_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(
        self, callback: Callable[[list[Parameter]], list[Parameter]]
    ) -> None:
        """Take the callback back; ValueError if it was not added."""
        self._pre_set_parameters_callbacks.remove(callback)

    def remove_on_set_parameters_callback(
        self, callback: Callable[[list[Parameter]], SetParametersResult]
    ) -> None:
        """Take the callback back; ValueError if it was not added."""
        self._on_set_parameters_callbacks.remove(callback)

    def remove_post_set_parameters_callback(
        self, callback: Callable[[list[Parameter]], None]
    ) -> None:
        """Take the callback back; ValueError if it was not added."""
        self._post_set_parameters_callbacks.remove(callback)
