"""Prototypes of the C functions used, from the library inside the ``cyclonedds`` wheel (11.0)."""

from __future__ import annotations

import ctypes as ct
from importlib.util import find_spec
from pathlib import Path
from typing import Any

__all__ = [
    "ALIVE",
    "ANY_STATE",
    "BUILTIN_PARTICIPANT",
    "BUILTIN_PUBLICATION",
    "BUILTIN_SUBSCRIPTION",
    "CYCLONEDDS_HANDLE",
    "INFINITY",
    "KEEP_ALL",
    "KEEP_LAST",
    "PRECONDITION_NOT_MET",
    "TIMEOUT",
    "BuiltinEndpoint",
    "BuiltinParticipant",
    "DDSError",
    "Iovec",
    "SampleInfo",
    "TopicDescriptor",
    "check",
    "dds",
]

INFINITY = 2**63 - 1
ANY_STATE = 0
ALIVE = 16
KEEP_LAST, KEEP_ALL = 0, 1
TIMEOUT, PRECONDITION_NOT_MET = -10, -4
_PSEUDO = 0x7FFF0000
BUILTIN_PARTICIPANT, BUILTIN_PUBLICATION, BUILTIN_SUBSCRIPTION = (
    _PSEUDO + 1,
    _PSEUDO + 3,
    _PSEUDO + 4,
)
CYCLONEDDS_HANDLE = _PSEUDO + 256

_RETCODES = {
    -1: "error",
    -2: "unsupported",
    -3: "bad parameter",
    -4: "precondition not met",
    -5: "out of resources",
    -6: "not enabled",
    -7: "immutable policy",
    -8: "inconsistent policy",
    -9: "already deleted",
    -10: "timeout",
    -11: "no data",
    -12: "illegal operation",
}


class DDSError(RuntimeError):
    """A call into Cyclone DDS failed; ``code`` is its return code."""

    def __init__(self, code: int, action: str) -> None:
        super().__init__(f"Cyclone DDS cannot {action}: {_RETCODES.get(code, code)}")
        self.code = code


def check(code: int, action: str) -> int:
    """Give ``code`` back if it is no error."""
    if code < 0:
        raise DDSError(code, action)
    return code


class TypeMeta(ct.Structure):
    _fields_ = [("data", ct.c_void_p), ("size", ct.c_uint32)]


class TopicDescriptor(ct.Structure):
    """``dds_topic_descriptor_t``."""

    _fields_ = [
        ("m_size", ct.c_uint32),
        ("m_align", ct.c_uint32),
        ("m_flagset", ct.c_uint32),
        ("m_nkeys", ct.c_uint32),
        ("m_typename", ct.c_char_p),
        ("m_keys", ct.c_void_p),
        ("m_nops", ct.c_uint32),
        ("m_ops", ct.c_void_p),
        ("m_meta", ct.c_char_p),
        ("type_information", TypeMeta),
        ("type_mapping", TypeMeta),
        ("restrict_data_representation", ct.c_uint32),
    ]


class SampleInfo(ct.Structure):
    """``dds_sample_info_t``."""

    _fields_ = [
        ("sample_state", ct.c_uint),
        ("view_state", ct.c_uint),
        ("instance_state", ct.c_uint),
        ("valid_data", ct.c_bool),
        ("source_timestamp", ct.c_int64),
        ("instance_handle", ct.c_uint64),
        ("publication_handle", ct.c_uint64),
        ("disposed_generation_count", ct.c_uint32),
        ("no_writers_generation_count", ct.c_uint32),
        ("sample_rank", ct.c_uint32),
        ("generation_rank", ct.c_uint32),
        ("absolute_generation_rank", ct.c_uint32),
    ]


class Iovec(ct.Structure):
    _fields_ = [("base", ct.c_void_p), ("size", ct.c_size_t)]


class BuiltinParticipant(ct.Structure):
    """``dds_builtintopic_participant_t``."""

    _fields_ = [("key", ct.c_uint8 * 16), ("qos", ct.c_void_p)]


