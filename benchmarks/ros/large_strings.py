"""Strings of 1, 5 and 20 MB echoed through a service between two processes.

    python benchmarks/ros/large_strings.py [--repeat 10]

Prints minimum, median and maximum in milliseconds (the aim is a median below 100 for 5 MB).
"""

from __future__ import annotations

import argparse
import statistics
import time
from pathlib import Path

from _processes import environment, running

SERVER = str(Path(__file__).with_name("service_round_trip.py"))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=10)
    options = parser.parse_args()
    from service_round_trip import DOMAIN

    environment(DOMAIN)
    import rclpy
    from diagnostic_msgs.srv import AddDiagnostics

    with running(SERVER, "--serve", "rclpy"):
        rclpy.init(args=[])
        node = rclpy.create_node("client")
        client = node.create_client(AddDiagnostics, "echo")
        assert client.wait_for_service(10.0)
        for megabytes in (1, 5, 20):
            text = "x" * (megabytes * 1_000_000)
            times = []
            for _ in range(options.repeat):
                start = time.perf_counter()
                reply = client.call(AddDiagnostics.Request(load_namespace=text), 30.0)
                times.append((time.perf_counter() - start) * 1e3)
                assert reply is not None
                assert len(reply.message) == len(text)
            print(
                f"{megabytes:3d} MB  min {min(times):7.1f}  median {statistics.median(times):7.1f}  "
                f"max {max(times):7.1f} ms"
            )
        node.destroy_node()
        rclpy.shutdown()


if __name__ == "__main__":
    main()
