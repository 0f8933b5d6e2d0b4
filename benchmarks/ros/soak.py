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


class Soak:
    """A server and a caller in one process, and what threads do with them.

    Attributes
    ----------
    counts : Counter
        What was done: calls by kind, messages published and received, timers, guests, and what was lost.
    """

    def __init__(self) -> None:
        import rclpy
        from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
        from std_msgs.msg import String
        from std_srvs.srv import Trigger

        rclpy.init(args=[])
        self.rclpy, self.text, self.trigger = rclpy, String, Trigger
        self.counts: Counter[str] = Counter()
        self.server = rclpy.create_node("server")
        self.caller = rclpy.create_node("caller")
        self.server.create_service(Trigger, "ping", self._answer)
        self.server.create_subscription(
            String, "chatter", lambda _: self.counts.update(received=1), 10
        )
        self.many, self.single = MultiThreadedExecutor(3), SingleThreadedExecutor()
        self.many.add_node(self.server)
        self.single.add_node(self.caller)
        self.spinning = threading.Thread(target=self.many.spin)
        self.spinning.start()
        self.client = self.caller.create_client(Trigger, "ping")
        self.other = self.caller.create_client(Trigger, "ping")
        self.publisher = self.caller.create_publisher(String, "chatter", 10)
        self.client.wait_for_service(5.0)

    @staticmethod
    def _answer(request, response):  # type: ignore[no-untyped-def]
        response.success = True
        return response

    def call_with_futures(self) -> None:
        """Call, and spin until the reply is there."""
        future = self.client.call_async(self.trigger.Request())
        self.single.spin_until_future_complete(future, 5.0)
        self.counts.update(["future" if future.done() else "lost"])

    def call_and_wait(self) -> None:
        """Call synchronously."""
        reply = self.other.call(self.trigger.Request(), 5.0)
        self.counts.update(["call" if reply is not None else "lost"])

    def publish(self) -> None:
        """Publish 1 kB."""
        self.publisher.publish(self.text(data="x" * 1000))
        self.counts.update(published=1)
        time.sleep(0.001)

    def come_and_go(self) -> None:
        """Make a node with a subscription, a timer and a client; call once; end it."""
        node = self.rclpy.create_node(f"guest_{self.counts['guest'] % 7}")
        self.many.add_node(node)
        node.create_subscription(self.text, "chatter", lambda _: None, 10)
        node.create_timer(0.001, lambda: self.counts.update(timer=1))
        guest = node.create_client(self.trigger, "ping")
        if not guest.wait_for_service(5.0) or guest.call(self.trigger.Request(), 5.0) is None:
            self.counts.update(lost=1)
        node.get_node_names()
        node.destroy_node()
        self.counts.update(guest=1)

    def end(self) -> None:
        """Stop the executors and end the nodes."""
        self.many.shutdown(5.0)
        self.single.shutdown(5.0)
        self.spinning.join(5.0)
        self.server.destroy_node()
        self.caller.destroy_node()
        self.rclpy.try_shutdown()


def run(soak: Soak, seconds: float) -> tuple[float, float, list[str]]:
    """Keep all jobs busy; return resident MB after a quarter of the time and at the end, and who hung."""
    stop = threading.Event()

    def repeat(work: Callable[[], None]) -> None:
        while not stop.is_set():
            work()

    jobs = (soak.call_with_futures, soak.call_and_wait, soak.publish, soak.come_and_go)
    threads = [threading.Thread(target=repeat, args=(job,)) for job in jobs]
    for thread in threads:
        thread.start()
    time.sleep(seconds / 4)
    gc.collect()
    begin = resident_mb()
    time.sleep(seconds * 3 / 4)
    stop.set()
    for thread in threads:
        thread.join(20.0)
    hung = [thread.name for thread in threads if thread.is_alive()]
    gc.collect()
    return begin, resident_mb(), hung


def main() -> int:
    """Run the soak, print its figures, and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    options = parser.parse_args()
    environment(65)
    soak = Soak()
    begin, end, hung = run(soak, options.seconds)
    soak.end()
    counts, spins = soak.counts, soak.spinning.is_alive()
    rates = ", ".join(f"{k} {v / options.seconds:.0f}/s" for k, v in sorted(counts.items()))
    print(f"{rates}; lost {counts['lost']}; hung {hung}; spinning ended {not spins}")
    print(f"resident memory {begin:.1f} -> {end:.1f} MB")
    calls = counts["call"] + counts["future"] + counts["guest"]
    return int(bool(counts["lost"] * 5000 > calls or hung or spins or end > begin + 20))


if __name__ == "__main__":
    sys.exit(main())
