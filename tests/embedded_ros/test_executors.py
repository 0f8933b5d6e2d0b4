"""Executors, futures, tasks, timers and callback groups."""

from __future__ import annotations

import gc
import threading
import time
import weakref
from typing import Any

import pytest
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import (
    ExternalShutdownException,
    MultiThreadedExecutor,
    SingleThreadedExecutor,
    TimeoutException,
)
from rclpy.task import Future, Task
from std_msgs.msg import Int32

EXECUTORS = [SingleThreadedExecutor, MultiThreadedExecutor]


@pytest.mark.parametrize("kind", EXECUTORS)
def test_a_timer_keeps_its_phase(node: Any, kind: Any) -> None:
    executor = kind()
    executor.add_node(node)
    calls: list[float] = []
    node.create_timer(0.02, lambda: calls.append(time.monotonic()))
    end = time.monotonic() + 0.5
    while time.monotonic() < end:
        executor.spin_once(0.1)
    executor.shutdown()
    assert 15 <= len(calls) <= 26


def test_timers_cancel_reset_and_change_their_period(node: Any) -> None:
    calls: list[int] = []
    timer = node.create_timer(0.01, lambda: calls.append(1), autostart=False)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.spin_once(0.05)
    assert timer.is_canceled()
    assert timer.time_until_next_call() is None
    assert not calls
    timer.reset()
    while not calls:
        executor.spin_once(1.0)
    timer.cancel()
    count = len(calls)
    executor.spin_once(0.05)
    assert len(calls) == count
    timer.timer_period_ns = 10**12
    assert timer.timer_period_ns == 10**12
    executor.shutdown()


@pytest.mark.parametrize("kind", EXECUTORS)
def test_exceptions_of_callbacks_come_out_of_spin(node: Any, kind: Any) -> None:
    def fail() -> None:
        raise ZeroDivisionError("in a timer")

    node.create_timer(0.001, fail)
    executor = kind()
    executor.add_node(node)
    with pytest.raises(ZeroDivisionError, match="in a timer"):
        executor.spin()
    executor.shutdown()


@pytest.mark.parametrize("kind", EXECUTORS)
def test_tasks_and_coroutines_run(ros: Any, kind: Any) -> None:
    executor = kind()
    inner: Future = Future()

    async def wait() -> int:
        return 1 + await inner

    first = executor.create_task(wait)
    second = executor.create_task(lambda a, b=0: a + b, 1, b=2)
    executor.create_task(lambda: inner.set_result(41))
    executor.spin_until_future_complete(first, 5.0)
    executor.spin_until_future_complete(second, 5.0)
    assert (first.result(), second.result()) == (42, 3)
    executor.shutdown()


def test_waiting_for_a_future_leaves_nothing_behind(ros: Any) -> None:
    executor = SingleThreadedExecutor()
    future: Future = Future()
    for _ in range(20):
        executor.spin_until_future_complete(future, 0.0)
    assert not future._callbacks
    future.set_result(3)
    executor.spin_until_future_complete(future)
    executor.shutdown()


def test_a_future_that_another_thread_completes_ends_the_spinning(ros: Any) -> None:
    executor = SingleThreadedExecutor()
    future: Future = Future()
    threading.Timer(0.1, future.set_result, (1,)).start()
    start = time.monotonic()
    executor.spin_until_future_complete(future, 10.0)
    assert future.done()
    assert time.monotonic() - start < 5.0
    executor.shutdown()


def test_futures_cancel_and_raise() -> None:
    future: Future = Future()
    seen: list[Any] = []
    future.add_done_callback(seen.append)
    future.cancel()
    assert future.cancelled()
    assert seen == [future]
    future = Future()
    future.set_exception(KeyError("x"))
    with pytest.raises(KeyError):
        future.result()
    task = Task(lambda: 1 / 0)
    task()
    assert isinstance(task.exception(), ZeroDivisionError)


def _overlap(ros: Any, group: Any) -> int:
    node = ros.create_node("overlapping")
    executor = MultiThreadedExecutor(4)
    running, most = 0, 0
    lock = threading.Lock()

    def work() -> None:
        nonlocal running, most
        with lock:
            running += 1
            most = max(most, running)
        time.sleep(0.02)
        with lock:
            running -= 1

    for _ in range(3):
        node.create_timer(0.005, work, callback_group=group)
    executor.add_node(node)
    end = time.monotonic() + 0.4
    while time.monotonic() < end:
        executor.spin_once(0.05)
    executor.shutdown()
    node.destroy_node()
    return most


def test_mutually_exclusive_callbacks_never_overlap(ros: Any) -> None:
    assert _overlap(ros, MutuallyExclusiveCallbackGroup()) == 1


