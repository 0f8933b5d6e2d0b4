"""Round trips of a service between two processes, against a bare cyclonedds server with a wait set.

    python benchmarks/ros/service_round_trip.py [--calls 2000]

Prints medians in microseconds, their ratio (the aim is at most 4), and the ratio of the last quarter
of the calls to the first (the aim is 1: no growth).
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time

from _processes import environment, running

DOMAIN = 61


def bare_pair(server: bool):  # type: ignore[no-untyped-def]
    """Writer, reader and wait set of one side, with plain IDL types."""
    from cyclonedds.core import (
        InstanceState,
        Policy,
        Qos,
        ReadCondition,
        SampleState,
        ViewState,
        WaitSet,
    )
    from cyclonedds.domain import Domain, DomainParticipant
    from cyclonedds.idl import make_idl_struct
    from cyclonedds.idl.types import int64, uint64
    from cyclonedds.pub import DataWriter
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic
    from cyclonedds.util import duration
    from rclpy._dds.domain import configuration

    header = {"guid": uint64, "seq": int64}
    request_type = make_idl_struct("BareRequest", "BareRequest", {**header, "text": str})
    reply_type = make_idl_struct("BareReply", "BareReply", {**header, "success": bool, "text": str})

    domain = Domain(DOMAIN + 1, configuration())
    participant = DomainParticipant(DOMAIN + 1)
    qos = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(10))
    request = Topic(participant, "request", request_type)
    reply = Topic(participant, "reply", reply_type)
    mine, theirs = (reply, request) if server else (request, reply)
    writer = DataWriter(participant, mine, qos=qos)
    reader = DataReader(participant, theirs, qos=qos)
    waitset = WaitSet(participant)
    any_state = ViewState.Any | InstanceState.Any | SampleState.Any
    waitset.attach(ReadCondition(reader, any_state))
    return (domain, participant), writer, reader, waitset, request_type, reply_type, duration


def serve_bare() -> None:
    """Answer requests until killed."""
    keep, writer, reader, waitset, _, reply, duration = bare_pair(server=True)
    print("ready", len(keep))
    while True:
        waitset.wait(duration(seconds=1))
        for sample in reader.take(N=10):
            if hasattr(sample, "text"):
                writer.write(reply(sample.guid, sample.seq, True, sample.text))


def call_bare(calls: int) -> list[float]:
    """Seconds of each round trip."""
    keep, writer, reader, waitset, request, _, duration = bare_pair(server=False)
    while not (writer.get_matched_subscriptions() and reader.get_matched_publications()):
        time.sleep(0.01)
    time.sleep(0.2)
    times: list[float] = []
    while len(times) < calls and keep:
        i = len(times)
        start = time.perf_counter()
        writer.write(request(1, i, "x"))
        done = False
        while not done:
            waitset.wait(duration(seconds=1))
            done = any(getattr(s, "seq", None) == i for s in reader.take(N=10))
        times.append(time.perf_counter() - start)
    return times


def serve_rclpy() -> None:
    """Answer requests until killed."""
    import rclpy
    from diagnostic_msgs.srv import AddDiagnostics

    rclpy.init(args=[])
    node = rclpy.create_node("server")

    def answer(request, response):  # type: ignore[no-untyped-def]
        response.success, response.message = True, request.load_namespace
        return response

    node.create_service(AddDiagnostics, "echo", answer)
    print("ready")
    rclpy.spin(node)


def call_rclpy(calls: int, synchronous: bool) -> list[float]:
    """Seconds of each round trip."""
    import rclpy
    from diagnostic_msgs.srv import AddDiagnostics

    rclpy.init(args=[])
    node = rclpy.create_node("client")
    client = node.create_client(AddDiagnostics, "echo")
    assert client.wait_for_service(10.0)
    times = []
    for _ in range(calls):
        request = AddDiagnostics.Request(load_namespace="x")
        start = time.perf_counter()
        if synchronous:
            client.call(request, 5.0)
        else:
            rclpy.spin_until_future_complete(node, client.call_async(request), timeout_sec=5.0)
        times.append(time.perf_counter() - start)
    node.destroy_node()
    rclpy.shutdown()
    return times


def _median_us(times: list[float]) -> float:
    return statistics.median(times) * 1e6


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--calls", type=int, default=2000)
    parser.add_argument("--serve", choices=["bare", "rclpy"], help=argparse.SUPPRESS)
    options = parser.parse_args()
    environment(DOMAIN)
    if options.serve:
        return serve_bare() if options.serve == "bare" else serve_rclpy()
    with running(__file__, "--serve", "bare"):
        bare = _median_us(call_bare(options.calls))
    with running(__file__, "--serve", "rclpy"):
        spinning = call_rclpy(options.calls, synchronous=False)
        waiting = call_rclpy(options.calls, synchronous=True)
    print(f"bare cyclonedds with a wait set  {bare:8.0f} us")
    for label, times in (("spin_until_future_complete", spinning), ("Client.call", waiting)):
        quarter = max(len(times) // 4, 1)
        growth = statistics.median(times[-quarter:]) / statistics.median(times[:quarter])
        own = _median_us(times)
        print(
            f"{label:32} {own:8.0f} us  {own / bare:5.2f} x bare  last/first quarter {growth:.2f}"
        )
    return None


if __name__ == "__main__":
    sys.exit(main())
