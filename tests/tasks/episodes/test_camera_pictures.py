"""Pictures for agents: marks where the objects are, and none where nothing can render."""

from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from episode_tasks import mug_task
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills import vision
from mansion_tasks.agents.interface import Access
from mansion_tasks.episodes.camera_pictures import CameraPictures, marked_view
from mansion_tasks.episodes.contact_sheet import draw_plan
from mansion_tasks.episodes.episode_folder import episode_folder
from mansion_tasks.episodes.observations import Observer
from mansion_tasks.episodes.port import LocalPort


def test_a_mark_is_drawn_on_its_object_and_nowhere_else() -> None:
    rgb = np.full((120, 160, 3), 200, dtype=np.uint8)
    labels = np.full((120, 160), -1, dtype=np.int32)
    labels[60:100, 100:140] = 1
    labels[10, 10:13] = 0
    data = marked_view(rgb, labels, ("F1/den/pin", "F1/den/box"), {"F1/den/pin": "#1", "F1/den/box": "#2"})
    with Image.open(BytesIO(data)) as picture:
        changed = np.argwhere((np.asarray(picture) != 200).any(axis=2))
    assert len(changed) > 50
    low, high = changed.min(axis=0), changed.max(axis=0)
    assert low[0] >= 60 and high[0] < 100
    assert low[1] >= 95 and high[1] < 145


def test_where_nothing_can_render_a_building_is_seen_without_pictures(
    building: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unavailable(*_: object) -> None:
        raise MansionError(ErrorCode.UNAVAILABLE, "no OpenGL library here can render offscreen")

    monkeypatch.setattr(vision, "Camera", unavailable)
    with episode_folder(building) as folder, CameraPictures() as pictures:
        port = LocalPort()
        port.load(folder)
        seen = pictures(Observer(port, mug_task(), Access()).snapshot())
        assert (seen.view(), seen.landmarks(), seen.lift_panel(), seen.stairs()) == (b"", [], b"", b"")


def test_the_plan_shows_robot_target_and_goal(building: Path) -> None:
    with episode_folder(building) as folder:
        port = LocalPort()
        port.load(folder)
        world, robot = port.world()
        plain = draw_plan(world, 1, [], 0.0)
        full = draw_plan(
            world, 1, [robot.place, (3.0, 5.0)], 0.0, targets=frozenset({"F1/office/mug_1"}),
            goals=frozenset({"F1/kitchen"}),
        )  # fmt: skip
    assert plain.size == full.size and max(plain.size) == 300
    colors = {color for _, color in full.getcolors(1 << 20)} - {color for _, color in plain.getcolors(1 << 20)}
    assert {(250, 214, 130), (214, 60, 40), (30, 80, 170)} <= colors
