"""Whole programs: signals, ends, slow peers and the guard beside a real ROS 2."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

SPIN = """
import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
rclpy.init(args=[])
node = rclpy.create_node("spinning")
executor = MultiThreadedExecutor() if {multi} else None
print("ready")
try:
    rclpy.spin(node, executor)
except (KeyboardInterrupt, ExternalShutdownException) as end:
    print(type(end).__name__)
finally:
    node.destroy_node()
    rclpy.try_shutdown()
"""


@pytest.mark.parametrize("multi", [False, True])
@pytest.mark.parametrize(
    ("number", "end"),
    [(signal.SIGINT, "KeyboardInterrupt"), (signal.SIGTERM, "ExternalShutdownException")],
)
def test_signals_end_spinning_without_noise(
    program: Callable[..., Any], multi: bool, number: int, end: str
) -> None:
    spinning = program(SPIN.format(multi=multi))
    assert spinning.line() == "ready"
    time.sleep(0.2)
    spinning.signal(number)
    out, errors = spinning.finish(15.0)
    assert (out.strip(), errors, spinning.process.returncode) == (end, "", 0)


def test_a_program_that_cleans_nothing_up_ends_silently(program: Callable[..., Any]) -> None:
    careless = program(
        """
        import rclpy
        from std_msgs.msg import String
        rclpy.init(args=[])
        node = rclpy.create_node("careless")
        node.create_publisher(String, "x", 10)
        node.create_timer(0.01, lambda: None)
        for _ in range(5):
            rclpy.spin_once(node)
        print("done")
        """
    )
    assert careless.line() == "done"
    _, errors = careless.finish(15.0)
    assert (errors, careless.process.returncode) == ("", 0)


def test_a_subscriber_that_stands_still_does_not_hold_the_publisher(
    ros: Any, program: Callable[..., Any]
) -> None:
    from std_msgs.msg import String

    subscriber = program(
        """
        import rclpy
        from std_msgs.msg import String
        rclpy.init(args=[])
        node = rclpy.create_node("still")
        node.create_subscription(String, "big", lambda message: None, 5)
        print("ready")
        rclpy.spin(node)
        """
    )
    assert subscriber.line() == "ready"
    node = ros.create_node("publisher")
    publisher = node.create_publisher(String, "big", 5)
    end = time.monotonic() + 10
    while not publisher.get_subscription_count():
        assert time.monotonic() < end
        time.sleep(0.02)
    subscriber.signal(signal.SIGSTOP)
    message = String(data="x" * 500_000)
    start = time.monotonic()
    for _ in range(40):
        publisher.publish(message)
    assert time.monotonic() - start < 5.0
    subscriber.signal(signal.SIGCONT)
    subscriber.signal(signal.SIGKILL)
    node.destroy_node()


def test_a_bare_cyclone_server_is_called_and_its_header_is_that_of_jazzy(
    ros: Any, program: Callable[..., Any]
) -> None:
    from std_srvs.srv import Trigger

    server = program(
        """
        import time
        from dataclasses import dataclass
        from cyclonedds.core import Policy, Qos
        from cyclonedds.domain import Domain, DomainParticipant
        from cyclonedds.idl import make_idl_struct
        from cyclonedds.idl.types import int64, uint64, uint8
        from cyclonedds.pub import DataWriter
        from cyclonedds.sub import DataReader
        from cyclonedds.topic import Topic
        from cyclonedds.util import duration
        from rclpy._dds.domain import configuration, domain_id_from_environment
        header = {"guid": uint64, "seq": int64}
        name = "std_srvs.srv.dds_.Trigger_"
        Request = make_idl_struct("Request", name + "Request_", {**header, "unused": uint8})
        Reply = make_idl_struct(
            "Reply", name + "Response_", {**header, "success": bool, "message": str})
        number = domain_id_from_environment()
        domain = Domain(number, configuration())
        participant = DomainParticipant(number)
        octets = "1.2.3.4.5.6.7.8.9.a.b.c.0.0.0.1"
        qos = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(10),
                  Policy.Durability.Volatile, Policy.DataRepresentation(True, False),
                  Policy.Userdata(f"serviceid= {octets};".encode()))
        reader = DataReader(participant, Topic(participant, "rq/bareRequest", Request), qos=qos)
        writer = DataWriter(participant, Topic(participant, "rr/bareReply", Reply), qos=qos)
        print("ready")
        while True:
            for sample in reader.take(N=10):
                if hasattr(sample, "seq"):
                    handles = reader.get_matched_publications()
                    known = sample.guid == sample.sample_info.publication_handle
                    writer.write(Reply(sample.guid + 1, sample.seq, False, "for somebody else"))
                    writer.write(Reply(sample.guid, sample.seq, True, str(sample.seq)))
            time.sleep(0.005)
        """
    )
    assert server.line() == "ready"
    node = ros.create_node("asker")
    client = node.create_client(Trigger, "bare")
    assert client.wait_for_service(10.0)
    replies = [client.call(Trigger.Request(), 5.0) for _ in range(3)]
    assert [(r.success, r.message) for r in replies] == [(True, "1"), (True, "2"), (True, "3")]
    node.destroy_node()


def test_a_real_rclpy_elsewhere_on_the_path_is_respected(
    program: Callable[..., Any], tmp_path: Path
) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("")
    source = f"""
        import sys
        sys.path.append({str(tmp_path)!r})
        try:
            import rclpy
        except ImportError as problem:
            print(problem)
        """
    assert "a real rclpy is at" in program(source).line()
    sourced = {"AMENT_PREFIX_PATH": "/opt/ros/jazzy", "ROS_DISTRO": "jazzy"}
    source = "try:\n    import rclpy\nexcept ImportError as problem:\n    print(problem)"
    assert "ROS 2 jazzy is sourced" in program(source, env=sourced).line()


@pytest.mark.parametrize(
    ("variables", "inside"),
    [
        ({}, []),
        (
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"},
            ['address="localhost"', "AllowMulticast>false"],
        ),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}, ["<Tag>", "ParticipantIndex>none"]),
        ({"ROS_STATIC_PEERS": "10.0.0.1;host"}, ['address="10.0.0.1"', 'address="host"']),
        ({"CYCLONEDDS_URI": "file:///x.xml"}, [",file:///x.xml"]),
    ],
)
def test_the_environment_chooses_the_discovery_range(
    variables: dict[str, str], inside: list[str]
) -> None:
    from rclpy._dds.domain import configuration

    text = configuration(variables)
    assert all(part in text for part in inside)
    assert ("AllowMulticast" in text) == ("ROS_AUTOMATIC_DISCOVERY_RANGE" in variables)


def test_localhost_only_is_honoured_with_a_warning() -> None:
    from rclpy._dds.domain import configuration

    with pytest.warns(UserWarning, match="deprecated"):
        assert 'address="localhost"' in configuration({"ROS_LOCALHOST_ONLY": "1"})


def test_nodes_of_one_process_and_domain_have_one_discovery_range(
    ros: Any, node: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    context = ros.context.Context()
    ros.init(args=[], context=context)
    try:
        with pytest.raises(Exception, match="different discovery parameters") as caught:
            ros.create_node("elsewhere", context=context)
        assert type(caught.value).__name__ == "RCLError"
    finally:
        ros.shutdown(context=context)
