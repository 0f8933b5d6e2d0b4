"""Nodes: what publishes, subscribes, serves, calls and keeps parameters under one name."""

from __future__ import annotations

import weakref
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Log, ParameterDescriptor, ParameterEvent
from rclpy import _log_sink
from rclpy._arguments import RosArguments, parse_arguments
from rclpy._dds.announcement import NodeEndpoints
from rclpy._node_entities import NodeEntities
from rclpy._node_graph import NodeGraph
from rclpy._node_parameters import NodeParameters
from rclpy._parameter_file import overrides_for
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock, ROSClock
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.exceptions import NotInitializedException
from rclpy.guard_condition import GuardCondition
from rclpy.logging import get_logger
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.parameter_service import ParameterService
from rclpy.publisher import Publisher
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_parameter_events
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.time_source import TimeSource
from rclpy.timer import Rate, Timer
from rclpy.type_description_service import TypeDescriptionService
from rclpy.utilities import get_default_context
from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from rclpy.executors import Executor

__all__ = ["HIDDEN_NODE_PREFIX", "PARAMETER_SEPARATOR_STRING", "S_TO_NS", "Node"]

HIDDEN_NODE_PREFIX = "_"
_ROSOUT_LIFESPAN = Duration(seconds=10)


class Node(NodeEntities, NodeParameters, NodeGraph):
    """A node.

    Parameters
    ----------
    cli_args
        Command line of this node alone, with ``--ros-args``.
    use_global_arguments
        Whether the command line of ``init`` counts for it.
    parameter_overrides
        Values that win over the defaults of declarations, and over the command line.
    allow_undeclared_parameters
        Whether parameters may be set without a declaration.
    automatically_declare_parameters_from_overrides
        Whether all overrides are declared at once.
    """

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        self._destroyed = True
        self._context = get_default_context() if context is None else context
        if not self._context.ok():
            raise NotInitializedException("cannot create node")
        state: Any = self._context.handle
        self._arguments: list[RosArguments] = [parse_arguments(cli_args)] if cli_args else []
        if use_global_arguments:
            self._arguments.append(state.arguments)
        self._name, self._namespace = self._own_name(node_name, namespace or "")
        self._publishers: list[Publisher] = []
        self._subscriptions: list[Subscription] = []
        self._clients: list[Client] = []
        self._services: list[Service] = []
        self._timers: list[Timer] = []
        self._guards: list[GuardCondition] = []
        self._waitables: list[Waitable] = []
        self._rates: dict[Timer, Rate] = {}
        self._default_callback_group = MutuallyExclusiveCallbackGroup()
        self._rate_group = MutuallyExclusiveCallbackGroup()
        self._executor_ref: weakref.ref[Executor[Any]] | None = None
        full = self.get_fully_qualified_name()
        overrides = overrides_for(list(reversed(self._arguments)), self._name, full)
        overrides.update({p.name: p for p in parameter_overrides or ()})
        self._init_parameters(allow_undeclared_parameters, overrides)
        self._clock = ROSClock()
        self._parameter_event_publisher: Publisher | None = None
        self._rosout: Publisher | None = None
        self._participant = state.acquire_participant()
        self._destroyed = False
        self._endpoints = NodeEndpoints(self._namespace, self._name)
        self._logger = get_logger(full[1:].replace("/", "."))
        self._participant.pause_announcements(True)
        try:
            self._participant.add_node(self._endpoints)
            self._start(
                enable_rosout,
                start_parameter_services,
                automatically_declare_parameters_from_overrides,
                enable_logger_service,
            )
        except BaseException:
            self.destroy_node()
            raise
        finally:
            self._participant.pause_announcements(False)

    def _start(self, rosout: bool, parameters: bool, declare_all: bool, logger: bool) -> None:
        if rosout and _log_sink.switches["rosout"]:
            profile = QoSProfile(
                depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=_ROSOUT_LIFESPAN
            )
            self._rosout = self.create_publisher(
                Log,
                "/rosout",
                profile,
                event_callbacks=PublisherEventCallbacks(use_default_callbacks=False),
            )
            _log_sink.add_rosout(self._logger.name, self._publish_log)
        self._parameter_event_publisher = self.create_publisher(
            ParameterEvent, "/parameter_events", qos_profile_parameter_events
        )
        if declare_all:
            self.declare_parameters(
                "",
                [
                    (name, parameter.value, ParameterDescriptor(dynamic_typing=True))
                    for name, parameter in self._parameter_overrides.items()
                ],
                ignore_override=True,
            )
        self._time_source = TimeSource(node=self)
        self._time_source.attach_clock(self._clock)
        if parameters:
            self._parameter_service = ParameterService(self)
        self._type_description_service = TypeDescriptionService(self)
        if logger:
            from rclpy.logging_service import LoggingService

            self._logger_service = LoggingService(self)

    def _publish_log(
        self,
        stamp: int,
        severity: int,
        name: str,
        message: str,
        file: str,
        function: str,
        line: int,
    ) -> None:
        if self._rosout is None or not self._context.ok():
            return
        entry = Log(
            level=int(severity), name=name, msg=message, file=file, function=function, line=line
        )
        entry.stamp.sec, entry.stamp.nanosec = divmod(stamp, S_TO_NS)
        self._rosout.publish(entry)

    @property
    def publishers(self) -> Iterator[Publisher]:
        """The publishers of this node."""
        yield from self._publishers

    @property
    def subscriptions(self) -> Iterator[Subscription]:
        """The subscriptions of this node."""
        yield from self._subscriptions

    @property
    def clients(self) -> Iterator[Client]:
        """The clients of this node."""
        yield from self._clients

    @property
    def services(self) -> Iterator[Service]:
        """The services of this node."""
        yield from self._services

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers of this node."""
        yield from self._timers

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions of this node."""
        yield from self._guards

    @property
    def waitables(self) -> Iterator[Waitable]:
        """The event handlers of this node."""
        yield from self._waitables

    @property
    def executor(self) -> Executor[Any] | None:
        """The executor that the node was added to, None if there is none."""
        return self._executor_ref() if self._executor_ref is not None else None

    @executor.setter
    def executor(self, new_executor: Executor[Any] | None) -> None:
        current = self.executor
        if current is new_executor:
            return
        if current is not None:
            current.remove_node(self)
        if new_executor is None:
            self._executor_ref = None
        else:
            self._executor_ref = weakref.ref(new_executor)
            new_executor.add_node(self)

    def _forget_executor(self, executor: Executor[Any]) -> None:
        if self.executor in (executor, None):
            self._executor_ref = None

    @property
    def context(self) -> Context:
        """The context of this node."""
        return self._context

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of what is created without one: mutually exclusive."""
        return self._default_callback_group

    @property
    def handle(self) -> Node:
        """The node itself; InvalidHandle after ``destroy_node``."""
        if self._destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        return self

    def __enter__(self) -> Node:
        return self

    def __exit__(self, *_: object) -> None:
        return None

    def get_clock(self) -> Clock:
        """The clock of the node: ROS time."""
        return self._clock

    def get_logger(self):
        """The logger of the node."""
        return self._logger

    def _waitables_of_all_kinds(self) -> list[Any]:
        return [
            *self._subscriptions,
            *self._guards,
            *self._clients,
            *self._services,
            *self._waitables,
            *self._timers,
        ]

    def destroy_node(self):
        """End the node and everything in it; a second call does nothing."""
        if self._destroyed:
            return
        executor = self.executor
        if executor is not None:
            executor.remove_node(self)
        self._destroyed = True
        _log_sink.remove_rosout(self._logger.name, self._publish_log)
        self._parameter_event_publisher = self._rosout = None
        for rate in list(self._rates.values()):
            rate.destroy()
        self._rates.clear()
        self._participant.pause_announcements(True)
        for items in (
            self._publishers,
            self._subscriptions,
            self._clients,
            self._services,
            self._timers,
            self._guards,
        ):
            while items:
                self._destroy(items[-1], items)
        self._waitables.clear()
        self._participant.remove_node(self._endpoints)
        self._participant.pause_announcements(False)
        state: Any = self._context.handle
        state.release_participant()
