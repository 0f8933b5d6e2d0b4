"""What the camera shows is where the world has it."""

import shutil
import sys
import threading
from math import cos, radians, sin
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills import Robot
from mansion_skills.skills.visibility import CAMERA_HEIGHT
from mansion_skills.vision import Camera, Frame
from mansion_skills.vision.floor_model import FloorModel
from mansion_skills.vision.loaded_floors import KEPT
from mansion_skills.world.floor_exports import _made


def done(result: SkillResult) -> None:
    assert result.status is SkillStatus.SUCCESS, result


def look_at(robot: Robot, x: float, y: float, yaw: float) -> None:
    done(robot.move_to(x, y, yaw))


def points(frame: Frame, camera: Camera, robot: Robot) -> np.ndarray:
    """Return where each pixel lies in the floor's frame, shape (height, width, 3)."""
    where = robot.where_am_i()
    pose, pitch = where.pose, robot.engine.session("").robot.pitch
    lens = camera.intrinsics
    cx, cy = lens.center
    columns, rows = np.meshgrid(np.arange(lens.width), np.arange(lens.height))
    depth = np.where(np.isfinite(frame.depth), frame.depth, 0.0).astype(float)
    right, down = (columns - cx) / lens.focal * depth, (rows - cy) / lens.focal * depth
    tilt, yaw = radians(pitch), radians(pose.yaw)
    ahead = depth * cos(tilt) + down * sin(tilt)
    up = depth * sin(tilt) - down * cos(tilt)
    x = pose.x + ahead * cos(yaw) + right * sin(yaw)
    y = pose.y + ahead * sin(yaw) - right * cos(yaw)
    return np.stack([x, y, CAMERA_HEIGHT + up], axis=-1)


def test_a_wall_is_as_far_as_it_stands_and_has_its_name(camera: Camera, robot: Robot) -> None:
    look_at(robot, 5.0, 1.5, 90.0)
    frame = camera.render()
    middle = frame.depth[60, 60]
    assert frame.names[frame.segmentation[60, 60]] == "w1"
    assert middle == pytest.approx(3.0 - 0.06 - 1.5, abs=0.01)
    wall = frame.segmentation == frame.names.index("w1")
    assert np.ptp(frame.depth[wall & (frame.depth < 1.5)]) < 0.01


def test_a_frame_has_the_size_and_types_that_it_says(robot: Robot, renders: None) -> None:
    with Camera(robot, 160, 90, fov=100.0) as camera:
        frame = camera.render()
    assert (frame.rgb.shape, frame.rgb.dtype) == ((90, 160, 3), np.uint8)
    assert (frame.depth.shape, frame.depth.dtype) == ((90, 160), np.float32)
    assert (frame.segmentation.shape, frame.segmentation.dtype) == ((90, 160), np.int32)
    assert 60 < frame.rgb.mean() < 240
    assert frame.rgb.std() > 10


@pytest.mark.parametrize("pitch", [0.0, -30.0, 30.0])
def test_the_pixels_of_an_object_lie_in_its_box(camera: Camera, robot: Robot, pitch: float) -> None:
    objects = robot.engine.session("").world.objects
    seen: set[str] = set()
    if pitch:
        done(robot.look_up(pitch) if pitch > 0 else robot.look_down(-pitch))
    for x, y, yaw in ((3.0, 5.2, 90.0), (1.6, 4.6, 200.0), (9.0, 4.0, 70.0), (10.5, 6.4, 40.0)):
        look_at(robot, x, y, yaw)
        frame = camera.render()
        at = points(frame, camera, robot)
        for name in frame.visible(4):
            if name not in objects or objects.kinds[name].openable:
                continue
            state, size = objects.state(name), np.array(objects.kinds[name].size)
            offset = at[frame.segmentation == frame.names.index(name)] - np.array(state.position)
            turn = radians(-state.rotation)
            c, s = cos(turn), sin(turn)
            local = offset @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
            assert (np.abs(local) <= size / 2 + 0.02).all(), name
            seen.add(name)
    assert len(seen) >= 3


