"""Publish messages on a topic."""

from __future__ import annotations

from typing import Any, Union

from rclpy import _rclpy_pybind11
from rclpy._dds.library import TIMEOUT, dds
from rclpy._rclpy_pybind11 import RCLError
from rclpy.callback_groups import CallbackGroup
from rclpy.duration import Duration
from rclpy.event_handler import EventHandler, PublisherEventCallbacks
from rclpy.qos import QoSProfile

__all__ = ["Publisher"]

MsgType = Any


class Publisher:
    """Made by ``Node.create_publisher``."""

    def __init__(
        self,
        publisher_impl: _rclpy_pybind11.Publisher,
        msg_type: MsgType,
        topic: str,
        qos_profile: QoSProfile,
        event_callbacks: PublisherEventCallbacks,
        callback_group: CallbackGroup,
    ) -> None:
        self.__publisher = publisher_impl
        self.msg_type: Any = msg_type
        self.topic = topic
        self.qos_profile = qos_profile
        self._name = publisher_impl.writer.topic_name.removeprefix("rt")
        self.event_handlers: list[EventHandler] = event_callbacks.create_event_handlers(
            callback_group, publisher_impl, topic
        )

    def publish(self, msg: Union[MsgType, bytes]) -> None:  # noqa: UP007
        """Send a message, or one that is serialized already.

        Raises
        ------
        TypeError
            If the message is of another type.
        """
        if isinstance(msg, self.msg_type):
            self.__publisher.publish(msg)
        elif isinstance(msg, bytes):
            self.__publisher.publish_raw(msg)
        else:
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")

    def get_subscription_count(self) -> int:
        """How many subscriptions this publisher is matched with."""
        with self.handle:
            return len(self.__publisher.writer.matched_handles())

    @property
    def topic_name(self) -> str:
        with self.handle:
            return self._name

    @property
    def handle(self) -> Any:
        return self.__publisher

    def destroy(self):  # type: ignore[no-untyped-def]
        """End the publisher; ``Node.destroy_publisher`` is what programs call."""
        for handler in self.event_handlers:
            handler.destroy()
        self.__publisher.destroy()

    def assert_liveliness(self) -> None:
        """Say that the publisher is alive, for MANUAL_BY_TOPIC."""
        with self.handle:
            dds.dds_assert_liveliness(self.__publisher.writer.entity)

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:  # noqa: B008
        """Wait until all published messages are acknowledged.

        Parameters
        ----------
        timeout
            A negative duration waits forever.

        Returns
        -------
        bool
            False at the timeout.
        """
        with self.handle:
            limit = timeout.nanoseconds if timeout.nanoseconds >= 0 else 2**63 - 1
            code = dds.dds_wait_for_acks(self.__publisher.writer.entity, limit)
        if code == TIMEOUT:
            return False
        if code < 0:
            raise RCLError("failed to wait for acknowledgements")
        return True

    def __enter__(self) -> Publisher:
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()
