"""Between two steps a robot is where even motion has it."""

import pytest

from mansion_msgs_py.world import Pose2D
from mansion_skills.engine.motion import MotionSegment, MotionState


def at(x: float, y: float, yaw: float = 0.0) -> MotionState:
    """Stand somewhere, as floor and wheels see it."""
    return MotionState(Pose2D(x=x + 10.0, y=y, yaw=yaw), Pose2D(x=x, y=y, yaw=yaw))


def test_half_way_in_half_the_time() -> None:
    motion = MotionSegment(at(0, 0, 90), at(0, 2, 90), begin=5.0, seconds=4.0).at(7.0)
    assert (motion.odometry.x, motion.odometry.y) == pytest.approx((0.0, 1.0))
    assert (motion.pose.x, motion.pose.y) == pytest.approx((10.0, 1.0))
    assert (motion.forward, motion.turning) == pytest.approx((0.5, 0.0))


def test_backwards_is_a_negative_speed_and_the_shorter_turn_is_taken() -> None:
    assert MotionSegment(at(0, 0), at(-1, 0), 0.0, 2.0).at(1.0).forward == pytest.approx(-0.5)
    motion = MotionSegment(at(0, 0, 350), at(0, 0, 10), 0.0, 1.0).at(0.25)
    assert motion.pose.yaw == pytest.approx(355.0)
    assert motion.turning == pytest.approx(0.349, abs=1e-3)


def test_at_the_end_and_without_a_length_it_stands_there() -> None:
    end = at(1, 1)
    assert MotionSegment(at(0, 0), end, 0.0, 1.0).at(1.0) is end
    assert MotionSegment(at(0, 0), end, 0.0, 0.0).at(-1.0) is end
    assert MotionSegment(at(0, 0), end, 3.0, 1.0).at(2.0).pose.x == 10.0
