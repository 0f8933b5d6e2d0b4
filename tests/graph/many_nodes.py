"""Processes of test_many_processes.py: ``python many_nodes.py nodes`` and ``python many_nodes.py client``.

Both read a JSON value a line and answer each with one, on a line that begins with ``@``. They end with their input.
"""

import json
import os
import signal
import sys
from typing import Any

from mansion_msgs_py.workers import end_with_parent


def answer(value: Any) -> None:
    """Answer the line that was read."""
    sys.stdout.write(f"@{json.dumps(value)}\n")
    sys.stdout.flush()


def start_nodes() -> None:
    """Start a node's process for each number that is read, and answer its process id."""
    # Imported once for all, which is most of what a small node's start costs.
    import rclpy
    import std_srvs.srv

    assert rclpy and std_srvs
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    pids = []
    for line in sys.stdin:
        starter = os.getpid()
        pid = os.fork()
        if pid == 0:
            end_with_parent(starter)
            serve(json.loads(line))
            os._exit(0)
        pids.append(pid)
        answer(pid)
    for pid in pids:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            continue


def serve(number: int) -> None:
    """Be the node of that number; its service answers how many of these nodes it sees."""
    import rclpy
    from rclpy.executors import ExternalShutdownException
    from std_srvs.srv import Trigger

    rclpy.init(args=[])
    node = rclpy.create_node(
        f"node_{number}", namespace="/mansion", start_parameter_services=False, enable_rosout=False
    )

    def count(request: Any, response: Any) -> Any:
        seen = {name for name in node.get_node_names() if name.startswith("node_")}
        response.success, response.message = True, json.dumps(len(seen))
        return response

    node.create_service(Trigger, f"ping_{number}", count)
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        return


def serve_client() -> None:
    """Answer ``["call", NAME]`` with the reply or the error's code, and ``["served", NAME]``."""
    from mansion_bringup.client import MansionClient
    from mansion_msgs_py.errors import MansionError

    with MansionClient(timeout=10.0) as client:
        for line in sys.stdin:
            question, name = json.loads(line)
            if question == "served":
                answer(client.is_served(name))
                continue
            try:
                answer(client.call(name, wait=2.0))
            except MansionError as error:
                answer(str(error.code))


if __name__ == "__main__":
    {"nodes": start_nodes, "client": serve_client}[sys.argv[1]]()
