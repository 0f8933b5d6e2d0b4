"""Lets the clocks of a node follow ``/clock`` while ``use_sim_time`` is true."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.clock import ROSClock
from rclpy.clock_type import ClockType
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from rosgraph_msgs.msg import Clock

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["CLOCK_TOPIC", "USE_SIM_TIME_NAME", "TimeSource"]

CLOCK_TOPIC = "/clock"
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    """Attached to one node and any number of its clocks."""

    def __init__(self, *, node: Node | None = None):
        self._clock_sub: Any = None
        self._node_weak_ref: weakref.ref[Node] | None = None
        self._associated_clocks: list[ROSClock] = []
        self._last_time_set = Time(clock_type=ClockType.ROS_TIME)
        self._ros_time_is_active = False
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        return self._ros_time_is_active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if self._ros_time_is_active == enabled:
            return
        self._ros_time_is_active = enabled
        for clock in self._associated_clocks:
            clock._set_ros_time_is_active(enabled)
        if enabled:
            self._subscribe()
        else:
            self._unsubscribe()

    def _node(self) -> Node | None:
        return self._node_weak_ref() if self._node_weak_ref is not None else None

    def _subscribe(self) -> None:
        node = self._node()
        if self._clock_sub is None and node is not None:
            self._clock_sub = node.create_subscription(
                Clock,
                CLOCK_TOPIC,
                self.clock_callback,
                QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT),
            )

    def _unsubscribe(self) -> None:
        node = self._node()
        if self._clock_sub is not None and node is not None:
            node.destroy_subscription(self._clock_sub)
        self._clock_sub = None

    def attach_node(self, node: Node) -> None:
        """Follow the ``use_sim_time`` parameter of a node."""
        if self._node_weak_ref is not None:
            self.detach_node()
        self._node_weak_ref = weakref.ref(node)
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        parameter = node.get_parameter(USE_SIM_TIME_NAME)
        if parameter.type_ == Parameter.Type.BOOL:
            self.ros_time_is_active = parameter.value
        else:
            node.get_logger().error(
                f"Invalid type for parameter '{USE_SIM_TIME_NAME}' {parameter.type_!r} should be bool"
            )
        node.add_on_set_parameters_callback(self._on_parameter_event)

    def detach_node(self) -> None:
        """Stop following the node's parameter.

        Raises
        ------
        RuntimeError
            If no node is attached.
        """
        node = self._node()
        if node is None:
            raise RuntimeError("Unable to detach node from TimeSource because no node is attached")
        self._unsubscribe()
        if self._on_parameter_event in node._on_set_parameters_callbacks:
            node.remove_on_set_parameters_callback(self._on_parameter_event)
        self._node_weak_ref = None

    def attach_clock(self, clock: ROSClock) -> None:
        """Have a clock follow.

        Raises
        ------
        ValueError
            If it is not a ROS clock.
        """
        if not isinstance(clock, ROSClock):
            raise ValueError("Only clocks with type ROS_TIME can be attached.")
        clock.set_ros_time_override(self._last_time_set)
        clock._set_ros_time_is_active(self.ros_time_is_active)
        self._associated_clocks.append(clock)

    def clock_callback(self, msg: Clock) -> None:
        """Take over a time of ``/clock``."""
        self._last_time_set = Time.from_msg(msg.clock)
        for clock in self._associated_clocks:
            clock.set_ros_time_override(self._last_time_set)

    def _on_parameter_event(self, parameter_list: list[Parameter]) -> SetParametersResult:
        for parameter in parameter_list:
            if parameter.name == USE_SIM_TIME_NAME:
                if parameter.type_ != Parameter.Type.BOOL:
                    return SetParametersResult(
                        successful=False,
                        reason=f"Invalid type for parameter '{USE_SIM_TIME_NAME}' "
                        f"{parameter.type_!r} should be bool",
                    )
                self.ros_time_is_active = parameter.value
        return SetParametersResult(successful=True)
