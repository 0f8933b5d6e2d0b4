"""What each skill needs, does and refuses."""

from math import atan2, copysign, degrees, dist
from pathlib import Path

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.world import Pose2D, SkillStatus
from mansion_skills import Robot
from mansion_skills.engine import Engine
from mansion_skills.skills.driving import TURN_SPEED
from mansion_skills.skills.go_to import _tilt_towards
from mansion_skills.skills.visibility import CAMERA_HEIGHT
from mansion_skills.world.overlay import overlay_path

OK, UNMET, INVALID = (SkillStatus.SUCCESS, SkillStatus.PRECONDITION_FAILURE, SkillStatus.INVALID_ACTION)


def do(robot: Robot, *steps: tuple[str, dict[str, object]]) -> None:
    for name, arguments in steps:
        result = robot.skill(name, **arguments)
        assert result.status is OK, result.message


def to_floor(robot: Robot, floor: int) -> None:
    do(robot, ("GoToLandmark", {"landmark": "elevator"}), ("CallElevator", {}))
    do(robot, ("UseElevator", {"target_floor": floor}))


def test_a_robot_begins_at_the_spawn_pose(robot: Robot) -> None:
    here = robot.where_am_i()
    assert (here.floor, here.label, here.room, here.held) == (1, "G", "F1/hall", None)
    assert (here.pose.x, here.pose.y) == (6.0, 1.5)


def test_the_lift_needs_the_entrance_and_the_call_and_takes_the_robot_to_the_standard_pose(robot: Robot) -> None:
    assert robot.call_elevator().status is UNMET
    do(robot, ("GoToLandmark", {"landmark": "elevator"}))
    refused = robot.use_elevator(3)
    assert (refused.status, refused.satisfied_by) == (UNMET, "CallElevator first")
    do(robot, ("CallElevator", {}), ("UseElevator", {"target_floor": 3}))
    here = robot.where_am_i()
    assert (here.floor, here.pose.x, here.pose.y, here.pose.yaw) == (3, 0.66, 1.0, 0.0)
    assert robot.use_elevator(1).status is UNMET


def test_a_floor_can_be_named_by_its_label(robot: Robot) -> None:
    to_floor(robot, 2)
    do(robot, ("CallElevator", {}), ("UseElevator", {"target_floor": "g"}))
    assert robot.where_am_i().floor == 1


def test_stairs_lead_one_floor_and_not_out_of_the_building(robot: Robot) -> None:
    assert robot.take_stairs("Up").status is UNMET
    do(robot, ("GoToLandmark", {"landmark": "stairs"}))
    assert robot.take_stairs("Down").satisfied_by == "direction Up"
    do(robot, ("TakeStairs", {"direction": "Up"}), ("TakeStairs", {"direction": "Up"}))
    assert robot.where_am_i().floor == 3
    assert robot.take_stairs("Up").status is UNMET


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("UseElevator", {"target_floor": 99}),
        ("UseElevator", {"target_floor": None}),
        ("UseElevator", {"target_floor": [3]}),
        ("UseElevator", {"target_floor": "²"}),
        ("TakeStairs", {"direction": "Sideways"}),
        ("TakeStairs", {"direction": 7}),
        ("GoToLandmark", {"landmark": "the moon"}),
        ("GoToLandmark", {"landmark": {}}),
        ("MoveTo", {"x": 1e300, "y": 0}),
        ("MoveTo", {"x": "left", "y": 0}),
        ("MoveTo", {"x": -50, "y": -50}),
        ("MoveAhead", {"distance": float("nan")}),
        ("Rotate", {"degrees": "round"}),
        ("LookUp", {"degrees": -5}),
        ("PickUp", {"object": "unicorn_1"}),
        ("PickUp", {"object": ""}),
        ("PickUp", {"object": "F1/office/desk_1"}),
        ("GoNearObject", {"object": 3}),
        ("OpenObject", {"object": "F1/office/mug_1"}),
        ("ToggleOn", {"object": "F1/office/mug_1"}),
        ("Place", {"target": "F1/office/desk_1", "relation": "under"}),
        ("Place", {"target": "nothing"}),
        ("Place", {"target": "F1/office/mug_1"}),
        ("OpenDoor", {"door": "F9/door_1"}),
        ("CloseDoor", {"door": "F1/door_5"}),
        ("OpenDoor", {"door": "F1/door_3"}),
        ("ListVisible", {"distance": -1}),
        ("PlanRoute", {"target": "the moon"}),
    ],
)
def test_impossible_input_is_an_invalid_action_and_changes_nothing(
    robot: Robot, building: Path, name: str, arguments: dict[str, object]
) -> None:
    before = robot.where_am_i()
    result = robot.skill(name, **arguments)
    assert result.status is INVALID and result.message and result.satisfied_by
    assert robot.where_am_i() == before
    assert not overlay_path(building, "default").exists()


