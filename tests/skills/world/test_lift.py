"""Whose turn it is with a lift."""

from mansion_msgs_py.world import LiftCall
from mansion_skills.world.lift import Lift


def lift() -> Lift:
    return Lift("elevator_1", {1: 0.0, 2: 3.5, 3: 7.0}, {1: "G", 2: "1", 3: "2"}, 0.0)


def test_calls_are_served_in_the_order_in_which_they_came() -> None:
    cabin = lift()
    places = [cabin.call(LiftCall(session=name, floor=2)) for name in ("ann", "bob", "cy", "di")]
    assert places == [0, 1, 2, 3]
    served = []
    while cabin.session:
        served.append(cabin.session)
        assert cabin.release(cabin.session)
    assert served == ["ann", "bob", "cy", "di"]


def test_calling_again_keeps_the_place_and_takes_the_new_floor() -> None:
    cabin = lift()
    for name in ("ann", "bob", "cy"):
        cabin.call(LiftCall(session=name, floor=2))
    assert cabin.call(LiftCall(session="bob", floor=3)) == 1
    cabin.release("ann")
    assert (cabin.session, cabin.target, cabin.place_of("cy")) == ("bob", 3, 1)


def test_who_gives_up_waiting_is_passed_over() -> None:
    cabin = lift()
    for name in ("ann", "bob", "cy"):
        cabin.call(LiftCall(session=name, floor=2))
    assert cabin.release("bob")
    assert not cabin.release("bob")
    cabin.release("ann")
    assert cabin.session == "cy"