def test_reentrant_callbacks_overlap_up_to_the_number_of_threads(ros: Any) -> None:
    assert 2 <= _overlap(ros, ReentrantCallbackGroup()) <= 4


def test_an_awaiting_callback_keeps_its_group_busy(node: Any) -> None:
    gate: Future = Future()
    order: list[str] = []

    async def first(_: Int32) -> None:
        order.append("begin")
        await gate
        order.append("end")

    node.create_subscription(Int32, "gate", first, 10)
    publisher = node.create_publisher(Int32, "gate", 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    publisher.publish(Int32())
    publisher.publish(Int32())
    for _ in range(5):
        executor.spin_once(0.02)
    assert order == ["begin"]
    gate.set_result(None)
    for _ in range(20):
        executor.spin_once(0.02)
    assert order == ["begin", "end", "begin", "end"]
    executor.shutdown()


def test_guard_conditions_run_their_callback_once(node: Any) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    threading.Timer(0.05, guard.trigger).start()
    executor.spin_once(5.0)
    executor.spin_once(0.02)
    assert calls == [1]
    assert node.destroy_guard_condition(guard)
    executor.shutdown()


def test_shutting_the_context_down_ends_spinning_elsewhere(ros: Any, node: Any) -> None:
    ended: list[type] = []

    def spin() -> None:
        try:
            ros.spin(node)
        except ExternalShutdownException as end:
            ended.append(type(end))

    thread = threading.Thread(target=spin)
    thread.start()
    time.sleep(0.1)
    ros.shutdown()
    thread.join(5.0)
    assert not thread.is_alive()
    assert ended == [ExternalShutdownException]


def test_wait_for_ready_callbacks_times_out(ros: Any) -> None:
    executor = SingleThreadedExecutor()
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(timeout_sec=0.0)
    executor.shutdown()


def test_an_entity_destroyed_by_a_callback_is_not_run_again(node: Any) -> None:
    calls: list[int] = []

    def once() -> None:
        calls.append(1)
        node.destroy_timer(timer)

    timer = node.create_timer(0.001, once)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    for _ in range(5):
        executor.spin_once(0.01)
    assert calls == [1]
    executor.shutdown()


def test_rates_sleep_while_another_thread_spins(ros: Any, node: Any) -> None:
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    rate = node.create_rate(50.0)
    start = time.monotonic()
    for _ in range(5):
        rate.sleep()
    assert time.monotonic() - start > 0.05
    assert node.destroy_rate(rate)
    executor.shutdown()
    thread.join(5.0)
    assert not thread.is_alive()


def test_destroyed_nodes_are_collected(ros: Any) -> None:
    node = ros.create_node("short_lived")
    node.create_timer(1.0, print)
    ros.spin_once(node, timeout_sec=0.0)
    ref = weakref.ref(node)
    node.destroy_node()
    del node
    gc.collect()
    assert ref() is None


def test_a_full_pool_waits_without_using_the_processor(ros: Any) -> None:
    node = ros.create_node("saturated")
    executor = MultiThreadedExecutor(2)
    for _ in range(4):
        node.create_timer(0.001, lambda: time.sleep(0.2), callback_group=ReentrantCallbackGroup())
    executor.add_node(node)
    end = time.monotonic() + 1.0
    used = time.process_time()
    while time.monotonic() < end:
        executor.spin_once(0.05)
    used = time.process_time() - used
    executor.shutdown()
    node.destroy_node()
    assert used < 0.3


def test_no_message_is_stuck_behind_a_busy_group(ros: Any) -> None:
    node = ros.create_node("busy_group")
    counts = [0] * 4
    executor = MultiThreadedExecutor(3)

    def counter(i: int) -> Any:
        def count(_: Int32) -> None:
            counts[i] += 1

        return count

    for i in range(4):
        node.create_subscription(Int32, f"busy_{i}", counter(i), 300)
    publishers = [node.create_publisher(Int32, f"busy_{i}", 300) for i in range(4)]
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    for _ in range(200):
        for publisher in publishers:
            publisher.publish(Int32())
    end = time.monotonic() + 20
    while sum(counts) < 800 and time.monotonic() < end:
        time.sleep(0.01)
    executor.shutdown()
    thread.join(5.0)
    node.destroy_node()
    assert counts == [200] * 4


def test_an_interrupt_while_work_is_handed_out_does_not_hold_the_end_up(
    node: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    executor = MultiThreadedExecutor()
    executor.add_node(node)

    def interrupted(*_: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(executor._executor, "submit", interrupted)
    task = executor.create_task(lambda: None)
    with pytest.raises(KeyboardInterrupt):
        executor.spin_once(1.0)
    assert not task.done()
    assert executor.shutdown(timeout_sec=5.0)
