"""What a subscriber that is slow or stands still does to a publisher, and how soon it hears again.

    python benchmarks/ros/slow_subscriber.py [--seconds 12] [--megabytes 1] [--setting all]

A reliable publisher that keeps its last 10 messages writes at 20 Hz. The subscriber takes a second for each message, or
is stopped by SIGSTOP, which lasts longer than the 10 s after which Mansion's profile counts a process as gone. rclpy
holds Python's lock while it publishes, so that a slow ``publish`` stops every thread of the process. Prints the longest
``publish`` (the aim is 100 ms), the longest pause of another thread, and the seconds from SIGCONT
until a new message came.
"""

import argparse
import signal
import threading
import time
from typing import Any, Final

from _processes import LOOPBACK, RANGE, Worker, all_ended, begin_worker, environment, load, say, spin

from mansion_bringup.graph.domains import free_domain

PERIOD: Final = 0.05
"""Seconds between two messages."""

PATIENCE: Final = 30.0
"""Seconds for a worker's answer beyond the time that it was given to work."""

KINDS: Final = {"quick": 0.0, "slow callback": 1.0, "stopped": 0.0}
"""Subscribers, and the seconds that each takes for a message."""


def subscribe(delay: float) -> None:
    """Say when each message was sent, and when it was here, after `delay` seconds of work."""
    import rclpy
    from std_msgs.msg import String

    def receive(message: Any) -> None:
        received = time.monotonic()
        time.sleep(delay)
        say([float(message.data.partition(" ")[0]), received])

    rclpy.init(args=[])
    node = rclpy.create_node("subscriber")
    node.create_subscription(String, "big", receive, 10)
    spin(node)


def publish(seconds: float, length: int) -> None:
    """Publish for some seconds once somebody listens; say "matched", then how long what took."""
    import rclpy
    from std_msgs.msg import String

    rclpy.init(args=[])
    node = rclpy.create_node("publisher")
    publisher = node.create_publisher(String, "big", 10)
    filler = "x" * length
    while publisher.get_subscription_count() == 0:
        time.sleep(PERIOD)
    pauses = [0.0]
    ended = threading.Event()

    def watch() -> None:
        last = time.monotonic()
        while not ended.wait(0.005):
            now = time.monotonic()
            pauses.append(now - last)
            last = now

    threading.Thread(target=watch, daemon=True).start()
    say("matched")
    end = time.monotonic() + seconds
    took = []
    while time.monotonic() < end:
        message = String(data=f"{time.monotonic()} {filler}")
        begin = time.monotonic()
        publisher.publish(message)
        took.append(time.monotonic() - begin)
        time.sleep(PERIOD)
    ended.set()
    say({"count": len(took), "publish": max(took), "pause": max(pauses)})
    node.destroy_node()
    rclpy.try_shutdown()


def row(setting: str, kind: str, options: argparse.Namespace) -> str:
    """Run one pair and return its row of the table."""
    variables = environment(setting, free_domain(options.domain))
    standing = kind == "stopped"
    # After the subscriber goes on, the publisher does so for half of the time.
    seconds = options.seconds * 1.5 if standing else options.seconds
    arguments = ["--seconds", str(seconds), "--megabytes", str(options.megabytes)]
    publisher = Worker([__file__, "--publish", *arguments], variables)
    workers = [publisher]
    again = ""
    with all_ended(workers):
        subscriber = Worker([__file__, "--subscribe", str(KINDS[kind])], variables)
        workers.append(subscriber)
        publisher.hear(PATIENCE)
        subscriber.hear(PATIENCE)
        if standing:
            subscriber.process.send_signal(signal.SIGSTOP)
            time.sleep(options.seconds)
            resumed = time.monotonic()
            subscriber.process.send_signal(signal.SIGCONT)
            again = f"{after(subscriber, resumed, options.seconds / 2):10.2f}"
        figures = publisher.hear(seconds + PATIENCE)
    return (
        f"{setting:18}{kind:15}{figures['count']:9d}{figures['publish'] * 1e3:12.0f}"
        f"{figures['pause'] * 1e3:10.0f}{again}"
    )


def after(subscriber: Worker, resumed: float, patience: float) -> float:
    """Return the seconds from `resumed` to the first message that was sent later; infinity when none comes."""
    end = resumed + patience
    try:
        sent, received = subscriber.hear(patience)
        while sent < resumed:
            sent, received = subscriber.hear(end - time.monotonic())
    except TimeoutError:
        return float("inf")
    return float(received - resumed)


def main() -> None:
    """Print the table, or be one of its processes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=12.0, help="to publish, to stand still (12)")
    parser.add_argument("--megabytes", type=float, default=1.0, help="size of a message (1)")
    parser.add_argument("--setting", choices=["loopback", "localhost", "all"], default="loopback")
    parser.add_argument("--domain", type=int, help="where to look for free ROS domains")
    parser.add_argument("--subscribe", type=float, help=argparse.SUPPRESS)
    parser.add_argument("--publish", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.subscribe is not None:
        begin_worker()
        subscribe(options.subscribe)
        return
    if options.publish:
        begin_worker()
        publish(options.seconds, int(options.megabytes * 1e6))
        return
    chosen = {"loopback": [LOOPBACK], "localhost": [RANGE], "all": [LOOPBACK, RANGE]}
    print("setting           subscriber      messages  publish ms  pause ms   again s")
    for setting in chosen[options.setting]:
        for kind in KINDS:
            print(row(setting, kind, options), flush=True)
    print(load())


if __name__ == "__main__":
    main()
