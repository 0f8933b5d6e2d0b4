"""Sharing a building, taking turns, cancelling, and coming back after an end."""

import threading
import time
from pathlib import Path

import pytest
from msgspec.structs import replace

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import ControlArgs, SessionArgs
from mansion_msgs_py.world import LiftDoor, LiftMotion, LiftRequest, LiftRequestType, SkillStatus, WorldState
from mansion_skills import Robot
from mansion_skills.engine import Engine
from mansion_skills.engine.executor import WorldClock
from mansion_skills.engine.motion import VelocityCommand, drive_for
from mansion_skills.engine.session import FairLock
from mansion_skills.skills.go_to import MoveToArgs
from mansion_skills.skills.motion_primitives import RotateArgs
from mansion_skills.world.overlay import overlay_path, world_overlays


def pair(building: Path, **options: object) -> tuple[Robot, Robot]:
    engine = Engine(**options)  # type: ignore[arg-type]
    return Robot(building, engine=engine), Robot(building, "second", engine=engine)


def test_robots_of_one_building_stand_apart_and_share_its_objects(building: Path) -> None:
    a, b = pair(building)
    assert a.where_am_i().pose != b.where_am_i().pose
    a.go_near_object("mug_1")
    assert a.pick_up("mug_1").status is SkillStatus.SUCCESS
    assert "held by default" in b.pick_up("F1/office/mug_1").message


def test_worlds_of_other_names_are_worlds_of_their_own(building: Path) -> None:
    engine = Engine()
    a = Robot(building, engine=engine)
    b = Robot(building, "second", world="mine", engine=engine)
    a.go_near_object("mug_1")
    a.pick_up("mug_1")
    b.go_near_object("mug_1")
    assert b.pick_up("mug_1").status is SkillStatus.SUCCESS


def test_a_lift_belongs_to_the_session_that_called_it_until_it_has_been_used(building: Path) -> None:
    a, b = pair(building)
    for robot in (a, b):
        robot.go_to_landmark("elevator")
    assert a.call_elevator().status is SkillStatus.SUCCESS
    waiting = b.call_elevator()
    assert waiting.status is SkillStatus.PRECONDITION_FAILURE
    assert "held by session 'default'" in waiting.message
    assert b.use_elevator(2).status is SkillStatus.PRECONDITION_FAILURE
    assert a.use_elevator(3).status is SkillStatus.SUCCESS
    assert b.call_elevator().status is SkillStatus.SUCCESS
    assert b.use_elevator(2).status is SkillStatus.SUCCESS


def test_a_lift_is_not_kept_by_a_robot_that_walked_away(building: Path) -> None:
    a, b = pair(building)
    a.go_to_landmark("elevator")
    a.call_elevator()
    a.go_to_landmark("kitchen")
    b.go_to_landmark("elevator")
    assert b.call_elevator().status is SkillStatus.SUCCESS
    a.go_to_landmark("elevator")
    assert a.use_elevator(2).status is SkillStatus.PRECONDITION_FAILURE


def test_lift_requests_hold_and_release_as_open_rmf_does(building: Path) -> None:
    robot = Robot(building)
    engine, world = robot.engine, robot.engine.session("").world
    request = LiftRequest(lift_name="elevator_1", session_id="fleet", destination_floor="3")
    engine.request_lift(request)
    state = world.lift_states()[0]
    assert (state.current_floor, state.door_state, state.session_id) == ("3", LiftDoor.OPEN, "fleet")
    motions = {change.motion_state for change in world.lift_changes}
    assert motions >= {LiftMotion.UP, LiftMotion.STOPPED}
    robot.go_to_landmark("elevator")
    assert robot.call_elevator().status is SkillStatus.PRECONDITION_FAILURE
    engine.request_lift(replace(request, request_type=LiftRequestType.END_SESSION))
    assert robot.call_elevator().status is SkillStatus.SUCCESS
    with pytest.raises(MansionError, match="does not serve"):
        engine.request_lift(LiftRequest(lift_name="elevator_1", session_id="x", destination_floor="9"))


def test_a_new_server_continues_where_the_former_one_ended(building: Path) -> None:
    a, b = pair(building)
    a.go_near_object("mug_1")
    a.pick_up("mug_1")
    b.go_to_landmark("stairs")
    b.take_stairs("Up")
    wanted = a.where_am_i(), b.where_am_i()
    again = pair(building)
    assert (again[0].where_am_i(), again[1].where_am_i()) == wanted
    objects = again[0].engine.session("").world.objects
    assert objects.held_by("default") == "F1/office/mug_1"


@pytest.mark.parametrize("last", [0, 1])
def test_a_new_server_takes_the_newest_overlay(building: Path, last: int) -> None:
    robots = pair(building)
    robots[1 - last].rotate(90)
    robots[last].rotate(90)
    world = robots[0].engine.session("").world
    again = pair(building)[0].engine.session("").world
    assert (again.time, again.step) == (world.time, world.step)


def test_the_overlay_names_what_differs_and_the_revisions_it_rests_on(building: Path) -> None:
    robot = Robot(building)
    robot.go_near_object("mug_1")
    robot.pick_up("mug_1")
    state = decode(WorldState, overlay_path(building, "default").read_bytes())
    assert [entry.id for entry in state.objects] == ["F1/office/mug_1"]
    assert state.revisions == {"1": 1, "2": 1, "3": 1}


