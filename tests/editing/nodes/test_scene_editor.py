"""The parameters of the scene editor tell the truth."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from mansion_msgs_py.editing.open_buildings import OpenEditorArgs

rclpy = pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")


@pytest.fixture
def editor() -> Iterator[Any]:
    from mansion_editing.nodes.scene_editor import SceneEditorNode

    options = ["-p", "physics:=static", "-p", "hooks:=mansion_editing"]
    rclpy.init(args=["--ros-args", *options], domain_id=150 + os.getpid() % 50)
    node = SceneEditorNode()
    yield node
    node.destroy_node()
    rclpy.try_shutdown()


def set_physics(node: Any, name: str) -> Any:
    """Set the parameter and return what the node says to it."""
    return node.set_parameters([rclpy.parameter.Parameter("physics", value=name)])[0]


def test_another_engine_serves_the_next_call_of_an_open_editor(editor: Any, folder: Path) -> None:
    editor.open(OpenEditorArgs(path=str(folder)))
    assert editor._editor("").engine.name == "static"
    assert set_physics(editor, "mujoco").successful
    assert editor._editor("").engine.name == "mujoco"


def test_an_engine_that_there_is_not_is_refused_with_those_that_there_are(editor: Any) -> None:
    answer = set_physics(editor, "bogus")
    assert not answer.successful
    assert answer.reason == "no physics engine 'bogus'; engines are mujoco, static, thor"
    assert editor.get_parameter("physics").value == "static"
    assert set_physics(editor, "static").successful
