"""Service introspection is not here; the state OFF is all that can be configured."""

from rclpy._rclpy_pybind11 import ServiceIntrospectionState

__all__ = ["ServiceIntrospectionState"]