def test_pick_up_needs_reach_sight_and_a_free_hand(robot: Robot) -> None:
    assert "reaches 1.5 m" in robot.pick_up("F1/office/mug_1").message
    do(robot, ("GoNearObject", {"object": "F1/office/mug_1"}), ("Rotate", {"degrees": 180}))
    assert "does not see" in robot.pick_up("F1/office/mug_1").message
    do(robot, ("Rotate", {"degrees": 180}), ("PickUp", {"object": "mug_1"}))
    assert robot.where_am_i().held == "F1/office/mug_1"
    assert robot.pick_up("F1/office/ball_1").satisfied_by == "Place it first"
    do(robot, ("Place", {"target": "desk_1"}))
    assert robot.where_am_i().held is None


def test_what_is_in_a_closed_fridge_is_out_of_sight_until_it_is_opened(robot: Robot) -> None:
    do(robot, ("GoNearObject", {"object": "F1/kitchen/fridge_1"}))
    seen = [entry.id for entry in robot.list_visible().objects]
    assert "F1/kitchen/fridge_1" in seen and "F1/kitchen/apple_1" not in seen
    assert robot.pick_up("apple_1").satisfied_by == "OpenObject F1/kitchen/fridge_1"
    do(robot, ("OpenObject", {"object": "fridge_1"}), ("PickUp", {"object": "apple_1"}))
    do(robot, ("CloseObject", {"object": "fridge_1"}))
    assert robot.place("fridge_1", "in").satisfied_by == "OpenObject F1/kitchen/fridge_1"
    do(robot, ("OpenObject", {"object": "fridge_1"}))
    do(robot, ("Place", {"target": "fridge_1", "relation": "in"}))


def test_a_box_goes_to_another_floor_with_what_is_in_it(robot: Robot) -> None:
    do(robot, ("GoNearObject", {"object": "box_1"}), ("PickUp", {"object": "box_1"}))
    to_floor(robot, 3)
    do(robot, ("Place", {"target": "floor"}))
    objects = robot.engine.session("").world.objects
    crate, ball = objects.state("F1/office/box_1"), objects.state("F1/office/ball_1")
    assert (crate.floor, ball.floor, ball.parent) == (3, 3, crate.id)
    assert dist(crate.position[:2], ball.position[:2]) < 1e-3
    assert crate.room == ball.room == "F3/hall"
    result = robot.go_near_object("F1/office/ball_1")
    assert result.status is OK, result.message
    do(robot, ("PickUp", {"object": "F1/office/ball_1"}))


def test_things_put_on_a_surface_do_not_overlap(robot: Robot) -> None:
    for name in ("F1/office/ball_1", "F1/kitchen/apple_1", "F1/office/mug_1"):
        if name.endswith("apple_1"):
            do(robot, ("GoNearObject", {"object": "fridge_1"}), ("OpenObject", {"object": "fridge_1"}))
        do(robot, ("GoNearObject", {"object": name}), ("PickUp", {"object": name}))
        do(robot, ("GoNearObject", {"object": "table_1"}), ("Place", {"target": "table_1"}))
    objects = robot.engine.session("").world.objects
    states = [objects.state(name) for name in objects.children("F1/kitchen/table_1")]
    assert len(states) == 3
    for i, a in enumerate(states):
        assert a.position[2] > 0.75
        for b in states[:i]:
            assert dist(a.position[:2], b.position[:2]) > 0.1


def test_a_lamp_is_toggled_once(robot: Robot) -> None:
    do(robot, ("GoNearObject", {"object": "lamp_1"}), ("ToggleOn", {"object": "lamp_1"}))
    assert robot.toggle_on("lamp_1").status is UNMET
    do(robot, ("ToggleOff", {"object": "lamp_1"}))
    assert robot.toggle_on("F1/kitchen/ceiling_light_1").status in (UNMET, INVALID)


def test_a_closed_door_stops_the_robot_and_the_answer_names_it(robot: Robot) -> None:
    do(robot, ("GoNearObject", {"object": "F1/door_1"}), ("CloseDoor", {"door": "F1/door_1"}))
    around = robot.go_to_landmark("office")
    assert around.status is OK and around.data["meters"] > 8.0
    do(robot, ("GoNearObject", {"object": "door_1"}), ("OpenDoor", {"door": ""}))
    assert robot.close_door("F1/door_2").status is UNMET


