"""Let parameters override the QoS of publishers and subscriptions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.duration import Duration
from rclpy.exceptions import ParameterAlreadyDeclaredException
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyKind,
    QoSProfile,
    ReliabilityPolicy,
)

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["InvalidQosOverridesError", "QoSOverridingOptions", "QosCallbackResult"]

QosCallbackResult = SetParametersResult
QosCallbackType = Callable[[QoSProfile], QosCallbackResult]

_ENUMS: dict[str, Any] = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}


class InvalidQosOverridesError(Exception):
    """The overrides are refused by the program's callback."""


@dataclass
class QoSOverridingOptions:
    """Which policies parameters may override; ``entity_id`` tells endpoints of a topic apart."""

    policy_kinds: Iterable[QoSPolicyKind]
    callback: QosCallbackType | None = None
    entity_id: str | None = None

    @classmethod
    def with_default_policies(
        cls, *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> QoSOverridingOptions:
        """History, depth and reliability."""
        kinds = (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY)
        return cls(policy_kinds=kinds, callback=callback, entity_id=entity_id)


def _to_parameter(value: Any) -> Any:
    if isinstance(value, Duration):
        return value.nanoseconds
    return value.short_key if hasattr(value, "short_key") else value


def _from_parameter(name: str, value: Any) -> Any:
    if name in _ENUMS:
        return _ENUMS[name][value.upper()]
    if name in ("deadline", "lifespan", "liveliness_lease_duration"):
        return Duration(nanoseconds=value)
    return value


def _declare_qos_parameters(
    entity: str, node: Node, topic: str, profile: QoSProfile, options: QoSOverridingOptions
) -> None:
    """Declare the parameters and take their values into the profile."""
    suffix = f"_{options.entity_id}" if options.entity_id else ""
    for kind in options.policy_kinds:
        policy = kind.name.lower()
        name = f"qos_overrides.{topic}.{entity}{suffix}.{policy}"
        descriptor = ParameterDescriptor(name=name, read_only=True)
        try:
            declared = node.declare_parameter(
                name, _to_parameter(getattr(profile, policy)), descriptor
            )
        except ParameterAlreadyDeclaredException:
            declared = node.get_parameter(name)
        setattr(profile, policy, _from_parameter(policy, declared.value))
    if options.callback is not None:
        result = options.callback(profile)
        if not result.successful:
            raise InvalidQosOverridesError(
                f"{entity} of '{topic}': the overrides were refused: {result.reason}"
            )
