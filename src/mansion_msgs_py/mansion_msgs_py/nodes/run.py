"""How every node process starts, spins and ends."""

from collections.abc import Callable, Sequence

import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node

__all__ = ["run_node"]


def run_node(
    make: Callable[[], Node], args: Sequence[str] | None = None, *, threads: int = 4
) -> None:
    """Make a node and spin it until the process is told to end.

    Parameters
    ----------
    make : callable
        Makes the node once rclpy is initialised.
    args : sequence of str, optional
        Command line with ``--ros-args``; ``sys.argv`` when absent.
    threads : int
        Of the executor.
    """
    rclpy.init(args=list(args) if args is not None else None)
    try:
        node = make()
        executor = MultiThreadedExecutor(num_threads=threads)
        executor.add_node(node)
        try:
            executor.spin()
        except (KeyboardInterrupt, ExternalShutdownException):
            node.get_logger().debug("told to end")
        finally:
            executor.shutdown()
            node.destroy_node()
    finally:
        rclpy.try_shutdown()
