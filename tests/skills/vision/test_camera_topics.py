"""The camera's topics as a robot stack sees them, across processes."""

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_msgs_py.codec import decode
from mansion_msgs_py.interfaces import topic
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_msgs_py.skills import CameraNames
from mansion_skills import Robot
from mansion_skills.vision import Camera

pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
NODE = NodeProcess("mansion_skills", "skill_server", "load_building")
KINDS = {"rgb8": (np.uint8, 3), "32FC1": (np.float32, 1), "32SC1": (np.int32, 1)}


def pixels(message: Any) -> np.ndarray:
    kind, channels = KINDS[message.encoding]
    assert message.step == message.width * channels * np.dtype(kind).itemsize
    flat = np.frombuffer(message.data.tobytes(), kind)
    shape = (message.height, message.width) + ((channels,) if channels > 1 else ())
    return flat.reshape(shape)


def test_images_are_what_the_camera_sees(pictured: Path, renders: None) -> None:
    from sensor_msgs.msg import CameraInfo, Image
    from std_msgs.msg import String

    with Camera(Robot(pictured), 300, 300) as camera:
        expected = camera.render()
    domain = free_domain()
    options = GraphOptions(domain_id=domain, quiet=True)
    with GraphProcesses(options, [NODE]), MansionClient(domain_id=domain) as client:
        client.call("load_building", {"path": str(pictured)})
        got: dict[str, Any] = {}

        def listen(kind: type, name: str) -> None:
            qos = qos_profile(topic(name).qos)
            client.node.create_subscription(kind, name, lambda message: got.__setitem__(name, message), qos)

        names = ("camera/image", "camera/depth", "camera/segmentation")
        for name in names:
            listen(Image, name)
        listen(CameraInfo, "camera/camera_info")
        listen(String, "camera/names")
        until(lambda: len(got) == 5)
        for name, wanted in zip(names, (expected.rgb, expected.depth, expected.segmentation)):
            assert got[name].header.frame_id == "camera_optical_frame"
            assert np.array_equal(pixels(got[name]), wanted), name
        info = got["camera/camera_info"]
        assert (info.width, info.height) == (300, 300)
        assert info.k[0] == pytest.approx(150.0)
        assert decode(CameraNames, got["camera/names"].data).names == list(expected.names)
        client.call("skills/rotate", {"degrees": 90})
        until(lambda: (pixels(got["camera/image"]) != expected.rgb).any())


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 30.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.05)