def test_a_part_that_is_not_asked_for_is_empty_and_the_others_stay_the_same(camera: Camera) -> None:
    whole = camera.render()
    for part in ("rgb", "depth", "segmentation"):
        some = camera.render(**{part: False})
        assert getattr(some, part).size == 0
        for other in {"rgb", "depth", "segmentation"} - {part}:
            assert np.array_equal(getattr(some, other), getattr(whole, other))


def test_two_cameras_see_the_same_bytes(pictured: Path, renders: None) -> None:
    pictures = []
    for _ in range(2):
        robot = Robot(pictured, reset=True)
        with Camera(robot, 120, 120) as camera:
            look_at(robot, 3.0, 5.0, 90.0)
            frame = camera.render()
        pictures.append((frame.rgb.tobytes(), frame.depth.tobytes(), frame.segmentation.tobytes()))
    assert pictures[0] == pictures[1]


def test_a_closed_door_hides_the_room_behind_it(camera: Camera, robot: Robot) -> None:
    look_at(robot, 2.45, 1.6, 90.0)
    before = camera.render().visible()
    done(robot.close_door("F1/door_1"))
    after = camera.render().visible()
    assert before["F1/office"] > 50
    assert "F1/office" not in after
    assert after["F1/door_1"] > 3 * before["F1/door_1"]
    done(robot.open_door("F1/door_1"))
    assert camera.render().visible() == before


def test_glass_does_not_hide_what_is_behind(camera: Camera, robot: Robot) -> None:
    look_at(robot, 8.45, 1.6, 90.0)
    done(robot.close_door("F1/door_2"))
    closed = camera.render().rgb.astype(int)
    look_at(robot, 8.45, 1.6, 90.0)
    done(robot.open_door("F1/door_2"))
    opened = camera.render().rgb.astype(int)
    assert np.abs(closed - opened).mean() < 25


def test_what_is_picked_up_leaves_its_place_and_is_seen_in_the_hand(camera: Camera, robot: Robot) -> None:
    mug = "F1/office/mug_1"
    done(robot.go_near_object(mug))
    done(robot.pick_up(mug))
    frame = camera.render()
    held = frame.segmentation == frame.names.index(mug)
    assert held.any()
    at = points(frame, camera, robot)[held]
    pose = robot.where_am_i().pose
    assert np.hypot(at[:, 0] - pose.x, at[:, 1] - pose.y).max() < 0.7
    assert at[:, 2].max() < 1.05
    done(robot.place("F1/office/desk_1"))
    frame = camera.render()
    at = points(frame, camera, robot)[frame.segmentation == frame.names.index(mug)]
    assert at[:, 2].max() == pytest.approx(0.84, abs=0.02)


def test_an_object_is_seen_on_the_floor_that_it_was_carried_to(camera: Camera, robot: Robot) -> None:
    mug, table = "F1/office/mug_1", "F2/kitchen/table_1"
    done(robot.go_near_object(mug))
    done(robot.pick_up(mug))
    camera.render()
    done(robot.go_to_landmark("elevator"))
    done(robot.call_elevator())
    done(robot.use_elevator(2))
    assert mug in camera.render().visible()
    done(robot.go_near_object(table))
    done(robot.place(table))
    done(robot.go_near_object(mug))
    frame = camera.render()
    at = points(frame, camera, robot)[frame.segmentation == frame.names.index(mug)]
    place = robot.engine.session("").world.objects.state(mug).position
    assert np.abs(at.mean(axis=0) - place).max() < 0.06


def test_an_open_fridge_shows_what_is_in_it(camera: Camera, robot: Robot) -> None:
    fridge, apple = "F1/kitchen/fridge_1", "F1/kitchen/apple_1"
    seen = {}
    for name, act in (("open", robot.open_object), ("shut", robot.close_object)):
        done(robot.go_near_object(fridge))
        done(act(fridge))
        look_at(robot, 11.4, 6.1, 88.0)
        seen[name] = camera.render().visible()
    assert seen["open"][apple] > 0
    assert apple not in seen["shut"]
    assert seen["shut"][fridge] > 500


