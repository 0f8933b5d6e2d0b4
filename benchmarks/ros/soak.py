"""Hours of use in minutes: what grows, hangs or gets lost in a process that makes and ends everything.

    python benchmarks/ros/soak.py [--seconds 60]

Four threads share two executors: calls with futures, synchronous calls, publishing, and nodes, clients
and subscriptions that come and go. Prints rates, and resident memory at the start and the end; exits
with status 1 if more than one call in 5000 went unanswered, a thread hung, or memory grew by 20 MB.
(All replies of a service share one topic, and Jazzy's clients keep the last 10 of them: one that is
not scheduled while others get more than that loses its own.)
"""

from __future__ import annotations

import argparse
import gc
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable

from _processes import environment


def resident_mb() -> float:
    """Resident memory of this process."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096 / 1e6


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    options = parser.parse_args()
    environment(65)
    import rclpy
    from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
    from std_msgs.msg import String
    from std_srvs.srv import Trigger

    rclpy.init(args=[])
    server, caller = rclpy.create_node("server"), rclpy.create_node("caller")
    counts: Counter[str] = Counter()

    def answer(request, response):  # type: ignore[no-untyped-def]
        response.success = True
        return response

    server.create_service(Trigger, "ping", answer)
    server.create_subscription(String, "chatter", lambda m: counts.update(received=1), 10)
    many = MultiThreadedExecutor(3)
    many.add_node(server)
    spinning = threading.Thread(target=many.spin)
    spinning.start()
    client = caller.create_client(Trigger, "ping")
    publisher = caller.create_publisher(String, "chatter", 10)
    client.wait_for_service(5.0)
    single = SingleThreadedExecutor()
    single.add_node(caller)
    stop = threading.Event()

    def call_with_futures() -> None:
        future = client.call_async(Trigger.Request())
        single.spin_until_future_complete(future, 5.0)
        counts.update(["future" if future.done() else "lost"])

    other = caller.create_client(Trigger, "ping")

    def call_and_wait() -> None:
        counts.update(["call" if other.call(Trigger.Request(), 5.0) is not None else "lost"])

    def publish() -> None:
        publisher.publish(String(data="x" * 1000))
        counts.update(published=1)
        time.sleep(0.001)

    def come_and_go() -> None:
        node = rclpy.create_node(f"guest_{counts['guest'] % 7}")
        many.add_node(node)
        node.create_subscription(String, "chatter", lambda m: None, 10)
        node.create_timer(0.001, lambda: counts.update(timer=1))
        guest = node.create_client(Trigger, "ping")
        if not guest.wait_for_service(5.0) or guest.call(Trigger.Request(), 5.0) is None:
            counts.update(lost=1)
        node.get_node_names()
        node.destroy_node()
        counts.update(guest=1)

    def repeat(work: Callable[[], None]) -> None:
        while not stop.is_set():
            work()

    jobs = (call_with_futures, call_and_wait, publish, come_and_go)
    threads = [threading.Thread(target=repeat, args=(job,)) for job in jobs]
    for thread in threads:
        thread.start()
    time.sleep(options.seconds / 4)
    gc.collect()
    begin = resident_mb()
    time.sleep(options.seconds * 3 / 4)
    stop.set()
    for thread in threads:
        thread.join(20.0)
    hung = [t.name for t in threads if t.is_alive()]
    gc.collect()
    end = resident_mb()
    many.shutdown(5.0)
    single.shutdown(5.0)
    spinning.join(5.0)
    server.destroy_node()
    caller.destroy_node()
    rclpy.try_shutdown()
    rates = ", ".join(f"{k} {v / options.seconds:.0f}/s" for k, v in sorted(counts.items()))
    print(f"{rates}; lost {counts['lost']}; hung {hung}; spinning ended {not spinning.is_alive()}")
    print(f"resident memory {begin:.1f} -> {end:.1f} MB")
    calls = counts["call"] + counts["future"] + counts["guest"]
    failed = counts["lost"] * 5000 > calls or hung or spinning.is_alive() or end > begin + 20
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(main())