class BuiltinEndpoint(ct.Structure):
    """``dds_builtintopic_endpoint_t``."""

    _fields_ = [
        ("key", ct.c_uint8 * 16),
        ("participant_key", ct.c_uint8 * 16),
        ("participant_instance_handle", ct.c_uint64),
        ("topic_name", ct.c_char_p),
        ("type_name", ct.c_char_p),
        ("qos", ct.c_void_p),
    ]


class MatchedStatus(ct.Structure):
    """``dds_publication_matched_status_t`` and ``dds_subscription_matched_status_t``."""

    _fields_ = [
        ("total_count", ct.c_uint32),
        ("total_count_change", ct.c_int32),
        ("current_count", ct.c_uint32),
        ("current_count_change", ct.c_int32),
        ("last_handle", ct.c_uint64),
    ]


class IncompatibleQosStatus(ct.Structure):
    _fields_ = [
        ("total_count", ct.c_uint32),
        ("total_count_change", ct.c_int32),
        ("last_policy_id", ct.c_uint32),
    ]


class CountStatus(ct.Structure):
    """Deadline missed, liveliness lost, sample lost, inconsistent topic: counts first in all."""

    _fields_ = [
        ("total_count", ct.c_uint32),
        ("total_count_change", ct.c_int32),
        ("last_handle", ct.c_uint64),
    ]


class LivelinessChangedStatus(ct.Structure):
    _fields_ = [
        ("alive_count", ct.c_uint32),
        ("not_alive_count", ct.c_uint32),
        ("alive_count_change", ct.c_int32),
        ("not_alive_count_change", ct.c_int32),
        ("last_handle", ct.c_uint64),
    ]


_entity, _pointer, _text = ct.c_int32, ct.c_void_p, ct.c_char_p
_u32, _u64, _i64, _size = ct.c_uint32, ct.c_uint64, ct.c_int64, ct.c_size_t