@pytest.mark.parametrize(("floor", "status"), [(1, UNMET), (2, OK)])
def test_only_a_robot_on_the_doors_floor_keeps_it_open(building: Path, floor: int, status: SkillStatus) -> None:
    engine = Engine()
    robot, other = Robot(building, engine=engine), Robot(building, "second", engine=engine)
    do(robot, ("GoNearObject", {"object": "F1/door_1"}))
    world = robot.engine.session("").world
    (ax, ay), (bx, by) = world.view(1).doors["F1/door_1"].segment
    body = world.robots["second"]
    body.floor, body.pose = floor, Pose2D(x=(ax + bx) / 2, y=(ay + by) / 2)
    assert robot.close_door("F1/door_1").status is status
    assert other.where_am_i().floor == floor


def test_shut_in_behind_the_only_door_the_plan_says_which_to_open(robot: Robot) -> None:
    do(robot, ("GoNearObject", {"object": "F1/door_1"}), ("CloseDoor", {"door": "F1/door_1"}))
    do(robot, ("GoNearObject", {"object": "F1/door_2"}), ("CloseDoor", {"door": "F1/door_2"}))
    refused = robot.go_to_landmark("kitchen")
    assert refused.status is SkillStatus.PLANNING_FAILURE
    assert refused.satisfied_by == "GoNearObject F1/door_2 and OpenDoor F1/door_2"
    do(robot, ("OpenDoor", {"door": "F1/door_2"}), ("GoToLandmark", {"landmark": "kitchen"}))


def test_moving_ahead_into_a_wall_says_where_there_is_room(robot: Robot) -> None:
    do(robot, ("Rotate", {"degrees": -90}))
    blocked = robot.move_ahead(3.0)
    assert blocked.status is SkillStatus.EXECUTION_FAILURE
    assert blocked.data["free"]["left"] > blocked.data["free"]["ahead"]
    assert robot.where_am_i().pose.y == 1.5


def test_a_robot_gets_out_of_every_corner(robot: Robot) -> None:
    grid = robot.engine.session("").world.view(1).map
    for x, y in ((0.3, 0.3), (11.7, 2.7), (0.3, 7.7), (11.05, 7.7), (5.7, 3.3)):
        body = robot.engine.session("").robot
        body.pose = Pose2D(x=x, y=y, yaw=body.pose.yaw)
        assert robot.go_to_landmark("hall").status is OK
        assert grid.is_free(*body.place)


def test_the_camera_tilts_between_its_stops(robot: Robot) -> None:
    do(robot, ("LookUp", {"degrees": 60}))
    assert robot.look_up(30).status is UNMET
    do(robot, ("LookDown", {"degrees": 120}))


def test_what_goes_somewhere_looks_ahead_and_what_handles_looks_down_as_far_as_needed(robot: Robot) -> None:
    body = robot.engine.session("").robot
    do(robot, ("GoNearObject", {"object": "fridge_1"}))
    assert body.pitch == 0.0, "a fridge is in the picture of a level camera"
    do(robot, ("OpenObject", {"object": "fridge_1"}), ("GoNearObject", {"object": "ball_1"}))
    low = robot.engine.session("").world.objects.state("F1/office/ball_1").position
    away = max(dist(body.place, low[:2]), body.radius)
    angle = degrees(atan2(low[2] - CAMERA_HEIGHT, away))
    assert body.pitch <= 0.0 and abs(angle - body.pitch) <= 30.0 + 1e-9
    for going in (
        ("MoveTo", {"x": body.pose.x, "y": body.pose.y}),
        ("GoToLandmark", {"landmark": "stairs"}),
        ("TakeStairs", {"direction": "Up"}),
    ):
        body.pitch = -45.0
        do(robot, going)
        assert body.pitch == 0.0, going
    body.pitch = -30.0
    do(robot, ("Rotate", {"degrees": 90}))
    assert body.pitch == -30.0, "turning keeps what LookDown set"


@given(height=st.floats(0.0, 2.4), away=st.floats(0.2, 1.6))
def test_a_tilt_is_the_least_that_shows_an_object(height: float, away: float) -> None:
    tilt, angle = _tilt_towards(height, away), degrees(atan2(height - CAMERA_HEIGHT, away))
    assert tilt % 15.0 == 0.0 and abs(tilt) <= 60.0
    assert abs(angle - tilt) <= 30.0 + 1e-9
    if tilt:
        assert abs(angle - (tilt - copysign(15.0, tilt))) > 30.0 - 1e-9


def test_a_route_to_another_floor_names_the_skills_and_they_lead_there(robot: Robot) -> None:
    route = robot.plan_route("F3/kitchen/apple_1")
    assert [step.split()[0] for step in route.skills][-1] == "GoNearObject"
    for step in route.skills:
        name, _, value = step.partition(" ")
        key = {
            "GoToLandmark": "landmark",
            "UseElevator": "target_floor",
            "TakeStairs": "direction",
            "GoNearObject": "object",
        }.get(name)
        do(robot, (name, {key: value} if key else {}))
    assert robot.where_am_i().room == "F3/kitchen"


