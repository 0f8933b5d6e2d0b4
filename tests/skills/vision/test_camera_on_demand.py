"""A camera draws for those who listen and for nobody else; this needs no OpenGL."""

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np
import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills import Robot
from mansion_skills.nodes import camera_topics
from mansion_skills.nodes.camera_topics import CameraSettings, CameraTopics, point_cloud
from mansion_skills.nodes.robot_names import RobotNames
from mansion_skills.vision import Frame, Intrinsics
from mansion_skills.world.overlay import DEFAULT_SESSION


class Publisher:
    def __init__(self, name: str) -> None:
        self.name, self.listeners, self.sent = name, 0, []

    def get_subscription_count(self) -> int:
        return self.listeners

    def publish(self, message: Any) -> None:
        self.sent.append(message)


class Node:
    """What of a node the camera's topics use."""

    def __init__(self) -> None:
        self.publishers: dict[str, Publisher] = {}
        self.errors: list[str] = []

    def create_publisher(self, kind: type, name: str, qos: Any) -> Publisher:
        return self.publishers.setdefault(name, Publisher(name))

    def get_clock(self) -> Any:
        from builtin_interfaces.msg import Time

        return SimpleNamespace(now=lambda: SimpleNamespace(to_msg=Time))

    def get_logger(self) -> Any:
        return SimpleNamespace(error=self.errors.append)


class Camera:
    """A camera that writes down what it was asked."""

    opened: ClassVar[list["Camera"]] = []
    broken = False

    def __init__(self, session: Any, width: int, height: int, fov: float) -> None:
        self.intrinsics = Intrinsics(width, height, fov)
        self.asked: list[tuple[bool, bool, bool]] = []
        self.closed = False
        Camera.opened.append(self)

    def render(self, *, rgb: bool, depth: bool, segmentation: bool) -> Frame:
        if Camera.broken:
            raise MansionError(ErrorCode.UNAVAILABLE, "the driver is gone")
        self.asked.append((rgb, depth, segmentation))
        shape = (self.intrinsics.height, self.intrinsics.width)
        return Frame(
            np.zeros((*shape, 3) if rgb else (0, 0, 3), np.uint8),
            np.zeros(shape if depth else (0, 0), np.float32),
            np.zeros(shape if segmentation else (0, 0), np.int32),
            ("F1/office",),
        )

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def topics(building: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[Node], CameraTopics]:
    monkeypatch.setattr(camera_topics, "Camera", Camera)
    monkeypatch.setattr(Camera, "opened", [])
    monkeypatch.setattr(Camera, "broken", False)
    robot = Robot(building)
    session = robot.engine.session(robot.session)

    def make(node: Node) -> CameraTopics:
        made = CameraTopics(node, RobotNames("", "", DEFAULT_SESSION), CameraSettings(40, 30, 90.0))
        made.show(session)
        return made

    return make


def test_nothing_is_opened_while_nobody_listens(topics: Callable[[Node], CameraTopics]) -> None:
    node = Node()
    camera = topics(node)
    for _ in range(3):
        camera.publish()
    assert Camera.opened == []
    assert not any(publisher.sent for publisher in node.publishers.values())


def test_drawing_stops_with_the_last_listener_and_goes_on_with_the_next(topics: Callable[[Node], CameraTopics]) -> None:
    node = Node()
    camera = topics(node)
    image = node.publishers["camera/image"]
    image.listeners = 2
    camera.publish()
    image.listeners = 1
    camera.publish()
    image.listeners = 0
    for _ in range(3):
        camera.publish()
    assert len(image.sent) == 2
    assert len(Camera.opened[0].asked) == 2
    image.listeners = 1
    camera.publish()
    assert len(image.sent) == 3
    assert len(Camera.opened) == 1, "the camera is kept for the next listener"


def test_only_what_is_listened_to_is_drawn(topics: Callable[[Node], CameraTopics]) -> None:
    node = Node()
    camera = topics(node)
    depth, labels = node.publishers["camera/depth"], node.publishers["camera/segmentation"]
    depth.listeners = 1
    camera.publish()
    depth.listeners, labels.listeners = 0, 1
    camera.publish()
    assert Camera.opened[0].asked == [(False, True, False), (False, False, True)]
    assert [len(depth.sent), len(labels.sent)] == [1, 1]
    assert node.publishers["camera/image"].sent == []


def test_the_camera_model_needs_no_picture(topics: Callable[[Node], CameraTopics]) -> None:
    node = Node()
    camera = topics(node)
    node.publishers["camera/camera_info"].listeners = 1
    camera.publish()
    assert Camera.opened[0].asked == []
    assert node.publishers["camera/camera_info"].sent[0].width == 40


def test_a_camera_that_fails_says_so_once_and_is_not_asked_again(
    topics: Callable[[Node], CameraTopics], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Camera, "broken", True)
    node = Node()
    camera = topics(node)
    node.publishers["camera/image"].listeners = 1
    for _ in range(3):
        camera.publish()
    assert len(node.errors) == 1 and "the driver is gone" in node.errors[0]
    assert [entry.closed for entry in Camera.opened] == [True]


def test_another_building_keeps_the_topics_and_gets_another_camera(
    topics: Callable[[Node], CameraTopics], building: Path
) -> None:
    node = Node()
    camera = topics(node)
    image = node.publishers["camera/image"]
    image.listeners = 1
    camera.publish()
    other = Robot(building)
    camera.show(other.engine.session(other.session))
    assert Camera.opened[0].closed
    camera.publish()
    assert node.publishers["camera/image"] is image and len(image.sent) == 2
    assert len(Camera.opened) == 2


def test_points_lie_where_the_depth_says_and_the_sky_is_nowhere() -> None:
    from builtin_interfaces.msg import Time

    intrinsics = Intrinsics(5, 3, 90.0)
    depth = np.full((3, 5), 2.0, np.float32)
    depth[0, 0] = np.inf
    rgb = np.zeros((3, 5, 3), np.uint8)
    rgb[1, 2] = (255, 128, 1)
    message = point_cloud(depth, rgb, intrinsics, "camera", Time())
    assert (message.height, message.width, message.point_step) == (3, 5, 16)
    cloud = np.frombuffer(message.data.tobytes(), "<f4").reshape(3, 5, 4)
    assert np.isnan(cloud[0, 0, :3]).all()
    assert cloud[1, 2, :3] == pytest.approx([0.0, 0.0, 2.0])
    right, down = 2 / intrinsics.focal * 2.0, 1 / intrinsics.focal * 2.0
    assert cloud[2, 4, :3] == pytest.approx([right, down, 2.0])
    assert cloud[1, 2, 3:].view("<u4")[0] == 0xFF8001
