"""QoS profiles of rclpy as Cyclone's, set as ``rmw_cyclonedds_cpp`` of Jazzy sets them, and back."""

from __future__ import annotations

import ctypes as ct
from typing import Any

from rclpy._dds.library import INFINITY, KEEP_ALL, KEEP_LAST, dds
from rclpy.duration import Duration, Infinite
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)

__all__ = ["CQos", "read_profile", "read_user_data"]

_VOLATILE, _TRANSIENT_LOCAL = 0, 1
_BEST_EFFORT, _RELIABLE = 0, 1
_AUTOMATIC, _MANUAL_BY_TOPIC = 0, 2
_XCDR1 = ct.c_int16(0)


class CQos:
    """A ``dds_qos_t``, freed at the end of the ``with`` block."""

    def __init__(self, profile: QoSProfile | None = None, user_data: str = "") -> None:
        self.pointer = dds.dds_create_qos()
        if user_data:
            data = user_data.encode("latin-1")
            dds.dds_qset_userdata(self.pointer, data, len(data))
        if profile is not None:
            self._fill(profile)

    def __enter__(self) -> Any:
        return self.pointer

    def __exit__(self, *_: object) -> None:
        dds.dds_delete_qos(self.pointer)

    def _fill(self, profile: QoSProfile) -> None:
        qos = self.pointer
        keep_all = profile.history == HistoryPolicy.KEEP_ALL
        depth = -1 if keep_all else max(profile.depth, 1)
        history = KEEP_ALL if keep_all else KEEP_LAST
        dds.dds_qset_writer_data_lifecycle(qos, False)
        dds.dds_qset_data_representation(qos, 1, ct.byref(_XCDR1))
        dds.dds_qset_history(qos, history, depth)
        best_effort = profile.reliability == ReliabilityPolicy.BEST_EFFORT
        dds.dds_qset_reliability(qos, _BEST_EFFORT if best_effort else _RELIABLE, INFINITY)
        if profile.durability == DurabilityPolicy.TRANSIENT_LOCAL:
            dds.dds_qset_durability(qos, _TRANSIENT_LOCAL)
            dds.dds_qset_durability_service(qos, 0, history, depth, -1, -1, -1)
        else:
            dds.dds_qset_durability(qos, _VOLATILE)
        if 0 < profile.lifespan.nanoseconds < INFINITY:
            dds.dds_qset_lifespan(qos, profile.lifespan.nanoseconds)
        if 0 < profile.deadline.nanoseconds < INFINITY - 1:
            dds.dds_qset_deadline(qos, profile.deadline.nanoseconds)
        lease = profile.liveliness_lease_duration.nanoseconds
        manual = profile.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC
        dds.dds_qset_liveliness(
            qos,
            _MANUAL_BY_TOPIC if manual else _AUTOMATIC,
            lease if 0 < lease < INFINITY - 1 else INFINITY,
        )


def read_user_data(qos: int) -> dict[str, str]:
    """The ``key=value;`` pairs of an endpoint's USER_DATA."""
    data, size = ct.c_void_p(), ct.c_size_t()
    if not dds.dds_qget_userdata(qos, ct.byref(data), ct.byref(size)) or not data.value:
        return {}
    text = ct.string_at(data.value, size.value).decode("latin-1")
    dds.dds_free(data)
    pairs = (part.partition("=") for part in text.split(";") if "=" in part)
    return {key: value for key, _, value in pairs}


def _duration(nanoseconds: int) -> Duration:
    return Infinite if nanoseconds >= INFINITY else Duration(nanoseconds=nanoseconds)


def read_profile(qos: int) -> QoSProfile:
    """The profile of a discovered endpoint; discovery does not carry the history, so it is UNKNOWN."""
    kind, second = ct.c_int(), ct.c_int64()
    profile = QoSProfile(history=HistoryPolicy.UNKNOWN, depth=0)
    if dds.dds_qget_history(qos, ct.byref(kind), ct.byref(depth := ct.c_int32())):
        profile.history = (
            HistoryPolicy.KEEP_ALL if kind.value == KEEP_ALL else HistoryPolicy.KEEP_LAST
        )
        if kind.value == KEEP_LAST:
            profile.depth = depth.value
    if dds.dds_qget_reliability(qos, ct.byref(kind), ct.byref(second)):
        reliable = kind.value == _RELIABLE
        profile.reliability = (
            ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
        )
    if dds.dds_qget_durability(qos, ct.byref(kind)):
        volatile = kind.value == _VOLATILE
        profile.durability = (
            DurabilityPolicy.VOLATILE if volatile else DurabilityPolicy.TRANSIENT_LOCAL
        )
    if dds.dds_qget_lifespan(qos, ct.byref(second)):
        profile.lifespan = _duration(second.value)
    else:
        profile.lifespan = Infinite
    if dds.dds_qget_deadline(qos, ct.byref(second)):
        profile.deadline = _duration(second.value)
    else:
        profile.deadline = Infinite
    profile.liveliness, profile.liveliness_lease_duration = LivelinessPolicy.AUTOMATIC, Infinite
    if dds.dds_qget_liveliness(qos, ct.byref(kind), ct.byref(second)):
        manual = kind.value == _MANUAL_BY_TOPIC
        profile.liveliness = (
            LivelinessPolicy.MANUAL_BY_TOPIC if manual else LivelinessPolicy.AUTOMATIC
        )
        profile.liveliness_lease_duration = _duration(second.value)
    return profile
