"""A publisher's process while a subscriber stands still (SIGSTOP) or is slow.

    python benchmarks/ros/slow_subscriber.py

A keep-last publisher writes 1 MB messages at 50 Hz for some seconds. Prints the longest ``publish`` and
the longest pause of another thread of the same process (the aim is that neither comes near a second).
"""

from __future__ import annotations

import argparse
import signal
import threading
import time

from _processes import environment, running

SUBSCRIBER = """
import sys, time
import rclpy
from std_msgs.msg import String
rclpy.init(args=[])
node = rclpy.create_node("slow")
node.create_subscription(String, "big", lambda message: time.sleep(float(sys.argv[1])), 10)
print("ready")
rclpy.spin(node)
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=5.0)
    options = parser.parse_args()
    environment(64)
    import rclpy
    from std_msgs.msg import String

    rclpy.init(args=[])
    node = rclpy.create_node("publisher")
    publisher = node.create_publisher(String, "big", 10)
    message = String(data="x" * 1_000_000)
    longest_pause = 0.0
    stop = threading.Event()

    def watch() -> None:
        nonlocal longest_pause
        last = time.monotonic()
        while not stop.wait(0.005):
            now = time.monotonic()
            longest_pause = max(longest_pause, now - last)
            last = now

    threading.Thread(target=watch, daemon=True).start()
    for label, stopped in (("slow callback (1 s)", False), ("stopped process", True)):
        with running("-c", SUBSCRIBER, "1.0") as subscriber:
            while publisher.get_subscription_count() == 0:
                time.sleep(0.02)
            if stopped:
                subscriber.send_signal(signal.SIGSTOP)
            longest_pause = longest = 0.0
            count = 0
            end = time.monotonic() + options.seconds
            while time.monotonic() < end:
                start = time.monotonic()
                publisher.publish(message)
                longest = max(longest, time.monotonic() - start)
                count += 1
                time.sleep(0.02)
            print(
                f"{label}: {count} messages, longest publish {longest * 1e3:.0f} ms, "
                f"longest pause of another thread {longest_pause * 1e3:.0f} ms"
            )
            if stopped:
                subscriber.send_signal(signal.SIGCONT)
        while publisher.get_subscription_count() > 0 and not stopped:
            time.sleep(0.1)
    stop.set()
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    main()