_PROTOTYPES: dict[str, tuple[Any, list[Any]]] = {
    "dds_create_domain": (_entity, [_u32, _text]),
    "dds_create_participant": (_entity, [_u32, _pointer, _pointer]),
    "dds_create_publisher": (_entity, [_entity, _pointer, _pointer]),
    "dds_create_subscriber": (_entity, [_entity, _pointer, _pointer]),
    "dds_create_topic": (_entity, [_entity, _pointer, _text, _pointer, _pointer]),
    "dds_create_reader": (_entity, [_entity, _entity, _pointer, _pointer]),
    "dds_create_writer": (_entity, [_entity, _entity, _pointer, _pointer]),
    "dds_create_readcondition": (_entity, [_entity, _u32]),
    "dds_create_guardcondition": (_entity, [_entity]),
    "dds_set_guardcondition": (ct.c_int32, [_entity, ct.c_bool]),
    "dds_take_guardcondition": (ct.c_int32, [_entity, _pointer]),
    "dds_create_waitset": (_entity, [_entity]),
    "dds_waitset_attach": (ct.c_int32, [_entity, _entity, ct.c_ssize_t]),
    "dds_waitset_detach": (ct.c_int32, [_entity, _entity]),
    "dds_waitset_wait": (ct.c_int32, [_entity, _pointer, _size, _i64]),
    "dds_delete": (ct.c_int32, [_entity]),
    "dds_get_guid": (ct.c_int32, [_entity, _pointer]),
    "dds_get_instance_handle": (ct.c_int32, [_entity, _pointer]),
    "dds_get_entity_sertype": (ct.c_int32, [_entity, _pointer]),
    "dds_set_status_mask": (ct.c_int32, [_entity, _u32]),
    "dds_take_status": (ct.c_int32, [_entity, _pointer, _u32]),
    "dds_get_status_changes": (ct.c_int32, [_entity, _pointer]),
    "dds_get_qos": (ct.c_int32, [_entity, _pointer]),
    "dds_read": (ct.c_int32, [_entity, _pointer, _pointer, _size, _u32]),
    "dds_return_loan": (ct.c_int32, [_entity, _pointer, ct.c_int32]),
    "dds_takecdr": (ct.c_int32, [_entity, _pointer, _u32, _pointer, _u32]),
    "dds_writecdr": (ct.c_int32, [_entity, _pointer]),
    "dds_assert_liveliness": (ct.c_int32, [_entity]),
    "dds_wait_for_acks": (ct.c_int32, [_entity, _i64]),
    "dds_get_matched_publications": (ct.c_int32, [_entity, _pointer, _size]),
    "dds_get_matched_subscriptions": (ct.c_int32, [_entity, _pointer, _size]),
    "dds_get_matched_publication_data": (_pointer, [_entity, _u64]),
    "dds_get_matched_subscription_data": (_pointer, [_entity, _u64]),
    "dds_builtintopic_free_endpoint": (None, [_pointer]),
    "dds_get_publication_matched_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_subscription_matched_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_offered_incompatible_qos_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_requested_incompatible_qos_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_offered_deadline_missed_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_requested_deadline_missed_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_liveliness_lost_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_liveliness_changed_status": (ct.c_int32, [_entity, _pointer]),
    "dds_get_sample_lost_status": (ct.c_int32, [_entity, _pointer]),
    "dds_free": (None, [_pointer]),
    "dds_create_qos": (_pointer, []),
    "dds_delete_qos": (None, [_pointer]),
    "dds_qset_userdata": (None, [_pointer, _text, _size]),
    "dds_qset_reliability": (None, [_pointer, ct.c_int, _i64]),
    "dds_qset_durability": (None, [_pointer, ct.c_int]),
    "dds_qset_durability_service": (
        None,
        [_pointer, _i64, ct.c_int, ct.c_int32, ct.c_int32, ct.c_int32, ct.c_int32],
    ),
    "dds_qset_history": (None, [_pointer, ct.c_int, ct.c_int32]),
    "dds_qset_lifespan": (None, [_pointer, _i64]),
    "dds_qset_deadline": (None, [_pointer, _i64]),
    "dds_qset_liveliness": (None, [_pointer, ct.c_int, _i64]),
    "dds_qset_ignorelocal": (None, [_pointer, ct.c_int]),
    "dds_qset_writer_data_lifecycle": (None, [_pointer, ct.c_bool]),
    "dds_qset_data_representation": (None, [_pointer, _u32, _pointer]),
    "dds_qget_userdata": (ct.c_bool, [_pointer, _pointer, _pointer]),
    "dds_qget_reliability": (ct.c_bool, [_pointer, _pointer, _pointer]),
    "dds_qget_durability": (ct.c_bool, [_pointer, _pointer]),
    "dds_qget_history": (ct.c_bool, [_pointer, _pointer, _pointer]),
    "dds_qget_lifespan": (ct.c_bool, [_pointer, _pointer]),
    "dds_qget_deadline": (ct.c_bool, [_pointer, _pointer]),
    "dds_qget_liveliness": (ct.c_bool, [_pointer, _pointer, _pointer]),
    "ddsi_serdata_from_ser_iov": (_pointer, [_pointer, ct.c_int, _size, _pointer, _size]),
    "ddsi_serdata_size": (_u32, [_pointer]),
    "ddsi_serdata_to_ser_ref": (_pointer, [_pointer, _size, _size, _pointer]),
    "ddsi_serdata_to_ser_unref": (None, [_pointer, _pointer]),
    "ddsi_serdata_unref": (None, [_pointer]),
}


def _library_path() -> str:
    """The C library in the wheel; importing the package itself would take most of the start-up."""
    spec = find_spec("cyclonedds")
    if spec is None or spec.origin is None:
        raise ImportError(
            "the embedded rclpy needs the Python package cyclonedds 11 "
            "(pip install 'cyclonedds==11.0.1')"
        )
    home = Path(spec.origin).parent
    for pattern in ("../cyclonedds.libs/libddsc-*.so.11.*", ".libs/libddsc.so"):
        for path in sorted(home.glob(pattern)):
            return str(path.resolve())
    from cyclonedds.internal import DDS

    return str(DDS._dll_handle._name)


def _load() -> ct.CDLL:
    # An instance of its own: prototypes set here must not change those of the cyclonedds package.
    library = ct.CDLL(_library_path())
    for name, (restype, argtypes) in _PROTOTYPES.items():
        function = getattr(library, name)
        function.restype, function.argtypes = restype, argtypes
    return library


dds: Any = _load()
