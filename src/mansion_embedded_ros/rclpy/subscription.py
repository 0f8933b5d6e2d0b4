"""Receive the messages of a topic."""

from __future__ import annotations

import inspect
from enum import Enum
from typing import Any, Callable  # noqa: UP035

from rclpy import _rclpy_pybind11
from rclpy.callback_groups import CallbackGroup
from rclpy.event_handler import EventHandler, SubscriptionEventCallbacks
from rclpy.qos import QoSProfile

__all__ = ["Subscription"]

MsgType = Any


class Subscription:
    """Made by ``Node.create_subscription``."""

    class CallbackType(Enum):
        """What the callback takes."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        subscription_impl: _rclpy_pybind11.Subscription,
        msg_type: MsgType,
        topic: str,
        callback: Callable,  # type: ignore[type-arg]
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        raw: bool,
        event_callbacks: SubscriptionEventCallbacks,
    ) -> None:
        self.__subscription = subscription_impl
        self.msg_type: Any = msg_type
        self.topic = topic
        self.callback = callback
        self.callback_group: CallbackGroup | None = callback_group
        self.qos_profile = qos_profile
        self.raw = raw
        self._executor_event = False
        self._destroyed = False
        self._name = subscription_impl.reader.topic_name.removeprefix("rt")
        self.event_handlers: list[EventHandler] = event_callbacks.create_event_handlers(
            callback_group, subscription_impl, topic
        )

    def get_publisher_count(self) -> int:
        """How many publishers this subscription is matched with."""
        with self.handle:
            return len(self.__subscription.reader.matched_handles())

    @property
    def handle(self) -> Any:
        return self.__subscription

    def destroy(self):  # type: ignore[no-untyped-def]
        """End the subscription; ``Node.destroy_subscription`` is what programs call."""
        self._destroyed = True
        for handler in self.event_handlers:
            handler.destroy()
        self.__subscription.destroy()

    @property
    def topic_name(self) -> str:
        with self.handle:
            return self._name

    @property
    def callback(self) -> Any:
        return self._callback

    @callback.setter
    def callback(self, value: Any) -> None:
        self._callback = value
        self._callback_type = Subscription.CallbackType.MessageOnly
        try:
            inspect.signature(value).bind(object())
        except TypeError:
            pass
        except ValueError:
            return
        else:
            return
        try:
            inspect.signature(value).bind(object(), object())
        except TypeError:
            raise RuntimeError(
                "Subscription.__init__(): callback should be either be callable with one argument"
                "(to get only the message) or two (to get message and message info)"
            ) from None
        self._callback_type = Subscription.CallbackType.WithMessageInfo

    def _wait_entity(self) -> int:
        return int(self.__subscription.reader.condition) if not self._destroyed else 0

    def _take(self) -> Any:
        return self.__subscription.take_message(self.msg_type, self.raw)

    def _execute(self, taken: Any) -> Any:
        if self._callback_type is Subscription.CallbackType.MessageOnly:
            return self._callback(taken[0])
        return self._callback(*taken)

    def __enter__(self) -> Subscription:
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()
