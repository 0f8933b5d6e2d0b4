"""How every node process starts, spins and ends."""

import sys
from collections.abc import Callable, Sequence

import rclpy
from rclpy.exceptions import ParameterException
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.logging import get_logger
from rclpy.node import Node

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.nodes.interrupts import Interrupts
from mansion_msgs_py.nodes.node import wake_regularly

__all__ = ["run_node"]

PATIENCE = 0.5
"""Seconds for which callbacks that still run are waited for at the end."""


def run_node(make: Callable[[], Node], args: Sequence[str] | None = None, *, threads: int = 4) -> None:
    """Make a node and spin it until the process is told to end, which leaves no traceback.

    Parameters
    ----------
    make : callable
        Makes the node once rclpy is initialised.
    args : sequence of str, optional
        Command line with ``--ros-args``; ``sys.argv`` when absent.
    threads : int
        Of the executor.

    Raises
    ------
    SystemExit
        With status 1 when `make` refuses, as it does for a parameter that it cannot use; the reason is logged.
    """
    interrupts = Interrupts()
    interrupts.install()
    rclpy.init(args=list(args) if args is not None else None)
    node: Node | None = None
    try:
        node = make()
        interrupts.spinning = True
        _spin(node, threads)
    except (MansionError, ParameterException) as error:
        get_logger("mansion").fatal(str(error))
        sys.exit(1)
    except (KeyboardInterrupt, ExternalShutdownException):
        return
    except Exception:
        # A signal shuts the context down between two calls of rclpy, which then fail in many ways.
        if rclpy.ok():
            raise
    finally:
        interrupts.ignore()
        if node is not None:
            node.destroy_node()
        rclpy.try_shutdown()
        # rclpy has put back the handlers that it found.
        interrupts.ignore()


def _spin(node: Node, threads: int) -> None:
    executor = MultiThreadedExecutor(num_threads=threads)
    executor.add_node(node)
    wake_regularly(node)
    try:
        executor.spin()
    finally:
        executor.shutdown(timeout_sec=PATIENCE)
