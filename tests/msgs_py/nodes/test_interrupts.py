"""Ctrl-C ends the making of a node at once, and a spinning node by its context."""

import signal
import threading

import pytest

from mansion_msgs_py.nodes import run
from mansion_msgs_py.nodes.run import INTERRUPT_WINDOW, Interrupts


def test_a_node_that_is_being_made_is_interrupted_at_once() -> None:
    with pytest.raises(KeyboardInterrupt):
        Interrupts(kill=lambda: None).handle(signal.SIGINT, None)


def test_a_spinning_node_is_interrupted_by_the_second_that_means_it() -> None:
    times = iter([10.0, 10.0 + INTERRUPT_WINDOW / 2, 10.0 + 2 * INTERRUPT_WINDOW])
    interrupts = Interrupts(clock=lambda: next(times), kill=lambda: None)
    interrupts.spinning = True
    interrupts.handle(signal.SIGINT, None)
    interrupts.handle(signal.SIGINT, None)
    with pytest.raises(KeyboardInterrupt):
        interrupts.handle(signal.SIGINT, None)


def test_terminating_a_spinning_node_again_changes_nothing() -> None:
    times = iter([10.0, 10.0 + 2 * INTERRUPT_WINDOW])
    interrupts = Interrupts(clock=lambda: next(times), kill=lambda: None)
    interrupts.spinning = True
    interrupts.handle(signal.SIGTERM, None)
    interrupts.handle(signal.SIGTERM, None)


def test_what_is_still_busy_after_the_grace_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run, "GRACE", 0.0)
    killed = threading.Event()
    interrupts = Interrupts(kill=killed.set)
    interrupts.spinning = True
    interrupts.handle(signal.SIGTERM, None)
    assert killed.wait(10.0)