def test_a_room_is_darker_with_its_lamps_off(camera: Camera, robot: Robot) -> None:
    world = robot.engine.session("").world
    look_at(robot, 9.0, 4.4, 180.0)

    def brightness(on: bool, room: str) -> float:
        world.objects.set_state("F1/kitchen/ceiling_light_1", "on", on)
        frame = camera.render()
        return float(frame.rgb[frame.segmentation == frame.names.index(room)].mean())

    lit, dark = (brightness(on, "F1/kitchen") for on in (True, False))
    assert dark == pytest.approx(0.4 * lit, rel=0.05)
    assert brightness(True, "F1/kitchen") == lit
    assert brightness(False, "F1/office") == brightness(True, "F1/office")


def test_the_lift_opens_its_doors_in_the_picture(camera: Camera, robot: Robot) -> None:
    done(robot.go_to_landmark("elevator"))
    done(robot.rotate(180.0))
    before = camera.render()
    done(robot.call_elevator())
    after = camera.render()
    assert before.names[before.segmentation[60, 60]] == "F1/door_3"
    assert after.depth[60, 60] > before.depth[60, 60] + 1.0


def test_robots_see_each_other_and_not_themselves(pictured: Path, renders: None) -> None:
    first = Robot(pictured)
    second = Robot(pictured, "second", engine=first.engine)
    look_at(first, 3.0, 1.5, 0.0)
    look_at(second, 6.0, 1.5, 180.0)
    with Camera(first, 120, 120) as one, Camera(second, 120, 120) as other:
        assert one.render().visible()["robot/second"] > 20
        seen = other.render().visible()
        assert seen["robot/default"] > 20
        assert "robot/second" not in seen
        look_at(second, 9.0, 6.6, 90.0)
        assert "robot/second" not in one.render().visible()


