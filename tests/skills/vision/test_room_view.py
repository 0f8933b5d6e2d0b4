"""A room is looked at from where most of it is in view."""

from math import cos, radians, sin
from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.world import ObjectState, Pose2D
from mansion_skills import Robot
from mansion_skills.engine.session import Session
from mansion_skills.skills.visibility import is_visible
from mansion_skills.vision.room_view import AHEAD, IN_FRONT, widest_view
from mansion_skills.vision.viewpoint import stand_at
from mansion_skills.world.floor_view import landmark_named
from mansion_skills.world.objects import box_distance
from sample_building import write_building

OFFICE, KITCHEN = "F1/office", "F1/kitchen"


@pytest.fixture
def session(tmp_path: Path) -> Session:
    robot = Robot(write_building(tmp_path / "plain"))
    return robot.engine.session(robot.session)


def furniture(session: Session, room: str) -> list[ObjectState]:
    objects = session.world.objects
    return [state for state in objects.on_floor(1) if state.room == room and state.mount == "floor"]


def seen(session: Session, room: str) -> list[str]:
    return [state.id for state in furniture(session, room) if is_visible(session.world, session.robot, state)]


def move(session: Session, name: str, x: float, y: float) -> None:
    objects = session.world.objects
    state = objects.state(name)
    assert state.position is not None
    objects.put(msgspec.structs.replace(state, position=(x, y, state.position[2])))
    session.world.refresh(1)


@pytest.mark.parametrize("room, large", [(OFFICE, {"desk_1", "shelf_1"}), (KITCHEN, {"fridge_1", "table_1"})])
def test_the_large_furniture_of_a_room_is_in_view_from_a_place_in_it(
    session: Session, room: str, large: set[str]
) -> None:
    stand_at(session, room)
    grid = session.world.view(1).map
    assert grid.room_at(*session.robot.place) == room and grid.is_free(*session.robot.place)
    assert {f"{room}/{name}" for name in large} <= set(seen(session, room))


def test_the_direction_follows_the_room_and_is_turned_from_there(session: Session) -> None:
    stand_at(session, OFFICE)
    usual = session.robot.pose
    middle = (3.0 - usual.x, 5.5 - usual.y)
    assert cos(radians(usual.yaw)) * middle[0] + sin(radians(usual.yaw)) * middle[1] > 1.0
    stand_at(session, OFFICE, turn=100.0)
    assert session.robot.pose == Pose2D(x=usual.x, y=usual.y, yaw=(usual.yaw + 100.0) % 360.0)


def test_the_same_world_is_looked_at_in_the_same_way(session: Session, tmp_path: Path) -> None:
    other = Robot(write_building(tmp_path / "again"))
    for name in (OFFICE, KITCHEN, "F2/hall"):
        stand_at(session, name)
        stand_at(other.engine.session(other.session), name)
        assert session.robot.pose == other.engine.session(other.session).robot.pose


def test_nothing_tall_stands_close_in_the_middle_of_the_picture(session: Session) -> None:
    stand_at(session, KITCHEN)
    before = session.robot.pose
    x, y = (place + 0.75 * step for place, step in zip(session.robot.place, direction(before)))
    move(session, "F1/kitchen/fridge_1", x, y)
    stand_at(session, KITCHEN)
    assert session.robot.pose != before
    dx, dy = direction(session.robot.pose)
    for state in furniture(session, KITCHEN):
        kind = session.world.objects.kinds[state.id]
        for away in (0.1, 0.2, 0.3, 0.4, 0.5):
            point = session.robot.pose.x + away * AHEAD * dx, session.robot.pose.y + away * AHEAD * dy
            assert kind.size[2] < IN_FRONT or box_distance(point, state, kind) > 0.0


def direction(pose: Pose2D) -> tuple[float, float]:
    return cos(radians(pose.yaw)), sin(radians(pose.yaw))


def test_a_leaf_that_stands_open_ends_the_view(session: Session) -> None:
    stand_at(session, OFFICE)
    assert session.robot.pose.y > 7.0
    view = session.world.view(1)
    door = view.doors["F1/door_1"]
    across = ((0.1, 6.6), (0.1, 7.5))
    leaf = msgspec.structs.replace(door, segment=across, hinge="start", width=5.0, rooms=(OFFICE, None))
    view.scene.doors[:] = [leaf if entry.id == door.id else entry for entry in view.scene.doors]
    stand_at(session, OFFICE)
    assert session.robot.pose.y < 6.6


def test_a_room_without_a_place_to_stand_is_looked_at_from_its_landmark(session: Session) -> None:
    view = session.world.view(1)
    landmark = landmark_named(KITCHEN, view.landmarks, 1, session.robot.place)
    assert landmark is not None
    view.map.blocked[:] = True
    assert widest_view(session.world, landmark) == landmark.pose
