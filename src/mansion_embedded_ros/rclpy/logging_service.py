"""Services that get and set the levels of a process's loggers, for nodes that ask for them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rcl_interfaces.msg import LoggerLevel, SetLoggerLevelsResult
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.logging import get_logger_level, set_logger_level
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["LoggingService"]


class LoggingService:
    """Made by a node with ``enable_logger_service``."""

    def __init__(self, node: Node):
        name = node.get_name()
        qos = qos_profile_services_default
        node.create_service(
            GetLoggerLevels, f"{name}/get_logger_levels", self._get, qos_profile=qos
        )
        node.create_service(
            SetLoggerLevels, f"{name}/set_logger_levels", self._set, qos_profile=qos
        )

    @staticmethod
    def _get(
        request: GetLoggerLevels.Request, response: GetLoggerLevels.Response
    ) -> GetLoggerLevels.Response:
        for name in request.names:
            response.levels.append(LoggerLevel(name=name, level=int(get_logger_level(name))))
        return response

    @staticmethod
    def _set(
        request: SetLoggerLevels.Request, response: SetLoggerLevels.Response
    ) -> SetLoggerLevels.Response:
        for level in request.levels:
            result = SetLoggerLevelsResult(successful=True)
            try:
                set_logger_level(level.name, LoggingSeverity(level.level))
            except ValueError as problem:
                result.successful, result.reason = False, str(problem)
            response.results.append(result)
        return response
