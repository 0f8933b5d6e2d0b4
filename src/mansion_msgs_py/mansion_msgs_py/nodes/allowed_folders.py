"""The parameter that says where a node's services may write."""

from typing import Final

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from mansion_msgs_py.allowed_folders import AllowedFolders, allowed_at_start

__all__ = ["ALLOW", "declare_allowed_folders"]

ALLOW: Final = "allow"


def declare_allowed_folders(node: Node, *more: str) -> AllowedFolders:
    """Declare the parameter ``allow`` of a node and return where its services may write.

    Parameters
    ----------
    node : Node
    *more : str
        Folders that other parameters name at the start.
    """
    descriptor = ParameterDescriptor(
        description="folders below which services may write, besides the working folder and the temporary one",
        read_only=True,
    )
    # An empty array has no type for rclpy; one empty string stands for none.
    named = node.declare_parameter(ALLOW, [""], descriptor).value
    return allowed_at_start([*(named or []), *more])
