"""Between two steps a robot is where even motion has it."""

import pytest

from mansion_msgs_py.world import Pose2D
from mansion_skills.engine.stretch import Moment, Stretch


def at(x: float, y: float, yaw: float = 0.0) -> Moment:
    """Stand somewhere, as floor and wheels see it."""
    return Moment(Pose2D(x=x + 10.0, y=y, yaw=yaw), Pose2D(x=x, y=y, yaw=yaw))


def test_half_way_in_half_the_time() -> None:
    moment = Stretch(at(0, 0, 90), at(0, 2, 90), begin=5.0, seconds=4.0).at(7.0)
    assert (moment.odometry.x, moment.odometry.y) == pytest.approx((0.0, 1.0))
    assert (moment.pose.x, moment.pose.y) == pytest.approx((10.0, 1.0))
    assert (moment.forward, moment.turning) == pytest.approx((0.5, 0.0))


def test_backwards_is_a_negative_speed_and_the_shorter_turn_is_taken() -> None:
    assert Stretch(at(0, 0), at(-1, 0), 0.0, 2.0).at(1.0).forward == pytest.approx(-0.5)
    moment = Stretch(at(0, 0, 350), at(0, 0, 10), 0.0, 1.0).at(0.25)
    assert moment.pose.yaw == pytest.approx(355.0)
    assert moment.turning == pytest.approx(0.349, abs=1e-3)


def test_at_the_end_and_without_a_length_it_stands_there() -> None:
    end = at(1, 1)
    assert Stretch(at(0, 0), end, 0.0, 1.0).at(1.0) is end
    assert Stretch(at(0, 0), end, 0.0, 0.0).at(-1.0) is end
    assert Stretch(at(0, 0), end, 3.0, 1.0).at(2.0).pose.x == 10.0
