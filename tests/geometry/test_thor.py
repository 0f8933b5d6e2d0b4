"""AI2-THOR's axes convert both ways; its controller starts, or says why it does not and leaves nothing behind."""

import sys
from collections.abc import Iterator
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_geometry.thor.controller import act, start_controller
from mansion_geometry.thor.house_format import floor_point, rotation_matrix, thor_euler, thor_point
from mansion_msgs_py.errors import MansionError

ANGLES = st.floats(0.0, 359.0)


@given(degrees=ANGLES)
@settings(max_examples=30, deadline=None)
def test_a_turn_about_the_vertical_is_that_turn(degrees: float) -> None:
    turned = rotation_matrix(thor_euler(degrees)) @ np.array([1.0, 0.0, 0.0])
    angle = np.radians(degrees)
    assert turned == pytest.approx([np.cos(angle), np.sin(angle), 0.0], abs=2e-5)


@pytest.mark.parametrize(
    ("euler", "up"),
    [
        ((90.0, 0.0, 0.0), (0.0, 1.0, 0.0)),  # pitched forward: what was up points ahead
        ((0.0, 0.0, 90.0), (-1.0, 0.0, 0.0)),  # rolled to the left
        ((90.0, 90.0, 0.0), (1.0, 0.0, 0.0)),  # pitched, then turned to the right
    ],
)
def test_unity_turns_by_z_then_x_then_y(euler: tuple[float, ...], up: tuple[float, ...]) -> None:
    turned = rotation_matrix(dict(zip("xyz", euler, strict=True)))
    assert turned @ np.array([0.0, 0.0, 1.0]) == pytest.approx(up, abs=1e-12)


@given(x=ANGLES, y=ANGLES, z=ANGLES)
@settings(max_examples=30, deadline=None)
def test_every_rotation_stays_one(x: float, y: float, z: float) -> None:
    turned = rotation_matrix({"x": x, "y": y, "z": z})
    assert turned @ turned.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(turned) == pytest.approx(1.0)


def test_points_are_rounded_as_asked() -> None:
    assert thor_point(1.00004, 2.0, 3.0) == {"x": 1.0, "y": 3.0, "z": 2.0}
    assert thor_point(1.00004, 2.0, 3.0, 6) == {"x": 1.00004, "y": 3.0, "z": 2.0}
    assert floor_point({"x": 1.00004, "y": 3.0, "z": 2.0}, 6) == (1.00004, 2.0, 3.0)


class Server:
    """A server whose simulator runs."""

    def __init__(self) -> None:
        self.calls: list[str] = []
        self.unity_proc = self

    def stop(self) -> None:
        self.calls.append("stop")

    def wait(self, timeout: float) -> None:
        assert timeout > 0.0
        self.calls.append("wait")


@pytest.fixture
def client(monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """A module ``ai2thor.controller`` whose constructor raises `error` when its simulator runs."""
    module: Any = ModuleType("ai2thor.controller")
    module.server, module.error = Server(), None

    class Controller:
        def __init__(self, **parameters: Any) -> None:
            module.parameters = parameters
            self.server = module.server
            if module.error is not None:
                raise module.error

    module.Controller = Controller
    platforms: Any = ModuleType("ai2thor.platform")
    platforms.CloudRendering = object()
    module.platforms = platforms
    for name, value in (("controller", module), ("platform", platforms)):
        monkeypatch.setitem(sys.modules, f"ai2thor.{name}", value)
    monkeypatch.setitem(sys.modules, "ai2thor", ModuleType("ai2thor"))
    yield module


def test_a_platform_is_named(client: Any) -> None:
    start_controller(platform="CloudRendering", width=300)
    assert client.parameters == {"platform": client.platforms.CloudRendering, "width": 300}
    assert client.server.calls == []


@pytest.mark.parametrize("error", [Exception("no Vulkan\n at X"), TimeoutError("late"), KeyError()])
def test_a_start_that_fails_half_way_leaves_no_simulator(client: Any, error: Exception) -> None:
    client.error = error
    with pytest.raises(MansionError, match="AI2-THOR does not start") as caught:
        start_controller()
    assert caught.value.code == "UNAVAILABLE" and "\n" not in caught.value.info.message
    assert client.server.calls == ["stop", "wait"]


def test_an_interrupt_ends_the_simulator_and_goes_on(client: Any) -> None:
    client.error = KeyboardInterrupt()
    with pytest.raises(KeyboardInterrupt):
        start_controller()
    assert client.server.calls == ["stop", "wait"]


def test_an_action_that_does_not_exist_is_an_error_message() -> None:
    class Refusing:
        last_event: Any = None

        def step(self, **_: Any) -> Any:
            raise ValueError("Invalid action: Fly\n  at Unity")

    refusing: Any = Refusing()
    assert act(refusing, "Fly") == "Fly: Invalid action: Fly"
