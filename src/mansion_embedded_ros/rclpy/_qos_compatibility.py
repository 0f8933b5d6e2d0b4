"""Compatibility of two QoS profiles, by the rules of the DDS specification (2.2.3)."""

from __future__ import annotations

from typing import Any

__all__ = ["check_compatible"]

_RELIABLE, _BEST_EFFORT = 1, 2
_TRANSIENT_LOCAL, _VOLATILE = 1, 2
_AUTOMATIC, _MANUAL_BY_TOPIC = 1, 3
_UNDECIDED = {"reliability": (0, 3, 4), "durability": (0, 3, 4), "liveliness": (0, 4, 5)}


def _set(duration: Any) -> bool:
    return 0 < duration.nanoseconds < 2**63 - 2


def check_compatible(publisher: Any, subscription: Any) -> tuple[int, str]:
    """Level (0 fine, 1 perhaps not, 2 incompatible) and the reasons."""
    errors: list[str] = []
    if publisher.reliability == _BEST_EFFORT and subscription.reliability == _RELIABLE:
        errors.append("Best effort publisher and reliable subscription")
    if publisher.durability == _VOLATILE and subscription.durability == _TRANSIENT_LOCAL:
        errors.append("Volatile publisher and transient local subscription")
    if publisher.liveliness == _AUTOMATIC and subscription.liveliness == _MANUAL_BY_TOPIC:
        errors.append("Publisher's liveliness is automatic and subscription's is manual by topic")
    for name in ("deadline", "liveliness_lease_duration"):
        offered, requested = getattr(publisher, name), getattr(subscription, name)
        label = name.replace("_", " ")
        if _set(requested) and not _set(offered):
            errors.append(f"Subscription has a {label}, but publisher does not")
        elif _set(requested) and offered.nanoseconds > requested.nanoseconds:
            errors.append(f"Subscription {label} is less than publisher {label}")
    if errors:
        return 2, "ERROR: " + "; ERROR: ".join(errors) + ";"
    warnings = [
        f"{name} of the {who} is not decided yet"
        for name, undecided in _UNDECIDED.items()
        for who, profile in (("publisher", publisher), ("subscription", subscription))
        if getattr(profile, name) in undecided and name != "liveliness"
    ]
    if warnings:
        return 1, "WARNING: " + "; WARNING: ".join(warnings) + ";"
    return 0, ""
