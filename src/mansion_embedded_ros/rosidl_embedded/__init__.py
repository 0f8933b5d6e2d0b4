"""Interface definitions as data, and the Python classes, CDR codecs and type hashes made from them.

The tables in ``interfaces/`` hold the message and service definitions of ROS 2 Jazzy (packages
``common_interfaces``, ``rcl_interfaces``, ``rmw_dds_common``, ``geometry2``) without their comments.
"""

from rosidl_embedded.definition import InterfaceNotFoundError
from rosidl_embedded.registry import get_interface, get_message, get_service

__all__ = ["InterfaceNotFoundError", "get_interface", "get_message", "get_service"]
