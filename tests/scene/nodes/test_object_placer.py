"""The object_placer node, called over loopback."""

import os
from collections.abc import Iterator
from types import ModuleType

import pytest

from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.scene import FloorScene

rclpy = pytest.importorskip("rclpy")
os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")


@pytest.fixture
def executor() -> Iterator[object]:
    from rclpy.executors import MultiThreadedExecutor

    rclpy.init(args=[], domain_id=150 + os.getpid() % 50)
    spinner = MultiThreadedExecutor(num_threads=2)
    yield spinner
    spinner.shutdown()
    rclpy.try_shutdown()


@pytest.mark.graph
def test_a_floor_is_furnished_by_service_and_published(sample_floors: ModuleType, executor: object) -> None:
    from diagnostic_msgs.srv import AddDiagnostics
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    from mansion_scene.nodes.object_placer import ObjectPlacer

    placer, caller = ObjectPlacer(), rclpy.create_node("caller")
    for node in (placer, caller):
        executor.add_node(node)
    published: list[str] = []
    latched = QoSProfile(depth=4, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    caller.create_subscription(String, "floor_scene", lambda message: published.append(message.data), latched)
    client = caller.create_client(AddDiagnostics, "furnish_floor")
    assert client.wait_for_service(timeout_sec=10.0)

    def call(text: str) -> AddDiagnostics.Response:
        future = client.call_async(AddDiagnostics.Request(load_namespace=text))
        executor.spin_until_future_complete(future, timeout_sec=60.0)
        return future.result()

    reply = call(encode(sample_floors.flat()))
    assert reply.success
    scene = decode(FloorScene, reply.message)
    assert scene.rooms and scene.objects
    for _ in range(50):
        if published:
            break
        executor.spin_once(timeout_sec=0.1)
    assert published == [reply.message]

    refused = call('{"floor": 3}')
    assert not refused.success and "INVALID_PAYLOAD" in refused.message
    assert call(encode(sample_floors.flat())).success
    for node in (placer, caller):
        node.destroy_node()