def test_a_reset_puts_everything_back_unless_others_are_there(building: Path) -> None:
    a, _ = pair(building)
    a.go_near_object("mug_1")
    a.pick_up("mug_1")
    with pytest.raises(MansionError, match="CONFLICT"):
        a.engine.load(LoadBuilding(path=str(building), reset=True))
    fresh = Robot(building, reset=True)
    assert fresh.where_am_i().held is None


def test_an_overlay_of_another_building_is_refused(building: Path) -> None:
    Robot(building).rotate(90)
    file = overlay_path(building, "default")
    file.write_bytes(file.read_bytes().replace(b'"building_id":"sample"', b'"building_id":"other"'))
    with pytest.raises(MansionError) as caught:
        Robot(building)
    assert caught.value.code == ErrorCode.CONFLICT


def test_a_call_without_a_building_says_so() -> None:
    with pytest.raises(MansionError) as caught:
        Engine().run("WhereAmI", SessionArgs())
    assert caught.value.code == ErrorCode.NOT_LOADED
    with pytest.raises(MansionError, match="letters"):
        Engine().run("WhereAmI", SessionArgs(session="../x"))


def test_only_the_driver_drives_while_it_has_control(robot: Robot) -> None:
    token = robot.engine.take_control(ControlArgs(client="me")).token
    with pytest.raises(MansionError, match="driven by me"):
        robot.rotate(90)
    assert robot.skill("Rotate", degrees=90, token=token).status is SkillStatus.SUCCESS
    assert robot.where_am_i().floor == 1
    robot.engine.release_control(ControlArgs(token=token))
    assert robot.rotate(90).status is SkillStatus.SUCCESS


def test_a_fair_lock_serves_in_the_order_of_arrival() -> None:
    lock, order, threads = FairLock(), list[int](), list[threading.Thread]()
    lock.acquire()
    for number in range(5):

        def work(mine: int = number) -> None:
            with lock:
                order.append(mine)

        threads.append(threading.Thread(target=work))
        threads[-1].start()
        while lock.waiting < number + 1:
            time.sleep(0.001)
    lock.release()
    for thread in threads:
        thread.join(5)
    assert order == [0, 1, 2, 3, 4]


def test_a_skill_in_real_time_is_cancelled_where_it_is(building: Path) -> None:
    robot = Robot(building, engine=Engine(WorldClock(realtime=True, factor=2.0)))
    results = []
    thread = threading.Thread(target=lambda: results.append(robot.engine.run("MoveTo", MoveToArgs(x=11.0, y=1.5))))
    thread.start()
    while robot.where_am_i().pose.x < 6.2:
        time.sleep(0.01)
    robot.engine.cancel(SessionArgs())
    thread.join(5)
    assert results[0].status is SkillStatus.CANCELED
    assert 6.2 <= robot.where_am_i().pose.x < 10.0
    after = Robot(building)
    assert after.where_am_i().pose == robot.where_am_i().pose


def test_lifts_run_while_their_passengers_wait_in_real_time(building: Path) -> None:
    robot = Robot(building, engine=Engine(WorldClock(realtime=True, factor=100.0)))
    robot.go_to_landmark("elevator")
    robot.call_elevator()
    assert robot.use_elevator(3).status is SkillStatus.SUCCESS
    assert robot.where_am_i().floor == 3


def test_drive_commands_move_the_robot_until_a_wall_stops_it(robot: Robot) -> None:
    session, drive, now = robot.engine.session(""), VelocityCommand(), 0.0
    for _ in range(400):
        drive.command(0.8, 0.0, now)
        assert drive_for(session, drive, 0.05, now)
        now += 0.05
    assert session.robot.pose.x == pytest.approx(11.74, abs=0.05)
    assert drive.forward == 0.0
    assert not drive_for(session, drive, 0.05, now + 1.0)
    drive.command(float("nan"), 0.0, now)
    assert not drive_for(session, drive, 0.05, now)


def test_a_fault_inside_a_skill_leaves_the_world_as_it_was(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    from mansion_skills.skills import manipulation

    robot.go_near_object("mug_1")

    def fail(*arguments: object) -> None:
        robot.engine.session("").world.objects.set_state("F1/office/mug_1", "open", True)
        raise RuntimeError("a fault")

    monkeypatch.setattr(manipulation, "take_up", fail)
    with pytest.raises(RuntimeError):
        robot.pick_up("mug_1")
    monkeypatch.undo()
    assert "open" not in robot.engine.session("").world.objects.state("F1/office/mug_1").states
    assert robot.engine.run("Rotate", RotateArgs(degrees=5.0)).status is SkillStatus.SUCCESS
    assert robot.pick_up("mug_1").status in (SkillStatus.SUCCESS, SkillStatus.PRECONDITION_FAILURE)


def test_a_session_that_loads_leaves_what_another_is_saving_alone(
    building: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    a, _ = pair(building)
    a.rotate(90)
    world = a.engine.session("").world
    replaced = Path.replace

    def while_another_loads(path: Path, target: Path) -> Path:
        monkeypatch.setattr(Path, "replace", replaced)
        assert world_overlays(building, world.name)
        return replaced(path, target)

    monkeypatch.setattr(Path, "replace", while_another_loads)
    assert a.rotate(90).status is SkillStatus.SUCCESS
    again = pair(building)[0]
    assert again.where_am_i().pose == a.where_am_i().pose


def test_the_number_of_sessions_is_limited(building: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mansion_skills.engine.engine.MOST_SESSIONS", 2)
    engine = pair(building)[0].engine
    with pytest.raises(MansionError, match="2 sessions are open") as caught:
        Robot(building, "third", engine=engine)
    assert caught.value.code == ErrorCode.CONFLICT
    Robot(building, "second", engine=engine)
