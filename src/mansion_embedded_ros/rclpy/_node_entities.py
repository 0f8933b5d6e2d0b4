"""Making and ending the publishers, subscriptions, services, clients and timers of a node."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy import _entities, _service_entities
from rclpy._dds.announcement import NodeEndpoints
from rclpy._endpoint_options import best_available, copy_profile, require_definition, to_profile
from rclpy._node_names import NodeNames
from rclpy.callback_groups import CallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.guard_condition import GuardCondition
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, qos_profile_services_default
from rclpy.qos_overriding_options import QoSOverridingOptions, _declare_qos_parameters
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Rate, Timer
from rclpy.waitable import Waitable

from rosidl_embedded.definition import MessageDefinition, ServiceDefinition

if TYPE_CHECKING:
    from rclpy._dds.participant import Participant
    from rclpy.executors import Executor

__all__ = ["NodeEntities"]


class NodeEntities(NodeNames):
    """Mixed into ``Node``."""

    _participant: Participant
    _endpoints: NodeEndpoints
    _clock: Clock
    _rate_group: CallbackGroup
    _rates: dict[Timer, Rate]
    _publishers: list[Publisher]
    _subscriptions: list[Subscription]
    _clients: list[Client]
    _services: list[Service]
    _timers: list[Timer]
    _guards: list[GuardCondition]
    _waitables: list[Waitable]
    context: Context
    default_callback_group: CallbackGroup
    executor: Executor | None
    handle: Any

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
        handle = self._new(_service_entities.Client, srv_type, full, qos_profile)
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
        handle = self._new(_service_entities.Service, srv_type, full, qos_profile)
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
