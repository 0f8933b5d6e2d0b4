"""The Python client library of ROS 2 Jazzy, over the PyPI package ``cyclonedds``.

It has the API of rclpy 7.1 for what nodes normally use, and the wire format of
``rmw_cyclonedds_cpp``. What it has not raises an error that says so.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from rclpy._real_ros import refuse_beside_real_ros

refuse_beside_real_ros()

from rclpy.context import Context  # noqa: E402
from rclpy.parameter import Parameter  # noqa: E402
from rclpy.signals import (  # noqa: E402
    SignalHandlerOptions,
    install_signal_handlers,
    uninstall_signal_handlers,
)
from rclpy.signals import _register as _register_for_signals  # noqa: E402
from rclpy.task import Future  # noqa: E402
from rclpy.utilities import (  # noqa: E402
    get_default_context,
    get_rmw_implementation_identifier,
    ok,
    try_shutdown,
)
from rclpy.utilities import shutdown as _shutdown  # noqa: E402

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.node import Node

__all__ = [
    "TYPE_CHECKING",
    "Context",
    "Future",
    "Parameter",
    "create_node",
    "get_default_context",
    "get_global_executor",
    "get_rmw_implementation_identifier",
    "init",
    "ok",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "try_shutdown",
]

__version__ = "7.1.3"

_executor: Executor | None = None


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> None:
    """Initialize ROS for a context.

    Parameters
    ----------
    args
        Command line; None takes ``sys.argv``.
    context
        None takes the default context.
    domain_id
        None takes ``ROS_DOMAIN_ID``.
    signal_handler_options
        None installs all handlers for the default context, none for others.
    """
    is_default = context is None
    chosen = get_default_context() if context is None else context
    if signal_handler_options is None:
        signal_handler_options = SignalHandlerOptions.ALL if is_default else SignalHandlerOptions.NO
    chosen.init(args, domain_id=domain_id)
    _register_for_signals(chosen)
    install_signal_handlers(signal_handler_options)


def get_global_executor() -> Executor:
    """The executor of ``spin`` and its like, made when first asked for."""
    global _executor
    if _executor is None:
        from rclpy.executors import SingleThreadedExecutor

        _executor = SingleThreadedExecutor()
        get_default_context().on_shutdown(_reset_executor)
    return _executor


def _reset_executor() -> None:
    # Only forgotten: it may be spinning in the thread that shuts the context down.
    global _executor
    executor, _executor = _executor, None
    if executor is not None:
        executor.wake()


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut a context down.

    Parameters
    ----------
    uninstall_handlers
        None uninstalls the signal handlers with the default context.
    """
    _shutdown(context=context)
    if uninstall_handlers or (uninstall_handlers is None and context is None):
        uninstall_signal_handlers()


def create_node(
    node_name: str,
    *,
    context: Context | None = None,
    cli_args: list[str] | None = None,
    namespace: str | None = None,
    use_global_arguments: bool = True,
    enable_rosout: bool = True,
    start_parameter_services: bool = True,
    parameter_overrides: list[Parameter] | None = None,
    allow_undeclared_parameters: bool = False,
    automatically_declare_parameters_from_overrides: bool = False,
    enable_logger_service: bool = False,
) -> Node:
    """Create a node; the parameters are those of ``rclpy.node.Node``."""
    from rclpy.node import Node

    return Node(
        node_name,
        context=context,
        cli_args=cli_args,
        namespace=namespace,
        use_global_arguments=use_global_arguments,
        enable_rosout=enable_rosout,
        start_parameter_services=start_parameter_services,
        parameter_overrides=parameter_overrides,
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
        enable_logger_service=enable_logger_service,
    )


def spin_once(
    node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Execute one callback of a node, or wait for the timeout."""
    executor = get_global_executor() if executor is None else executor
    try:
        executor.add_node(node)
        executor.spin_once(timeout_sec=timeout_sec)
    finally:
        executor.remove_node(node)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Execute the callbacks of a node until the context is shut down.

    Raises
    ------
    rclpy.executors.ExternalShutdownException
        If a signal or another thread shuts it down.
    """
    executor = get_global_executor() if executor is None else executor
    try:
        executor.add_node(node)
        while executor.context.ok():
            executor.spin_once()
    finally:
        executor.remove_node(node)


def spin_until_future_complete(
    node: Node,
    future: Future,
    executor: Executor | None = None,
    timeout_sec: float | None = None,
) -> None:
    """Execute the callbacks of a node until the future is done, the timeout, or shutdown."""
    executor = get_global_executor() if executor is None else executor
    try:
        executor.add_node(node)
        executor.spin_until_future_complete(future, timeout_sec)
    finally:
        executor.remove_node(node)


_SUBMODULES = frozenset(
    [
        "action",
        "callback_groups",
        "client",
        "clock",
        "constants",
        "duration",
        "event_handler",
        "exceptions",
        "executors",
        "guard_condition",
        "lifecycle",
        "logging",
        "node",
        "parameter_client",
        "parameter_event_handler",
        "publisher",
        "qos",
        "qos_event",
        "serialization",
        "service",
        "subscription",
        "time",
        "timer",
        "topic_endpoint_info",
        "wait_for_message",
    ]
)


def __getattr__(name: str) -> Any:
    if name in _SUBMODULES:
        return import_module(f"rclpy.{name}")
    raise AttributeError(
        f"module 'rclpy' has no attribute {name!r} (this is the rclpy of mansion_embedded_ros)"
    )
