"""The former name of :mod:`rclpy.event_handler`."""

from rclpy.event_handler import (
    PublisherEventCallbacks,
    QoSEventHandler,
    SubscriptionEventCallbacks,
    UnsupportedEventTypeError,
)

__all__ = [
    "PublisherEventCallbacks",
    "QoSEventHandler",
    "SubscriptionEventCallbacks",
    "UnsupportedEventTypeError",
]