def test_the_same_skills_work_in_a_basement_and_on_floor_ten(tmp_path: Path) -> None:
    from sample_building import write_building

    robot = Robot(write_building(tmp_path / "tower", list(range(-1, 11))))
    for floor in (10, -1, 0):
        to_floor(robot, floor)
        do(robot, ("GoNearObject", {"object": "mug_1"}), ("PickUp", {"object": "mug_1"}))
        do(robot, ("Place", {"target": "desk_1"}))
        assert robot.where_am_i().floor == floor


def test_time_goes_on_with_what_is_done(robot: Robot) -> None:
    world = robot.engine.session("").world
    robot.move_to(8.0, 1.5)
    assert world.time == pytest.approx(4.0, abs=0.2)


def test_unknown_skills_and_arguments_are_errors_of_the_call(robot: Robot) -> None:
    with pytest.raises(MansionError, match="no skill"):
        robot.skill("Fly")
    with pytest.raises(MansionError, match="INVALID_PAYLOAD"):
        robot.skill("Rotate", radians=3)


@pytest.mark.parametrize("direction", ["up", "UP", " Up "])
def test_a_direction_is_understood_in_any_case(robot: Robot, direction: str) -> None:
    do(robot, ("GoToLandmark", {"landmark": "stairs"}), ("TakeStairs", {"direction": direction}))
    assert robot.where_am_i().floor == 2


def without(building: Path, *kinds: str) -> Robot:
    """Return a robot in the building with its cores of these kinds walled up."""
    for file in sorted(building.glob("floors/*/scene.json")):
        scene = decode(FloorScene, file.read_bytes())
        left = [core for core in scene.cores if core.type not in kinds]
        file.write_bytes(encode_bytes(msgspec.structs.replace(scene, cores=left)))
    return Robot(building)


def test_a_building_without_a_lift_says_so_and_names_the_stairs(building: Path) -> None:
    robot = without(building, "elevator")
    for result in (robot.call_elevator(), robot.use_elevator(2)):
        assert result.status is INVALID
        assert result.message == "this building has no elevator; use TakeStairs"
    do(robot, ("GoToLandmark", {"landmark": "stair"}), ("TakeStairs", {"direction": "up"}))


def test_a_building_without_stairs_says_so_and_names_the_lift(building: Path) -> None:
    result = without(building, "stair").take_stairs("Up")
    assert (result.status, result.message) == (INVALID, "this building has no stairs; use CallElevator")


def test_a_building_of_one_floor_has_nowhere_to_ride_to(tmp_path: Path) -> None:
    from sample_building import write_building

    robot = without(write_building(tmp_path / "flat", [1]), "elevator", "stair")
    for result in (robot.call_elevator(), robot.take_stairs("Up")):
        assert result.status is INVALID and "one floor only" in result.message


def test_a_turn_goes_all_the_way_round_and_takes_its_time(robot: Robot) -> None:
    session = robot.engine.session("")
    before, yaw = session.world.time, session.robot.pose.yaw
    do(robot, ("Rotate", {"degrees": -540.0}))
    assert session.world.time - before == pytest.approx(540.0 / TURN_SPEED)
    assert session.robot.pose.yaw == (yaw + 180.0) % 360.0


def test_a_room_of_any_floor_is_found_by_the_name_that_it_was_given(building: Path) -> None:
    file = building / "floors/floor_3/scene.json"
    scene = decode(FloorScene, file.read_bytes())
    rooms = [
        msgspec.structs.replace(room, name="The Trough", aliases=["Canteen"]) if room.id == "F3/kitchen" else room
        for room in scene.rooms
    ]
    file.write_bytes(encode_bytes(msgspec.structs.replace(scene, rooms=rooms)))
    robot = Robot(building)
    for name in ("the trough", "Canteen"):
        assert robot.plan_route(name).legs[-1].floor == 3
    assert robot.skill("PlanRoute", target="").status is SkillStatus.INVALID_ACTION


@pytest.mark.parametrize(
    ("skill", "arguments"),
    [
        ("GoToLandmark", {"landmark": "x" * 1_000_000}),
        ("PickUp", {"object": "x" * 1_000_000}),
        ("Place", {"target": "x" * 1_000_000, "relation": "y" * 1_000_000}),
        ("UseElevator", {"target_floor": "x" * 1_000_000}),
        ("TakeStairs", {"direction": "x" * 1_000_000}),
        ("MoveTo", {"x": "1" * 1_000_000, "y": 1e300}),
        ("Rotate", {"degrees": 1e300}),
    ],
)
def test_a_refusal_quotes_long_arguments_in_short(robot: Robot, skill: str, arguments: dict[str, object]) -> None:
    result = robot.skill(skill, **arguments)
    assert result.status is not OK
    assert len(encode_bytes(result)) < 20_000
