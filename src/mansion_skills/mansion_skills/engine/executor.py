"""Run one skill step by step, at once or in real time, until it ends or is cancelled."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import SkillChange, SkillProgress, SkillResult, SkillStatus
from mansion_skills.engine.motion import MotionSegment, MotionState
from mansion_skills.engine.session import Session, SharedWorld
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.results import Step, refused, with_changes

__all__ = ["WorldClock", "catch_up", "perform"]

LONG = 1.0
"""Duration from which a step is reported even when it takes no real time, seconds of the world."""


@dataclass(frozen=True)
class WorldClock:
    """How fast the time of a world passes.

    Attributes
    ----------
    realtime : bool
        Whether skills take the time that they need; else they complete at once and only the world's clock advances.
    factor : float
        Seconds of the world for one second on the wall.
    wall : callable
        The wall clock, seconds.
    """

    realtime: bool = False
    factor: float = 1.0
    wall: Callable[[], float] = time.monotonic

    def now(self) -> float:
        """Return the time to which worlds are brought, seconds."""
        return self.wall() * self.factor

    def wait(self, seconds: float, stop: threading.Event) -> None:
        """Wait for seconds of the world, or until `stop` is set."""
        stop.wait(seconds / self.factor)


def perform(
    session: Session, skill: Skill, arguments: SessionArgs, clock: WorldClock, report: Callable[[SkillProgress], None]
) -> SkillResult:
    """Run a skill to its end; the caller holds the world's lock, which is released while time passes.

    When a skill raises, the objects are put back to where they were before its last step.
    """
    world, robot = session.world, session.robot
    before = (robot.floor, robot.pose)
    session.stop.clear()
    running = skill.call(world, robot, arguments, realtime=clock.realtime)
    here, floor = MotionState(robot.pose, robot.odometry), robot.floor
    try:
        while True:
            step = next(running)
            world.objects.commit()
            there = MotionState(robot.pose, robot.odometry)
            if clock.realtime and robot.floor == floor:
                session.segment = MotionSegment(here, there, clock.wall(), step.seconds / clock.factor)
            _elapse(session, skill, step, clock, report)
            here, floor = there, robot.floor
            if session.stop.is_set():
                running.close()
                return _cancelled(session, skill, before[1])
    except StopIteration as end:
        world.objects.commit()
        result: SkillResult = end.value
        if not result.changed and (robot.floor, robot.pose) != before:
            return with_changes(result, SkillChange(what="pose", before=before[1], after=robot.pose))
        return result
    except BaseException:
        world.objects.roll_back()
        raise
    finally:
        session.segment = None


def _elapse(
    session: Session, skill: Skill, step: Step, clock: WorldClock, report: Callable[[SkillProgress], None]
) -> None:
    """Let a step's time pass, and report it unless it is short and takes no real time."""
    world = session.world
    if clock.realtime or step.seconds >= LONG:
        report(_progress(session, skill, step))
    if not clock.realtime:
        world.advance(step.seconds)
        return
    session.shared.lock.release()
    try:
        clock.wait(step.seconds, session.stop)
    finally:
        session.shared.lock.acquire()
    catch_up(session.shared, clock)


def _progress(session: Session, skill: Skill, step: Step) -> SkillProgress:
    world, robot = session.world, session.robot
    return SkillProgress(
        session=session.name,
        skill=skill.name,
        message=step.message,
        fraction=round(min(max(step.fraction, 0.0), 1.0), 4),
        pose=robot.pose,
        floor=robot.floor,
        time=round(world.time, 6),
        building_id=world.building.building_id,
    )


def _cancelled(session: Session, skill: Skill, before: object) -> SkillResult:
    world, robot = session.world, session.robot
    text = f"{skill.name} was cancelled"
    result = refused(world, robot, skill.name, SkillStatus.CANCELED, text, "calling the skill again")
    if robot.pose != before:
        return with_changes(result, SkillChange(what="pose", before=before, after=robot.pose))
    return result


def catch_up(shared: SharedWorld, clock: WorldClock) -> None:
    """Bring a world's time up to the clock when motion takes its time."""
    now = clock.now()
    if clock.realtime and now > shared.synced:
        shared.world.advance(now - shared.synced)
    shared.synced = now
