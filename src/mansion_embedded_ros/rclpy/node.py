"""Nodes: what publishes, subscribes, serves, calls and keeps parameters under one name."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Log, ParameterDescriptor, ParameterEvent
from rclpy import _entities, _log_sink
from rclpy._arguments import RosArguments, parse_arguments
from rclpy._dds.announcement import NodeEndpoints
from rclpy._endpoint_options import best_available, copy_profile, require_definition, to_profile
from rclpy._names import expand_name
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
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.exceptions import InvalidTopicNameException, NotInitializedException
from rclpy.guard_condition import GuardCondition
from rclpy.logging import get_logger
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.parameter_service import ParameterService
from rclpy.publisher import Publisher
from rclpy.qos import (
    DurabilityPolicy,
    QoSProfile,
    qos_profile_parameter_events,
    qos_profile_services_default,
)
from rclpy.qos_overriding_options import QoSOverridingOptions, _declare_qos_parameters
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.time_source import TimeSource
from rclpy.timer import Rate, Timer
from rclpy.type_description_service import TypeDescriptionService
from rclpy.utilities import get_default_context
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name
from rclpy.waitable import Waitable

from rosidl_embedded.definition import MessageDefinition, ServiceDefinition

if TYPE_CHECKING:
    from rclpy.executors import Executor

__all__ = ["HIDDEN_NODE_PREFIX", "PARAMETER_SEPARATOR_STRING", "S_TO_NS", "Node"]

HIDDEN_NODE_PREFIX = "_"
_ROSOUT_LIFESPAN = Duration(seconds=10)


class Node(NodeParameters, NodeGraph):
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

    def _own_name(self, name: str, namespace: str) -> tuple[str, str]:
        validate_node_name(name)
        for arguments in self._arguments:
            changed = arguments.namespace(name)
            if changed is not None:
                namespace = changed
                break
        for arguments in self._arguments:
            changed = arguments.node_name(name)
            if changed != name:
                name = changed
                break
        if not namespace.startswith("/"):
            namespace = f"/{namespace}"
        validate_node_name(name)
        validate_namespace(namespace)
        return name, namespace

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

    # Properties

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

    def get_name(self) -> str:
        """The name without namespace."""
        return self._name

    def get_namespace(self) -> str:
        """The namespace, ``/`` for none."""
        return self._namespace

    def get_fully_qualified_name(self) -> str:
        """Namespace and name."""
        return f"{self._namespace.rstrip('/')}/{self._name}"

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

    # Names

    def _resolve(self, name: str, only_expand: bool, service: bool) -> str:
        validate_topic_name(name, is_service=service)
        try:
            full = expand_name(name, self._name, self._namespace)
        except ValueError as problem:
            raise InvalidTopicNameException(name, str(problem), 0) from None
        validate_full_topic_name(full, is_service=service)
        if only_expand:
            return full
        for arguments in self._arguments:
            changed = arguments.remap(full, self._name, self._namespace, service)
            if changed is not None:
                return changed
        return full

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """The full name of a topic, remapped unless ``only_expand``."""
        return self._resolve(topic, only_expand, False)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """The full name of a service, remapped unless ``only_expand``."""
        return self._resolve(service, only_expand, True)

    # Making and ending entities

    def _attach(self, item: Any, group: CallbackGroup | None = None) -> None:
        if group is not None:
            group.add_entity(item)
        executor = self.executor
        if executor is not None:
            executor._dispatcher.add(item)
            executor.wake()

    def _detach(self, item: Any) -> None:
        executor = self.executor
        if executor is not None:
            executor._dispatcher.discard(item)

    def _new(self, factory: Callable[..., Any], kind: Any, name: str, profile: QoSProfile) -> Any:
        self.handle  # noqa: B018 (raises after destroy_node)
        return factory(self._participant, self._endpoints, kind, name, profile)

    def create_publisher(
        self,
        msg_type,
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher] = Publisher,
    ) -> Publisher:
        """Create a publisher; an integer as ``qos_profile`` is the history depth."""
        profile, full = self._endpoint_arguments(
            msg_type, topic, qos_profile, qos_overriding_options, "publisher"
        )
        group = callback_group or self.default_callback_group
        handle = self._new(_entities.Publisher, msg_type, full, profile)
        events = event_callbacks or PublisherEventCallbacks()
        publisher = publisher_class(handle, msg_type, topic, profile, events, group)
        self._publishers.append(publisher)
        for handler in publisher.event_handlers:
            self._waitables.append(handler)
            self._attach(handler)
        return publisher

    def create_subscription(
        self,
        msg_type,
        topic: str,
        callback: Callable[[Any], None],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Create a subscription; with ``raw`` the callback gets CDR bytes."""
        profile, full = self._endpoint_arguments(
            msg_type, topic, qos_profile, qos_overriding_options, "subscription"
        )
        group = callback_group or self.default_callback_group
        handle = self._new(_entities.Subscription, msg_type, full, profile)
        events = event_callbacks or SubscriptionEventCallbacks()
        try:
            subscription: Subscription = Subscription(
                handle, msg_type, topic, callback, group, profile, raw, events
            )
        except BaseException:
            handle.destroy()
            raise
        self._subscriptions.append(subscription)
        self._attach(subscription, group)
        for handler in subscription.event_handlers:
            self._waitables.append(handler)
            self._attach(handler)
        return subscription

    def _endpoint_arguments(
        self,
        msg_type: Any,
        topic: str,
        qos_profile: QoSProfile | int,
        options: QoSOverridingOptions | None,
        kind: str,
    ) -> tuple[QoSProfile, str]:
        require_definition(msg_type, MessageDefinition, "message")
        full = self.resolve_topic_name(topic)
        profile = to_profile(qos_profile)
        if options is not None:
            profile = copy_profile(profile)
            _declare_qos_parameters(kind, self, full, profile, options)
        return best_available(self, profile, full, kind), full

    def create_client(
        self,
        srv_type,
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        """Create a client of a service."""
        require_definition(srv_type, ServiceDefinition, "service")
        full = self.resolve_service_name(srv_name)
        group = callback_group or self.default_callback_group
        handle = self._new(_entities.Client, srv_type, full, qos_profile)
        client: Client = Client(self.context, handle, srv_type, srv_name, qos_profile, group)
        self._clients.append(client)
        self._attach(client, group)
        return client

    def create_service(
        self,
        srv_type,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        """Create a service; the callback takes a request and a response to fill and return."""
        require_definition(srv_type, ServiceDefinition, "service")
        full = self.resolve_service_name(srv_name)
        group = callback_group or self.default_callback_group
        handle = self._new(_entities.Service, srv_type, full, qos_profile)
        service: Service = Service(handle, srv_type, srv_name, callback, group, qos_profile)
        self._services.append(service)
        self._attach(service, group)
        return service

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer of the node's clock, or another."""
        self.handle  # noqa: B018 (raises after destroy_node)
        group = callback_group or self.default_callback_group
        timer = Timer(
            callback,
            group,
            int(float(timer_period_sec) * S_TO_NS),
            clock or self._clock,
            context=self.context,
            autostart=autostart,
        )
        self._timers.append(timer)
        self._attach(timer, group)
        return timer

    def create_guard_condition(
        self, callback: Callable, callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a guard condition."""
        self.handle  # noqa: B018 (raises after destroy_node)
        group = callback_group or self.default_callback_group
        guard = GuardCondition(callback, group, context=self.context)
        self._guards.append(guard)
        self._attach(guard, group)
        return guard

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate; another thread has to spin the node while it sleeps.

        Raises
        ------
        ValueError
            If the frequency is not positive.
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, lambda: None, self._rate_group, clock)
        rate = Rate(timer, context=self.context)
        self._rates[timer] = rate
        return rate

    def add_waitable(self, waitable: Waitable) -> None:
        """Add an event handler; other waitables need rcl's wait set, which is not here."""
        if not hasattr(waitable, "_wait_entity"):
            raise NotImplementedError(
                f"the embedded ROS cannot wait for a {type(waitable).__name__}: it has no wait set of "
                "rcl. Use a subscription, service, timer or guard condition"
            )
        self._waitables.append(waitable)
        self._attach(waitable)

    def remove_waitable(self, waitable: Waitable) -> None:
        """Remove an event handler."""
        self._detach(waitable)
        self._waitables.remove(waitable)

    def _destroy(self, item: Any, items: list[Any]) -> bool:
        if item not in items:
            return False
        items.remove(item)
        for handler in getattr(item, "event_handlers", ()):
            self._detach(handler)
            if handler in self._waitables:
                self._waitables.remove(handler)
        self._detach(item)
        item.destroy()
        return True

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """End a publisher; False if it is not of this node."""
        return self._destroy(publisher, self._publishers)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """End a subscription; False if it is not of this node."""
        return self._destroy(subscription, self._subscriptions)

    def destroy_client(self, client: Client) -> bool:
        """End a client; False if it is not of this node."""
        return self._destroy(client, self._clients)

    def destroy_service(self, service: Service) -> bool:
        """End a service; False if it is not of this node."""
        return self._destroy(service, self._services)

    def destroy_timer(self, timer: Timer) -> bool:
        """End a timer; False if it is not of this node."""
        return self._destroy(timer, self._timers)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """End a guard condition; False if it is not of this node."""
        return self._destroy(guard, self._guards)

    def destroy_rate(self, rate: Rate) -> bool:
        """End a rate and its timer."""
        if self._rates.pop(rate._timer, None) is None:
            return False
        rate.destroy()
        return self.destroy_timer(rate._timer)

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
