"""Processes with a node each in one domain: how long until each has found all others.

    python benchmarks/ros/many_processes.py [--processes 40]

Every process is started first and waits; the clock runs from the common start to the moment at which
the last of them lists all nodes (the aim is less than 5 s for 40). Then the processor time of the idle
processes is measured for some seconds (the aim is less than 1% of a core for each).
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time

from _processes import environment

NODE = """
import sys, time
import rclpy
from rclpy.node import Node
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import String
from std_srvs.srv import Trigger
number, count = int(sys.argv[1]), int(sys.argv[2])
print("loaded")
sys.stdin.readline()
rclpy.init(args=[])
node = rclpy.create_node(f"node_{number}")
node.create_publisher(String, "chatter", 10)
node.create_subscription(String, "chatter", lambda message: None, 10)
node.create_service(Trigger, f"ping_{number}", lambda request, response: response)
executor = SingleThreadedExecutor()
executor.add_node(node)
while len(set(node.get_node_names())) < count:
    executor.spin_once(0.2)
    time.sleep(0.1)
print("found")
executor.spin()
"""


def _processor_seconds(pid: int) -> float:
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--processes", type=int, default=40)
    parser.add_argument("--idle", type=float, default=10.0, help="seconds to watch idle nodes")
    options = parser.parse_args()
    environment(63)
    count = options.processes
    started = [
        subprocess.Popen(
            [sys.executable, "-u", "-c", NODE, str(i), str(count)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for i in range(count)
    ]
    try:
        for process in started:
            assert process.stdout is not None
            assert process.stdout.readline() == "loaded\n"
        begin = time.monotonic()
        for process in started:
            assert process.stdin is not None
            process.stdin.write("go\n")
            process.stdin.flush()
        for process in started:
            assert process.stdout is not None
            assert process.stdout.readline() == "found\n"
        seconds = time.monotonic() - begin
        used = sum(_processor_seconds(p.pid) for p in started)
        print(f"{count} processes found each other in {seconds:.2f} s ({used:.1f} s of processor)")
        time.sleep(2.0)
        before = [_processor_seconds(p.pid) for p in started]
        time.sleep(options.idle)
        each = [
            100 * (_processor_seconds(p.pid) - b) / options.idle
            for p, b in zip(started, before, strict=True)
        ]
        print(f"idle: mean {sum(each) / count:.2f}% of a core each, most {max(each):.2f}%")
    finally:
        for process in started:
            process.kill()
        for process in started:
            process.wait()


if __name__ == "__main__":
    main()