def test_culling_loses_nothing_that_can_be_seen(camera: Camera, robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    for x, y, yaw in ((6.0, 1.5, 30.0), (2.4, 2.0, 70.0), (5.0, 4.4, 0.0), (8.4, 3.6, 250.0)):
        look_at(robot, x, y, yaw)
        culled = camera.render()
        with monkeypatch.context() as patch:
            patch.setattr(FloorModel, "_in_wedges", lambda self, rooms, offset, radius, heading: radius >= 0.0)
            whole = camera.render()
        assert (culled.segmentation != whole.segmentation).mean() < 0.002
        assert (culled.rgb != whole.rgb).mean() < 0.002


def test_a_table_of_names_only_grows(camera: Camera, robot: Robot) -> None:
    first = camera.render().names
    assert len(set(first)) == len(first)
    done(robot.go_to_landmark("stairs"))
    done(robot.take_stairs("Up"))
    assert camera.render().names[: len(first)] == first


def test_few_floors_stay_loaded(camera: Camera, robot: Robot) -> None:
    camera.render()
    done(robot.go_to_landmark("stairs"))
    for _ in range(4):
        done(robot.take_stairs("Up"))
        camera.render()
    assert camera.loaded_floors == [3, 4, 5]
    assert len(camera.loaded_floors) == KEPT


def test_a_floor_looks_the_same_after_another_was_drawn(camera: Camera, robot: Robot) -> None:
    body = robot.engine.session("").robot

    def picture(floor: int, yaw: float) -> np.ndarray:
        body.floor, body.pose = floor, replace(body.pose, yaw=yaw)
        return camera.render(depth=False, segmentation=False).rgb

    below, above = picture(1, 0.0), picture(2, 90.0)
    assert not np.array_equal(below, above)
    for _ in range(2):
        assert np.array_equal(picture(1, 0.0), below)
        assert np.array_equal(picture(2, 90.0), above)


def test_threads_may_share_a_camera(camera: Camera) -> None:
    expected = camera.render().rgb
    found: list[bool] = []

    def look() -> None:
        found.extend(np.array_equal(camera.render().rgb, expected) for _ in range(5))

    threads = [threading.Thread(target=look) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [True] * 15


def test_a_closed_camera_says_so(robot: Robot, renders: None) -> None:
    camera = Camera(robot, 64, 64)
    camera.render()
    camera.close()
    camera.close()
    with pytest.raises(MansionError) as error:
        camera.render()
    assert error.value.code == ErrorCode.UNAVAILABLE


def test_two_thousand_frames_need_no_more_memory_than_a_few(robot: Robot, renders: None) -> None:
    def resident() -> float:
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 2**20

    with Camera(robot, 48, 48) as camera:
        for _ in range(200):
            camera.render()
        before = resident()
        for turn in range(2000):
            camera.render(depth=False, segmentation=turn % 10 == 0)
        assert resident() - before < 10.0


def test_cameras_that_are_closed_leave_nothing_behind(robot: Robot, renders: None) -> None:
    def once() -> None:
        with Camera(robot, 48, 48) as camera:
            camera.render()

    def resident() -> float:
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 2**20

    for _ in range(3):
        once()
    before, threads = resident(), threading.active_count()
    for _ in range(8):
        once()
    assert threading.active_count() == threads
    assert resident() - before < 60.0


def bare(folder: Path) -> Path:
    """Take the models out of a building's folder."""
    for model in folder.glob("floors/*/model.xml"):
        model.unlink()
    shutil.rmtree(folder / "meshes")
    return folder


def test_a_building_without_models_looks_as_with_them(pictured: Path, tmp_path: Path, renders: None) -> None:
    without = bare(Path(shutil.copytree(pictured, tmp_path / "bare")))
    seen = []
    for folder in (pictured, without):
        robot = Robot(folder)
        done(robot.go_near_object("F1/kitchen/fridge_1"))
        done(robot.open_object("F1/kitchen/fridge_1"))
        with Camera(robot, 120, 90) as camera:
            seen.append((camera.render(), camera.panorama("F1/kitchen"), camera.panorama("stair_1")))
    (before, *rooms), (after, *same_rooms) = seen
    assert before.visible()["F1/kitchen/fridge_1"] > 1000
    assert np.array_equal(before.segmentation, after.segmentation) and np.array_equal(before.rgb, after.rgb)
    assert rooms[0].std() > 5 and all(np.array_equal(one, other) for one, other in zip(rooms, same_rooms))
    assert not list(without.glob("floors/*/model.xml"))


def test_where_models_cannot_be_made_the_command_that_writes_them_is_named(
    pictured: Path, renders: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "mansion_export.mjcf", None)
    _made.cache_clear()
    with Camera(Robot(bare(pictured)), 48, 48) as camera, pytest.raises(MansionError) as error:
        camera.render()
    assert error.value.code == ErrorCode.NOT_FOUND
    assert "mansion export DIR --to mjcf" in str(error.value)


def test_an_object_that_the_models_do_not_have_is_left_out(pictured: Path, renders: None) -> None:
    robot = Robot(pictured)
    mug = "F1/office/mug_1"
    done(robot.go_near_object(mug))
    done(robot.pick_up(mug))
    path = pictured / "floors" / "floor_1" / "model.xml"
    path.write_text(path.read_text().replace(f'"{mug}"', '"gone"'))
    with Camera(robot, 120, 120) as camera:
        assert mug not in camera.render().visible()
        assert camera.render().visible()["F1/office/desk_1"] > 100


def test_without_opengl_the_packages_are_named(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mansion_skills.vision.offscreen.find_library", lambda name: None)
    with pytest.raises(MansionError) as error:
        Camera(robot, 48, 48)
    assert error.value.code == ErrorCode.UNAVAILABLE
    assert "libegl1" in str(error.value)
    assert "libosmesa6" in str(error.value)
