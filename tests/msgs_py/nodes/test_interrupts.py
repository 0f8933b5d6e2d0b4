"""Ctrl-C ends the making of a node at once, and a spinning node by its context."""

import signal

import pytest

from mansion_msgs_py.nodes.interrupts import PATIENCE, Interrupts


def test_a_node_that_is_being_made_is_interrupted_at_once() -> None:
    with pytest.raises(KeyboardInterrupt):
        Interrupts().handle(signal.SIGINT, None)


def test_a_spinning_node_is_interrupted_by_the_second_that_means_it() -> None:
    times = iter([10.0, 10.0 + PATIENCE / 2, 10.0 + 2 * PATIENCE])
    interrupts = Interrupts(clock=lambda: next(times))
    interrupts.spinning = True
    interrupts.handle(signal.SIGINT, None)
    interrupts.handle(signal.SIGINT, None)
    with pytest.raises(KeyboardInterrupt):
        interrupts.handle(signal.SIGINT, None)
