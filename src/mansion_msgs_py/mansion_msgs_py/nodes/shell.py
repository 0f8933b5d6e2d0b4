"""Services and topics of a node whose payloads are JSON, and the replies of handlers that fail.

``diagnostic_msgs/srv/AddDiagnostics`` is the only service of the common interfaces that takes a string and returns a
string: it is aliased here as `JsonCall` and used by that name everywhere.
"""

import traceback
from collections.abc import Callable
from typing import Any, Final

from diagnostic_msgs.srv import AddDiagnostics as JsonCall
from rclpy.callback_groups import CallbackGroup
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.service import Service
from rclpy.subscription import Subscription
from std_msgs.msg import String
from std_srvs.srv import Trigger

from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.errors import (
    MOST_CHARACTERS,
    MOST_IN_DETAILS,
    SYSTEM_REFUSALS,
    ErrorCode,
    MansionError,
    refused_by_system,
)
from mansion_msgs_py.interfaces import Qos, ServiceInterface, TopicInterface
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.wording import shortened

__all__ = [
    "CALLS",
    "JsonCall",
    "JsonPublisher",
    "Trigger",
    "add_json_service",
    "add_json_subscription",
    "qos_profile",
    "run_handler",
]


CALLS: Final = QoSProfile(depth=1000)
"""QoS of services and clients: with rclpy's depth of 10 a busy service drops requests, and a client that waits for the
processor while others get more replies of the same service loses its own."""


def qos_profile(qos: Qos) -> QoSProfile:
    """Return the ROS profile of `qos`."""
    return QoSProfile(
        depth=qos.depth,
        reliability=(ReliabilityPolicy.RELIABLE if qos.reliability == "reliable" else ReliabilityPolicy.BEST_EFFORT),
        durability=(
            DurabilityPolicy.TRANSIENT_LOCAL if qos.durability == "transient_local" else DurabilityPolicy.VOLATILE
        ),
    )


class JsonPublisher:
    """Publishes payloads on a topic of the table."""

    def __init__(self, node: Node, interface: TopicInterface) -> None:
        self.publisher: Publisher = node.create_publisher(String, interface.name, qos_profile(interface.qos))

    def publish(self, payload: Any) -> None:
        """Encode and publish."""
        self.publisher.publish(String(data=encode(payload)))


def run_handler(node: MansionNode, name: str, call: Callable[[], Any]) -> tuple[bool, str]:
    """Run a handler and return (success, JSON); every failure becomes the error object, and the node lives on.

    What fails because the process is being ended is not worth a traceback.
    """
    with node.calls.one():
        try:
            return True, encode(call())
        except MansionError as error:
            return _refusal(node, name, error)
        except OSError as error:
            if error.errno not in SYSTEM_REFUSALS:
                return _fault(node, name, error)
            return _refusal(node, name, refused_by_system(error))
        except Exception as error:
            return _fault(node, name, error)


def _refusal(node: MansionNode, name: str, error: MansionError) -> tuple[bool, str]:
    node.calls.refuse()
    node.get_logger().warning(f"{name}: {error}")
    return False, encode(error.reply())


def _fault(node: MansionNode, name: str, error: Exception) -> tuple[bool, str]:
    reason = f"{name} failed inside Mansion: {type(error).__name__}: {error}"
    node.calls.fail(shortened(reason, MOST_CHARACTERS))
    if node.context.ok():
        node.get_logger().error(f"{name}: {shortened(traceback.format_exc(), MOST_IN_DETAILS)}")
    details = {"node": node.get_fully_qualified_name()}
    return False, encode(MansionError(ErrorCode.INTERNAL, reason, details=details).reply())


def add_json_service(
    node: MansionNode,
    interface: ServiceInterface,
    handler: Callable[[Any], Any],
    *,
    callback_group: CallbackGroup | None = None,
) -> Service:
    """Serve `interface` with `handler`, which gets the decoded arguments (``None`` for a Trigger).

    Parameters
    ----------
    handler : callable
        Pure or thin function from arguments to payload; raises `MansionError` to refuse.
    """

    def answer(request: Any, response: Any) -> Any:
        def call() -> Any:
            if interface.arguments is None:
                return handler(None)
            return handler(decode(interface.arguments, request.load_namespace))

        response.success, response.message = run_handler(node, interface.name, call)
        return response

    kind = Trigger if interface.arguments is None else JsonCall
    return node.create_service(kind, interface.name, answer, qos_profile=CALLS, callback_group=callback_group)


def add_json_subscription(
    node: Node,
    interface: TopicInterface,
    handler: Callable[[Any], None],
    *,
    callback_group: CallbackGroup | None = None,
) -> Subscription:
    """Call `handler` with each decoded payload of a topic.

    A message that does not decode, or that the handler fails on, is logged and dropped: nobody may end a node by
    publishing.
    """

    def receive(message: Any) -> None:
        try:
            payload = decode(interface.payload, message.data)
        except MansionError as error:
            node.get_logger().warning(f"{interface.name}: {error}")
            return
        try:
            handler(payload)
        except Exception:
            if not node.context.ok():
                return
            node.get_logger().error(f"{interface.name}: {shortened(traceback.format_exc(), MOST_IN_DETAILS)}")

    return node.create_subscription(
        String, interface.name, receive, qos_profile(interface.qos), callback_group=callback_group
    )
