"""Run one skill step by step, in its time, until it ends or is cancelled."""

from collections.abc import Callable

from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import SkillChange, SkillProgress, SkillResult, SkillStatus
from mansion_skills.engine.motion_segment import MotionSegment, MotionState
from mansion_skills.engine.pace import Pace
from mansion_skills.engine.seat import Seat, SharedWorld
from mansion_skills.skills.outcome import Step, refused
from mansion_skills.skills.registry import Skill

__all__ = ["catch_up", "perform"]

LONG = 1.0
"""Seconds of the world from which a step is reported although it is gone at once."""


def perform(
    seat: Seat, skill: Skill, arguments: SessionArgs, pace: Pace, report: Callable[[SkillProgress], None]
) -> SkillResult:
    """Run a skill to its end; the caller holds the world's lock, which is let go while time passes.

    Whatever goes wrong inside of a skill, the objects are as they were before its last step.
    """
    world, robot = seat.world, seat.robot
    before = (robot.floor, robot.pose)
    seat.stop.clear()
    running = skill.call(world, robot, arguments, pace.realtime)
    here, floor = MotionState(robot.pose, robot.odometry), robot.floor
    try:
        while True:
            step = next(running)
            world.objects.commit()
            there = MotionState(robot.pose, robot.odometry)
            if pace.realtime and robot.floor == floor:
                seat.segment = MotionSegment(here, there, pace.clock(), step.seconds / pace.factor)
            _pass(seat, skill, step, pace, report)
            here, floor = there, robot.floor
            if seat.stop.is_set():
                running.close()
                return _cancelled(seat, skill, before[1])
    except StopIteration as end:
        world.objects.commit()
        result: SkillResult = end.value
        if not result.changed and (robot.floor, robot.pose) != before:
            result.changed.append(SkillChange(what="pose", before=before[1], after=robot.pose))
        return result
    except BaseException:
        world.objects.roll_back()
        raise
    finally:
        seat.segment = None


def _pass(seat: Seat, skill: Skill, step: Step, pace: Pace, report: Callable[[SkillProgress], None]) -> None:
    """Let a step's time pass, and report it unless it is short and gone at once."""
    world = seat.world
    if pace.realtime or step.seconds >= LONG:
        report(_progress(seat, skill, step))
    if not pace.realtime:
        world.advance(step.seconds)
        return
    seat.shared.lock.release()
    try:
        pace.wait(step.seconds, seat.stop)
    finally:
        seat.shared.lock.acquire()
    catch_up(seat.shared, pace)


def _progress(seat: Seat, skill: Skill, step: Step) -> SkillProgress:
    world, robot = seat.world, seat.robot
    return SkillProgress(
        session=seat.session,
        skill=skill.name,
        message=step.message,
        fraction=round(min(max(step.fraction, 0.0), 1.0), 4),
        pose=robot.pose,
        floor=robot.floor,
        time=round(world.time, 6),
        building_id=world.building.building_id,
    )


def _cancelled(seat: Seat, skill: Skill, before: object) -> SkillResult:
    world, robot = seat.world, seat.robot
    text = f"{skill.name} was cancelled"
    result = refused(world, robot, skill.name, SkillStatus.CANCELED, text, "calling the skill again")
    if robot.pose != before:
        result.changed.append(SkillChange(what="pose", before=before, after=robot.pose))
    return result


def catch_up(shared: SharedWorld, pace: Pace) -> None:
    """Bring a world's clock up to the pace's, when motion takes its time."""
    now = pace.now()
    if pace.realtime and now > shared.seen:
        shared.world.advance(now - shared.seen)
    shared.seen = now
