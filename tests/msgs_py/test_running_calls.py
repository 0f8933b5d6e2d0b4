"""Calls in work are counted, and cancelled by what they are for."""

import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.running_calls import RunningCalls


def test_the_chosen_calls_are_cancelled_and_no_others() -> None:
    calls = RunningCalls[str]("builds")
    with calls.begun("flat") as flat, calls.begun("office") as office, calls.begun("flat") as other_flat:
        assert calls.cancel(lambda call: call == "flat") == ["flat", "flat"]
        assert (flat.is_set(), office.is_set(), other_flat.is_set()) == (True, False, True)


def test_a_call_that_has_ended_is_not_in_work() -> None:
    calls = RunningCalls[str]("builds")
    with pytest.raises(KeyError), calls.begun("flat"):
        assert calls.any(lambda call: call == "flat")
        raise KeyError
    assert not calls.any(lambda call: True)
    assert calls.cancel(lambda call: True) == []


def test_no_more_calls_begin_than_may_be_in_work() -> None:
    calls = RunningCalls[str]("builds", 2)
    with calls.begun("flat"), calls.begun("office"):
        with pytest.raises(MansionError, match="2 builds are running") as refused, calls.begun("clinic"):
            pass
        assert refused.value.code == ErrorCode.CONFLICT
    with calls.begun("clinic"):
        pass
